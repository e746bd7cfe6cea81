// SPDX-License-Identifier: MIT
// Intersections: which shapes touch, their contact depths and normals, and the distances of all others.
import type { Relation } from "graze";

import { Board } from "../board";
import type { Chapter, ChapterContext, OpenChapter } from "../chapter";
import { element } from "../dom";
import { paintOfRelation } from "../drawing/paint";
import type { Mark } from "../overlay";
import { counted, duration, measure } from "../numbers";
import { button, choice, Figures, row, section, title, toggle } from "../panel";
import { numbersOf } from "../scene/inspector";
import type { ShapeType } from "../shapes/flat_shape";
import { wordOf } from "../state";
import { timeOf } from "../timing";
import { between, plus, times } from "../vectors";

const usual = {
  2: "half_space:0.04,1,-3.15;obb:-3.1,-1.9,1.5,0.8,14;sphere:-1.2,-0.7,0.9;triangle:0.4,-2.6,3.1,-2.2,1.5,0.1;" +
  "capsule:-3.6,1.5,-1.7,2.3,0.5;polytope:2.35,1.25,2.6,0.5,4,0.2,4.7,1.4,3.7,2.5,2.5,1.8;" +
  "compound:aabb:0.2,1,0.7,2.8|aabb:0.7,1,1.5,1.45|sphere:1.9,1.25,0.45;segment:-0.9,0.6,-0.5,2.9",
  3: "half_space:0,0,1,0;obb:-1.5,-1.2,0.55,1.1,0.5,0.7,0,0,24;sphere:-0.5,-1.9,0.65,0.7;" +
    "capsule:-2.1,1.1,0.4,-0.6,1.8,1.2,0.35;polytope:1.1,-1.5,0.1,2.4,-1.7,0.1,2.8,-0.5,0.1,1.5,-0.3,0.1,1.9,-1,1.6;" +
    "compound:aabb:0.6,-2.4,0.1,1,-1.6,1.4|aabb:1,-2.4,0.1,1.9,-1.6,0.5|sphere:2.2,-2,0.5,0.45;" +
    "triangle:0.2,1.5,0,2.2,1.9,0.6,0.9,2.2,2.3;segment:0.2,-0.3,0.3,1.4,0.6,2.2;aabb:-2.7,0.3,0.6,-1.8,1,1.4",
} as const;
const extent = {
  2: { min: [-5.6, -4], max: [5.6, 3.6] },
  3: { min: [-3, -3, -0.3], max: [3, 3, 2.6] },
} as const;

const addable: readonly ShapeType[] = [
  "sphere", "aabb", "obb", "triangle", "capsule", "polytope", "segment", "ray", "point", "plane", "half_space", "compound",
];

type Shown = "contact" | "manifold" | "none";

/** Two touching shapes, by index. */
interface Pair {
  readonly a: number;
  readonly b: number;
  readonly relation: Relation;
}

class Intersections implements OpenChapter {
  readonly #context: ChapterContext;
  readonly #board: Board;
  readonly #figures = new Figures();
  readonly #pairList = element("ul", { class: "list", id: "pairs", "aria-label": "Pairs that touch" });
  readonly #inspector = element("div");
  #shown: Shown;
  #showsDistances: boolean;

  constructor(context: ChapterContext) {
    this.#context = context;
    const { parameters } = context;
    this.#shown = wordOf(parameters, "show", ["contact", "manifold", "none"]);
    this.#showsDistances = parameters.get("distances") !== "no";
    this.#board = new Board(context, { usual, extent, addable, onChange: () => this.#draw() });
    this.#fillPanel();
    this.#draw();
  }

