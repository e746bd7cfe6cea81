// SPDX-License-Identifier: MIT
// What is drawn over the stage with constant line width: results, labels, and handles that the pointer or the arrow
// keys move.
import { aboutPoint, LabelPlaces } from "./label_places";
import type { Point2, Stage } from "./stage";

export type Tone = "answer" | "second" | "third" | "touching-line" | "overlapping-line" | "free-line" | "faint" | "ink";

export type Mark =
  | {
      readonly kind: "line";
      readonly points: readonly (readonly number[])[];
      readonly tone: Tone;
      readonly dashed?: boolean;
      readonly thin?: boolean;
      readonly arrow?: boolean;
    }
  | { readonly kind: "dot"; readonly at: readonly number[]; readonly tone: Tone; readonly hollow?: boolean }
  | { readonly kind: "label"; readonly at: readonly number[]; readonly text: string; readonly tone: Tone; readonly shift?: Point2 };

interface HandleBase {
  readonly key: string;
  readonly label: string;
  /** A grip is an invisible ring around a shape's center, used only with the keyboard. */
  readonly kind?: "handle" | "grip";
  readonly onFocus?: () => void;
}

export interface Handle extends HandleBase {
  readonly at: Point2;
  readonly onMove: (to: Point2) => void;
}

/** A handle in 2D or 3D, where it keeps its distance from the camera or, if `isLevel`, its height. */
export interface SpaceHandle extends HandleBase {
  readonly at: readonly number[];
  readonly isLevel?: boolean;
  readonly onMoveInSpace: (to: readonly number[]) => void;
}

export type AnyHandle = Handle | SpaceHandle;

const svg = "http://www.w3.org/2000/svg";

/** The visible radius of a handle, and the radius that reacts to a finger or a mouse; in pixels. */
const knobRadius = 6.5;
const touchRadius = 16;
const pointerRadius = 10;

interface PlacedHandle {
  handle: AnyHandle;
  readonly circle: SVGCircleElement;
  readonly knob: SVGCircleElement;
}

export class Overlay {
  readonly #root: SVGSVGElement;
  readonly #marks: SVGGElement;
  readonly #labels: SVGGElement;
  readonly #handleGroup: SVGGElement;
  readonly #stage: Stage;
  #drawn: readonly Mark[] = [];
  #handles = new Map<string, PlacedHandle>();

  constructor(root: SVGSVGElement, stage: Stage) {
    this.#root = root;
    this.#stage = stage;
    stage.afterView = () => this.#place();
    this.#marks = root.appendChild(document.createElementNS(svg, "g"));
    this.#labels = root.appendChild(document.createElementNS(svg, "g"));
    this.#handleGroup = root.appendChild(document.createElementNS(svg, "g"));
  }

  clear(): void {
    this.draw([]);
    this.setHandles([]);
  }

  draw(marks: readonly Mark[]): void {
    this.#drawn = marks;
    this.#drawMarks();
  }

  /** Handles with the same key keep their elements, so that a drag or the focus continues. */
  setHandles(handles: readonly AnyHandle[]): void {
    const wanted = new Set(handles.map((handle) => handle.key));
    for (const [key, { circle, knob }] of this.#handles) {
      if (wanted.has(key)) continue;
      circle.remove();
      knob.remove();
      this.#handles.delete(key);
    }
    for (const handle of handles) {
      const placed = this.#handles.get(handle.key) ?? this.#makeHandle(handle);
      placed.handle = handle;
      this.#handles.set(handle.key, placed);
      this.#placeHandle(placed);
    }
    this.#drawLabels();
  }

  focusHandle(key: string): void {
    this.#handles.get(key)?.circle.focus();
  }

  #place(): void {
    for (const placed of this.#handles.values()) this.#placeHandle(placed);
    this.#drawMarks();
  }

