// SPDX-License-Identifier: MIT
// Moves, rotates and resizes a selected shape in the engine's representation: handles and keys.
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

export interface HeldShape {
  readonly name: string;
  readonly shape: Shape;
  /** The center of rotation. */
  readonly middle: readonly number[];
  readonly edit: (shape: Shape) => void;
}

/** Rotation is about the vertical axis, tilting about the line of sight, so that the shape follows its handle. */
export function handlesOf(stage: Stage, held: HeldShape, grasp: Grasp): SpaceHandle[] {
  const { name, shape, middle, edit } = held;
  const [x, y] = stage.toPixels(middle);
  const beside = (right: number, down: number): number[] => stage.pointAtPixels([x + right, y + down], middle);
  const offset = (to: readonly number[]): [number, number] => {
    const [toX, toY] = stage.toPixels(to);
    return [toX - x, toY - y];
  };
  const sense = stage.isYDown ? 1 : -1;
  const turning = (key: "turn" | "tilt", axis?: readonly number[]): SpaceHandle => ({
    key, label: `${name}: ${key}`, at: beside(reach * Math.sin(grasp.angles[key]), -reach * Math.cos(grasp.angles[key])),
    onMoveInSpace: (to) => {
      const [right, down] = offset(to);
      const before = grasp.angles[key];
      grasp.angles[key] = Math.atan2(right, -down);
      edit(turnedAbout(shape, (sense * (grasp.angles[key] - before) * 180) / Math.PI, middle, axis));
    },
  });
  const move: SpaceHandle = {
    key: "move", label: `${name}: move`, at: middle,
    onMoveInSpace: (to) => edit(movedBy(shape, minus(to, middle))),
  };
  const size: SpaceHandle = {
    key: "size", label: `${name}: size`, at: beside(grasp.distance, 0),
    onMoveInSpace: (to) => {
      const before = grasp.distance;
      grasp.distance = Math.max(leastReach, Math.hypot(...offset(to)));
      edit(scaledAbout(shape, grasp.distance / before, middle));
    },
  };
  const turns = stage.isFlat ? [turning("turn")] : [turning("turn"), turning("tilt", toEye(stage))];
  return [move, ...(hasSize(shape) ? [size] : []), ...(hasAspects(shape) ? turns : [])];
}

/** Rotates or resizes by a key; returns false for other keys. */
export function editByKey(stage: Stage, held: HeldShape, key: string): boolean {
  const { shape, middle, edit } = held;
  const turn = { "[": degreesOfKey, "]": -degreesOfKey }[key];
  const tilt = stage.isFlat ? undefined : { "{": degreesOfKey, "}": -degreesOfKey }[key];
  const factor = { "<": 1 / factorOfKey, ">": factorOfKey }[key];
  if (turn !== undefined) edit(turnedAbout(shape, turn, middle));
  else if (tilt !== undefined) edit(turnedAbout(shape, tilt, middle, toEye(stage)));
  else if (factor !== undefined) edit(scaledAbout(shape, factor, middle));
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
