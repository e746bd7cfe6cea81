// SPDX-License-Identifier: MIT
import { element } from "./dom";

const keys: readonly (readonly [string, string])[] = [
  ["1 … 9", "the tabs"],
  ["Tab", "the next shape, handle or control"],
  ["← → ↑ ↓", "move the focused shape or handle, or else the view; Shift: ten times as far, Alt: one pixel"],
  ["[ ]", "rotate the selected shape, in 3D about the vertical axis"],
  ["{ }", "in 3D: tilt it about the line of sight"],
  ["< >", "shrink or enlarge it"],
  ["Delete", "remove it"],
  ["Escape", "clear the selection"],
  ["Space", "play or pause; in Walk, where arrows walk: jump"],
  [". ,", "one step; in a scene one frame forward or back"],
  ["/ Z", "in a scene: search, zoom to the selection"],
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
      element("p", {}, "With a pointer: drag shapes and handles; drag the background to pan, in 3D to orbit; scroll or pinch to zoom. In 3D a dragged shape keeps its distance from the camera, with Shift its height."),
      element("p", {}, "graze itself, compiled to WebAssembly, calculates everything; times are measured in this browser. The address holds what you see: copy it to share it. Nothing leaves your machine."),
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
