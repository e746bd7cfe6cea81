// SPDX-License-Identifier: MIT
// Shapes in 2D or 3D that can be dragged, rotated and resized by pointer and keyboard. The engine determines what is
// under the pointer.
import type { Scene, Shape } from "graze";

import type { ChapterContext } from "./chapter";
import { cornersFor, drawingsOf } from "./drawing/drawings";
import { MeshDrawing } from "./drawing/mesh_drawing";
import { Paint, paintOf } from "./drawing/paint";
import { degreesOfKey, editByKey, factorOfKey, Grasp, handlesOf, heldShape } from "./held_shape";
import type { AnyHandle, Mark } from "./overlay";
import { gripsOf } from "./shapes/flat_edit";
import type { ShapeType } from "./shapes/flat_shape";
import { asFlat, type ShapeKit } from "./shapes/shape_kit";
import { solidGripsOf } from "./shapes/solid_grips";
import type { Extent } from "./stage";
import { under } from "./under";
import { minus } from "./vectors";

/** The distance of a rotation handle from its shape, in pixels. */
const handleReach = 18;
/** A press on the background that moves farther than this pans the view and keeps the selection. */
const clickReach = 4;

export interface EditorOptions {
  readonly kit: ShapeKit;
  readonly shapes: readonly Shape[];
  /** The index of the selected shape, if any. */
  readonly selected: number;
  /** Called after every change of a shape or of the selection, and when a 2D view has moved. */
  readonly onChange: () => void;
  /** Handles that belong to the chapter instead of a shape. */
  readonly ownHandles: () => readonly AnyHandle[];
}

export class Editor {
  /** The shapes in the engine; their ids are `ids`, in the order of `shapes`. */
  readonly scene: Scene;
  #shapes: Shape[];
  #ids: number[];
  #selected: number | undefined;
  #paints: readonly Paint[] = [];
  #marks: () => readonly Mark[] = () => [];
  #grasp = new Grasp();
  readonly #context: ChapterContext;
  readonly #options: EditorOptions;
  readonly #kit: ShapeKit;
  readonly #drawing: MeshDrawing;
  readonly #selection: MeshDrawing;
  readonly #listening = new AbortController();

