// SPDX-License-Identifier: MIT
// Boxes that move inside a larger box and bounce off its walls. They are moved here; the engine finds the overlaps.
import { randomNumbers } from "./random";

export interface World {
  readonly dimension: 2 | 3;
  readonly count: number;
  readonly seed: number;
  /** The approximate number of others that a box overlaps, if they are evenly distributed. */
  readonly crowd: number;
}

export class MovingBoxes {
  readonly dimension: 2 | 3;
  /** The world extends from -half to half along every axis. */
  readonly half = 1;
  #centers: Float32Array;
  #halves: Float32Array;
  #velocities: Float32Array;
  #random: () => number;

  constructor(world: World) {
    this.dimension = world.dimension;
    this.#random = randomNumbers(world.seed);
    const length = world.count * world.dimension;
    this.#centers = Float32Array.from({ length }, () => (2 * this.#random() - 1) * this.half);
    // Two boxes of width w overlap along an axis of length 2 with probability near w: sizes are from 0.5 to 1.5 times w.
    const width = 2 * Math.min(0.2, (world.crowd / Math.max(1, world.count)) ** (1 / world.dimension) / 2);
    this.#halves = Float32Array.from({ length }, () => (width / 2) * (0.5 + this.#random()));
    this.#velocities = Float32Array.from({ length }, () => (2 * this.#random() - 1) * 0.25);
  }

  get count(): number {
    return this.#centers.length / this.dimension;
  }

  /** Moves all by their velocities and reverses those that have reached a wall. */
  step(seconds: number): void {
    const [centers, velocities] = [this.#centers, this.#velocities];
    for (let i = 0; i < centers.length; ++i) {
      const velocity = velocities[i] ?? 0;
      const next = (centers[i] ?? 0) + velocity * seconds;
      centers[i] = next;
      if (Math.abs(next) > this.half && next * velocity > 0) velocities[i] = -velocity;
    }
  }

  /** Adds similar boxes that fly in from a corner, in one direction with some spread. */
  throwIn(count: number): void {
    const added = count * this.dimension;
    const size = this.#halves.reduce((sum, half) => sum + half, 0) / Math.max(1, this.#halves.length);
    const grown = (old: Float32Array, value: (axis: number) => number): Float32Array => {
      const result = new Float32Array(old.length + added);
      result.set(old);
      for (let i = 0; i < added; ++i) result[old.length + i] = value(i % this.dimension);
      return result;
    };
    this.#centers = grown(this.#centers, () => this.half * (-1 + 0.25 * this.#random()));
    this.#halves = grown(this.#halves, () => size * (0.5 + this.#random()));
    this.#velocities = grown(this.#velocities, () => 0.6 + 0.5 * this.#random());
  }

  /** The boxes in the engine's layout: 2 N numbers each, min, then max. */
  write(boxes: Float32Array): void {
    const [n, centers, halves] = [this.dimension, this.#centers, this.#halves];
    for (let box = 0, from = 0, to = 0; box < centers.length / n; ++box, to += 2 * n) {
      for (let axis = 0; axis < n; ++axis, ++from) {
        const [center, half] = [centers[from] ?? 0, halves[from] ?? 0];
        boxes[to + axis] = center - half;
        boxes[to + n + axis] = center + half;
      }
    }
  }
}