  #drawMarks(): void {
    this.#marks.replaceChildren(...this.#drawn.flatMap((mark) => this.#elementsOf(mark)));
    this.#drawLabels();
  }

  /** Labels avoid handles and earlier labels. */
  #drawLabels(): void {
    const seen = [...this.#handles.values()].filter(({ handle }) => handle.kind !== "grip" && this.#stage.isBeforeEye(handle.at));
    const handles = seen.map(({ handle }) => aboutPoint(this.#stage.toPixels(handle.at), knobRadius + 3));
    const places = new LabelPlaces(handles, this.#root.clientWidth, this.#root.clientHeight);
    const labels = this.#drawn.filter((mark) => mark.kind === "label").filter(({ at }) => this.#stage.isBeforeEye(at));
    this.#labels.replaceChildren(
      ...labels.map(({ at, text, tone, shift }) => {
        const [x, y] = places.take(text, this.#stage.toPixels(at), shift ?? [0, -12]);
        const drawn = shape("text", { x, y, fill: `var(--${tone}-ink, var(--${tone}))` });
        drawn.textContent = text;
        return drawn;
      }),
    );
  }

  #elementsOf(mark: Mark): SVGElement[] {
    const colour = `var(--${mark.tone})`;
    if (mark.kind === "line") return this.#lineOf(mark, colour);
    if (mark.kind === "label" || !this.#stage.isBeforeEye(mark.at)) return [];
    const [cx, cy] = this.#stage.toPixels(mark.at);
    if (mark.hollow === true) return [shape("circle", { cx, cy, r: 4.5, class: "hollow", stroke: colour })];
    return [shape("circle", { cx, cy, r: 4.5, class: "dot", fill: colour })];
  }

  #lineOf(mark: Extract<Mark, { kind: "line" }>, colour: string): SVGElement[] {
    const style = `line${mark.dashed === true ? " dashed" : ""}${mark.thin === true ? " thin" : ""}`;
    const runs = this.#runsOf(mark.points).map((run) => run.map((point) => this.#stage.toPixels(point)));
    const drawn: SVGElement[] = runs.map((run) => shape("polyline", { class: style, stroke: colour, points: run.map((at) => at.join(",")).join(" ") }));
    const [before, end] = runs.at(-1)?.slice(-2) ?? [];
    const tip = mark.points.at(-1);
    const hasTip = mark.arrow === true && tip !== undefined && this.#stage.isBeforeEye(tip);
    if (hasTip && before !== undefined && end !== undefined) drawn.push(arrowHead(before, end, colour));
    return drawn;
  }

  /** The parts of a line in front of the camera. */
  #runsOf(points: readonly (readonly number[])[]): (readonly (readonly number[])[])[] {
    if (points.every((point) => this.#stage.isBeforeEye(point))) return [points];
    return points.slice(1).flatMap((point, index) => {
      const part = this.#stage.partBeforeEye(points[index] ?? point, point);
      return part === undefined ? [] : [part];
    });
  }

  #placeHandle({ handle, circle, knob }: PlacedHandle): void {
    const [x, y] = this.#stage.toPixels(handle.at);
    for (const part of [circle, knob]) {
      part.setAttribute("cx", String(x));
      part.setAttribute("cy", String(y));
      part.style.display = this.#stage.isBeforeEye(handle.at) ? "" : "none";
    }
  }

  /** A circle that reacts to the pointer, and a visible knob at its center. */
  #makeHandle(handle: AnyHandle): PlacedHandle {
    const isGrip = handle.kind === "grip";
    const reach = isGrip || window.matchMedia("(pointer: coarse)").matches ? touchRadius : pointerRadius;
    const circle = shape("circle", { class: isGrip ? "grip" : "handle", r: reach, tabindex: 0, role: "button" });
    circle.setAttribute("aria-label", `${handle.label}; arrow keys move it`);
    circle.dataset["key"] = handle.key;
    const knob = shape("circle", { class: isGrip ? "no-knob" : "knob", r: knobRadius, "aria-hidden": "true" });
    const current = (): AnyHandle => this.#handles.get(handle.key)?.handle ?? handle;
    circle.addEventListener("focus", () => current().onFocus?.());
    circle.addEventListener("pointerdown", (event) => {
      const nearest = this.#nearestTo(event) ?? circle;
      nearest.setPointerCapture(event.pointerId);
      event.preventDefault();
      nearest.focus();
    });
    circle.addEventListener("pointermove", (event) => {
      if (circle.hasPointerCapture(event.pointerId)) this.#move(current(), event);
    });
    circle.addEventListener("keydown", (event) => {
      const step = arrowStep(event);
      if (step === undefined) return;
      event.preventDefault();
      event.stopPropagation();
      const { left, top } = this.#root.getBoundingClientRect();
      const [x, y] = this.#stage.toPixels(current().at);
      this.#move(current(), { clientX: left + x + step[0], clientY: top + y + step[1] });
    });
    if (isGrip) circle.style.pointerEvents = "none";
    this.#handleGroup.append(circle, knob);
    return { handle, circle, knob };
  }

  /** If handles are close together, the nearest one is dragged. */
  #nearestTo(event: PointerEvent): SVGCircleElement | undefined {
    const { left, top } = this.#root.getBoundingClientRect();
    const distance = ({ handle }: PlacedHandle): number => {
      const [x, y] = this.#stage.toPixels(handle.at);
      return Math.hypot(left + x - event.clientX, top + y - event.clientY);
    };
    const open = [...this.#handles.values()].filter(({ handle }) => handle.kind !== "grip" && this.#stage.isBeforeEye(handle.at));
    return open.sort((a, b) => distance(a) - distance(b))[0]?.circle;
  }

  #move(handle: AnyHandle, to: { clientX: number; clientY: number }): void {
    if ("onMoveInSpace" in handle) handle.onMoveInSpace(this.#stage.pointAt(to, handle.at, handle.isLevel));
    else handle.onMove(this.#stage.planePoint(to));
  }
}

/** Shows the height of a 3D point above a level by a vertical line; nothing in 2D. */
export function plumb([x = 0, y = 0, z]: readonly number[], level: number): Mark[] {
  if (z === undefined) return [];
  const foot = [x, y, level];
  return [
    { kind: "line", points: [[x, y, z], foot], tone: "faint", dashed: true, thin: true },
    { kind: "dot", at: foot, tone: "faint", hollow: true },
  ];
}

const arrowWays: Readonly<Record<string, Point2>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** Arrow keys move by four pixels, with Shift by forty, with Alt by one. */
function arrowStep(event: KeyboardEvent): Point2 | undefined {
  const way = arrowWays[event.key];
  if (way === undefined) return undefined;
  const pixels = event.shiftKey ? 40 : event.altKey ? 1 : 4;
  return [way[0] * pixels, way[1] * pixels];
}

function shape<Tag extends keyof SVGElementTagNameMap>(
  tag: Tag,
  attributes: Record<string, string | number>,
): SVGElementTagNameMap[Tag] {
  const made = document.createElementNS(svg, tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value));
  return made;
}

function arrowHead(before: Point2, end: Point2, colour: string): SVGElement {
  const angle = Math.atan2(end[1] - before[1], end[0] - before[0]);
  const corner = (turn: number): string => {
    return `${end[0] - 10 * Math.cos(angle + turn)},${end[1] - 10 * Math.sin(angle + turn)}`;
  };
  return shape("polygon", { points: `${end.join(",")} ${corner(0.42)} ${corner(-0.42)}`, fill: colour });
}
