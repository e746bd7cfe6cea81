// SPDX-License-Identifier: MIT
// Shapes and closest points: the point of a shape that is nearest to a query point, its distance and, from inside, the
// shortest way out.
import type { Shape } from "graze";

import { Board } from "../board";
import type { Chapter, ChapterContext, OpenChapter } from "../chapter";
import { element } from "../dom";
import { Paint } from "../drawing/paint";
import { measure } from "../numbers";
import { plumb, type Mark, type SpaceHandle } from "../overlay";
import { button, choice, Figures, row, section, title } from "../panel";
import type { ShapeType } from "../shapes/flat_shape";
import { pointOf, wordOf, writePoint } from "../state";

const usual = {
  2: "sphere:-3.3,1.2,1;obb:0.2,2.1,1.3,0.6,-12;triangle:2.6,0.6,4.6,1.1,3.5,2.7;capsule:-4.2,-2.1,-2.2,-1.5,0.45;" +
  "polytope:2.2,-2.6,3.6,-2.9,4.5,-1.8,3.8,-0.7,2.5,-1;segment:-0.9,-2.9,1,-2.2;aabb:-1.2,-0.9,-0.1,0.3;ray:-5,-3.35,1,0",
  3: "sphere:-1.9,1.3,0.7,0.7;obb:1.5,1.5,0.5,0.8,0.5,0.5,0,0,-20;triangle:2.1,-0.9,0.1,2.7,0.3,0.2,2.3,-0.2,1.7;" +
    "capsule:-2.4,-1.5,0.35,-1.1,-2.1,0.5,0.35;polytope:0.4,-2.4,0,1.9,-2.5,0,1.9,-1.3,0,0.7,-1.2,0,1.2,-1.9,1.2;" +
    "segment:-0.9,2.4,1.1,0.6,2.5,2;aabb:-2.7,-0.6,0,-1.9,0.2,1.1",
} as const;
const extent = {
  2: { min: [-5.4, -3.7], max: [5.4, 3.7] },
  3: { min: [-3, -3, 0], max: [3, 3, 2.4] },
} as const;
const usualProbe = { 2: [1.15, -0.15], 3: [0.1, -0.2, 0.9] } as const;

const addable: readonly ShapeType[] = [
  "sphere", "aabb", "obb", "triangle", "capsule", "polytope", "segment", "ray", "plane", "half_space", "compound",
];

type Shown = "all" | "nearest";

class ClosestPoints implements OpenChapter {
  readonly #context: ChapterContext;
  readonly #board: Board;
  readonly #figures = new Figures();
  readonly #distances = element("ul", { class: "list", "aria-label": "Distances of the shapes" });
  /** The query point in 2D and in 3D. */
  readonly #probes: Record<2 | 3, readonly number[]>;
  #shown: Shown;

  constructor(context: ChapterContext) {
    this.#context = context;
    const { parameters } = context;
    this.#probes = { 2: pointOf(parameters, "", usualProbe[2]), 3: pointOf(parameters, "", usualProbe[3]) };
    this.#shown = wordOf(parameters, "show", ["all", "nearest"]);
    this.#board = new Board(context, { usual, extent, addable, onChange: () => this.#draw(), ownHandles: () => [this.#handle()] });
    this.#fillPanel();
    this.#draw();
  }

  parameters(): URLSearchParams {
    const parameters = new URLSearchParams();
    writePoint(parameters, "", this.#probe);
    parameters.set("show", this.#shown);
    this.#board.describe(parameters);
    return parameters;
  }

  get #probe(): readonly number[] {
    return this.#probes[this.#board.dimension];
  }

  onKey(event: KeyboardEvent): boolean {
    return this.#board.editor.onKey(event);
  }

  close(): void {
    this.#board.close();
  }

  #handle(): SpaceHandle {
    return {
      key: "probe",
      label: "The query point",
      at: this.#probe,
      onMoveInSpace: (to) => {
        this.#probes[this.#board.dimension] = to;
        this.#draw();
      },
    };
  }

