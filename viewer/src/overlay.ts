// SPDX-License-Identifier: MIT
// What is drawn over the stage in lines of even width: answers, labels, and handles that a pointer or the arrow keys move.
import type { Point2, Stage } from "./stage";

export type Tone = "answer" | "second" | "third" | "touching-line" | "free-line" | "faint" | "ink";

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
  /** A grip is an invisible ring about a shape's centre, which only the keyboard needs. */
  readonly kind?: "handle" | "grip";
  readonly onFocus?: () => void;
}

export interface Handle extends HandleBase {
  readonly at: Point2;
  readonly onMove: (to: Point2) => void;
}

/** A handle of the plane or of space, where it moves as far from the eye as it is or, `isLevel`, as high. */
export interface SpaceHandle extends HandleBase {
  readonly at: readonly number[];
  readonly isLevel?: boolean;
  readonly onMoveInSpace: (to: readonly number[]) => void;
}

export type AnyHandle = Handle | SpaceHandle;

const svg = "http://www.w3.org/2000/svg";

export class Overlay {
  readonly #root: SVGSVGElement;
  readonly #marks: SVGGElement;
  readonly #handleGroup: SVGGElement;
  readonly #stage: Stage;
  #drawn: readonly Mark[] = [];
  #handles = new Map<string, { handle: AnyHandle; circle: SVGCircleElement }>();

  constructor(root: SVGSVGElement, stage: Stage) {
    this.#root = root;
    this.#stage = stage;
    stage.afterView = () => this.#place();
    this.#marks = root.appendChild(document.createElementNS(svg, "g"));
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

  /** Handles of the same key stay the same elements, so that a drag or the focus goes on. */
  setHandles(handles: readonly AnyHandle[]): void {
    const wanted = new Set(handles.map((handle) => handle.key));
    for (const [key, { circle }] of this.#handles) {
      if (wanted.has(key)) continue;
      circle.remove();
      this.#handles.delete(key);
    }
    for (const handle of handles) {
      const known = this.#handles.get(handle.key);
      if (known !== undefined) known.handle = handle;
      else this.#handles.set(handle.key, { handle, circle: this.#makeHandle(handle) });
      const circle = this.#handles.get(handle.key)?.circle;
      if (circle !== undefined) this.#placeHandle(handle, circle);
    }
  }

  focusHandle(key: string): void {
    this.#handles.get(key)?.circle.focus();
  }

  #place(): void {
    this.#drawMarks();
    for (const { handle, circle } of this.#handles.values()) this.#placeHandle(handle, circle);
  }

  #drawMarks(): void {
    this.#marks.replaceChildren(...this.#drawn.flatMap((mark) => this.#elementsOf(mark)));
  }

  #elementsOf(mark: Mark): SVGElement[] {
    const colour = `var(--${mark.tone})`;
    if (mark.kind === "line") return this.#lineOf(mark, colour);
    if (!this.#stage.isBeforeEye(mark.at)) return [];
    if (mark.kind === "dot") {
      const [cx, cy] = this.#stage.toPixels(mark.at);
      if (mark.hollow === true) return [shape("circle", { cx, cy, r: 4.5, class: "hollow", stroke: colour })];
      return [shape("circle", { cx, cy, r: 4.5, class: "dot", fill: colour })];
    }
    const [x, y] = this.#stage.toPixels(mark.at);
    const [right, down] = mark.shift ?? [0, -12];
    const text = shape("text", { x: x + right, y: y + down, fill: colour });
    text.textContent = mark.text;
    return [text];
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

  /** The parts of a line that lie before the eye. */
  #runsOf(points: readonly (readonly number[])[]): (readonly (readonly number[])[])[] {
    if (points.every((point) => this.#stage.isBeforeEye(point))) return [points];
    return points.slice(1).flatMap((point, index) => {
      const part = this.#stage.partBeforeEye(points[index] ?? point, point);
      return part === undefined ? [] : [part];
    });
  }

  #placeHandle(handle: AnyHandle, circle: SVGCircleElement): void {
    const [x, y] = this.#stage.toPixels(handle.at);
    circle.setAttribute("cx", String(x));
    circle.setAttribute("cy", String(y));
    circle.style.display = this.#stage.isBeforeEye(handle.at) ? "" : "none";
  }

  #makeHandle(handle: AnyHandle): SVGCircleElement {
    const isGrip = handle.kind === "grip";
    const circle = shape("circle", { class: isGrip ? "grip" : "handle", r: isGrip ? 10 : 6.5, tabindex: 0, role: "button" });
    circle.setAttribute("aria-label", `${handle.label}; arrow keys move it`);
    circle.dataset["key"] = handle.key;
    const current = (): AnyHandle => this.#handles.get(handle.key)?.handle ?? handle;
    circle.addEventListener("focus", () => current().onFocus?.());
    circle.addEventListener("pointerdown", (event) => {
      circle.setPointerCapture(event.pointerId);
      event.preventDefault();
      circle.focus();
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
    this.#handleGroup.append(circle);
    return circle;
  }

  #move(handle: AnyHandle, to: { clientX: number; clientY: number }): void {
    if ("onMoveInSpace" in handle) handle.onMoveInSpace(this.#stage.pointAt(to, handle.at, handle.isLevel));
    else handle.onMove(this.#stage.planePoint(to));
  }
}

/** How high a point of space is above a level: a line straight down. Nothing for a point of the plane. */
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
