// SPDX-License-Identifier: MIT
// Moving, turning and resizing the bounded shapes of a scene, in the plane and in space, as the engine gives them.
import type { Shape, Vector } from "graze";

/** How points, directions and lengths change. */
interface Change {
  readonly point: (point: Vector) => number[];
  readonly direction: (direction: Vector) => number[];
  readonly factor: number;
}

const kept = (vector: Vector): number[] => Array.from(vector);

export function movedBy(shape: Shape, offset: Vector): Shape {
  return changed(shape, { point: (point) => Array.from(point, (value, axis) => value + (offset[axis] ?? 0)), direction: kept, factor: 1 });
}

/** Made larger or smaller about a point. */
export function scaledAbout(shape: Shape, factor: number, about: Vector): Shape {
  const point = (from: Vector): number[] => Array.from(from, (value, axis) => (about[axis] ?? 0) + (value - (about[axis] ?? 0)) * factor);
  return changed(shape, { point, direction: kept, factor });
}

/** Turned in the plane, in space about the upright axis through a point. A box along the axes stays along them. */
export function turnedAbout(shape: Shape, degrees: number, about: Vector): Shape {
  if (shape.type === "aabb") return shape;
  const [cosine, sine] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
  const direction = (from: Vector): number[] => {
    const [x = 0, y = 0, ...rest] = Array.from(from);
    return [cosine * x - sine * y, sine * x + cosine * y, ...rest];
  };
  const point = (from: Vector): number[] => {
    const turned = direction(Array.from(from, (value, axis) => value - (about[axis] ?? 0)));
    return turned.map((value, axis) => value + (about[axis] ?? 0));
  };
  return changed(shape, { point, direction, factor: 1 });
}

/** What is unbounded stays as it is. */
function changed(shape: Shape, change: Change): Shape {
  const { point, direction, factor } = change;
  switch (shape.type) {
    case "point":
      return { ...shape, position: point(shape.position) };
    case "segment":
      return { ...shape, start: point(shape.start), end: point(shape.end) };
    case "sphere":
      return { ...shape, center: point(shape.center), radius: shape.radius * factor };
    case "aabb":
      return "min" in shape ? { ...shape, min: point(shape.min), max: point(shape.max) } : shape;
    case "obb": {
      const half_extents = Array.from(shape.half_extents, (value) => value * factor);
      return { type: "obb", center: point(shape.center), half_extents, axes: (shape.axes ?? []).map((axis) => unit(direction(axis))) };
    }
    case "triangle":
      return { ...shape, a: point(shape.a), b: point(shape.b), c: point(shape.c) };
    case "capsule":
      return { ...shape, a: point(shape.a), b: point(shape.b), radius: shape.radius * factor };
    case "polytope":
      return { ...shape, points: shape.points.map(point) };
    case "compound":
      return { ...shape, parts: shape.parts.map((part) => changed(part, change)) };
    case "ray":
    case "plane":
    case "half_space":
      return shape;
  }
}

function unit(vector: readonly number[]): number[] {
  const length = Math.hypot(...vector);
  return vector.map((value) => value / length);
}
