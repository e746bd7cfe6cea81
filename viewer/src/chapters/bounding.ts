// SPDX-License-Identifier: MIT
// Bounding volumes: the smallest and the fast bounding circle, the box and the oriented box of points, side by side.
import type { Graze, Shape } from "graze";

import type { Chapter, ChapterContext, OpenChapter } from "../chapter";
import { element } from "../dom";
import { circlesOfSphere } from "../drawing/circles";
import { Grid } from "../drawing/grid";
import { duration, measure, rounded } from "../numbers";
import type { Mark, Tone } from "../overlay";
import { button, dimensionChoice, Figures, row, section, slider, title, toggle } from "../panel";
import { randomNumbers } from "../random";
import { numberOf, wordOf } from "../state";
import { timeOf } from "../timing";

const countLimits = { least: 1, most: 60, usual: 14 } as const;

type Volume = "box" | "obb" | "sphere" | "fast" | "hull";

const volumes: readonly { readonly id: Volume; readonly label: string; readonly tone: Tone }[] = [
  { id: "sphere", label: "smallest sphere", tone: "overlapping-line" },
  { id: "fast", label: "fast sphere", tone: "faint" },
  { id: "box", label: "box", tone: "free-line" },
  { id: "obb", label: "oriented box", tone: "answer" },
  { id: "hull", label: "convex hull", tone: "second" },
];

class Bounding implements OpenChapter {
  readonly #context: ChapterContext;
  readonly #figures = new Figures();
  readonly #listening = new AbortController();
  #dimension: 2 | 3;
  #points: number[][] = [];
  #shown: Set<Volume>;
  #seed: number;

  constructor(context: ChapterContext) {
    this.#context = context;
    const { parameters } = context;
    this.#dimension = wordOf(parameters, "dimension", ["2", "3"]) === "3" ? 3 : 2;
    this.#seed = Math.round(numberOf(parameters, "seed", { least: 0, most: 4_294_967_295, usual: 11 }));
    const known = volumes.map((volume) => volume.id);
    const wanted = (parameters.get("show") ?? "sphere,box,obb,hull").split(",");
    this.#shown = new Set(known.filter((id) => wanted.includes(id)));
    this.#points = pointsOfText(parameters.get("points") ?? "", this.#dimension) ?? this.#scatter(countLimits.usual);
    this.#open();
    this.#fillPanel();
    this.#draw();
  }

