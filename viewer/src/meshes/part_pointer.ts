// SPDX-License-Identifier: MIT
// The pointer over the parts of a model: the face under it, and parts that are dragged.
import type { Stage } from "../stage";
import { minus } from "../vectors";
import type { PartHit } from "./mesh_model";

/** A press that moves farther than this, in pixels, rotates the view and picks nothing. */
const clickReach = 4;

export interface PartPointerOptions {
  /** The face under a position of the pointer. */
  readonly under: (event: PointerEvent) => PartHit | undefined;
  /** Whether parts are dragged now. */
  readonly drags: () => boolean;
  /** The pointer is over a face, or over none, without a button. */
  readonly onHover: (hit: PartHit | undefined) => void;
  readonly onPress: (hit: PartHit | undefined) => void;
  readonly onDrag: (place: number, offset: readonly number[]) => void;
  /** The end of a drag. */
  readonly onDrop: () => void;
}

export class PartPointer {
  readonly #listening = new AbortController();
  readonly #stage: Stage;
  readonly #options: PartPointerOptions;
  #pressed: { readonly x: number; readonly y: number } | undefined;
  #dragged: { readonly place: number; last: readonly number[] } | undefined;

  constructor(stage: Stage, options: PartPointerOptions) {
    this.#stage = stage;
    this.#options = options;
    const { canvas } = stage;
    const { signal } = this.#listening;
    canvas.addEventListener("pointerdown", (event) => this.#press(event), { signal, capture: true });
    canvas.addEventListener("pointermove", (event) => this.#move(event), { signal });
    for (const end of ["pointerup", "pointercancel"] as const) canvas.addEventListener(end, (event) => this.#release(event), { signal });
  }

  close(): void {
    this.#listening.abort();
    this.#stage.movesView = true;
  }

  #press(event: PointerEvent): void {
    this.#pressed = { x: event.clientX, y: event.clientY };
    if (!this.#options.drags() || event.button !== 0) return;
    const hit = this.#options.under(event);
    if (hit === undefined) return;
    this.#options.onPress(hit);
    this.#dragged = { place: hit.place, last: hit.point };
    this.#stage.movesView = false;
    this.#stage.canvas.setPointerCapture(event.pointerId);
  }

  #move(event: PointerEvent): void {
    if (this.#dragged === undefined) {
      if (event.buttons === 0 && event.pointerType !== "touch") this.#options.onHover(this.#options.under(event));
      return;
    }
    const at = this.#stage.pointAt(event, this.#dragged.last, event.shiftKey);
    this.#options.onDrag(this.#dragged.place, minus(at, this.#dragged.last));
    this.#dragged.last = at;
  }

  #release(event: PointerEvent): void {
    const wasDragged = this.#dragged !== undefined;
    const isClick = this.#pressed !== undefined && Math.hypot(event.clientX - this.#pressed.x, event.clientY - this.#pressed.y) <= clickReach;
    [this.#dragged, this.#pressed] = [undefined, undefined];
    this.#stage.movesView = true;
    if (wasDragged) this.#options.onDrop();
    else if (isClick && event.type === "pointerup") this.#options.onPress(this.#options.under(event));
  }
}
