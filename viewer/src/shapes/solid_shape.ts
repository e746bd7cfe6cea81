// SPDX-License-Identifier: MIT
// The initial 3D shapes when they are added.
import type { Shape } from "graze";

import { plus, times } from "../vectors";
import { heading, type ShapeType } from "./flat_shape";

export const solidNames: Readonly<Record<ShapeType, string>> = {
  point: "point",
  segment: "segment",
  ray: "ray",
  sphere: "sphere",
  aabb: "box",
  obb: "oriented box",
  half_space: "half-space",
  plane: "plane",
  triangle: "triangle",
  capsule: "capsule",
  polytope: "polytope",
  compound: "compound",
};

/** A new shape of about the given size. Half-spaces are placed below the other shapes. */
export function newSolid(type: ShapeType, at: readonly number[], size: number): Shape {
  const on = (x: number, y: number, z: number): number[] => [...plus(at, times([x, y, z], size))];
  switch (type) {
    case "point":
      return { type, position: [...at] };
    case "segment":
      return { type, start: on(-1, -0.3, -0.4), end: on(1, 0.3, 0.4) };
    case "ray":
      return { type, origin: [...at], direction: [size, size * 0.3, size * 0.2] };
    case "sphere":
      return { type, center: [...at], radius: size * 0.8 };
    case "aabb":
      return { type, min: on(-0.8, -0.6, -0.5), max: on(0.8, 0.6, 0.5) };
    case "obb":
      return { type, center: [...at], half_extents: [size, size * 0.5, size * 0.4], rotation: { axis: [0, 0, 1], angle: 25 } };
    case "half_space":
      return { type, normal: [0, 0, 1], offset: (at[2] ?? 0) - 3 * size };
    case "plane":
      return { type, normal: [0, 0, 1], offset: at[2] ?? 0 };
    case "triangle":
      return { type, a: on(-0.9, -0.5, -0.4), b: on(0.9, -0.3, -0.4), c: on(0.1, 0.4, 0.8) };
    case "capsule":
      return { type, a: on(-0.7, -0.3, 0), b: on(0.7, 0.3, 0), radius: size * 0.4 };
    case "polytope":
      return { type, points: [...pentagon.map(([x, y]) => on(x, y, -0.6)), on(0.2, 0, 0.9)] };
    case "compound":
      return {
        type,
        parts: [
          { type: "aabb", min: on(-0.9, -0.4, -0.8), max: on(-0.4, 0.4, 0.8) },
          { type: "aabb", min: on(-0.4, -0.4, -0.8), max: on(0.5, 0.4, -0.4) },
          { type: "sphere", center: on(0.8, 0, -0.4), radius: size * 0.45 },
        ],
      };
  }
}

const pentagon = [0, 1, 2, 3, 4].map((corner) => heading(72 * corner + 90));
