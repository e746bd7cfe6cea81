// SPDX-License-Identifier: MIT
// Moving, rotating and resizing 2D shapes. Collision detection happens elsewhere.
import type { Point2 } from "../stage";
import { dot, lengthOf, minus, plus, times } from "../vectors";
import { heading, sideways, type FlatShape } from "./flat_shape";

/** The center of rotation of a shape. */
export function middleOf(shape: FlatShape): Point2 {
  switch (shape.type) {
    case "point":
      return shape.position;
    case "ray":
      return shape.origin;
    case "sphere":
    case "obb":
      return shape.center;
    case "half_space":
    case "plane":
      return times(shape.normal, shape.offset / dot(shape.normal, shape.normal));
    case "compound":
      return mean(shape.parts.map(middleOf));
    default:
      return mean(cornersOf(shape));
  }
}

/** The defining points of a shape. */
function cornersOf(shape: FlatShape): readonly Point2[] {
  switch (shape.type) {
    case "segment":
      return [shape.start, shape.end];
    case "aabb":
      return [shape.min, shape.max];
    case "triangle":
      return [shape.a, shape.b, shape.c];
    case "capsule":
      return [shape.a, shape.b];
    case "polytope":
      return shape.points;
    default:
      return [middleOf(shape)];
  }
}

function mean(points: readonly Point2[]): Point2 {
  return times(points.reduce<Point2>((sum, point) => plus(sum, point), [0, 0]), 1 / points.length);
}

export function moved(shape: FlatShape, by: Point2): FlatShape {
  if (shape.type === "half_space" || shape.type === "plane") return { ...shape, offset: shape.offset + dot(shape.normal, by) };
  return mapped(shape, (point) => plus(point, by), { degrees: 0, factor: 1 });
}

/** Rotated about a point. An axis-aligned box stays axis-aligned, and only its center moves. */
export function turned(shape: FlatShape, degrees: number, about: Point2 = middleOf(shape)): FlatShape {
  const [right, up] = [heading(degrees), sideways(heading(degrees))];
  const turn = (vector: Point2): Point2 => plus(times(right, vector[0]), times(up, vector[1]));
  const around = (point: Point2): Point2 => plus(about, turn(minus(point, about)));
  if (shape.type === "half_space" || shape.type === "plane") {
    const normal = turn(shape.normal);
    return { ...shape, normal, offset: dot(normal, around(middleOf(shape))) };
  }
  if (shape.type === "ray") return { ...shape, origin: around(shape.origin), direction: turn(shape.direction) };
  if (shape.type === "aabb") return moved(shape, minus(around(middleOf(shape)), middleOf(shape)));
  if (shape.type === "compound") return { ...shape, parts: shape.parts.map((part) => turned(part, degrees, about)) };
  return mapped(shape, around, { degrees, factor: 1 });
}

/** Scaled about its center. Half-spaces, lines and points have no size. */
export function resized(shape: FlatShape, factor: number): FlatShape {
  if (shape.type === "half_space" || shape.type === "plane" || shape.type === "ray") return shape;
  const about = middleOf(shape);
  return mapped(shape, (point) => plus(about, times(minus(point, about), factor)), { degrees: 0, factor });
}

/** Applies a map to every point; angles and lengths change according to the map, which is a similarity. */
function mapped(
  shape: FlatShape,
  map: (point: Point2) => Point2,
  change: { readonly degrees: number; readonly factor: number },
): FlatShape {
  switch (shape.type) {
    case "point":
      return { ...shape, position: map(shape.position) };
    case "segment":
      return { ...shape, start: map(shape.start), end: map(shape.end) };
    case "ray":
      return { ...shape, origin: map(shape.origin) };
    case "sphere":
      return { ...shape, center: map(shape.center), radius: shape.radius * change.factor };
    case "aabb":
      return { ...shape, min: map(shape.min), max: map(shape.max) };
    case "obb": {
      const half_extents = times(shape.half_extents, change.factor);
      return { ...shape, center: map(shape.center), half_extents, angle: (shape.angle + change.degrees) % 360 };
    }
    case "triangle":
      return { ...shape, a: map(shape.a), b: map(shape.b), c: map(shape.c) };
    case "capsule":
      return { ...shape, a: map(shape.a), b: map(shape.b), radius: shape.radius * change.factor };
    case "polytope":
      return { ...shape, points: shape.points.map(map) };
    case "compound":
      return { ...shape, parts: shape.parts.map((part) => mapped(part, map, change)) };
    case "half_space":
    case "plane":
      return shape;
  }
}

