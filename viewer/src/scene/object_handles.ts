// SPDX-License-Identifier: MIT
// What a selected object of a scene is moved, turned and resized by: three handles, and keys.
import type { Shape } from "graze";

import type { SpaceHandle } from "../overlay";
import { movedBy, scaledAbout, turnedAbout } from "../shapes/solid_edit";
import type { Stage } from "../stage";
import type { SceneModel } from "./scene_model";

/** How far the handles for turning and resizing first stand from the middle, in pixels, and how near they may come. */
const reach = 46;
const leastReach = 12;
const degreesOfKey = 5;
const factorOfKey = 1.08;

/** Where the two handles stand, which are left where they were let go. */
export class Grasp {
  /** Of the handle for the size from the middle, in pixels. */
  distance = reach;
  /** Of the handle for turning from upright, clockwise in radians. */
  angle = 0;
}

export type Edit = (place: number, shape: Shape) => void;

/** The middle of an object's box; nothing for what is unbounded, which is not edited. */
function middleOf(model: SceneModel, place: number): number[] | undefined {
  const { min, max } = model.scene.object(model.id(place)).box;
  const middle = min.map((low, axis) => (low + (max[axis] ?? low)) / 2);
  return middle.every(Number.isFinite) ? middle : undefined;
}

export function handlesOf(stage: Stage, model: SceneModel, place: number, grasp: Grasp, edit: Edit): SpaceHandle[] {
  const middle = middleOf(model, place);
  if (middle === undefined) return [];
  const name = model.objects[place]?.name ?? "";
  const [x, y] = stage.toPixels(middle);
  const beside = (right: number, down: number): number[] => stage.pointAtPixels([x + right, y + down], middle);
  const offset = (to: readonly number[]): [number, number] => {
    const [toX, toY] = stage.toPixels(to);
    return [toX - x, toY - y];
  };
  const move: SpaceHandle = {
    key: "move", label: `${name}: move`, at: middle,
    onMoveInSpace: (to) => edit(place, movedBy(model.shape(place), to.map((value, axis) => value - (middle[axis] ?? 0)))),
  };
  const size: SpaceHandle = {
    key: "size", label: `${name}: size`, at: beside(grasp.distance, 0),
    onMoveInSpace: (to) => {
      const before = grasp.distance;
      grasp.distance = Math.max(leastReach, Math.hypot(...offset(to)));
      edit(place, scaledAbout(model.shape(place), grasp.distance / before, middle));
    },
  };
  if (model.objects[place]?.type === "aabb" || model.objects[place]?.type === "sphere") return [move, size];
  const sense = stage.isYDown ? 1 : -1;
  const turn: SpaceHandle = {
    key: "turn", label: `${name}: turn`, at: beside(reach * Math.sin(grasp.angle), -reach * Math.cos(grasp.angle)),
    onMoveInSpace: (to) => {
      const [right, down] = offset(to);
      const before = grasp.angle;
      grasp.angle = Math.atan2(right, -down);
      edit(place, turnedAbout(model.shape(place), (sense * (grasp.angle - before) * 180) / Math.PI, middle));
    },
  };
  return [move, size, turn];
}

/** Turns or resizes by a key; false if it is none of those. */
export function editByKey(model: SceneModel, place: number, key: string, edit: Edit): boolean {
  const middle = middleOf(model, place);
  const turn = { "[": degreesOfKey, "]": -degreesOfKey }[key];
  const factor = { "<": 1 / factorOfKey, ">": factorOfKey }[key];
  if (middle === undefined || (turn === undefined && factor === undefined)) return false;
  const shape = model.shape(place);
  edit(place, turn !== undefined ? turnedAbout(shape, turn, middle) : scaledAbout(shape, factor ?? 1, middle));
  return true;
}
