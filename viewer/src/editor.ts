// SPDX-License-Identifier: MIT
// Shapes of the plane that can be dragged, turned and resized, by pointer and by keyboard. The engine says what is under
// the pointer.
import type { Scene } from "graze";

import type { ChapterContext } from "./chapter";
import { cornersFor, drawingsOf } from "./drawing/drawings";
import { MeshDrawing } from "./drawing/mesh_drawing";
import { Paint, paintOf } from "./drawing/paint";
import type { Handle, Mark } from "./overlay";
import { gripsOf, middleOf, moved, resized, turned } from "./shapes/edit";
import { minus, newShape, shapeNames, type FlatShape, type FlatType } from "./shapes/flat_shape";
import type { Extent, Point2 } from "./stage";

/** How near to a line or a point the pointer has to be to take hold of it, in pixels. */
const pointerReach = 7;
/** How far a turning handle stands from its shape, in pixels. */
const handleReach = 18;

export interface EditorOptions {
  readonly shapes: readonly FlatShape[];
  /** Called after every change of a shape, of the selection, or of what is seen. */
  readonly onChange: () => void;
  /** Handles that belong to the chapter and not to a shape. */
  readonly ownHandles?: () => readonly Handle[];
}

export class Editor {
  /** The shapes as the engine holds them; ids are those of `ids`, in the order of `shapes`. */
  readonly scene: Scene;
  #shapes: FlatShape[];
  #ids: number[];
  #selected: number | undefined;
  readonly #context: ChapterContext;
  readonly #options: EditorOptions;
  readonly #drawing: MeshDrawing;
  readonly #selection: MeshDrawing;
  readonly #listening = new AbortController();