/** A draggable feature of a shape, and the shape that results from moving it. */
export interface Grip {
  readonly name: string;
  readonly at: Point2;
  readonly move: (to: Point2) => FlatShape;
}

/** The draggable features; `reach` is the distance of the rotation handle from the shape. */
export function gripsOf(shape: FlatShape, reach: number): Grip[] {
  const turning = (at: Point2): Grip => turningGrip(shape, at);
  switch (shape.type) {
    case "point":
      return [];
    case "segment":
      return [
        { name: "start", at: shape.start, move: (start) => ({ ...shape, start }) },
        { name: "end", at: shape.end, move: (end) => ({ ...shape, end }) },
      ];
    case "ray": {
      const tip = plus(shape.origin, shape.direction);
      return [{ name: "direction", at: tip, move: (to) => ({ ...shape, direction: orElse(minus(to, shape.origin), shape.direction) }) }];
    }
    case "sphere": {
      const rim = plus(shape.center, [shape.radius, 0]);
      return [{ name: "radius", at: rim, move: (to) => ({ ...shape, radius: lengthOf(minus(to, shape.center)) }) }];
    }
    case "aabb":
      return boxGrips(shape);
    case "obb":
      return orientedGrips(shape, reach);
    case "half_space":
    case "plane":
      return [turning(plus(middleOf(shape), times(shape.normal, (2 * reach) / lengthOf(shape.normal))))];
    case "triangle":
      return (["a", "b", "c"] as const).map((name) => ({ name, at: shape[name], move: (to) => ({ ...shape, [name]: to }) }));
    case "capsule":
      return capsuleGrips(shape);
    case "polytope":
      return shape.points.map((at, index) => ({
        name: `corner ${index + 1}`,
        at,
        move: (to) => ({ ...shape, points: shape.points.map((point, other) => (other === index ? to : point)) }),
      }));
    case "compound":
      return [turning(plus(middleOf(shape), [0, 3 * reach]))];
  }
}

function boxGrips(shape: Extract<FlatShape, { type: "aabb" }>): Grip[] {
  const set = (corner: "min" | "max", to: Point2): FlatShape => {
    const [a, b] = [to, corner === "min" ? shape.max : shape.min];
    return { ...shape, min: [Math.min(a[0], b[0]), Math.min(a[1], b[1])], max: [Math.max(a[0], b[0]), Math.max(a[1], b[1])] };
  };
  return (["min", "max"] as const).map((name) => ({ name, at: shape[name], move: (to) => set(name, to) }));
}

function orientedGrips(shape: Extract<FlatShape, { type: "obb" }>, reach: number): Grip[] {
  const [right, up] = [heading(shape.angle), sideways(heading(shape.angle))];
  const [width, height] = shape.half_extents;
  const extent = (to: Point2, axis: Point2): number => Math.abs(dot(minus(to, shape.center), axis));
  const top = plus(shape.center, times(up, height + 1.5 * reach));
  return [
    {
      name: "corner",
      at: plus(shape.center, plus(times(right, width), times(up, height))),
      move: (to) => ({ ...shape, half_extents: [extent(to, right), extent(to, up)] }),
    },
    turningGrip(shape, top),
  ];
}

function capsuleGrips(shape: Extract<FlatShape, { type: "capsule" }>): Grip[] {
  const along = minus(shape.b, shape.a);
  const length = lengthOf(along);
  const across: Point2 = length > 0 ? times(sideways(along), 1 / length) : [0, 1];
  const middle = middleOf(shape);
  return [
    { name: "a", at: shape.a, move: (a) => ({ ...shape, a }) },
    { name: "b", at: shape.b, move: (b) => ({ ...shape, b }) },
    {
      name: "radius",
      at: plus(middle, times(across, shape.radius)),
      move: (to) => ({ ...shape, radius: Math.abs(dot(minus(to, middle), across)) }),
    },
  ];
}

function turningGrip(shape: FlatShape, at: Point2): Grip {
  const middle = middleOf(shape);
  const angle = (point: Point2): number => Math.atan2(point[1] - middle[1], point[0] - middle[0]);
  return { name: "turn", at, move: (to) => turned(shape, ((angle(to) - angle(at)) * 180) / Math.PI) };
}

/** A direction must not be zero. */
function orElse(direction: Point2, usual: Point2): Point2 {
  return lengthOf(direction) > 0 ? direction : usual;
}
