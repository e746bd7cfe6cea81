// SPDX-License-Identifier: MIT
// Play, pause and single steps.
import { button, row } from "./panel";
import type { Stage } from "./stage";

/** The duration of a step in the world, independent of the time to calculate it. */
export const stepSeconds = 1 / 60;

export class Player {
  readonly root: HTMLElement;
  readonly #stage: Stage;
  readonly #step: () => void;
  readonly #single: () => void;
  readonly #play: HTMLButtonElement;
  #isPlaying: boolean;

  /** Animations start paused if the system requests reduced motion. `single` is called by the button for one step; by
   * default it makes a step. */
  constructor(stage: Stage, isPlaying: boolean, step: () => void, single = step) {
    this.#stage = stage;
    this.#step = step;
    this.#single = single;
    this.#isPlaying = isPlaying && !window.matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.#play = button("", () => this.toggle(), "Space");
    this.#play.id = "play";
    const one = button("Step", () => this.stepOnce(), "Full stop");
    one.id = "step";
    this.root = row(this.#play, one);
    this.#label();
    stage.animate(() => {
      if (this.#isPlaying) this.#step();
      return this.#isPlaying;
    });
  }

  get isPlaying(): boolean {
    return this.#isPlaying;
  }

  toggle(): void {
    this.#isPlaying = !this.#isPlaying;
    this.#label();
    this.#stage.invalidate();
  }

  stepOnce(): void {
    if (this.#isPlaying) this.toggle();
    this.#single();
    this.#stage.invalidate();
  }

  onKey(event: KeyboardEvent): boolean {
    const onButton = event.target instanceof HTMLButtonElement;
    if (event.key === " " && !onButton) this.toggle();
    else if (event.key === ".") this.stepOnce();
    else return false;
    return true;
  }

  #label(): void {
    this.#play.textContent = this.#isPlaying ? "❚❚ Pause" : "▶ Play";
  }
}
