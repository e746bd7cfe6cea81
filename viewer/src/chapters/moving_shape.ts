// SPDX-License-Identifier: MIT
// A shape that moves from one point to another, and may turn on its way: what it touches, when, and how that looks.
import type { Impact } from "graze";

import type { ChapterContext } from "../chapter";
import { drawingsOf } from "../drawing/drawings";
import { MeshDrawing } from "../drawing/mesh_drawing";
import { Paint } from "../drawing/paint";
import type { Mark } from "../overlay";
import { middleOf, moved, turned } from "../shapes/edit";
import { minus, newShape, plus, times, type FlatShape } from "../shapes/flat_shape";
import type { Point2 } from "../stage";

export const movingTypes = ["sphere", "obb", "capsule", "polytope"] as const;
export type MovingType = (typeof movingTypes)[number];

export interface MovingLook {
  readonly type: MovingType;
  readonly size: number;
  /** In degrees, over the whole way. */
  readonly turn: number;
}

/** Where the shape first touches another, of which this is the place among all. */
export interface CastHit {
  readonly place: number;
  readonly t: number;
  readonly point: Point2;
  readonly normal: Point2;
}

/** The shape is also drawn so often between its start and its end. */
const shadows = 6;

export class MovingShape {
  look: MovingLook;
  readonly #context: ChapterContext;
  readonly #solid: MeshDrawing;
  readonly #shadow: MeshDrawing;
  #from: Point2 = [0, 0];
  #to: Point2 = [0, 0];

  constructor(context: ChapterContext, look: MovingLook) {
    this.#context = context;
    this.look = look;
    const { palette } = context.stage;
    this.#solid = new MeshDrawing(2, palette, { fill: 0.75, lineWidth: 2.5 });
    this.#shadow = new MeshDrawing(2, palette, { fill: 0.1, lineWidth: 1 });
    this.#solid.object.renderOrder = 2;
    context.stage.world.add(this.#shadow.object, this.#solid.object);
    context.stage.onTheme(() => [this.#solid, this.#shadow].forEach((part) => part.setPalette(context.stage.palette)));
  }

  hide(): void {
    this.#solid.object.visible = false;
    this.#shadow.object.visible = false;
  }

  /** What it touches on its way, the first first; `refused` shapes cannot be asked, `spent` is in milliseconds. */
  cast(from: Point2, to: Point2, shapes: readonly FlatShape[]): { impacts: CastHit[]; refused: number; spent: number } {
    [this.#from, this.#to] = [from, to];
    const start = performance.now();
    const found = shapes.map((shape) => this.#impactWith(shape));
    const spent = performance.now() - start;
    const impacts = found.flatMap((impact, place): CastHit[] => {
      if (impact === null || impact === undefined) return [];
      const [{ t }, [x = 0, y = 0], [right = 0, up = 0]] = [impact, impact.point, impact.normal];
      return [{ place, t, point: [x, y], normal: [right, up] }];
    });
    impacts.sort((a, b) => a.t - b.t);
    return { impacts, refused: found.filter((impact) => impact === undefined).length, spent };
  }

  /** Draws it at its start, on its way to the first touch or to the end, and there. */
  draw(first: CastHit | undefined): Mark[] {
    const { graze, stage } = this.#context;
    const end = first?.t ?? 1;
    const drawn = (t: number): ReturnType<typeof drawingsOf> => drawingsOf(graze, this.#at(t), { corners: 64 });
    const way = Array.from({ length: shadows }, (_, i) => drawn((end * i) / shadows));
    this.#shadow.set([...way, drawn(1)], new Uint8Array([...way.map(() => Paint.found), Paint.faint]));
    this.#solid.set([drawn(end)], new Uint8Array([Paint.found]));
    this.#solid.object.visible = true;
    this.#shadow.object.visible = true;
    const stop = this.#middleAt(end);
    const line: Mark = { kind: "line", points: [this.#from, stop], tone: "answer", thin: true };
    const rest: Mark = { kind: "line", points: [stop, this.#to], tone: "faint", dashed: true, thin: true };
    if (first === undefined) return [line, rest];
    const normal = plus(first.point, times(first.normal, -34 / stage.pixelsPerUnit));
    return [
      line,
      rest,
      { kind: "line", points: [first.point, normal], tone: "second", arrow: true },
      { kind: "dot", at: first.point, tone: "touching-line" },
    ];
  }

  /** Nothing if the engine does not take such a shape, which a compound is to one that turns. */
  #impactWith(shape: FlatShape): Impact | null | undefined {
    const { graze } = this.#context;
    const linear = minus(this.#to, this.#from);
    if (this.look.turn === 0) return graze.shapeCast(this.#at(0), linear, shape);
    if (shape.type === "compound" || shape.type === "ray") return undefined;
    return graze.timeOfImpact(this.#at(0), { linear, angular: (this.look.turn * Math.PI) / 180, center: this.#from }, shape);
  }

  /** Where it is at a time from 0 to 1. */
  #at(t: number): FlatShape {
    const shape = newShape(this.look.type, [0, 0], this.look.size);
    const there = moved(shape, minus(this.#middleAt(t), middleOf(shape)));
    return this.look.turn === 0 ? there : turned(there, this.look.turn * t, this.#middleAt(t));
  }

  #middleAt(t: number): Point2 {
    return plus(this.#from, times(minus(this.#to, this.#from), t));
  }
}
