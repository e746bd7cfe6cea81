// SPDX-License-Identifier: MIT
// A capsule that walks, jumps and falls among shapes: `slide` moves it, and `contactsWith` tells what it touches.
import type { Scene, Shape } from "graze";

import { dot, lengthOf, minus, plus, times } from "./vectors";

const radius = 0.3;
const height = 1.2;
const speed = 4;
const gravity = 20;
/** It jumps 2.1 high. */
const jumpSpeed = 9.2;

/** The capsule stays this far from everything, and touches what is at most twice as far away. */
const clearance = 0.01;
const feeler = 2 * clearance;

/** Angles closer than this are equal, in degrees. */
const sameAngle = 1e-6;

export interface WalkerLook {
  /** The steepest ground that it can stand on, in degrees. */
  readonly slope: number;
  /** The highest step that it climbs. */
  readonly step: number;
}

/** Where it touches a shape. */
export interface WalkerTouch {
  readonly id: number;
  readonly points: readonly (readonly number[])[];
  /** From the shape to the capsule. */
  readonly normal: readonly number[];
  /** The slope of the shape's surface there in degrees: 0 for level ground, 90 for a wall, more for a ceiling. */
  readonly slope: number;
}

export class Walker {
  look: WalkerLook;
  readonly #scene: Scene;
  readonly #up: readonly number[];
  #place: readonly number[];
  /** The speed upwards. */
  #rise = 0;
  #touches: readonly WalkerTouch[] = [];
  #isStill = false;
  /** The number of slides and their time in milliseconds, of which older ones count less and less. */
  #slides = { count: 0, spent: 0 };

  constructor(scene: Scene, place: readonly number[], look: WalkerLook) {
    [this.#scene, this.#place, this.look] = [scene, place, look];
    this.#up = place.map((_, axis) => (axis === place.length - 1 ? 1 : 0));
    this.feel();
  }

  /** The lowest point of the capsule. */
  get place(): readonly number[] {
    return this.#place;
  }

  /** The center of the capsule. */
  get middle(): readonly number[] {
    return this.#above(height / 2);
  }

  get shape(): Shape {
    return this.#grown(0);
  }

  get touches(): readonly WalkerTouch[] {
    return this.#touches;
  }

  /** What it stands on: the most level of the ground that it touches. */
  get ground(): WalkerTouch | undefined {
    const ground = this.#touches.filter(({ slope }) => slope <= this.look.slope + sameAngle);
    return ground.sort((a, b) => a.slope - b.slope)[0];
  }

  /** True after a step in which it has not moved; without a new wish it would not move in the next one either. */
  get isStill(): boolean {
    return this.#isStill;
  }

  /** The mean duration of the last slides, in milliseconds; undefined before the first. A browser's clock is too coarse
   * for one. */
  get spent(): number | undefined {
    const { count, spent } = this.#slides;
    return count > 0 ? spent / count : undefined;
  }

  /** Updates what it touches, after the shapes have changed. */
  feel(): void {
    this.#isStill = false;
    this.#touches = this.#scene.contactsWith(this.#grown(feeler)).map(({ id, points, normal }) => ({
      id,
      points: different(points.map(({ pointB }) => pointB)),
      normal: times(normal, -1),
      slope: (Math.acos(Math.max(-1, Math.min(1, -dot(normal, this.#up)))) * 180) / Math.PI,
    }));
  }

  /** Puts it somewhere else. */
  put(place: readonly number[]): void {
    this.#place = place;
    this.#rise = 0;
    this.feel();
  }

  /** Slides towards a point without falling, as far as the shapes let it. */
  pull(middle: readonly number[]): void {
    this.#rise = 0;
    this.#slide(minus(middle, this.middle));
    this.feel();
  }

  /** Walks for some seconds in a horizontal direction of length 1 or 0. */
  step(direction: readonly number[], jumps: boolean, seconds: number): void {
    const before = this.#place;
    const stood = this.ground !== undefined && this.#rise <= 0;
    if (stood) this.#rise = jumps ? jumpSpeed : 0;
    else this.#rise -= gravity * seconds;
    const wanted = this.#rise * seconds;
    const moved = this.#slide(plus(times(direction, speed * seconds), times(this.#up, wanted)));
    this.feel();
    if (stood && !jumps && this.ground === undefined) this.#followGround(seconds);
    // What stops a fall or a jump ends it.
    const actual = dot(moved, this.#up) / seconds;
    if (!stood || jumps) this.#rise = this.#rise > 0 ? Math.max(0, Math.min(this.#rise, actual)) : Math.min(0, Math.max(this.#rise, actual));
    const rests = this.#touches.length > 0 && Math.abs(this.#rise) < 1e-3;
    this.#isStill = rests && lengthOf(minus(this.#place, before)) < 1e-7;
  }

  #slide(motion: readonly number[]): readonly number[] {
    const { slope, step } = this.look;
    const options = { up: this.#up, maxSlope: (slope * Math.PI) / 180, stepHeight: step, clearance };
    const start = performance.now();
    const path = this.#scene.slide(this.shape, motion, options);
    const { count, spent } = this.#slides;
    this.#slides = { count: 0.98 * count + 1, spent: 0.98 * spent + performance.now() - start };
    this.#place = plus(this.#place, path.motion);
    return path.motion;
  }

  /** Stays on ground that falls away: down a slope or a step. */
  #followGround(seconds: number): void {
    const reach = this.look.step + speed * seconds * Math.tan((this.look.slope * Math.PI) / 180) + feeler;
    const hit = this.#scene.shapeCast(this.shape, times(this.#up, -reach), { ignoreInitialTouch: true });
    if (hit === null || -dot(hit.normal, this.#up) < Math.cos(((this.look.slope + sameAngle) * Math.PI) / 180)) return;
    this.#place = plus(this.#place, times(this.#up, -Math.max(0, hit.t * reach - clearance)));
    this.feel();
  }

  #above(rise: number): readonly number[] {
    return plus(this.#place, times(this.#up, rise));
  }

  #grown(by: number): Shape {
    return { type: "capsule", a: [...this.#above(radius)], b: [...this.#above(height - radius)], radius: radius + by };
  }
}

/** Without points that are the same up to rounding. */
function different(points: readonly (readonly number[])[]): readonly (readonly number[])[] {
  const isSame = (a: readonly number[], b: readonly number[]): boolean => lengthOf(minus(a, b)) < 1e-9;
  return points.filter((point, index) => points.findIndex((other) => isSame(point, other)) === index);
}
