// SPDX-License-Identifier: MIT
// Moves, rotates and resizes a selected thing, such as a shape in the engine's representation: handles and keys.
import type { Shape } from "graze";

import type { SpaceHandle } from "./overlay";
import { movedBy, scaledAbout, turnedAbout } from "./shapes/solid_edit";
import type { Stage } from "./stage";
import { minus } from "./vectors";

/** The initial distance of the rotation and size handles from the center, in pixels, and their minimum distance. */
const reach = 46;
const leastReach = 12;
export const degreesOfKey = 5;
export const factorOfKey = 1.08;

/** The positions of the handles, which stay where they were released. */
export class Grasp {
  /** Distance of the size handle from the center, in pixels. */
  distance = reach;
  /** Angles of the rotation and tilt handles from the vertical, clockwise in radians. */
  angles = { turn: 0, tilt: -Math.PI / 3 };
}

/** What can be held; methods that are missing have no handle and no key. */
export interface Held {
  readonly name: string;
  /** The center of rotation. */
  readonly middle: readonly number[];
  readonly move: (offset: readonly number[]) => void;
  /** About an axis through the center; about the vertical one if none is given. */
  readonly turn?: (degrees: number, axis?: readonly number[]) => void;
  readonly resize?: (factor: number) => void;
}

export function heldShape(name: string, shape: Shape, middle: readonly number[], edit: (shape: Shape) => void): Held {
  const turn = (degrees: number, axis?: readonly number[]): void => edit(turnedAbout(shape, degrees, middle, axis));
  const resize = (factor: number): void => edit(scaledAbout(shape, factor, middle));
  return {
    name, middle,
    move: (offset) => edit(movedBy(shape, offset)),
    ...(hasAspects(shape) ? { turn } : {}),
    ...(hasSize(shape) ? { resize } : {}),
  };
}

/** Rotation is about the vertical axis, tilting about the line of sight, so that the thing follows its handle. */
export function handlesOf(stage: Stage, held: Held, grasp: Grasp): SpaceHandle[] {
  const { name, middle, move, turn, resize } = held;
  const [x, y] = stage.toPixels(middle);
  const beside = (right: number, down: number): number[] => stage.pointAtPixels([x + right, y + down], middle);
  const offset = (to: readonly number[]): [number, number] => {
    const [toX, toY] = stage.toPixels(to);
    return [toX - x, toY - y];
  };
  const sense = stage.isYDown ? 1 : -1;
  const turning = (key: "turn" | "tilt", rotate: (degrees: number, axis?: readonly number[]) => void, axis?: readonly number[]): SpaceHandle => ({
    key, label: `${name}: ${key}`, at: beside(reach * Math.sin(grasp.angles[key]), -reach * Math.cos(grasp.angles[key])),
    onMoveInSpace: (to) => {
      const [right, down] = offset(to);
      const before = grasp.angles[key];
      grasp.angles[key] = Math.atan2(right, -down);
      rotate((sense * (grasp.angles[key] - before) * 180) / Math.PI, axis);
    },
  });
  const moving: SpaceHandle = { key: "move", label: `${name}: move`, at: middle, onMoveInSpace: (to) => move(minus(to, middle)) };
  const sizing = (change: (factor: number) => void): SpaceHandle => ({
    key: "size", label: `${name}: size`, at: beside(grasp.distance, 0),
    onMoveInSpace: (to) => {
      const before = grasp.distance;
      grasp.distance = Math.max(leastReach, Math.hypot(...offset(to)));
      change(grasp.distance / before);
    },
  });
  const turns = turn === undefined ? [] : stage.isFlat ? [turning("turn", turn)] : [turning("turn", turn), turning("tilt", turn, toEye(stage))];
  return [moving, ...(resize === undefined ? [] : [sizing(resize)]), ...turns];
}

/** Rotates or resizes by a key; returns false for other keys. */
export function editByKey(stage: Stage, held: Held, key: string): boolean {
  const turn = { "[": degreesOfKey, "]": -degreesOfKey }[key];
  const tilt = stage.isFlat ? undefined : { "{": degreesOfKey, "}": -degreesOfKey }[key];
  const factor = { "<": 1 / factorOfKey, ">": factorOfKey }[key];
  if (turn !== undefined) held.turn?.(turn);
  else if (tilt !== undefined) held.turn?.(tilt, toEye(stage));
  else if (factor !== undefined) held.resize?.(factor);
  return turn !== undefined || tilt !== undefined || factor !== undefined;
}

function toEye(stage: Stage): number[] {
  return stage.sight.map((value) => -value);
}

function hasSize(shape: Shape): boolean {
  return !["point", "ray", "plane", "half_space"].includes(shape.type);
}

/** Whether rotation changes its appearance. */
function hasAspects(shape: Shape): boolean {
  return !["point", "sphere", "aabb"].includes(shape.type);
}