  constructor(context: ChapterContext, options: EditorOptions) {
    this.#context = context;
    this.#options = options;
    this.#kit = options.kit;
    const { dimension } = options.kit;
    this.#shapes = dimension === 2 ? [...options.shapes] : options.shapes.map((shape) => context.graze.normalised(shape));
    this.#selected = this.#shapes[options.selected] === undefined ? undefined : options.selected;
    this.scene = new context.graze.Scene(dimension);
    this.#ids = this.#shapes.map((shape) => this.scene.add(shape));
    const { stage } = context;
    this.#drawing = new MeshDrawing(dimension, stage.palette);
    this.#selection = new MeshDrawing(dimension, stage.palette, { fill: 0, lineWidth: 4, isSeenThrough: true });
    this.#selection.object.renderOrder = 1;
    stage.world.add(this.#drawing.object, this.#selection.object);
    stage.onTheme(() => {
      this.#drawing.setPalette(stage.palette);
      this.#selection.setPalette(stage.palette);
    });
    // In 3D the drawing is independent of the view, except for sizes in pixels.
    stage.onView(() => (stage.isFlat ? options.onChange() : this.#drawOver()));
    this.#listen();
  }

  get shapes(): readonly Shape[] {
    return this.#shapes;
  }

  get selected(): number | undefined {
    return this.#selected;
  }

  /** The index in `shapes` of an object of the scene. */
  placeOf(id: number): number {
    return this.#ids.indexOf(id);
  }

  nameOf(place: number): string {
    const type = this.#shapes[place]?.type ?? "point";
    const before = this.#shapes.slice(0, place).filter((shape) => shape.type === type).length;
    const isOnly = this.#shapes.filter((shape) => shape.type === type).length === 1;
    const name = type === "mesh" ? type : this.#kit.names[type];
    return isOnly ? name : `${name} ${before + 1}`;
  }

  add(type: ShapeType): void {
    const { stage } = this.#context;
    const seen = stage.isFlat ? stage.seenPlane() : stage.extent;
    const spread = 0.16 * (this.#shapes.length % 3) - 0.16;
    const share = [0.5 + spread, 0.5 - 0.5 * spread, 0.75];
    const at = seen.min.map((low, axis) => low + ((seen.max[axis] ?? 0) - low) * (share[axis] ?? 0.5));
    const size = ((seen.max[1] ?? 0) - (seen.min[1] ?? 0)) / 9;
    const shape = this.#kit.make(type, at, size);
    this.#ids.push(this.scene.add(shape));
    this.#shapes.push(shape);
    this.select(this.#shapes.length - 1);
  }

  remove(place: number): void {
    const id = this.#ids[place];
    if (id === undefined) return;
    this.scene.remove(id);
    this.#ids.splice(place, 1);
    this.#shapes.splice(place, 1);
    this.select(undefined);
  }

  replace(place: number, shape: Shape): void {
    const id = this.#ids[place];
    if (id === undefined) return;
    this.scene.move(id, shape);
    this.#shapes[place] = shape;
    this.#options.onChange();
  }

  select(place: number | undefined): void {
    this.#selected = place;
    this.#grasp = new Grasp();
    this.#options.onChange();
  }

  /** Draws the shapes in these paints, their marks, and the handles of the selected one. */
  draw(paints: readonly Paint[], marks: () => readonly Mark[]): void {
    [this.#paints, this.#marks] = [paints, marks];
    const { stage, graze } = this.#context;
    const within = stage.isFlat ? beyond(stage.seenPlane()) : { min: [...stage.extent.min], max: [...stage.extent.max] };
    const options = { within, corners: cornersFor(this.#shapes.length, this.#kit.dimension) };
    const painted = this.#shapes.map((shape, place) => paintOf(shape.type, paints[place] ?? Paint.free));
    const drawings = this.#shapes.map((shape) => drawingsOf(graze, shape, this.#kit.dimension, options));
    this.#drawing.set(drawings, Uint8Array.from(painted));
    const selected = this.#selected === undefined ? undefined : drawings[this.#selected];
    this.#selection.set(selected === undefined ? [] : [selected], new Uint8Array([paints[this.#selected ?? 0] ?? 0]));
    this.#drawOver();
    stage.invalidate();
  }

  /** The same after a change of paints and marks alone: fast, because no geometry is rebuilt. */
  recolour(paints: readonly Paint[], marks: () => readonly Mark[]): void {
    [this.#paints, this.#marks] = [paints, marks];
    this.#drawing.setPaints(Uint8Array.from(this.#shapes, (shape, place) => paintOf(shape.type, paints[place] ?? Paint.free)));
    if (this.#selected !== undefined) this.#selection.setPaints(new Uint8Array([paints[this.#selected] ?? 0]));
    this.#drawOver();
    this.#context.stage.invalidate();
  }

  #drawOver(): void {
    const { overlay } = this.#context;
    overlay.draw([...this.#pointMarks(this.#paints), ...this.#marks()]);
    overlay.setHandles([...this.#handles(), ...this.#options.ownHandles()]);
  }

  /** Handles keys for the selected shape; returns true if the key was used. */
  onKey(event: KeyboardEvent): boolean {
    const place = this.#selected;
    if (place === undefined) return false;
    const change: Record<string, () => void> = {
      Delete: () => this.remove(place),
      Backspace: () => this.remove(place),
      Escape: () => this.select(undefined),
    };
    const action = change[event.key];
    action?.();
    return action !== undefined || this.#editByKey(place, event.key);
  }

  #editByKey(place: number, key: string): boolean {
    const shape = this.#shapes[place];
    if (shape === undefined) return false;
    const middle = this.#kit.middleOf(shape);
    if (this.#kit.dimension === 3) {
      return editByKey(this.#context.stage, heldShape("", shape, middle, (edited) => this.replace(place, edited)), key);
    }
    const change: Record<string, () => Shape> = {
      "[": () => this.#kit.turned(shape, degreesOfKey, middle),
      "]": () => this.#kit.turned(shape, -degreesOfKey, middle),
      "<": () => this.#kit.resized(shape, 1 / factorOfKey),
      ">": () => this.#kit.resized(shape, factorOfKey),
    };
    const edited = change[key]?.();
    if (edited !== undefined) this.replace(place, edited);
    return edited !== undefined;
  }

  close(): void {
    this.#listening.abort();
    this.scene.delete();
  }

  /** Points have no visible outline. */
  #pointMarks(paints: readonly Paint[]): Mark[] {
    return this.#shapes.flatMap((shape, place) => {
      if (shape.type === "ray") return [{ kind: "dot", at: [...shape.origin], tone: toneOf(paints[place]) } as const];
      return shape.type === "point" ? [{ kind: "dot", at: [...shape.position], tone: toneOf(paints[place]) } as const] : [];
    });
  }

  #handles(): AnyHandle[] {
    const grips = this.#shapes.map((shape, place): AnyHandle => {
      const at = this.#kit.middleOf(shape);
      return {
        key: `shape-${this.#slotOf(place)}`,
        label: this.nameOf(place),
        at,
        kind: "grip",
        onMoveInSpace: (to) => this.replace(place, this.#kit.moved(shape, minus(to, at))),
        onFocus: () => this.#selected !== place && this.select(place),
      };
    });
    const place = this.#selected;
    const shape = place === undefined ? undefined : this.#shapes[place];
    return place === undefined || shape === undefined ? grips : [...grips, ...this.#handlesOf(place, shape)];
  }

  /** Its corners, ends and sides; in 3D also handles for size and rotation. */
  #handlesOf(place: number, shape: Shape): AnyHandle[] {
    const { stage } = this.#context;
    const name = this.nameOf(place);
    const replace = (edited: Shape): void => this.replace(place, edited);
    const keyOf = (handle: string): string => `grip-${this.#slotOf(place)}-${handle}`;
    if (this.#kit.dimension === 2) {
      return gripsOf(asFlat(shape), handleReach / stage.pixelsPerUnit).map((grip) => ({
        key: keyOf(grip.name), label: `${name}: ${grip.name}`, at: grip.at, onMove: (to) => replace(grip.move(to)),
      }));
    }
    const grips = solidGripsOf(shape).map((grip): AnyHandle => ({
      key: keyOf(grip.name), label: `${name}: ${grip.name}`, at: grip.at, onMoveInSpace: (to) => replace(grip.move(to)),
    }));
    // The shape itself can be dragged; its grip is for the keyboard.
    const handles = handlesOf(stage, heldShape(name, shape, this.#kit.middleOf(shape), replace), this.#grasp);
    return [...grips, ...handles.filter((handle) => handle.key !== "move").map((handle) => ({ ...handle, key: keyOf(handle.key) }))];
  }

  /** A small number that identifies the shape during its lifetime. */
  #slotOf(place: number): number {
    return this.#context.graze.slotOf(this.#ids[place] ?? 0);
  }

  #listen(): void {
    const { canvas } = this.#context.stage;
    const { stage } = this.#context;
    const { signal } = this.#listening;
    let dragged: { place: number; last: readonly number[] } | undefined;
    let pressed: { x: number; y: number } | undefined;
    canvas.addEventListener(
      "pointerdown",
      (event) => {
        const found = under(stage, this.scene, event);
        pressed = found === undefined ? { x: event.clientX, y: event.clientY } : undefined;
        if (found === undefined) return;
        const place = this.placeOf(found.id);
        if (place !== this.#selected) this.select(place);
        if (event.button !== 0) return;
        dragged = { place, last: found.at };
        stage.movesView = false;
        canvas.setPointerCapture(event.pointerId);
      },
      { signal, capture: true },
    );
    canvas.addEventListener(
      "pointermove",
      (event) => {
        if (dragged === undefined) {
          if (event.buttons === 0) canvas.style.cursor = under(stage, this.scene, event) === undefined ? "" : "grab";
          return;
        }
        const at = stage.pointAt(event, dragged.last, event.shiftKey);
        const shape = this.#shapes[dragged.place];
        if (shape !== undefined) this.replace(dragged.place, this.#kit.moved(shape, minus(at, dragged.last)));
        dragged.last = at;
      },
      { signal },
    );
    const release = (event: PointerEvent): void => {
      const isClick = pressed !== undefined && Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) <= clickReach;
      if (isClick && event.type === "pointerup" && this.#selected !== undefined) this.select(undefined);
      [dragged, pressed] = [undefined, undefined];
      stage.movesView = true;
    };
    for (const end of ["pointerup", "pointercancel"] as const) canvas.addEventListener(end, release, { signal });
  }
}

function toneOf(paint: Paint | undefined): Mark["tone"] {
  if (paint === Paint.overlapping) return "overlapping-line";
  return paint === Paint.touching ? "touching-line" : paint === Paint.found ? "answer" : "free-line";
}

/** A box larger than the view, so that the cut edge of a half-space is not visible. */
function beyond(seen: Extent): { min: number[]; max: number[] } {
  const width = (seen.max[0] ?? 0) - (seen.min[0] ?? 0);
  const height = (seen.max[1] ?? 0) - (seen.min[1] ?? 0);
  return {
    min: [(seen.min[0] ?? 0) - width, (seen.min[1] ?? 0) - height],
    max: [(seen.max[0] ?? 0) + width, (seen.max[1] ?? 0) + height],
  };
}
