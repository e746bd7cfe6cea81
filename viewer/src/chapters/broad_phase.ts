// SPDX-License-Identifier: MIT
// Broad phase at scale: all overlapping pairs among thousands of moving boxes, found from scratch in every step.
import type { PairFinder, PairMethod } from "graze";

import type { Chapter, ChapterContext, OpenChapter } from "../chapter";
import { Chart } from "../chart";
import { element } from "../dom";
import { BoxCloud } from "../drawing/box_cloud";
import { Grid } from "../drawing/grid";
import { Paint } from "../drawing/paint";
import { MovingBoxes } from "../moving_boxes";
import { count as countText, counted, milliseconds } from "../numbers";
import { button, choice, dimensionChoice, Figures, row, section, slider, title } from "../panel";
import { Player, stepSeconds } from "../player";
import { numberOf, wordOf } from "../state";

const limits = {
  count: { least: 10, most: 200_000, usual: 10_000 },
  crowd: { least: 0, most: 20, usual: 0.4 },
  seed: { least: 0, most: 4_294_967_295, usual: 1 },
} as const;

class BroadPhase implements OpenChapter {
  readonly #context: ChapterContext;
  readonly #figures = new Figures();
  readonly #chart = new Chart();
  readonly #player: Player;
  readonly #seed: number;
  #dimension: 2 | 3;
  #count: number;
  #crowd: number;
  #method: PairMethod;
  #boxes!: MovingBoxes;
  #finder!: PairFinder<Float32Array>;
  #cloud!: BoxCloud;

  constructor(context: ChapterContext) {
    this.#context = context;
    const { parameters, stage } = context;
    this.#dimension = wordOf(parameters, "dimension", ["3", "2"]) === "2" ? 2 : 3;
    this.#count = Math.round(numberOf(parameters, "count", limits.count));
    this.#crowd = numberOf(parameters, "crowd", limits.crowd);
    this.#seed = Math.round(numberOf(parameters, "seed", limits.seed));
    this.#method = wordOf(parameters, "method", ["automatic", "tree", "dense", "brute_force"]);
    this.#begin();
    this.#player = new Player(stage, parameters.get("play") !== "no", () => this.#step());
    this.#fillPanel();
    this.#find();
  }

  parameters(): URLSearchParams {
    return new URLSearchParams({
      dimension: String(this.#dimension),
      count: String(this.#count),
      crowd: String(this.#crowd),
      seed: String(this.#seed),
      method: this.#method,
      play: this.#player.isPlaying ? "yes" : "no",
    });
  }

  onKey(event: KeyboardEvent): boolean {
    const used = this.#player.onKey(event);
    if (used) this.#context.changed();
    return used;
  }

  close(): void {
    this.#finder.delete();
  }

  #begin(): void {
    const { stage, graze } = this.#context;
    this.#boxes = new MovingBoxes({ dimension: this.#dimension, count: this.#count, seed: this.#seed, crowd: this.#crowd });
    this.#finder = new graze.PairFinder(this.#dimension, this.#count);
    stage.clearDrawing();
    const look = this.#dimension === 2 ? { fill: 0.5, edge: 0.95 } : { fill: 1, edge: 1 };
    const cloud = new BoxCloud(this.#dimension, stage.palette, look);
    cloud.resize(this.#count);
    this.#cloud = cloud;
    stage.onTheme(() => cloud.setPalette(stage.palette));
    stage.world.add(cloud.object);
    const far = this.#boxes.half * 1.05;
    const extent = { min: [-far, -far, -far], max: [far, far, far] };
    if (this.#dimension === 2) stage.showFlat(extent);
    else stage.showDeep(extent);
    if (this.#dimension === 2) new Grid(stage);
    else new Grid(stage, extent);
    this.#chart.clear();
  }

  /** Recreates the world after a control has changed. */
  #restart(): void {
    this.#finder.delete();
    this.#begin();
    this.#find();
    this.#context.changed();
  }

  #step(): void {
    this.#boxes.step(stepSeconds);
    this.#find();
  }

  #find(): void {
    this.#boxes.write(this.#finder.boxes);
    const start = performance.now();
    const pairs = this.#finder.find({ method: this.#method, order: "any" });
    const spent = performance.now() - start;
    this.#cloud.paints.fill(Paint.free);
    for (const box of pairs) this.#cloud.paints[box] = Paint.overlapping;
    const found = pairs.length / 2;
    this.#cloud.boxes.set(this.#finder.boxes);
    this.#cloud.boxesChanged();
    this.#cloud.paintsChanged();
    this.#chart.add(spent);
    this.#show(found);
    this.#context.stage.invalidate();
  }

  #show(found: number): void {
    const median = this.#chart.median;
    this.#figures.set("boxes", "Boxes", countText(this.#boxes.count));
    this.#figures.set("pairs", "Overlapping pairs", countText(found));
    this.#figures.set("time", "Time per step", milliseconds(median));
    this.#figures.set("rate", "Steps per second, engine only", median > 0 ? countText(Math.round(1000 / median)) : "–");
    this.#figures.set("method", "Method", this.#finder.method.replace("_", " "));
    this.#context.say(`${counted(this.#boxes.count, "box").replace(/boxs$/, "boxes")}, ${counted(found, "pair")}`);
  }

  #throwIn(count: number): void {
    this.#boxes.throwIn(count);
    this.#count = this.#boxes.count;
    this.#finder.count = this.#count;
    this.#cloud.resize(this.#count);
    this.#find();
    this.#context.changed();
  }

  #fillPanel(): void {
    const dimension = dimensionChoice([3, 2], this.#dimension, (word) => {
      this.#dimension = word;
      this.#restart();
    });
    const method = choice<PairMethod>(
      "Method",
      [["automatic", "Automatic"], ["tree", "Tree"], ["dense", "Dense"], ["brute_force", "Brute force"]],
      this.#method,
      (word) => {
        this.#method = word;
        this.#chart.clear();
        this.#find();
        this.#context.changed();
      },
    );
    const number = slider({
      label: "Boxes", ...limits.count, value: this.#count, logarithmic: true, text: countText,
      onInput: (value) => {
        this.#count = value;
        this.#restart();
      },
    });
    const crowd = slider({
      label: "Neighbours per box, about", ...limits.crowd, step: 0.1, value: this.#crowd,
      onInput: (value) => {
        this.#crowd = value;
        this.#restart();
      },
    });
    this.#context.panel.append(
      title("Broad phase at scale"),
      element("p", { class: "lead" }, "All boxes move in every step, and every step finds all overlapping pairs from scratch. Boxes that overlap another are orange."),
      this.#player.root,
      this.#figures.root,
      this.#chart.root,
      this.#chart.legend(),
      section("World", dimension, number, crowd, row(button("Add 1 000 boxes", () => this.#throwIn(1000)))),
      section("Method", method, element("p", { class: "lead" }, "With more than a few thousand boxes, brute force takes seconds per step.")),
    );
  }
}

export const broadPhase: Chapter = {
  id: "broad-phase",
  title: "Broad phase",
  open: (context) => new BroadPhase(context),
};
