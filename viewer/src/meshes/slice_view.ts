// SPDX-License-Identifier: MIT
// A plane through the parts, which cuts off what is in front of it and shows how often the surfaces run around each of
// its points, or how far away they are.
import type { Graze } from "graze";

import type { ChapterContext } from "../chapter";
import { element } from "../dom";
import { count as countText, duration, measure } from "../numbers";
import type { Mark, SpaceHandle } from "../overlay";
import { choice, Figures, slider } from "../panel";
import type { Extent } from "../stage";
import { numberOf, pointOf, wordOf, writePoint } from "../state";
import type { MeshModel } from "./mesh_model";
import { setCut } from "./part_drawing";
import { SliceDrawing } from "./slice_drawing";
import { fieldAt, SliceField, type Quantity, type SliceGrid, type SliceProgress } from "./slice_field";

/** Cells of the plane along each side. */
const cells = 256;
/** The plane is wider than the parts by this factor. */
const margin = 1.16;
/** Lines of equal distance across the parts. */
const linesAcross = 24;
/** The drawing follows at least this many milliseconds apart. */
const pause = 90;

const axes = ["x", "y", "z"] as const;
type Axis = (typeof axes)[number];

export interface SliceOptions {
  /** Called when marks and handles have changed. */
  readonly onChange: () => void;
}

export class SliceView {
  readonly root = element("div");
  readonly #context: ChapterContext;
  readonly #options: SliceOptions;
  readonly #figures = new Figures();
  readonly #bar = element("progress", { max: 1, value: 0, "aria-label": "Progress of the slice" });
  readonly #field = new SliceField((progress) => this.#show(progress));
  #drawing: SliceDrawing | undefined;
  #model: MeshModel | undefined;
  #extent: Extent = { min: [-1, -1, -1], max: [1, 1, 1] };
  #axis: Axis;
  #quantity: Quantity;
  #share: number;
  /** As shares of the box around the parts. */
  #probe: readonly number[];
  #shownAt = 0;

  constructor(context: ChapterContext, options: SliceOptions) {
    this.#context = context;
    this.#options = options;
    const { parameters } = context;
    this.#axis = wordOf(parameters, "axis", ["y", "x", "z"]);
    this.#quantity = wordOf(parameters, "show", ["winding", "distance"]);
    this.#share = numberOf(parameters, "at", { least: 0, most: 1, usual: 0.5 });
    this.#probe = pointOf(parameters, "probe-", [0.5, 0.5, 0.5]);
    this.#fill();
  }

