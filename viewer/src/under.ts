// SPDX-License-Identifier: MIT
// Determines which shape is under the pointer, using the engine.
import type { Scene, Shape } from "graze";

import type { Stage } from "./stage";
import { plus, times } from "./vectors";

/** Lines and points react to the pointer within this distance, in pixels. */
const reach = 7;

export interface Under {
  readonly id: number;
  /** The point of the shape under the pointer. */
  readonly at: readonly number[];
}

/** The topmost shape within reach of the pointer, in 3D the first on the line of sight; half-spaces and 3D planes only
 * if there is nothing else. */
export function under(stage: Stage, scene: Scene, event: { clientX: number; clientY: number }): Under | undefined {
  return stage.isFlat ? underInPlane(stage, scene, event) : underInSpace(stage, scene, event);
}

function underInPlane(stage: Stage, scene: Scene, event: { clientX: number; clientY: number }): Under | undefined {
  const at = stage.planePoint(event);
  const found = Array.from(scene.overlapping({ type: "sphere", center: at, radius: reach / stage.pixelsPerUnit }));
  const inFront = found.filter((id) => scene.object(id).shape.type !== "half_space");
  const id = (inFront.length > 0 ? inFront : found).at(-1);
  return id === undefined ? undefined : { id, at };
}

function underInSpace(stage: Stage, scene: Scene, event: { clientX: number; clientY: number }): Under | undefined {
  const thin = thinUnder(stage, scene, event);
  if (thin !== undefined) return thin;
  const { origin, direction } = stage.sightLine(event);
  const hits = scene.rayCastAll({ origin: origin.toArray(), direction: direction.toArray() });
  const bounded = hits.find(({ id }) => !["half_space", "plane"].includes(scene.object(id).shape.type));
  const hit = bounded ?? hits.find(({ point }) => stage.isInExtent(point));
  return hit === undefined ? undefined : { id: hit.id, at: hit.point };
}

/** Lines and points, which a line of sight cannot hit, are tested in screen space. */
function thinUnder(stage: Stage, scene: Scene, event: { clientX: number; clientY: number }): Under | undefined {
  const { left, top } = stage.canvas.getBoundingClientRect();
  const pointer = [event.clientX - left, event.clientY - top] as const;
  for (const id of scene.ids().reverse()) {
    const [start, end] = endsOf(scene.object(id).shape);
    if (start === undefined || end === undefined) continue;
    const near = nearestAsSeen(stage, pointer, [start, end]);
    if (near !== undefined) return { id, at: near };
  }
  return undefined;
}

function endsOf(shape: Shape): readonly number[][] {
  if (shape.type === "point") return [Array.from(shape.position), Array.from(shape.position)];
  if (shape.type === "segment") return [Array.from(shape.start), Array.from(shape.end)];
  return shape.type === "ray" ? [Array.from(shape.origin), plus(Array.from(shape.origin), Array.from(shape.direction))] : [];
}

/** The point of a line within reach of the pointer on screen; interpolated linearly in screen space. */
function nearestAsSeen(stage: Stage, pointer: readonly [number, number], ends: readonly [number[], number[]]): number[] | undefined {
  const [from, to] = ends;
  if (!stage.isBeforeEye(from) || !stage.isBeforeEye(to)) return undefined;
  const [[fromX, fromY], [toX, toY]] = [stage.toPixels(from), stage.toPixels(to)];
  const [right, down] = [toX - fromX, toY - fromY];
  const square = right * right + down * down;
  const along = (pointer[0] - fromX) * right + (pointer[1] - fromY) * down;
  const share = square > 0 ? Math.min(1, Math.max(0, along / square)) : 0;
  const far = Math.hypot(fromX + right * share - pointer[0], fromY + down * share - pointer[1]);
  return far > reach ? undefined : plus(times(from, 1 - share), times(to, share));
}