  parameters(): URLSearchParams {
    const parameters = new URLSearchParams();
    if (this.#shown !== "contact") parameters.set("show", this.#shown);
    if (!this.#showsDistances) parameters.set("distances", "no");
    this.#board.describe(parameters);
    return parameters;
  }

  onKey(event: KeyboardEvent): boolean {
    return this.#board.editor.onKey(event);
  }

  close(): void {
    this.#board.close();
  }

  #fillPanel(): void {
    const shown = choice<Shown>(
      "What to draw at contacts",
      [["contact", "Contact"], ["manifold", "Manifold"], ["none", "None"]],
      this.#shown,
      (word) => {
        this.#shown = word;
        this.#draw();
      },
    );
    this.#context.panel.append(
      title("Intersections"),
      element("p", { class: "lead" }, "Drag the shapes, or their handles to rotate and resize them. Shapes that overlap turn orange and are hatched; shapes that only touch turn green and are dotted."),
      this.#board.dimensionSwitch(),
      this.#figures.root,
      section("Where they touch", shown, toggle("Distances from the selected shape", this.#showsDistances, (on) => {
        this.#showsDistances = on;
        this.#draw();
      })),
      section("Pairs", this.#pairList, this.#inspector),
      section("Add", this.#board.addRow),
    );
  }

  #draw(): void {
    const { editor, shapes } = this.#board;
    const { scene } = editor;
    scene.update();
    const spent = timeOf(() => scene.checkPairs());
    const pairs = this.#pairs();
    const marks = (): Mark[] => [...pairs.flatMap((pair) => this.#contactMarks(pair)), ...this.#distanceMarks()];
    const closest = shapes.map(() => "apart" as Relation);
    for (const { a, b, relation } of pairs) for (const place of [a, b]) if (closest[place] !== "overlapping") closest[place] = relation;
    editor.draw(closest.map((relation) => paintOfRelation[relation]), marks);
    this.#figures.set("pairs", "Pairs that touch", String(pairs.length));
    this.#figures.set("candidates", "Candidates, boxes overlap", String(scene.checkPairs().candidates));
    this.#figures.set("objects", "Shapes", String(shapes.length));
    this.#figures.set("time", "Time for all pairs", duration(spent));
    this.#listPairs(pairs);
    this.#inspect();
    this.#context.say(`${counted(pairs.length, "pair")} ${pairs.length === 1 ? "touches" : "touch"}`);
    this.#context.changed();
  }

  /** The pairs that the engine finds, by index of their shapes. */
  #pairs(): Pair[] {
    const { editor, shapes } = this.#board;
    const ids = editor.scene.pairs();
    return Array.from({ length: ids.length / 2 }, (_, i) => {
      const [a, b] = [editor.placeOf(ids[2 * i] ?? 0), editor.placeOf(ids[2 * i + 1] ?? 0)];
      const [first, second] = [shapes[a], shapes[b]];
      const relation = first === undefined || second === undefined ? "apart" : this.#context.graze.relation(first, second);
      return { a, b, relation };
    });
  }

  #contactMarks({ a: placeA, b: placeB, relation }: Pair): Mark[] {
    const { graze, stage } = this.#context;
    const [a, b] = [this.#board.shapes[placeA], this.#board.shapes[placeB]];
    if (a === undefined || b === undefined || this.#shown === "none") return [];
    const tone = relation === "overlapping" ? "overlapping-line" : "touching-line";
    if (this.#shown === "manifold") return graze.manifold(a, b).points.map((point) => ({ kind: "dot", at: point.point, tone }));
    const contact = graze.contact(a, b);
    if (contact === null) return [];
    const from = contact.pointB;
    const dot: Mark = { kind: "dot", at: from, tone };
    // Crossing lines cannot be separated, however far they are moved.
    if (!Number.isFinite(contact.depth)) return [dot, { kind: "label", at: from, text: "∞", tone, shift: [0, -10] }];
    const depth = Math.max(contact.depth, 26 * stage.lengthOfPixel(from));
    const tip = plus(from, times(contact.normal, depth));
    return [
      { kind: "line", points: [from, tip], tone, arrow: true },
      dot,
      { kind: "label", at: tip, text: measure(contact.depth), tone, shift: [0, -10] },
    ];
  }

  /** From the selected shape to all that it does not touch. */
  #distanceMarks(): Mark[] {
    const { selected, shapes } = this.#board.editor;
    const chosen = selected === undefined ? undefined : shapes[selected];
    if (!this.#showsDistances || chosen === undefined) return [];
    return shapes.flatMap((other): Mark[] => {
      if (other === chosen) return [];
      const near = this.#context.graze.closestPoints(chosen, other);
      if (near.relation !== "apart") return [];
      return [
        { kind: "line", points: [near.pointA, near.pointB], tone: "answer", dashed: true },
        { kind: "dot", at: near.pointA, tone: "answer" },
        { kind: "dot", at: near.pointB, tone: "answer" },
        { kind: "label", at: between(near.pointA, near.pointB), text: measure(near.distance), tone: "answer" },
      ];
    });
  }

  #listPairs(pairs: readonly Pair[]): void {
    const { editor } = this.#board;
    this.#pairList.replaceChildren(
      ...pairs.map(({ a, b, relation }) => {
        const name = element("span", {}, `${editor.nameOf(a)} · ${editor.nameOf(b)}`);
        const tag = element("span", { class: "tag" }, relation);
        return element("li", {}, element("button", { type: "button", class: relation, onclick: () => editor.select(b) }, name, tag));
      }),
    );
  }

  #inspect(): void {
    const { editor } = this.#board;
    const place = editor.selected;
    const shape = place === undefined ? undefined : editor.shapes[place];
    if (place === undefined || shape === undefined) {
      this.#inspector.replaceChildren(element("p", { class: "lead" }, "Select a shape to see its numbers."));
      return;
    }
    const figures = new Figures();
    for (const [name, value] of numbersOf(shape)) figures.set(name.replace(" ", "-"), name.replace("_", " "), value);
    this.#inspector.replaceChildren(
      element("p", {}, element("strong", {}, editor.nameOf(place))),
      figures.root,
      row(button("Remove", () => editor.remove(place))),
    );
  }
}

export const intersections: Chapter = {
  id: "intersections",
  title: "Intersections",
  open: (context) => new Intersections(context),
};