  /** Shows the parts of a model, in their places. */
  open(model: MeshModel): void {
    const { graze, stage } = this.#context;
    this.#model = model;
    this.#extent = boxOf(graze, model) ?? model.extent;
    this.#drawing?.close();
    this.#drawing = new SliceDrawing(stage);
    stage.world.add(this.#drawing.object);
    stage.onView(() => this.#cut());
    this.#start();
  }

  describe(parameters: URLSearchParams): void {
    if (this.#axis !== "y") parameters.set("axis", this.#axis);
    if (this.#quantity !== "winding") parameters.set("show", this.#quantity);
    if (this.#share !== 0.5) parameters.set("at", String(Math.round(this.#share * 1e4) / 1e4));
    if (this.#probe.some((value) => value !== 0.5)) writePoint(parameters, "probe-", this.#probe);
  }

  /** Stops, and shows the parts whole again. */
  close(): void {
    this.#field.stop();
    this.#drawing?.object.removeFromParent();
    this.#drawing?.object.geometry.dispose();
    this.#drawing?.object.material.dispose();
    this.#drawing?.close();
    this.#drawing = undefined;
    this.#model = undefined;
    setCut([0, 0, 0], 1);
  }

  handles(): SpaceHandle[] {
    return [
      { key: "slice", label: "The slice", at: this.#edge, onMoveInSpace: (to) => this.#moveTo(to[this.#normal] ?? 0) },
      { key: "probe", label: "The query point", at: this.#point, onMoveInSpace: (to) => this.#moveProbe(to) },
    ];
  }

  marks(): Mark[] {
    const { size, origin, right, up } = this.#grid;
    const corner = (column: number, row: number): number[] => origin.map((value, axis) => value + column * size * (right[axis] ?? 0) + row * size * (up[axis] ?? 0));
    const frame = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1), corner(0, 0)];
    const text = `${this.#quantity === "winding" ? "winding number" : "distance"} ${measure(this.#valueAt(this.#point))}`;
    return [
      { kind: "line", points: frame, tone: "faint", thin: true },
      { kind: "label", at: this.#point, text, tone: "ink" },
    ];
  }

  get #normal(): number {
    return axes.indexOf(this.#axis);
  }

  /** The position of the plane along its normal. */
  get #offset(): number {
    const [low, high] = [this.#extent.min[this.#normal] ?? 0, this.#extent.max[this.#normal] ?? 0];
    return low + this.#share * (high - low);
  }

  get #point(): number[] {
    const { min, max } = this.#extent;
    return this.#probe.map((share, axis) => (axis === this.#normal ? this.#offset : (min[axis] ?? 0) + share * ((max[axis] ?? 0) - (min[axis] ?? 0))));
  }

  /** The middle of an edge of the plane, where it is moved. */
  get #edge(): number[] {
    const { size, origin, right, up } = this.#grid;
    return origin.map((value, axis) => value + 0.5 * size * (right[axis] ?? 0) + size * (up[axis] ?? 0));
  }

  get #grid(): SliceGrid {
    const normal = this.#normal;
    const [across, along] = normal === 2 ? [0, 1] : [normal === 0 ? 1 : 0, 2];
    const { min, max } = this.#extent;
    const widths = max.map((high, axis) => Math.max((high - (min[axis] ?? 0)) * margin, 1e-9));
    const origin = max.map((high, axis) => (high + (min[axis] ?? 0)) / 2 - (widths[axis] ?? 0) / 2 + (widths[axis] ?? 0) / cells / 2);
    origin[normal] = this.#offset;
    const step = (axis: number): number[] => [0, 1, 2].map((each) => (each === axis ? (widths[axis] ?? 0) / cells : 0));
    return { size: cells, origin, right: step(across), up: step(along) };
  }

  get #unit(): number {
    const { min, max } = this.#extent;
    return this.#quantity === "winding" ? 1 : Math.max(...max.map((high, axis) => high - (min[axis] ?? 0))) / linesAcross || 1;
  }

  #valueAt(point: readonly number[]): number {
    const meshes = this.#model?.parts.map(({ mesh }) => mesh) ?? [];
    return fieldAt(meshes, Float64Array.from(point), this.#quantity)[0] ?? 0;
  }

  #moveTo(offset: number): void {
    const [low, high] = [this.#extent.min[this.#normal] ?? 0, this.#extent.max[this.#normal] ?? 0];
    this.#share = high > low ? Math.min(1, Math.max(0, (offset - low) / (high - low))) : 0.5;
    this.#fill();
    this.#start();
  }

  #moveProbe(to: readonly number[]): void {
    const { min, max } = this.#extent;
    this.#probe = this.#probe.map((before, axis) => {
      const width = (max[axis] ?? 0) - (min[axis] ?? 0);
      if (axis === this.#normal || width <= 0) return before;
      const spare = (margin - 1) / 2;
      return Math.min(1 + spare, Math.max(-spare, ((to[axis] ?? 0) - (min[axis] ?? 0)) / width));
    });
    this.#tell();
    this.#options.onChange();
  }

  #start(): void {
    if (this.#model === undefined) return;
    this.#drawing?.place(this.#grid, this.#quantity);
    this.#shownAt = 0;
    this.#field.start(this.#grid, this.#model.parts.map(({ mesh }) => mesh), this.#quantity);
    this.#cut();
    this.#tell();
    this.#options.onChange();
  }

  /** Cuts off the side of the plane on which the camera is. */
  #cut(): void {
    if (this.#drawing === undefined) return;
    const side = (this.#context.stage.sight[this.#normal] ?? 0) > 0 ? -1 : 1;
    const normal = [0, 1, 2].map((axis) => (axis === this.#normal ? side : 0));
    setCut(normal, side * this.#offset);
  }

  #show({ values, share, spent, points }: SliceProgress): void {
    this.#bar.value = share;
    this.#bar.hidden = share === 1;
    const now = performance.now();
    if (share < 1 && now - this.#shownAt < pause) return;
    this.#shownAt = now;
    this.#drawing?.show(values, cells, this.#unit);
    this.#figures.set("points", "Points answered", `${countText(points)} of ${countText(cells * cells)}`);
    this.#figures.set("point-time", "Time for a point", duration(spent / points));
    this.#context.stage.invalidate();
  }

  #tell(): void {
    const value = measure(this.#valueAt(this.#point));
    this.#figures.set("value", "At the point", value);
    this.#context.say(`${this.#quantity === "winding" ? "Winding number" : "Signed distance"} at the point: ${value}`);
  }

  #fill(): void {
    this.root.replaceChildren(
      choice<Quantity>("Quantity", [["winding", "Winding number"], ["distance", "Signed distance"]], this.#quantity, (word) => {
        this.#quantity = word;
        this.#start();
      }),
      choice<Axis>("Axis of the slice", axes.map((axis) => [axis, `Across ${axis}`] as const), this.#axis, (word) => {
        this.#axis = word;
        this.#start();
      }),
      slider({
        label: "Position of the slice", least: 0, most: 1, step: 0.005, value: this.#share, text: (value) => `${(100 * value).toFixed(1)} %`,
        onInput: (value) => {
          this.#share = value;
          this.#start();
        },
      }),
      this.#bar,
      this.#figures.root,
    );
  }
}

/** The box around all parts in their places; undefined without faces. */
function boxOf(graze: Graze, { parts }: MeshModel): Extent | undefined {
  const boxes = parts.map(({ mesh }) => graze.bounds(mesh)).filter(({ min }) => min.every(Number.isFinite));
  if (boxes.length === 0) return undefined;
  const over = (pick: (...values: number[]) => number, side: "min" | "max"): number[] => [0, 1, 2].map((axis) => pick(...boxes.map((box) => box[side][axis] ?? 0)));
  return { min: over(Math.min, "min"), max: over(Math.max, "max") };
}
