// SPDX-License-Identifier: MIT
// A chart of recent step times, with a line at the frame time of 60 frames per second.
import { element } from "./dom";
import { milliseconds } from "./numbers";

const kept = 120;
const frame = 1000 / 60;
const svg = "http://www.w3.org/2000/svg";

export class Chart {
  readonly root = document.createElementNS(svg, "svg");
  readonly #line = document.createElementNS(svg, "polyline");
  readonly #limit = document.createElementNS(svg, "line");
  #times: number[] = [];

  constructor() {
    this.root.setAttribute("class", "chart");
    this.root.setAttribute("viewBox", `0 0 ${kept - 1} 100`);
    this.root.setAttribute("preserveAspectRatio", "none");
    this.root.setAttribute("role", "img");
    this.root.setAttribute("aria-label", `Milliseconds per step; the dashed line is ${milliseconds(frame)}, 60 steps a second`);
    this.root.append(this.#limit, this.#line);
    this.root.append(document.createElementNS(svg, "title"));
  }

  /** The median of the recent times, which a single slow step does not change. */
  get median(): number {
    const sorted = [...this.#times].sort((a, b) => a - b);
    return sorted[Math.floor(sorted.length / 2)] ?? 0;
  }

  clear(): void {
    this.#times = [];
  }

  add(time: number): void {
    this.#times.push(time);
    if (this.#times.length > kept) this.#times.shift();
    const top = Math.max(frame * 1.25, ...this.#times);
    const height = (value: number): number => 98 - (value / top) * 94;
    this.#line.setAttribute("points", this.#times.map((value, index) => `${index},${height(value).toFixed(1)}`).join(" "));
    const limit = String(height(frame));
    for (const [name, value] of [["x1", "0"], ["x2", String(kept)], ["y1", limit], ["y2", limit]] as const) {
      this.#limit.setAttribute(name, value);
    }
  }

  legend(): HTMLElement {
    return element("p", { class: "lead" }, `Milliseconds per step; dashed: ${milliseconds(frame)}, which is 60 steps a second.`);
  }
}
