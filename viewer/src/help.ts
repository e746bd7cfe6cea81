// SPDX-License-Identifier: MIT
import { element } from "./dom";

const keys: readonly (readonly [string, string])[] = [
  ["1 … 7", "the chapters"],
  ["Tab", "the next shape, handle or control"],
  ["← → ↑ ↓", "move the shape or handle that has the focus, else the view; with Shift ten times as far, with Alt a pixel"],
  ["[ ]", "turn the selected shape, in space about the upright axis"],
  ["{ }", "in space: tilt it about the line of sight"],
  ["< >", "make it smaller or larger"],
  ["Delete", "remove it"],
  ["Escape", "select nothing"],
  ["Space", "play and pause"],
  [". ,", "one step; in the scene a frame on or back"],
  ["/ Z", "in the scene: search, zoom to what is selected"],
  ["+ − 0", "zoom in, out, show all"],
  ["T", "light or dark"],
  ["?", "this help"],
];

/** The help that `?` opens and closes. */
export class HelpDialog {
  readonly #dialog: HTMLDialogElement;

  constructor(dialog: HTMLDialogElement) {
    this.#dialog = dialog;
    const list = keys.flatMap(([key, meaning]) => [
      element("dt", {}, ...key.split(" ").flatMap((part) => [element("kbd", {}, part), " "])),
      element("dd", {}, meaning),
    ]);
    dialog.append(
      element("h2", { id: "help-heading" }, "Keys"),
      element("dl", {}, ...list),
      element("p", {}, "With a pointer: drag shapes and handles; drag the ground to move the view, in space to turn it; in space a shape that is dragged stays as far from the eye, with Shift as high; wheel or pinch to zoom."),
      element("p", {}, "Everything is calculated by graze itself, compiled to WebAssembly; times are measured in this browser. The address bar holds what you see: copy it to show it to somebody. Nothing leaves your machine."),
      element("button", { type: "button", onclick: () => dialog.close() }, "Close"),
    );
    dialog.addEventListener("keydown", (event) => {
      if (event.key === "?") dialog.close();
    });
  }

  get isOpen(): boolean {
    return this.#dialog.open;
  }

  toggle(): void {
    if (this.#dialog.open) this.#dialog.close();
    else this.#dialog.showModal();
  }
}
