// SPDX-License-Identifier: MIT
import type { Drawing, Graze, OutlineOptions, Shape } from "graze";

/** The drawings of a shape: one, or for a compound in 3D one for each part, so that round parts stay round. */
export function drawingsOf(graze: Graze, shape: Shape, dimension: 2 | 3, options: OutlineOptions): Drawing[] {
  if (shape.type === "compound" && dimension === 3) return shape.parts.flatMap((part) => drawingsOf(graze, part, dimension, options));
  return [graze.drawing(shape, options)];
}

/** The number of corners of a full circle; fewer if there are more shapes. */
export function cornersFor(shapes: number, dimension: 2 | 3): number {
  if (dimension === 2) return shapes > 5000 ? 16 : shapes > 500 ? 32 : 72;
  return shapes > 5000 ? 8 : shapes > 500 ? 16 : 40;
}
