// SPDX-License-Identifier: MIT
// 2D shapes that can be edited, each with one set of fields. All are also valid shapes of the engine.
import type { Point2 } from "../stage";
import { plus, times } from "../vectors";

export type FlatShape =
  | { readonly type: "point"; readonly position: Point2 }
  | { readonly type: "segment"; readonly start: Point2; readonly end: Point2 }
  | { readonly type: "ray"; readonly origin: Point2; readonly direction: Point2 }
  | { readonly type: "sphere"; readonly center: Point2; readonly radius: number }
  | { readonly type: "aabb"; readonly min: Point2; readonly max: Point2 }
  | { readonly type: "obb"; readonly center: Point2; readonly half_extents: Point2; readonly angle: number }
  | { readonly type: "half_space"; readonly normal: Point2; readonly offset: number }
  | { readonly type: "plane"; readonly normal: Point2; readonly offset: number }
  | { readonly type: "triangle"; readonly a: Point2; readonly b: Point2; readonly c: Point2 }
  | { readonly type: "capsule"; readonly a: Point2; readonly b: Point2; readonly radius: number }
  | { readonly type: "polytope"; readonly points: readonly Point2[] }
  | { readonly type: "compound"; readonly parts: readonly FlatShape[] };

/** The names of shapes in 2D and in 3D. */
export type ShapeType = FlatShape["type"];

export const flatNames: Readonly<Record<ShapeType, string>> = {
  point: "point",
  segment: "segment",
  ray: "ray",
  sphere: "circle",
  aabb: "box",
  obb: "oriented box",
  half_space: "half-space",
  plane: "line",
  triangle: "triangle",
  capsule: "capsule",
  polytope: "polygon",
  compound: "compound",
};

/** A quarter turn counter-clockwise. */
export function sideways(a: Point2): Point2 {
  return [-a[1], a[0]];
}

/** The unit vector at an angle in degrees. */
export function heading(degrees: number): Point2 {
  const radians = (degrees * Math.PI) / 180;
  return [Math.cos(radians), Math.sin(radians)];
}

/** A new shape of about the given size; circles have no corners. */
export function newFlatShape(type: ShapeType, at: Point2, size: number): FlatShape {
  const [x, y] = at;
  const on = (right: number, up: number): Point2 => [x + right * size, y + up * size];
  switch (type) {
    case "point":
      return { type, position: at };
    case "segment":
      return { type, start: on(-1, -0.5), end: on(1, 0.5) };
    case "ray":
      return { type, origin: at, direction: [size, size * 0.4] };
    case "sphere":
      return { type, center: at, radius: size * 0.8 };
    case "aabb":
      return { type, min: on(-0.9, -0.6), max: on(0.9, 0.6) };
    case "obb":
      return { type, center: at, half_extents: [size, size * 0.5], angle: 25 };
    case "half_space":
    case "plane":
      return { type, normal: [0, 1], offset: y };
    case "triangle":
      return { type, a: on(-0.9, -0.6), b: on(0.9, -0.6), c: on(0.1, 0.9) };
    case "capsule":
      return { type, a: on(-0.7, -0.3), b: on(0.7, 0.3), radius: size * 0.45 };
    case "polytope":
      return { type, points: [0, 1, 2, 3, 4].map((i) => plus(at, times(heading(72 * i + 90), size))) };
    case "compound":
      return {
        type,
        parts: [
          { type: "aabb", min: on(-0.9, -0.9), max: on(-0.3, 0.9) },
          { type: "aabb", min: on(-0.3, -0.9), max: on(0.6, -0.4) },
          { type: "sphere", center: on(0.7, -0.65), radius: size * 0.45 },
        ],
      };
  }
}
