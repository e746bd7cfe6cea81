// SPDX-License-Identifier: MIT
// How a reader steers: arrow keys and Space, or buttons for pointers and fingers, as long as they are held down.
import { element } from "./dom";

type Way = "left" | "right" | "ahead" | "back" | "jump";

const wayOfKey: Readonly<Record<string, Way>> = { ArrowLeft: "left", ArrowRight: "right", ArrowUp: "ahead", ArrowDown: "back", " ": "jump" };

const buttons: readonly (readonly [Way, string, string])[] = [
  ["left", "←", "Walk left"],
  ["ahead", "↑", "Walk ahead, in 2D jump"],
  ["back", "↓", "Walk back"],
  ["right", "→", "Walk right"],
  ["jump", "Jump", "Jump"],
];

export class WalkKeys {
  /** The buttons. */
  readonly pad = element("div", { class: "row pad", role: "group", "aria-label": "Walk" });
  readonly #onPress: () => void;
  readonly #held = new Set<Way>();
  /** Pressed since the last step, and perhaps released already. */
  readonly #tapped = new Set<Way>();
  readonly #listening = new AbortController();
  #isDragged = false;

  /** `onPress` is called when something is pressed, and when a drag of the capsule ends. */
  constructor(onPress: () => void) {
    this.#onPress = onPress;
    this.pad.append(...buttons.map(([way, text, label]) => this.#button(way, text, label)));
    const { signal } = this.#listening;
    window.addEventListener("keyup", (event) => this.#release(wayOfKey[event.key]), { signal });
    window.addEventListener("blur", () => this.#held.clear(), { signal });
    window.addEventListener("pointerdown", (event) => (this.#isDragged = isCapsule(event.target)), { signal, capture: true });
    for (const end of ["pointerup", "pointercancel"] as const) window.addEventListener(end, () => this.#endDrag(), { signal });
  }

  /** 1, 0 or -1. */
  get right(): number {
    return Number(this.#isOn("right")) - Number(this.#isOn("left"));
  }

  get ahead(): number {
    return Number(this.#isOn("ahead")) - Number(this.#isOn("back"));
  }

  /** In 2D, where nothing is ahead, the up arrow jumps as well. */
  jumps(dimension: 2 | 3): boolean {
    return this.#isOn("jump") || (dimension === 2 && this.#isOn("ahead"));
  }

  get isHeld(): boolean {
    return this.#held.size > 0 || this.#tapped.size > 0;
  }

  /** Whether the pointer holds the capsule, which then does not fall. */
  get isDragged(): boolean {
    return this.#isDragged;
  }

  /** Called after a step. */
  forgetTaps(): void {
    this.#tapped.clear();
  }

  /** Returns true if the key was used. Space presses a button that has the focus. */
  onKey(event: KeyboardEvent): boolean {
    const way = wayOfKey[event.key];
    if (way === undefined || (way === "jump" && event.target instanceof HTMLButtonElement)) return false;
    this.#press(way);
    return true;
  }

  close(): void {
    this.#listening.abort();
  }

  #isOn(way: Way): boolean {
    return this.#held.has(way) || this.#tapped.has(way);
  }

  #press(way: Way): void {
    this.#held.add(way);
    this.#tapped.add(way);
    this.#onPress();
  }

  #release(way: Way | undefined): void {
    if (way !== undefined) this.#held.delete(way);
  }

  /** After a press of a pointer, keys walk instead of changing what was pressed. */
  #endDrag(): void {
    const wasDragged = this.#isDragged;
    this.#isDragged = false;
    const focused = document.activeElement;
    const takesArrows = isCapsule(focused) || (focused instanceof HTMLInputElement && focused.type === "range");
    if (takesArrows && (focused instanceof HTMLElement || focused instanceof SVGElement)) focused.blur();
    if (wasDragged) this.#onPress();
  }

  #button(way: Way, text: string, label: string): HTMLButtonElement {
    const made = element("button", { type: "button", "aria-label": label, title: label }, text);
    made.addEventListener("pointerdown", (event) => {
      made.setPointerCapture(event.pointerId);
      this.#press(way);
    });
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"] as const) made.addEventListener(end, () => this.#release(way));
    made.addEventListener("contextmenu", (event) => event.preventDefault());
    made.addEventListener("click", (event) => {
      if (event.detail > 0) return; // a pointer, which has been heard above
      this.#press(way);
      this.#release(way);
    });
    return made;
  }
}

function isCapsule(target: EventTarget | null): boolean {
  return target instanceof SVGElement && target.dataset["key"] === "walker";
}
