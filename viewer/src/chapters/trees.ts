// SPDX-License-Identifier: MIT
// Quad tree and octree: cells that split where boxes are dense, and what a query finds with them. A bounding volume
// hierarchy is shown for comparison.
import type { SpatialIndex } from "graze";

import type { Chapter, ChapterContext, OpenChapter } from "../chapter";
import { Chart } from "../chart";
import { element } from "../dom";
import { BoxCloud } from "../drawing/box_cloud";
import { Grid } from "../drawing/grid";
import { Paint } from "../drawing/paint";
import { MovingBoxes } from "../moving_boxes";
import { count as countText, duration, milliseconds } from "../numbers";
import type { Handle, Mark, SpaceHandle } from "../overlay";
import { choice, dimensionChoice, Figures, section, slider, title, toggle } from "../panel";
import { Player, stepSeconds } from "../player";
import { circleAbout, circlesOfSphere } from "../drawing/circles";
import { numberOf, wordOf } from "../state";
import type { Point2 } from "../stage";
import { timeOf } from "../timing";
import { lengthOf, minus, plus } from "../vectors";

const limits = {
  count: { least: 1, most: 5000, usual: 260 },
  capacity: { least: 1, most: 32, usual: 4 },
  depth: { least: 0, most: 12, usual: 7 },
  crowd: { least: 0, most: 10, usual: 0.3 },
} as const;

type IndexName = "orthtree" | "bvh";

class Trees implements OpenChapter {
  readonly #context: ChapterContext;
  readonly #figures = new Figures();
  readonly #chart = new Chart();
  readonly #player: Player | undefined;
  #dimension: 2 | 3;
  #indexName: IndexName;
  #count: number;
  #capacity: number;
  #depth: number;
  #showsCells = true;
  #query: { center: Point2; radius: number };
  #boxes!: MovingBoxes;
  #index!: SpatialIndex;
  #keys: Float64Array = new Float64Array(0);
  #places = new Map<number, number>();
  #coordinates = new Float32Array(0);
  #cloud!: BoxCloud;
  #cells!: BoxCloud;

  constructor(context: ChapterContext) {
    this.#context = context;
    const { parameters, stage } = context;
    this.#dimension = wordOf(parameters, "dimension", ["2", "3"]) === "3" ? 3 : 2;
    this.#indexName = wordOf(parameters, "index", ["orthtree", "bvh"]);
    this.#count = Math.round(numberOf(parameters, "count", limits.count));
    this.#capacity = Math.round(numberOf(parameters, "capacity", limits.capacity));
    this.#depth = Math.round(numberOf(parameters, "depth", limits.depth));
    const place = (name: string, usual: number): number => numberOf(parameters, name, { least: -2, most: 2, usual });
    this.#query = {
      center: [place("x", 0.35), place("y", -0.3)],
      radius: numberOf(parameters, "radius", { least: 0, most: 2, usual: 0.28 }),
    };
    this.#begin();
    const player = new Player(stage, parameters.get("play") !== "no", () => this.#step());
    this.#player = player;
    this.#fillPanel(player);
    this.#show();
  }

