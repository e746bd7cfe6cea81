// SPDX-License-Identifier: MIT
// Values on a grid of points of a plane: a few thousand at a time, from coarse to fine, so that the page answers
// meanwhile.
import type { BuiltMesh } from "graze";

export type Quantity = "winding" | "distance";

/** The grid: the center of its first cell, and the steps to the next one in its row and in its column. */
export interface SliceGrid {
  readonly size: number;
  readonly origin: readonly number[];
  readonly right: readonly number[];
  readonly up: readonly number[];
}

/** How long the page may be busy at a time, in milliseconds. */
const budget = 8;
/** The steps between the points of a pass: each halves that of the one before. */
const coarsest = 8;

export interface SliceProgress {
  /** Values of all cells, row by row; those that are not yet known have the value of a neighbour. */
  readonly values: Float32Array;
  /** From 0 to 1. */
  readonly share: number;
  /** The time spent in the engine so far, in milliseconds, and the points that it has answered. */
  readonly spent: number;
  readonly points: number;
}

/** The sum of the winding numbers of several parts, or the least of the signed distances. */
export class SliceField {
  readonly #onProgress: (progress: SliceProgress) => void;
  #timer: number | undefined;

  constructor(onProgress: (progress: SliceProgress) => void) {
    this.#onProgress = onProgress;
  }

  /** Begins anew; the meshes must exist until it is done or stopped. */
  start(grid: SliceGrid, meshes: readonly BuiltMesh[], quantity: Quantity): void {
    this.stop();
    const work = new SliceWork(grid, meshes, quantity);
    const step = (): void => {
      work.advance(budget);
      this.#timer = work.isDone ? undefined : window.setTimeout(step, 0);
      this.#onProgress(work.progress);
    };
    this.#timer = window.setTimeout(step, 0);
  }

  stop(): void {
    window.clearTimeout(this.#timer);
    this.#timer = undefined;
  }
}

class SliceWork {
  readonly #grid: SliceGrid;
  readonly #meshes: readonly BuiltMesh[];
  readonly #quantity: Quantity;
  readonly #values: Float32Array;
  /** The cells in the order in which they are asked, and how far each value is spread. */
  readonly #cells: Uint32Array;
  readonly #spreads: Uint8Array;
  #done = 0;
  #batch = 64;
  #spent = 0;

  constructor(grid: SliceGrid, meshes: readonly BuiltMesh[], quantity: Quantity) {
    this.#grid = grid;
    this.#meshes = meshes;
    this.#quantity = quantity;
    const { size } = grid;
    this.#values = new Float32Array(size * size);
    this.#cells = new Uint32Array(size * size);
    this.#spreads = new Uint8Array(size * size);
    let next = 0;
    for (let step = coarsest; step >= 1; step /= 2) {
      for (let row = 0; row < size; row += step) {
        for (let column = 0; column < size; column += step) {
          const isKnown = step < coarsest && row % (2 * step) === 0 && column % (2 * step) === 0;
          if (isKnown) continue;
          this.#cells[next] = row * size + column;
          this.#spreads[next++] = step;
        }
      }
    }
  }

  get isDone(): boolean {
    return this.#done === this.#cells.length;
  }

  get progress(): SliceProgress {
    return { values: this.#values, share: this.#done / this.#cells.length, spent: this.#spent, points: this.#done };
  }

  /** Asks for about as long as given. */
  advance(milliseconds: number): void {
    const start = performance.now();
    let now = start;
    while (!this.isDone && now - start < milliseconds) {
      const count = Math.min(this.#batch, this.#cells.length - this.#done);
      this.#ask(count);
      const before = now;
      now = performance.now();
      this.#batch = now - before < milliseconds / 4 ? Math.min(8192, 2 * this.#batch) : Math.max(16, this.#batch / 2);
    }
    this.#spent += now - start;
  }

  #ask(count: number): void {
    const { size, origin, right, up } = this.#grid;
    const points = new Float64Array(3 * count);
    for (let i = 0; i < count; ++i) {
      const cell = this.#cells[this.#done + i] ?? 0;
      const [row, column] = [Math.floor(cell / size), cell % size];
      for (let axis = 0; axis < 3; ++axis) {
        points[3 * i + axis] = (origin[axis] ?? 0) + column * (right[axis] ?? 0) + row * (up[axis] ?? 0);
      }
    }
    const found = fieldAt(this.#meshes, points, this.#quantity);
    for (let i = 0; i < count; ++i) this.#spread(this.#cells[this.#done + i] ?? 0, this.#spreads[this.#done + i] ?? 1, found[i] ?? 0);
    this.#done += count;
  }

  #spread(cell: number, step: number, value: number): void {
    const { size } = this.#grid;
    const [row, column] = [Math.floor(cell / size), cell % size];
    for (let y = row; y < Math.min(size, row + step); ++y) this.#values.fill(value, y * size + column, y * size + Math.min(size, column + step));
  }
}

/** The values at points, three coordinates each. */
export function fieldAt(meshes: readonly BuiltMesh[], points: Float64Array, quantity: Quantity): Float64Array {
  const sum = new Float64Array(points.length / 3).fill(quantity === "winding" ? 0 : Infinity);
  for (const mesh of meshes) {
    const own = quantity === "winding" ? mesh.windingNumbers(points) : mesh.signedDistances(points);
    own.forEach((value, i) => (sum[i] = quantity === "winding" ? (sum[i] ?? 0) + value : Math.min(sum[i] ?? 0, value)));
  }
  return sum;
}