  parameters(): URLSearchParams {
    return new URLSearchParams({
      dimension: String(this.#dimension),
      show: [...this.#shown].join(","),
      seed: String(this.#seed),
      points: this.#points.map((point) => point.map(rounded).join(",")).join(";"),
    });
  }

  close(): void {
    this.#listening.abort();
  }

  #open(): void {
    const { stage, overlay } = this.#context;
    overlay.clear();
    stage.clearDrawing();
    if (this.#dimension === 2) {
      stage.showFlat({ min: [-3.4, -2.5], max: [3.4, 2.5] });
      new Grid(stage);
    } else {
      const extent = { min: [-2.6, -2.6, -2.4], max: [2.6, 2.6, 2.4] };
      stage.showDeep(extent);
      new Grid(stage, extent);
    }
    stage.onTheme(() => this.#draw());
  }

  /** Points along a slanted line, so that the volumes differ. */
  #scatter(count: number): number[][] {
    const random = randomNumbers(this.#seed);
    const bell = (): number => random() + random() + random() - 1.5;
    return Array.from({ length: count }, () => {
      const [along, across, up] = [3.1 * bell(), 1.3 * bell(), 1.2 * bell()];
      const point = [0.88 * along - 0.47 * across, 0.47 * along + 0.88 * across];
      return this.#dimension === 2 ? point : [...point, 0.5 * along + up];
    });
  }

  #volume(id: Volume): Shape {
    const { graze } = this.#context;
    switch (id) {
      case "box":
        return graze.boundingBox(this.#points);
      case "obb":
        return graze.boundingObb(this.#points);
      case "sphere":
        return graze.boundingSphere(this.#points);
      case "fast":
        return graze.boundingSphereFast(this.#points);
      case "hull":
        return graze.convexHull(this.#points);
    }
  }

  #draw(): void {
    const { stage, overlay, graze } = this.#context;
    const marks: Mark[] = [];
    for (const { id, label, tone } of volumes) {
      const shape = this.#volume(id);
      const spent = timeOf(() => this.#volume(id));
      const size = this.#sizeOf(shape);
      this.#figures.set(id, label, `${measure(size)} · ${duration(spent)}`);
      if (this.#shown.has(id)) marks.push(...linesOf(graze, shape, this.#dimension, { tone, dashed: id === "fast" }));
    }
    overlay.draw(marks);
    overlay.setHandles(
      this.#points.map((at, index) => ({
        key: `point-${index}`,
        label: `Point ${index + 1}`,
        at,
        onMoveInSpace: (to) => {
          this.#points[index] = [...to];
          this.#draw();
        },
      })),
    );
    this.#context.say(`${this.#points.length} points`);
    this.#context.changed();
    stage.invalidate();
  }

  /** The area in 2D, the volume in 3D. */
  #sizeOf(shape: Shape): number {
    const isFlat = this.#dimension === 2;
    if (shape.type === "sphere") return isFlat ? Math.PI * shape.radius ** 2 : (4 / 3) * Math.PI * shape.radius ** 3;
    if (shape.type === "obb") return product(Array.from(shape.half_extents, (half) => 2 * half));
    if (shape.type === "aabb" && "min" in shape) return product(Array.from(shape.max, (high, axis) => high - (shape.min[axis] ?? 0)));
    return enclosed(this.#context.graze.drawing(shape), this.#dimension);
  }

  #fillPanel(): void {
    const toggles = volumes.map(({ id, label, tone }) => {
      const box = toggle(label, this.#shown.has(id), (on) => {
        if (on) this.#shown.add(id);
        else this.#shown.delete(id);
        this.#draw();
      });
      box.prepend(element("span", { class: "swatch", style: `border-color: var(--${tone})` }));
      return box;
    });
    const scatter = (): void => {
      this.#points = this.#scatter(this.#points.length);
      this.#draw();
    };
    this.#context.panel.append(
      title("Bounding volumes"),
      element("p", { class: "lead" }, "Drag the points. Each volume contains all of them; the figures show its size and the time to compute it. The fast sphere takes two passes and is at most a few percent larger than the smallest."),
      dimensionChoice([2, 3], this.#dimension, (dimension) => {
        this.#dimension = dimension;
        this.#points = this.#scatter(this.#points.length);
        this.#open();
        this.#draw();
      }),
      section("Area or volume · time", this.#figures.root),
      section("Show", ...toggles),
      section(
        "Points",
        slider({ label: "Points", ...countLimits, value: this.#points.length, onInput: (value) => {
          this.#points = this.#scatter(value);
          this.#draw();
        } }),
        row(button("Scatter again", () => {
          this.#seed += 1;
          scatter();
        })),
      ),
    );
  }
}

function product(values: readonly number[]): number {
  return values.reduce((result, value) => result * value, 1);
}

/** The area or volume inside the triangles of a drawing: the sum of signed cones from the origin. */
function enclosed(drawing: { positions: Float32Array; triangles: Uint32Array }, dimension: 2 | 3): number {
  const corner = (index: number): number[] => {
    const from = (drawing.triangles[index] ?? 0) * dimension;
    return Array.from(drawing.positions.subarray(from, from + dimension));
  };
  let sum = 0;
  for (let i = 0; i < drawing.triangles.length; i += 3) {
    const [[ax = 0, ay = 0, az = 0], [bx = 0, by = 0, bz = 0], [cx = 0, cy = 0, cz = 0]] = [corner(i), corner(i + 1), corner(i + 2)];
    if (dimension === 2) sum += ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2;
    else sum += (ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)) / 6;
  }
  return Math.abs(sum);
}

/** The edges of a volume, connected ones as one polyline; a sphere, which has no edges, as three circles. */
function linesOf(graze: Graze, shape: Shape, dimension: 2 | 3, look: { tone: Tone; dashed: boolean }): Mark[] {
  if (shape.type === "sphere" && dimension === 3) return circlesOfSphere(shape.center, shape.radius, look);
  const { positions, lines } = graze.drawing(shape, { corners: 96 });
  const corner = (index: number): number[] => Array.from(positions.subarray(index * dimension, (index + 1) * dimension));
  const runs: number[][] = [];
  for (let i = 0; i < lines.length; i += 2) {
    const [start = 0, end = 0] = lines.subarray(i, i + 2);
    const run = runs.at(-1);
    if (run?.at(-1) === start) run.push(end);
    else runs.push([start, end]);
  }
  return runs.map((run) => ({ kind: "line", points: run.map(corner), ...look }));
}

function pointsOfText(text: string, dimension: 2 | 3): number[][] | undefined {
  if (text === "") return undefined;
  const points = text.split(";").map((point) => point.split(",").map(Number));
  const isWhole = points.every((point) => point.length === dimension && point.every(Number.isFinite));
  return isWhole && points.length <= countLimits.most ? points : undefined;
}

export const bounding: Chapter = {
  id: "bounding-volumes",
  title: "Bounding volumes",
  open: (context) => new Bounding(context),
};