  #draw(): void {
    const { graze } = this.#context;
    const { editor, shapes } = this.#board;
    const probe = this.#probe;
    const distances = shapes.map((shape) => graze.signedDistance(shape, probe));
    const nearest = distances.reduce((best, distance, place) => (distance < (distances[best] ?? Infinity) ? place : best), 0);
    const holders = shapes.map((shape) => graze.contains(shape, probe));
    const paints = holders.map((holds, place) => (!holds ? Paint.free : (distances[place] ?? 0) < 0 ? Paint.overlapping : Paint.touching));
    const shown = shapes.map((_, place) => this.#shown === "all" || place === nearest);
    const marks = shapes.flatMap((shape, place) => (shown[place] === true ? this.#marksOf(shape, distances[place] ?? 0) : []));
    editor.draw(paints, () => [...plumb(probe, extent[3].min[2]), ...marks]);
    this.#figures.set("nearest", "Nearest shape", shapes.length > 0 ? editor.nameOf(nearest) : "none");
    this.#figures.set("distance", "Its signed distance", shapes.length > 0 ? measure(distances[nearest] ?? 0) : "–");
    this.#figures.set("contains", "Shapes containing the point", String(holders.filter(Boolean).length));
    this.#list(distances);
    this.#context.say(shapes.length === 0 ? "No shapes" : `Nearest: ${editor.nameOf(nearest)}, ${measure(distances[nearest] ?? 0)}`);
    this.#context.changed();
  }

  /** Outside, both closest points are equal; inside, they are the point itself and the nearest boundary point. */
  #marksOf(shape: Shape, distance: number): Mark[] {
    const { graze } = this.#context;
    const onBoundary = graze.closestBoundaryPoint(shape, this.#probe);
    const inSolid = graze.closestPoint(shape, this.#probe);
    const tone = distance < 0 ? "overlapping-line" : "answer";
    const middle = onBoundary.map((value, axis) => 0.35 * value + 0.65 * (this.#probe[axis] ?? 0));
    const place = distance < 0 ? onBoundary : middle.map((value, axis) => 0.5 * (value + (onBoundary[axis] ?? 0)));
    return [
      { kind: "line", points: [this.#probe, onBoundary], tone, dashed: distance >= 0, arrow: distance < 0 },
      { kind: "dot", at: onBoundary, tone, hollow: true },
      { kind: "dot", at: inSolid, tone },
      { kind: "label", at: place, text: measure(distance), tone },
    ];
  }

  #list(distances: readonly number[]): void {
    const order = distances.map((_, place) => place).sort((a, b) => (distances[a] ?? 0) - (distances[b] ?? 0));
    this.#distances.replaceChildren(
      ...order.map((place) => {
        const distance = distances[place] ?? 0;
        const relation = distance < 0 ? "overlapping" : distance === 0 ? "touching" : "";
        const tag = element("span", { class: "tag" }, measure(distances[place] ?? 0));
        const attributes = { type: "button", class: relation, "aria-current": String(place === this.#board.editor.selected) };
        return element("li", {}, element("button", { ...attributes, onclick: () => this.#board.editor.select(place) }, element("span", {}, this.#board.editor.nameOf(place)), tag));
      }),
    );
  }

  #fillPanel(): void {
    const shown = choice<Shown>("Shapes to query", [["all", "All shapes"], ["nearest", "The nearest"]], this.#shown, (word) => {
      this.#shown = word;
      this.#draw();
    });
    const remove = button("Remove selected", () => {
      const { editor } = this.#board;
      if (editor.selected !== undefined) editor.remove(editor.selected);
    });
    this.#context.panel.append(
      title("Shapes and closest points"),
      element("p", { class: "lead" }, "Drag the round handle. Outside a shape, a dashed line leads to its closest point. Inside, the distance is negative, and an arrow shows the shortest way out."),
      this.#board.dimensionSwitch(),
      this.#figures.root,
      section("Answers", shown, this.#distances),
      section("Shapes", this.#board.addRow, row(remove)),
    );
  }
}

export const closestPoints: Chapter = {
  id: "closest-points",
  title: "Closest points",
  open: (context) => new ClosestPoints(context),
};
