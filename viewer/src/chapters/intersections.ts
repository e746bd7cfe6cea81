// SPDX-License-Identifier: MIT
// Intersections: what touches what, how deep and which way out, and how far the rest is away.
import type { Chapter, ChapterContext, OpenChapter } from "../chapter";
import { element } from "../dom";
import { Grid } from "../drawing/grid";
import { Paint } from "../drawing/paint";
import { Editor } from "../editor";
import type { Mark } from "../overlay";
import { counted, duration, measure, vector } from "../numbers";
import { button, choice, Figures, row, section, toggle } from "../panel";
import { plus, shapeNames, times, type FlatShape, type FlatType } from "../shapes/flat_shape";
import { shapesOfText, textOfShapes } from "../shapes/text";
import { wordOf } from "../state";
import type { Point2 } from "../stage";
import { timeOf } from "../timing";

const usualShapes =
  "half_space:0.04,1,-3.15;obb:-3.1,-1.9,1.5,0.8,14;sphere:-1.2,-0.7,0.9;triangle:0.4,-2.6,3.1,-2.2,1.5,0.1;" +
  "capsule:-3.6,1.5,-1.7,2.3,0.5;polytope:2.6,0.5,4,0.2,4.7,1.4,3.7,2.5,2.5,1.8;" +
  "compound:aabb:0.2,1,0.7,2.8|aabb:0.7,1,1.5,1.45|sphere:1.9,1.25,0.45;segment:-0.9,0.6,-0.5,2.9";

const addable: readonly FlatType[] = [
  "sphere", "aabb", "obb", "triangle", "capsule", "polytope", "segment", "point", "plane", "half_space", "compound",
];

type Shown = "contact" | "manifold" | "none";

class Intersections implements OpenChapter {
  readonly #context: ChapterContext;
  readonly #editor: Editor;
  readonly #figures = new Figures();
  readonly #pairList = element("ul", { class: "list", id: "pairs", "aria-label": "Pairs that touch" });
  readonly #inspector = element("div");
  #shown: Shown;
  #showsDistances: boolean;