  parameters(): URLSearchParams {
    const { center, radius } = this.#query;
    return new URLSearchParams({
      dimension: String(this.#dimension),
      index: this.#indexName,
      count: String(this.#count),
      capacity: String(this.#capacity),
      depth: String(this.#depth),
      x: center[0].toFixed(3),
      y: center[1].toFixed(3),
      radius: radius.toFixed(3),
      play: this.#player?.isPlaying === true ? "yes" : "no",
    });
  }

  onKey(event: KeyboardEvent): boolean {
    const used = this.#player?.onKey(event) === true;
    if (used) this.#context.changed();
    return used;
  }

  close(): void {
    this.#index.delete();
  }

  #begin(): void {
    const { stage, overlay } = this.#context;
    this.#boxes = new MovingBoxes({ dimension: this.#dimension, count: this.#count, seed: 7, crowd: limits.crowd.usual });
    this.#coordinates = new Float32Array(this.#count * 2 * this.#dimension);
    this.#boxes.write(this.#coordinates);
    this.#makeIndex();
    overlay.clear();
    stage.clearDrawing();
    const isFlat = this.#dimension === 2;
    const cloud = new BoxCloud(this.#dimension, stage.palette, isFlat ? { fill: 0.6, edge: 1 } : { fill: 1, edge: 1 });
    const cells = new BoxCloud(this.#dimension, stage.palette, { fill: 0, edge: isFlat ? 0.8 : 0.25, width: 0.8 });
    cloud.resize(this.#count);
    stage.onTheme(() => {
      cloud.setPalette(stage.palette);
      cells.setPalette(stage.palette);
    });
    stage.world.add(cloud.object, cells.object);
    [this.#cloud, this.#cells] = [cloud, cells];
    // The cells extend beyond the boxes.
    const far = isFlat ? 1.1 : 1.3;
    const extent = { min: [-far, -far, -far], max: [far, far, far] };
    if (isFlat) {
      stage.showFlat(extent);
      new Grid(stage);
    } else {
      stage.showDeep(extent);
    }
    this.#chart.clear();
  }

  #makeIndex(): void {
    const { graze } = this.#context;
    const options = { capacity: this.#capacity, maxDepth: this.#depth };
    if (this.#indexName === "bvh") this.#index = new graze.Bvh(this.#dimension, { margin: 0.01 });
    else this.#index = this.#dimension === 2 ? new graze.QuadTree(options) : new graze.Octree(options);
    this.#keys = this.#index.insertMany(this.#coordinates);
    this.#places = new Map(Array.from(this.#keys, (key, place) => [key, place]));
  }

  #reindex(): void {
    this.#index.delete();
    this.#makeIndex();
    this.#show();
    this.#context.changed();
  }

  #restart(): void {
    this.#index.delete();
    this.#begin();
    this.#show();
    this.#context.changed();
  }

  #step(): void {
    this.#boxes.step(stepSeconds);
    this.#boxes.write(this.#coordinates);
    const start = performance.now();
    this.#index.updateMany(this.#keys, this.#coordinates);
    this.#chart.add(performance.now() - start);
    this.#show();
  }

  #show(): void {
    const { stage, overlay } = this.#context;
    const found = this.#index.query(this.#region());
    this.#cloud.paints.fill(Paint.free);
    for (const key of found) this.#cloud.paints[this.#places.get(key) ?? 0] = Paint.overlapping;
    this.#cloud.boxes.set(this.#coordinates);
    this.#cloud.boxesChanged();
    this.#cloud.paintsChanged();
    const cells = this.#index.cells();
    this.#cells.resize(this.#showsCells ? cells.depths.length : 0);
    if (this.#showsCells) {
      this.#cells.boxes.set(cells.boxes);
      for (let i = 0; i < cells.depths.length; ++i) this.#cells.paints[i] = this.#showsCell(cells, i) ? Paint.faint : Paint.hidden;
    }
    const deepest = cells.depths.reduce((most, depth) => Math.max(most, depth), 0);
    this.#figures.set("boxes", "Boxes", countText(this.#count));
    this.#figures.set("cells", this.#indexName === "bvh" ? "Nodes" : "Cells", countText(cells.depths.length));
    this.#figures.set("depth", "Levels", String(deepest + 1));
    this.#figures.set("found", "Found by the query", countText(found.length));
    this.#figures.set("query-time", "Time of the query", this.#player?.isPlaying === true ? "–" : duration(timeOf(() => this.#index.query(this.#region()))));
    this.#figures.set("time", "Moving all boxes", milliseconds(this.#chart.median));
    overlay.draw(this.#queryMarks(found.length));
    overlay.setHandles(this.#dimension === 2 ? this.#handles() : this.#handles().map(levelled));
    stage.invalidate();
  }

  /** The leaves of a hierarchy are the boxes themselves. */
  #showsCell(cells: { leaves: Uint8Array }, cell: number): boolean {
    return this.#indexName === "orthtree" || cells.leaves[cell] !== 1;
  }

  #region(): { type: "sphere"; center: number[]; radius: number } {
    const { center, radius } = this.#query;
    return { type: "sphere", center: this.#dimension === 2 ? [...center] : [...center, 0], radius };
  }

  #queryMarks(found: number): Mark[] {
    const { center, radius } = this.#query;
    const label = { kind: "label", at: plus(center, [0, radius]), text: `${found} found`, tone: "answer" } as const;
    if (this.#dimension === 3) return [...circlesOfSphere([...center, 0], radius, { tone: "answer" }), label];
    return [{ kind: "line", points: circleAbout(center, radius), tone: "answer" }, label];
  }

  #handles(): Handle[] {
    const { center, radius } = this.#query;
    const changed = (query: { center: Point2; radius: number }): void => {
      this.#query = query;
      this.#show();
      this.#context.changed();
    };
    return [
      { key: "center", label: "Center of the query", at: center, onMove: (to) => changed({ center: to, radius }) },
      {
        key: "radius", label: "Radius of the query", at: plus(center, [radius, 0]),
        onMove: (to) => changed({ center, radius: lengthOf(minus(to, center)) }),
      },
    ];
  }

  #fillPanel(player: Player): void {
    const whole = (label: string, range: { least: number; most: number }, value: number, set: (value: number) => void): HTMLElement =>
      slider({ label, ...range, value, onInput: set });
    const limitsOfCells = [
      whole("Capacity of a cell", limits.capacity, this.#capacity, (value) => {
        this.#capacity = value;
        this.#reindex();
      }),
      whole("Greatest depth", limits.depth, this.#depth, (value) => {
        this.#depth = value;
        this.#reindex();
      }),
    ];
    for (const control of limitsOfCells) control.hidden = this.#indexName === "bvh";
    this.#context.panel.append(
      title("Quad tree and octree"),
      element("p", { class: "lead" }, "A cell with too many boxes splits into four, in 3D into eight, and merges again when they leave. Drag the circle: the tree finds the boxes it overlaps without visiting the rest."),
      player.root,
      this.#figures.root,
      section(
        "Index",
        dimensionChoice([2, 3], this.#dimension, (dimension) => {
          this.#dimension = dimension;
          this.#restart();
        }),
        choice<IndexName>("Index", [["orthtree", "Quad tree, octree"], ["bvh", "BVH"]], this.#indexName, (word) => {
          this.#indexName = word;
          for (const control of limitsOfCells) control.hidden = word === "bvh";
          this.#reindex();
        }),
        toggle("Show cells", true, (on) => {
          this.#showsCells = on;
          this.#show();
        }),
        ...limitsOfCells,
        slider({
          label: "Boxes", ...limits.count, value: this.#count, logarithmic: true, text: countText,
          onInput: (value) => {
            this.#count = value;
            this.#restart();
          },
        }),
      ),
    );
  }
}

/** In 3D a handle stays at height zero. */
function levelled({ at, onMove, ...rest }: Handle): SpaceHandle {
  return { ...rest, at: [...at, 0], isLevel: true, onMoveInSpace: ([x = 0, y = 0]) => onMove([x, y]) };
}

export const trees: Chapter = {
  id: "trees",
  title: "Quad tree",
  open: (context) => new Trees(context),
};
