// SPDX-License-Identifier: MIT
// A shape that moves from one point to another and may rotate on the way: what it touches, when, and its drawing.
import type { Impact, Shape } from "graze";

import type { ChapterContext } from "../chapter";
import { drawingsOf } from "../drawing/drawings";
import { MeshDrawing } from "../drawing/mesh_drawing";
import { Paint } from "../drawing/paint";
import type { Mark } from "../overlay";
import type { ShapeKit } from "../shapes/shape_kit";
import { minus, plus, times } from "../vectors";

/** The first is the default. */
export const movingTypes = ["obb", "sphere", "capsule", "polytope"] as const;
export type MovingType = (typeof movingTypes)[number];

export interface MovingLook {
  readonly type: MovingType;
  readonly size: number;
  /** In degrees, over the whole path; in 3D about the vertical axis. */
  readonly turn: number;
}

/** The first contact with another shape, given by its index. */
export interface CastHit {
  readonly place: number;
  readonly t: number;
  readonly point: readonly number[];
  readonly normal: readonly number[];
}

/** The number of intermediate positions that are drawn between start and end. */
const shadows = 6;

export class MovingShape {
  readonly #context: ChapterContext;
  readonly #kit: ShapeKit;
  readonly #solid: MeshDrawing;
  readonly #shadow: MeshDrawing;
  #look: MovingLook = { type: "sphere", size: 1, turn: 0 };
  #from: readonly number[] = [];
  #to: readonly number[] = [];

  constructor(context: ChapterContext, kit: ShapeKit) {
    this.#context = context;
    this.#kit = kit;
    const { stage } = context;
    const isFlat = kit.dimension === 2;
    this.#solid = new MeshDrawing(kit.dimension, stage.palette, { fill: isFlat ? 0.75 : 0.4, lineWidth: 2.5 });
    this.#shadow = new MeshDrawing(kit.dimension, stage.palette, { fill: isFlat ? 0.1 : 0.06, lineWidth: 1 });
    this.#solid.object.renderOrder = 2;
    stage.world.add(this.#shadow.object, this.#solid.object);
    stage.onTheme(() => [this.#solid, this.#shadow].forEach((part) => part.setPalette(stage.palette)));
  }

  hide(): void {
    this.#solid.object.visible = false;
    this.#shadow.object.visible = false;
  }

  /** The shapes that it touches, in order of time; `spent` is in milliseconds. */
  cast(look: MovingLook, from: readonly number[], to: readonly number[], shapes: readonly Shape[]): { impacts: CastHit[]; spent: number } {
    [this.#look, this.#from, this.#to] = [look, from, to];
    const start = performance.now();
    const found = shapes.map((shape) => this.#impactWith(shape));
    const spent = performance.now() - start;
    const impacts = found.flatMap((impact, place): CastHit[] => (impact === null ? [] : [{ ...impact, place }]));
    impacts.sort((a, b) => a.t - b.t);
    return { impacts, spent };
  }

  /** Draws it at its start, on the way to the first contact or to the end, and there. */
  draw(first: CastHit | undefined): void {
    const { graze } = this.#context;
    const end = first?.t ?? 1;
    const corners = this.#kit.dimension === 2 ? 64 : 32;
    const drawn = (t: number): ReturnType<typeof drawingsOf> => drawingsOf(graze, this.#at(t), this.#kit.dimension, { corners });
    const way = Array.from({ length: shadows }, (_, i) => drawn((end * i) / shadows));
    this.#shadow.set([...way, drawn(1)], new Uint8Array([...way.map(() => Paint.found), Paint.faint]));
    this.#solid.set([drawn(end)], new Uint8Array([Paint.found]));
    this.#solid.object.visible = true;
    this.#shadow.object.visible = true;
  }

  /** Its path, and its first contact. */
  marks(first: CastHit | undefined): Mark[] {
    const stop = this.#middleAt(first?.t ?? 1);
    const line: Mark = { kind: "line", points: [this.#from, stop], tone: "answer", thin: true };
    const rest: Mark = { kind: "line", points: [stop, this.#to], tone: "faint", dashed: true, thin: true };
    if (first === undefined) return [line, rest];
    const normal = plus(first.point, times(first.normal, -34 * this.#context.stage.lengthOfPixel(first.point)));
    return [
      line,
      rest,
      { kind: "line", points: [first.point, normal], tone: "second", arrow: true },
      { kind: "dot", at: first.point, tone: "touching-line" },
    ];
  }

  #impactWith(shape: Shape): Impact | null {
    const { graze } = this.#context;
    const linear = minus(this.#to, this.#from);
    if (this.#look.turn === 0) return graze.shapeCast(this.#at(0), linear, shape);
    const angle = (this.#look.turn * Math.PI) / 180;
    const angular = this.#kit.dimension === 2 ? angle : [0, 0, angle];
    return graze.timeOfImpact(this.#at(0), { linear, angular, center: this.#from }, shape);
  }

  /** Its position at a time from 0 to 1. */
  #at(t: number): Shape {
    const { make, middleOf, moved, turned, dimension } = this.#kit;
    const middle = this.#middleAt(t);
    const shape = make(this.#look.type, Array<number>(dimension).fill(0), this.#look.size);
    const there = moved(shape, minus(middle, middleOf(shape)));
    return this.#look.turn === 0 ? there : turned(there, this.#look.turn * t, middle);
  }

  #middleAt(t: number): readonly number[] {
    return plus(this.#from, times(minus(this.#to, this.#from), t));
  }
}
