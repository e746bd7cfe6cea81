// SPDX-License-Identifier: MIT
// The operations on shapes that an editor needs, for 2D and 3D.
import type { Graze, Shape } from "graze";

import type { Point2 } from "../stage";
import { between, dot, times } from "../vectors";
import { middleOf, moved, resized, turned } from "./flat_edit";
import { flatNames, newFlatShape, type FlatShape, type ShapeType } from "./flat_shape";
import { movedBy, scaledAbout, turnedAbout } from "./solid_edit";
import { newSolid, solidNames } from "./solid_shape";

export interface ShapeKit {
  readonly dimension: 2 | 3;
  readonly names: Readonly<Record<ShapeType, string>>;
  /** A new shape of about this size. */
  readonly make: (type: ShapeType, at: readonly number[], size: number) => Shape;
  /** The center of rotation of a shape. */
  readonly middleOf: (shape: Shape) => readonly number[];
  readonly moved: (shape: Shape, by: readonly number[]) => Shape;
  /** Rotated about a point, in 3D about a vertical axis through it. */
  readonly turned: (shape: Shape, degrees: number, about: readonly number[]) => Shape;
  /** Scaled about its center. */
  readonly resized: (shape: Shape, factor: number) => Shape;
}

export function kitOf(graze: Graze, dimension: 2 | 3): ShapeKit {
  return dimension === 2 ? flatKit : solidKit(graze);
}

const flatKit: ShapeKit = {
  dimension: 2,
  names: flatNames,
  make: (type, at, size) => newFlatShape(type, flat(at), size),
  middleOf: (shape) => middleOf(asFlat(shape)),
  moved: (shape, by) => moved(asFlat(shape), flat(by)),
  turned: (shape, degrees, about) => turned(asFlat(shape), degrees, flat(about)),
  resized: (shape, factor) => resized(asFlat(shape), factor),
};

/** All 2D shapes have the editable fields, because `newFlatShape` or a link created them. */
export function asFlat(shape: Shape): FlatShape {
  return shape as FlatShape;
}

function flat([x = 0, y = 0]: readonly number[]): Point2 {
  return [x, y];
}

/** 3D shapes are in the engine's representation: oriented boxes by their axes. */
function solidKit(graze: Graze): ShapeKit {
  const middle = (shape: Shape): number[] => middleOfSolid(graze, shape);
  return {
    dimension: 3,
    names: solidNames,
    make: (type, at, size) => graze.normalised(newSolid(type, at, size)),
    middleOf: middle,
    moved: movedBy,
    turned: turnedAbout,
    resized: (shape, factor) => scaledAbout(shape, factor, middle(shape)),
  };
}

/** The center of its bounding box; for unbounded shapes the start, or the point nearest to the origin. */
function middleOfSolid(graze: Graze, shape: Shape): number[] {
  if (shape.type === "ray") return Array.from(shape.origin);
  if (shape.type === "plane" || shape.type === "half_space") {
    return times(Array.from(shape.normal), shape.offset / dot(shape.normal, shape.normal));
  }
  const { min, max } = graze.bounds(shape);
  return between(min, max);
}
