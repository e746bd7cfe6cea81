// SPDX-License-Identifier: MIT
// Shapes and closest points: where a shape is nearest to a point, how far that is, and, from inside, the way out.
import type { Chapter, ChapterContext, OpenChapter } from "../chapter";
import { element } from "../dom";
import { Grid } from "../drawing/grid";
import { Paint } from "../drawing/paint";
import { Editor } from "../editor";
import { measure, rounded } from "../numbers";
import type { Handle, Mark } from "../overlay";
import { button, choice, Figures, row, section } from "../panel";
import { shapeNames, type FlatShape, type FlatType } from "../shapes/flat_shape";
import { shapesOfText, textOfShapes } from "../shapes/text";
import { numberOf, wordOf } from "../state";
import type { Point2 } from "../stage";

const usualShapes =
  "sphere:-3.3,1.2,1;obb:0.2,2.1,1.3,0.6,-12;triangle:2.6,0.6,4.6,1.1,3.5,2.7;capsule:-4.2,-2.1,-2.2,-1.5,0.45;" +
  "polytope:2.2,-2.6,3.6,-2.9,4.5,-1.8,3.8,-0.7,2.5,-1;segment:-0.9,-2.9,1,-2.2;aabb:-1.2,-0.9,-0.1,0.3;ray:-5,-3.35,1,0";

const addable: readonly FlatType[] = [
  "sphere", "aabb", "obb", "triangle", "capsule", "polytope", "segment", "ray", "plane", "half_space", "compound",
];

type Shown = "all" | "nearest";

class ClosestPoints implements OpenChapter {
  readonly #context: ChapterContext;
  readonly #editor: Editor;
  readonly #figures = new Figures();
  readonly #distances = element("ul", { class: "list", "aria-label": "Distances of the shapes" });
  #probe: Point2;
  #shown: Shown;

  constructor(context: ChapterContext) {
    this.#context = context;
    const { stage, parameters } = context;
    stage.showFlat({ min: [-5.4, -3.7], max: [5.4, 3.7] });
    new Grid(stage);
    const coordinate = (name: string, usual: number): number => numberOf(parameters, name, { least: -1e6, most: 1e6, usual });
    this.#probe = [coordinate("x", 1.15), coordinate("y", -0.15)];
    this.#shown = wordOf(parameters, "show", ["all", "nearest"]);
    const shapes = shapesOfText(parameters.get("shapes") ?? "") ?? shapesOfText(usualShapes) ?? [];
    this.#editor = new Editor(context, { shapes, onChange: () => this.#draw(), ownHandles: () => [this.#handle()] });
    stage.onView(() => this.#draw());
    this.#fillPanel();
    this.#draw();
  }

  parameters(): URLSearchParams {
    const [x, y] = this.#probe.map(rounded);
    return new URLSearchParams({ x: String(x), y: String(y), show: this.#shown, shapes: textOfShapes(this.#editor.shapes) });
  }

  onKey(event: KeyboardEvent): boolean {
    return this.#editor.onKey(event);
  }

  close(): void {
    this.#editor.close();
  }

  #handle(): Handle {
    return {
      key: "probe",
      label: "The point that is asked about",
      at: this.#probe,
      onMove: (to) => {
        this.#probe = to;
        this.#draw();
      },
    };
  }

  #draw(): void {
    const { graze } = this.#context;
    const { shapes } = this.#editor;
    const distances = shapes.map((shape) => graze.signedDistance(shape, this.#probe));
    const nearest = distances.reduce((best, distance, place) => (distance < (distances[best] ?? Infinity) ? place : best), 0);
    const holders = shapes.map((shape) => graze.contains(shape, this.#probe));
    const shown = shapes.map((_, place) => this.#shown === "all" || place === nearest);
    const marks = shapes.flatMap((shape, place) => (shown[place] === true ? this.#marksOf(shape, distances[place] ?? 0) : []));
    this.#editor.draw(holders.map((holds) => (holds ? Paint.touching : Paint.free)), marks);
    this.#figures.set("nearest", "Nearest shape", shapes.length > 0 ? this.#editor.nameOf(nearest) : "none");
    this.#figures.set("distance", "Its signed distance", measure(distances[nearest] ?? 0));
    this.#figures.set("contains", "Shapes that contain the point", String(holders.filter(Boolean).length));
    this.#list(distances);
    this.#context.say(`Nearest: ${this.#editor.nameOf(nearest)}, ${measure(distances[nearest] ?? 0)}`);
    this.#context.changed();
  }

  /** Outside, both closest points are the same; inside, the point itself and the nearest one of the boundary. */
  #marksOf(shape: FlatShape, distance: number): Mark[] {
    const { graze } = this.#context;
    const onBoundary = graze.closestBoundaryPoint(shape, this.#probe);
    const inSolid = graze.closestPoint(shape, this.#probe);
    const tone = distance < 0 ? "touching-line" : "answer";
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
        const isInside = (distances[place] ?? 0) <= 0;
        const tag = element("span", { class: "tag" }, measure(distances[place] ?? 0));
        const attributes = { type: "button", class: isInside ? "touching" : "", "aria-current": String(place === this.#editor.selected) };
        return element("li", {}, element("button", { ...attributes, onclick: () => this.#editor.select(place) }, element("span", {}, this.#editor.nameOf(place)), tag));
      }),
    );
  }

  #fillPanel(): void {
    const shown = choice<Shown>("Which shapes answer", [["all", "All shapes"], ["nearest", "The nearest"]], this.#shown, (word) => {
      this.#shown = word;
      this.#draw();
    });
    const remove = button("Remove the selected", () => {
      const { selected } = this.#editor;
      if (selected !== undefined) this.#editor.remove(selected);
    });
    this.#context.panel.append(
      element("h2", {}, "Shapes and closest points"),
      element("p", { class: "lead" }, "Drag the round handle. From outside, the dashed line is the shortest way to each shape. Inside, the distance is negative, and the arrow is the shortest way out."),
      this.#figures.root,
      section("Answers", shown, this.#distances),
      section("Shapes", row(...addable.map((type) => button(shapeNames[type], () => this.#editor.add(type)))), row(remove)),
    );
  }
}

export const closestPoints: Chapter = {
  id: "closest-points",
  title: "Closest points",
  open: (context) => new ClosestPoints(context),
};