  constructor(context: ChapterContext) {
    this.#context = context;
    const { stage, parameters } = context;
    stage.showFlat({ min: [-5.6, -4], max: [5.6, 3.6] });
    new Grid(stage);
    this.#shown = wordOf(parameters, "show", ["contact", "manifold", "none"]);
    this.#showsDistances = parameters.get("distances") !== "no";
    const shapes = shapesOfText(parameters.get("shapes") ?? "") ?? shapesOfText(usualShapes) ?? [];
    this.#editor = new Editor(context, { shapes, onChange: () => this.#draw() });
    const selected = Number(parameters.get("selected") ?? Number.NaN);
    if (shapes[selected] !== undefined) this.#editor.select(selected);
    stage.onView(() => this.#draw());
    this.#fillPanel();
    this.#draw();
  }

  parameters(): URLSearchParams {
    const parameters = new URLSearchParams({ shapes: textOfShapes(this.#editor.shapes) });
    if (this.#shown !== "contact") parameters.set("show", this.#shown);
    if (!this.#showsDistances) parameters.set("distances", "no");
    if (this.#editor.selected !== undefined) parameters.set("selected", String(this.#editor.selected));
    return parameters;
  }

  onKey(event: KeyboardEvent): boolean {
    return this.#editor.onKey(event);
  }

  close(): void {
    this.#editor.close();
  }

  #fillPanel(): void {
    const shown = choice<Shown>(
      "What is drawn where shapes touch",
      [["contact", "Contact"], ["manifold", "Manifold"], ["none", "Nothing"]],
      this.#shown,
      (word) => {
        this.#shown = word;
        this.#draw();
      },
    );
    this.#context.panel.append(
      element("h2", {}, "Intersections"),
      element("p", { class: "lead" }, "Drag shapes, or their handles to turn and resize them. What touches lights up; touching counts."),
      this.#figures.root,
      section("Where they touch", shown, toggle("Distances from the selected shape", this.#showsDistances, (on) => {
        this.#showsDistances = on;
        this.#draw();
      })),
      section("Pairs", this.#pairList, this.#inspector),
      section("Add", row(...addable.map((type) => button(shapeNames[type], () => this.#editor.add(type))))),
    );
  }

  #draw(): void {
    const { scene, shapes } = this.#editor;
    scene.update();
    const spent = timeOf(() => scene.checkPairs());
    const pairs = pairsOf(scene.pairs(), (id) => this.#editor.placeOf(id));
    const touching = new Set(pairs.flat());
    const marks = pairs.flatMap(([a, b]) => this.#contactMarks(shapes[a], shapes[b]));
    this.#editor.draw(shapes.map((_, place) => (touching.has(place) ? Paint.touching : Paint.free)), [
      ...marks,
      ...this.#distanceMarks(touching),
    ]);
    this.#figures.set("pairs", "Pairs that touch", String(pairs.length));
    this.#figures.set("objects", "Shapes", String(shapes.length));
    this.#figures.set("time", "Time for all pairs", duration(spent));
    this.#listPairs(pairs);
    this.#inspect();
    this.#context.say(`${counted(pairs.length, "pair")} ${pairs.length === 1 ? "touches" : "touch"}`);
    this.#context.changed();
  }

  #contactMarks(a: FlatShape | undefined, b: FlatShape | undefined): Mark[] {
    if (a === undefined || b === undefined || this.#shown === "none") return [];
    const { graze, stage } = this.#context;
    if (this.#shown === "manifold") {
      return graze.manifold(a, b).points.map((point) => ({ kind: "dot", at: point.point, tone: "touching-line" }));
    }
    const contact = graze.contact(a, b);
    if (contact === null) return [];
    const from = contact.pointB as unknown as Point2;
    const dot: Mark = { kind: "dot", at: from, tone: "touching-line" };
    // Nothing parts lines that cross, however far they are moved.
    if (!Number.isFinite(contact.depth)) return [dot, { kind: "label", at: from, text: "∞", tone: "touching-line", shift: [0, -10] }];
    const depth = Math.max(contact.depth, 26 / stage.pixelsPerUnit);
    const tip = plus(from, times(contact.normal as unknown as Point2, depth));
    return [
      { kind: "line", points: [from, tip], tone: "touching-line", arrow: true },
      dot,
      { kind: "label", at: tip, text: measure(contact.depth), tone: "touching-line", shift: [0, -10] },
    ];
  }

  /** From the selected shape to all that it does not touch. */
  #distanceMarks(touching: ReadonlySet<number>): Mark[] {
    const { selected, shapes } = this.#editor;
    const chosen = selected === undefined ? undefined : shapes[selected];
    if (!this.#showsDistances || chosen === undefined || touching.size > shapes.length) return [];
    return shapes.flatMap((other): Mark[] => {
      if (other === chosen) return [];
      const near = this.#context.graze.closestPoints(chosen, other);
      if (near.relation !== "apart") return [];
      const middle = near.pointA.map((value, axis) => (value + (near.pointB[axis] ?? 0)) / 2);
      return [
        { kind: "line", points: [near.pointA, near.pointB], tone: "answer", dashed: true },
        { kind: "dot", at: near.pointA, tone: "answer" },
        { kind: "dot", at: near.pointB, tone: "answer" },
        { kind: "label", at: middle, text: measure(near.distance), tone: "answer" },
      ];
    });
  }

  #listPairs(pairs: readonly (readonly [number, number])[]): void {
    const { shapes } = this.#editor;
    this.#pairList.replaceChildren(
      ...pairs.map(([a, b]) => {
        const [first, second] = [shapes[a], shapes[b]];
        const relation = first === undefined || second === undefined ? "apart" : this.#context.graze.relation(first, second);
        const name = element("span", {}, `${this.#editor.nameOf(a)} · ${this.#editor.nameOf(b)}`);
        const tag = element("span", { class: "tag" }, relation);
        return element("li", {}, element("button", { type: "button", class: "touching", onclick: () => this.#editor.select(b) }, name, tag));
      }),
    );
  }

  #inspect(): void {
    const place = this.#editor.selected;
    if (place === undefined) {
      this.#inspector.replaceChildren(element("p", { class: "lead" }, "Select a shape to see its numbers."));
      return;
    }
    const shape = this.#editor.shapes[place];
    const figures = new Figures();
    if (shape !== undefined && shape.type !== "compound") {
      for (const [name, value] of Object.entries(shape)) {
        if (typeof value === "number") figures.set(name, name.replace("_", " "), measure(value));
        else if (Array.isArray(value) && typeof value[0] === "number") figures.set(name, name.replace("_", " "), vector(value));
        else if (Array.isArray(value)) figures.set(name, name, String(value.length));
      }
    }
    this.#inspector.replaceChildren(
      element("p", {}, element("strong", {}, this.#editor.nameOf(place))),
      figures.root,
      row(button("Remove", () => this.#editor.remove(place))),
    );
  }
}

function pairsOf(ids: ArrayLike<number>, placeOf: (id: number) => number): [number, number][] {
  const pairs: [number, number][] = [];
  for (let i = 0; i + 1 < ids.length; i += 2) pairs.push([placeOf(ids[i] ?? 0), placeOf(ids[i + 1] ?? 0)]);
  return pairs;
}

export const intersections: Chapter = {
  id: "intersections",
  title: "Intersections",
  open: (context) => new Intersections(context),
};
