// SPDX-License-Identifier: MIT
// A list of any length, of which only the visible part is in the page.
import type { Relation } from "graze";

import { element } from "../dom";

export interface Row {
  readonly text: string;
  readonly tag: string;
  /** The relation of the closest pair; "apart" for none. */
  readonly relation: Relation;
  readonly isCurrent: boolean;
}

const rowHeight = 32;
/** Browsers do not draw elements higher than several million pixels. */
const mostRows = 200_000;

export class VirtualList {
  readonly root: HTMLElement;
  readonly #list = element("div", { style: "position: relative" });
  readonly #row: (index: number) => Row;
  readonly #onChoose: (index: number) => void;
  #count = 0;

  constructor(label: string, row: (index: number) => Row, onChoose: (index: number) => void) {
    this.#row = row;
    this.#onChoose = onChoose;
    this.root = element("div", { class: "list", role: "group", "aria-label": label }, this.#list);
    this.root.addEventListener("scroll", () => this.#draw());
    this.root.addEventListener("keydown", (event) => this.#onKey(event));
    new ResizeObserver(() => this.#draw()).observe(this.root);
  }

  setCount(count: number): void {
    this.#count = Math.min(count, mostRows);
    this.#list.style.height = `${this.#count * rowHeight}px`;
    this.root.hidden = this.#count === 0;
    this.#draw();
  }

  /** Redraws the visible rows because the result of `row` has changed. */
  refresh(): void {
    this.#draw();
  }

  scrollTo(index: number): void {
    const top = index * rowHeight;
    const { scrollTop, clientHeight } = this.root;
    if (top < scrollTop || top + rowHeight > scrollTop + clientHeight) this.root.scrollTop = top - clientHeight / 2;
    this.#draw();
  }

  #draw(): void {
    const first = Math.max(0, Math.floor(this.root.scrollTop / rowHeight) - 2);
    const last = Math.min(this.#count, first + Math.ceil((this.root.clientHeight || 230) / rowHeight) + 4);
    const focused = document.activeElement instanceof HTMLElement ? document.activeElement.dataset["row"] : undefined;
    const hadFocus = this.root.contains(document.activeElement);
    this.#list.replaceChildren(...Array.from({ length: Math.max(0, last - first) }, (_, i) => this.#make(first + i)));
    if (hadFocus && focused !== undefined) this.#focus(Number(focused));
  }

  #make(index: number): HTMLElement {
    const { text, tag, relation, isCurrent } = this.#row(index);
    return element(
      "button",
      {
        type: "button",
        class: relation,
        "aria-current": String(isCurrent),
        "data-row": index,
        style: `position: absolute; top: ${index * rowHeight}px`,
        onclick: () => this.#onChoose(index),
      },
      element("span", {}, text),
      element("span", { class: "tag" }, tag),
    );
  }

  #onKey(event: KeyboardEvent): void {
    const step = event.key === "ArrowDown" ? 1 : event.key === "ArrowUp" ? -1 : 0;
    const at = event.target instanceof HTMLElement ? event.target.dataset["row"] : undefined;
    if (step === 0 || at === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const next = Math.min(this.#count - 1, Math.max(0, Number(at) + step));
    this.scrollTo(next);
    this.#focus(next);
  }

  #focus(index: number): void {
    this.#list.querySelector<HTMLElement>(`[data-row="${index}"]`)?.focus({ preventScroll: true });
  }
}
