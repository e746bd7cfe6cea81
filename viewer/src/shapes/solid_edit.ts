// SPDX-License-Identifier: MIT
// Moving, rotating and resizing shapes in the engine's representation, in 2D and 3D.
import type { Shape, Vector } from "graze";
import * as THREE from "three";

import { dot, times } from "../vectors";

/** The maps of points, directions and lengths. */
interface Change {
  readonly point: (point: Vector) => number[];
  readonly direction: (direction: Vector) => number[];
  readonly factor: number;
}

const kept = (vector: Vector): number[] => Array.from(vector);

export function movedBy(shape: Shape, offset: Vector): Shape {
  return changed(shape, { point: (point) => Array.from(point, (value, axis) => value + (offset[axis] ?? 0)), direction: kept, factor: 1 });
}

/** Scaled about a point. */
export function scaledAbout(shape: Shape, factor: number, about: Vector): Shape {
  const point = (from: Vector): number[] => Array.from(from, (value, axis) => (about[axis] ?? 0) + (value - (about[axis] ?? 0)) * factor);
  return changed(shape, { point, direction: kept, factor });
}

/** Rotated, in 3D about an axis of any length through a point; the default is the vertical axis. An axis-aligned box
 * stays axis-aligned. */
export function turnedAbout(shape: Shape, degrees: number, about: Vector, axis: readonly number[] = [0, 0, 1]): Shape {
  if (shape.type === "aabb") return shape;
  const turn = new THREE.Quaternion().setFromAxisAngle(asSpatial(axis).normalize(), (degrees * Math.PI) / 180);
  const direction = (from: Vector): number[] => asSpatial(from).applyQuaternion(turn).toArray().slice(0, from.length);
  const point = (from: Vector): number[] => {
    const turned = direction(Array.from(from, (value, place) => value - (about[place] ?? 0)));
    return turned.map((value, place) => value + (about[place] ?? 0));
  };
  return changed(shape, { point, direction, factor: 1 });
}

/** Unbounded shapes have no size. */
function changed(shape: Shape, change: Change): Shape {
  const { point, direction, factor } = change;
  switch (shape.type) {
    case "point":
      return { ...shape, position: point(shape.position) };
    case "segment":
      return { ...shape, start: point(shape.start), end: point(shape.end) };
    case "ray":
      return { ...shape, origin: point(shape.origin), direction: direction(shape.direction) };
    case "sphere":
      return { ...shape, center: point(shape.center), radius: shape.radius * factor };
    case "aabb":
      return "min" in shape ? { ...shape, min: point(shape.min), max: point(shape.max) } : shape;
    case "obb": {
      const half_extents = Array.from(shape.half_extents, (value) => value * factor);
      return { type: "obb", center: point(shape.center), half_extents, axes: (shape.axes ?? []).map((axis) => unit(direction(axis))) };
    }
    case "plane":
    case "half_space": {
      const foot = times(Array.from(shape.normal), shape.offset / dot(shape.normal, shape.normal));
      const normal = direction(shape.normal);
      return { ...shape, normal, offset: dot(normal, point(foot)) };
    }
    case "triangle":
      return { ...shape, a: point(shape.a), b: point(shape.b), c: point(shape.c) };
    case "capsule":
      return { ...shape, a: point(shape.a), b: point(shape.b), radius: shape.radius * factor };
    case "polytope":
      return { ...shape, points: shape.points.map(point) };
    case "mesh":
      return { ...shape, vertices: shape.vertices.map(point) };
    case "compound":
      return { ...shape, parts: shape.parts.map((part) => changed(part, change)) };
  }
}

function asSpatial(vector: Vector): THREE.Vector3 {
  return new THREE.Vector3(vector[0], vector[1], vector[2] ?? 0);
}

function unit(vector: readonly number[]): number[] {
  const length = Math.hypot(...vector);
  return vector.map((value) => value / length);
}
