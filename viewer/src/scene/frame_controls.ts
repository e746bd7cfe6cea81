// SPDX-License-Identifier: MIT
// The slider of a scene's frames, with play, pause, single steps and speed.
import { element } from "../dom";
import { slider } from "../panel";
import { Player } from "../player";
import type { Stage } from "../stage";
import type { Timeline } from "./timeline";

const speeds = { least: 1, most: 240, usual: 30 } as const;

export class FrameControls {
  readonly root: HTMLElement;
  readonly #player: Player;
  readonly #input: HTMLInputElement;
  readonly #frames: number;
  #perSecond: number = speeds.usual;
  /** With the elapsed fraction of a frame. */
  #place = 0;
  #last: number | undefined;

  /** Calls `onFrame` for every frame that is shown except the first. */
  constructor(stage: Stage, timeline: Timeline, onFrame: (frame: number) => void) {
    this.#frames = timeline.frames;
    const bar = slider({
      label: "Frame", least: 0, most: timeline.frames - 1, value: 0,
      text: (frame) => `${frame} of ${timeline.frames - 1} ${timeline.timeOf(frame)}`.trim(),
      onInput: (frame) => {
        if (Math.floor(this.#place) !== frame) this.#place = frame;
        onFrame(frame);
      },
    });
    const input = bar.querySelector("input");
    if (input === null) throw new Error("a slider has an input");
    input.id = "frame";
    this.#input = input;
    this.#player = new Player(stage, false, () => this.#advance(), () => this.show((this.frame + 1) % this.#frames));
    const speed = slider({
      label: "Frames a second", least: speeds.least, most: speeds.most, value: speeds.usual, logarithmic: true,
      onInput: (value) => (this.#perSecond = value),
    });
    this.root = element("section", { id: "frames" }, element("h2", {}, "Frames"), this.#player.root, bar, speed);
  }

  get frame(): number {
    return this.#input.valueAsNumber;
  }

  /** Shows the nearest existing frame. */
  show(frame: number): void {
    const kept = Math.min(this.#frames - 1, Math.max(0, Math.round(frame)));
    if (kept === this.frame) return;
    this.#input.value = String(kept);
    this.#input.dispatchEvent(new Event("input"));
  }

  onKey(event: KeyboardEvent): boolean {
    this.#last = undefined;
    if (event.key === ",") this.show((this.frame + this.#frames - 1) % this.#frames);
    else return this.#player.onKey(event);
    return true;
  }

  /** Advances by the number of frames for the time since the last picture; restarts after the last one. */
  #advance(): void {
    const now = performance.now();
    const seconds = Math.min(0.25, (now - (this.#last ?? now)) / 1000);
    this.#last = now;
    this.#place = (this.#place + seconds * this.#perSecond) % this.#frames;
    this.show(Math.floor(this.#place));
  }
}
