// SPDX-License-Identifier: MIT
// The draggable corners, ends and sides of 3D shapes.
import type { Shape, Vector } from "graze";

import { dot, minus, plus, times } from "../vectors";

/** A draggable feature of a shape, and the shape that results from moving it. */
export interface SolidGrip {
  readonly name: string;
  readonly at: readonly number[];
  readonly move: (to: readonly number[]) => Shape;
}

/** None for shapes without corners, ends or sides, and for compounds. Oriented boxes are given by their axes, as in the
 * engine. */
export function solidGripsOf(shape: Shape): SolidGrip[] {
  switch (shape.type) {
    case "segment":
      return [
        { name: "start", at: Array.from(shape.start), move: (start) => ({ ...shape, start }) },
        { name: "end", at: Array.from(shape.end), move: (end) => ({ ...shape, end }) },
      ];
    case "ray": {
      const origin = Array.from(shape.origin);
      const move = (to: readonly number[]): Shape => ({ ...shape, direction: orElse(minus(to, origin), shape.direction) });
      return [{ name: "direction", at: plus(origin, Array.from(shape.direction)), move }];
    }
    case "triangle":
      return (["a", "b", "c"] as const).map((name) => ({ name, at: Array.from(shape[name]), move: (to) => ({ ...shape, [name]: to }) }));
    case "capsule":
      return (["a", "b"] as const).map((name) => ({ name, at: Array.from(shape[name]), move: (to) => ({ ...shape, [name]: to }) }));
    case "aabb":
      return "min" in shape ? cornerGrips(Array.from(shape.min), Array.from(shape.max)) : [];
    case "obb":
      return sideGrips(shape);
    case "polytope":
      return shape.points.map((at, index) => ({
        name: `corner ${index + 1}`,
        at: Array.from(at),
        move: (to) => ({ ...shape, points: shape.points.map((point, other) => (other === index ? to : point)) }),
      }));
    default:
      return [];
  }
}

/** The moved corner may pass the opposite one. */
function cornerGrips(min: readonly number[], max: readonly number[]): SolidGrip[] {
  const between = (a: readonly number[], b: readonly number[]): Shape => ({
    type: "aabb",
    min: a.map((value, axis) => Math.min(value, b[axis] ?? value)),
    max: a.map((value, axis) => Math.max(value, b[axis] ?? value)),
  });
  return [
    { name: "min", at: min, move: (to) => between(to, max) },
    { name: "max", at: max, move: (to) => between(to, min) },
  ];
}

/** The center of a face; moving it keeps the opposite face in place. */
function sideGrips(shape: Extract<Shape, { type: "obb" }>): SolidGrip[] {
  const center = Array.from(shape.center);
  return (shape.axes ?? []).map((vector, axis) => {
    const direction = Array.from(vector);
    const half = shape.half_extents[axis] ?? 0;
    const set = (extent: number): number[] => Array.from(shape.half_extents, (value, other) => (other === axis ? extent : value));
    return {
      name: `side ${axis + 1}`,
      at: plus(center, times(direction, half)),
      move: (to) => ({ ...shape, half_extents: set(Math.abs(dot(minus(to, center), direction))) }),
    };
  });
}

/** A direction must not be zero. */
function orElse(direction: readonly number[], usual: Vector): Vector {
  return dot(direction, direction) > 0 ? direction : usual;
}