  constructor(context: ChapterContext, options: EditorOptions) {
    this.#context = context;
    this.#options = options;
    this.#shapes = [...options.shapes];
    this.scene = new context.graze.Scene(2);
    this.#ids = this.#shapes.map((shape) => this.scene.add(shape));
    const { palette } = context.stage;
    this.#drawing = new MeshDrawing(2, palette);
    this.#selection = new MeshDrawing(2, palette, { fill: 0, lineWidth: 4 });
    this.#selection.object.renderOrder = 1;
    context.stage.world.add(this.#drawing.object, this.#selection.object);
    context.stage.onTheme(() => {
      this.#drawing.setPalette(context.stage.palette);
      this.#selection.setPalette(context.stage.palette);
    });
    this.#listen();
  }

  get shapes(): readonly FlatShape[] {
    return this.#shapes;
  }

  get selected(): number | undefined {
    return this.#selected;
  }

  /** The place in `shapes` of an object of the scene. */
  placeOf(id: number): number {
    return this.#ids.indexOf(id);
  }

  nameOf(place: number): string {
    const type = this.#shapes[place]?.type ?? "point";
    const before = this.#shapes.slice(0, place).filter((shape) => shape.type === type).length;
    const isOnly = this.#shapes.filter((shape) => shape.type === type).length === 1;
    return isOnly ? shapeNames[type] : `${shapeNames[type]} ${before + 1}`;
  }

  add(type: FlatType): void {
    const seen = this.#context.stage.seenPlane();
    const spread = 0.16 * (this.#shapes.length % 3) - 0.16;
    const at = (axis: 0 | 1): number => {
      const [low = 0, high = 0] = [seen.min[axis], seen.max[axis]];
      return low + (high - low) * (0.5 + spread * (axis === 0 ? 1 : -0.5));
    };
    const size = ((seen.max[1] ?? 0) - (seen.min[1] ?? 0)) / 9;
    const shape = newShape(type, [at(0), at(1)], size);
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

  replace(place: number, shape: FlatShape): void {
    const id = this.#ids[place];
    if (id === undefined) return;
    this.scene.move(id, shape);
    this.#shapes[place] = shape;
    this.#options.onChange();
  }

  select(place: number | undefined): void {
    this.#selected = place;
    this.#options.onChange();
  }

  /** Draws the shapes in these paints, and the handles of the selected one. */
  draw(paints: readonly Paint[], marks: readonly Mark[]): void {
    const { stage, overlay, graze } = this.#context;
    const options = { within: beyond(stage.seenPlane()), corners: cornersFor(this.#shapes.length, 2) };
    const painted = this.#shapes.map((shape, place) => paintOf(shape.type, paints[place] ?? Paint.free));
    this.#drawing.set(this.#shapes.map((shape) => drawingsOf(graze, shape, options)), Uint8Array.from(painted));
    const selected = this.#selected === undefined ? undefined : this.#shapes[this.#selected];
    this.#selection.set(selected === undefined ? [] : [drawingsOf(graze, selected, options)], new Uint8Array([paints[this.#selected ?? 0] ?? 0]));
    overlay.draw([...this.#pointMarks(paints), ...marks]);
    overlay.setHandles([...this.#handles(), ...(this.#options.ownHandles?.() ?? [])]);
    stage.invalidate();
  }

  /** Keys of the selected shape; true if it was one. */
  onKey(event: KeyboardEvent): boolean {
    const place = this.#selected;
    const shape = place === undefined ? undefined : this.#shapes[place];
    if (place === undefined || shape === undefined) return false;
    const change: Record<string, () => void> = {
      "[": () => this.replace(place, turned(shape, 5)),
      "]": () => this.replace(place, turned(shape, -5)),
      "<": () => this.replace(place, resized(shape, 1 / 1.08)),
      ">": () => this.replace(place, resized(shape, 1.08)),
      Delete: () => this.remove(place),
      Backspace: () => this.remove(place),
      Escape: () => this.select(undefined),
    };
    const action = change[event.key];
    action?.();
    return action !== undefined;
  }

  close(): void {
    this.#listening.abort();
    this.scene.delete();
  }

  /** Points have no outline that could be seen. */
  #pointMarks(paints: readonly Paint[]): Mark[] {
    return this.#shapes.flatMap((shape, place) => {
      if (shape.type === "ray") return [{ kind: "dot", at: shape.origin, tone: toneOf(paints[place]) } as const];
      return shape.type === "point" ? [{ kind: "dot", at: shape.position, tone: toneOf(paints[place]) } as const] : [];
    });
  }

  #handles(): Handle[] {
    const grips = this.#shapes.map((shape, place): Handle => {
      const at = middleOf(shape);
      return {
        key: `shape-${this.#slotOf(place)}`,
        label: this.nameOf(place),
        at,
        kind: "grip",
        onMove: (to) => this.replace(place, moved(shape, minus(to, at))),
        onFocus: () => this.#selected !== place && this.select(place),
      };
    });
    const place = this.#selected;
    const shape = place === undefined ? undefined : this.#shapes[place];
    if (place === undefined || shape === undefined) return grips;
    const own = gripsOf(shape, handleReach / this.#context.stage.pixelsPerUnit).map((grip): Handle => {
      return {
        key: `grip-${this.#slotOf(place)}-${grip.name}`,
        label: `${this.nameOf(place)}: ${grip.name}`,
        at: grip.at,
        onMove: (to) => this.replace(place, grip.move(to)),
      };
    });
    return [...grips, ...own];
  }


  /** A small number that stays the shape's as long as it is there. */
  #slotOf(place: number): number {
    return this.#context.graze.slotOf(this.#ids[place] ?? 0);
  }

  #listen(): void {
    const { canvas } = this.#context.stage;
    const { signal } = this.#listening;
    let dragged: { place: number; last: Point2 } | undefined;
    canvas.addEventListener(
      "pointerdown",
      (event) => {
        const at = this.#context.stage.planePoint(event);
        const place = this.#under(at);
        if (place !== this.#selected) this.select(place);
        if (place === undefined || event.button !== 0) return;
        dragged = { place, last: at };
        this.#context.stage.movesView = false;
        canvas.setPointerCapture(event.pointerId);
      },
      { signal, capture: true },
    );
    canvas.addEventListener(
      "pointermove",
      (event) => {
        const at = this.#context.stage.planePoint(event);
        if (dragged === undefined) {
          if (event.buttons === 0) canvas.style.cursor = this.#under(at) === undefined ? "" : "grab";
          return;
        }
        const shape = this.#shapes[dragged.place];
        if (shape !== undefined) this.replace(dragged.place, moved(shape, minus(at, dragged.last)));
        dragged.last = at;
      },
      { signal },
    );
    for (const end of ["pointerup", "pointercancel"] as const) {
      canvas.addEventListener(
        end,
        () => {
          dragged = undefined;
          this.#context.stage.movesView = true;
        },
        { signal },
      );
    }
  }

  /** The topmost shape within reach of the pointer; half-spaces only where nothing else is. */
  #under(at: Point2): number | undefined {
    const radius = pointerReach / this.#context.stage.pixelsPerUnit;
    const places = Array.from(this.scene.overlapping({ type: "sphere", center: at, radius }), (id) => this.placeOf(id));
    const inFront = places.filter((place) => this.#shapes[place]?.type !== "half_space");
    return (inFront.length > 0 ? inFront : places).sort((a, b) => b - a)[0];
  }
}

function toneOf(paint: Paint | undefined): Mark["tone"] {
  return paint === Paint.touching ? "touching-line" : paint === Paint.found ? "answer" : "free-line";
}

/** A box that reaches beyond what is seen, so that the cut edge of a half-space is not. */
function beyond(seen: Extent): { min: number[]; max: number[] } {
  const width = (seen.max[0] ?? 0) - (seen.min[0] ?? 0);
  const height = (seen.max[1] ?? 0) - (seen.min[1] ?? 0);
  return {
    min: [(seen.min[0] ?? 0) - width, (seen.min[1] ?? 0) - height],
    max: [(seen.max[0] ?? 0) + width, (seen.max[1] ?? 0) + height],
  };
}
