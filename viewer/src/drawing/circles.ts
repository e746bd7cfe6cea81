// SPDX-License-Identifier: MIT
// Circles as lines of the overlay.
import type { Vector } from "graze";

import type { Mark, Tone } from "../overlay";
import { heading } from "../shapes/flat_shape";
import type { Point2 } from "../stage";
import { plus, times } from "../vectors";

const corners = 72;

export function circleAbout(center: Point2, radius: number): Point2[] {
  return Array.from({ length: corners + 1 }, (_, i) => plus(center, times(heading((360 / corners) * i), radius)));
}

/** A sphere, which has no edges, as its three axis-aligned circles. */
export function circlesOfSphere(center: Vector, radius: number, look: { tone: Tone; dashed?: boolean }): Mark[] {
  return [0, 1, 2].map((axis) => {
    const [first, second] = [(axis + 1) % 3, (axis + 2) % 3];
    const points = circleAbout([center[first] ?? 0, center[second] ?? 0], radius).map(([x, y]) => {
      const point = Array.from(center);
      [point[first], point[second]] = [x, y];
      return point;
    });
    return { kind: "line", points, ...look };
  });
}
