// SPDX-License-Identifier: MIT
// Shapes of the plane as text in a link: "sphere:0,1,0.5;segment:0,0,2,1".
import { rounded } from "../numbers";
import type { Point2 } from "../stage";
import { dot, shapeNames, type FlatShape, type FlatType } from "./flat_shape";

export function textOfShapes(shapes: readonly FlatShape[]): string {
  return shapes.map(textOfShape).join(";");
}

/** Nothing if any of it is no shape: a link is followed wholly or not at all. */
export function shapesOfText(text: string): FlatShape[] | undefined {
  const shapes = text.split(";").map(shapeOfText);
  return shapes.every((shape) => shape !== undefined) ? shapes : undefined;
}

function textOfShape(shape: FlatShape): string {
  if (shape.type === "compound") return `compound:${shape.parts.map(textOfShape).join("|")}`;
  return `${shape.type}:${numbersOf(shape).map(rounded).join(",")}`;
}

function numbersOf(shape: Exclude<FlatShape, { type: "compound" }>): number[] {
  switch (shape.type) {
    case "point":
      return [...shape.position];
    case "segment":
      return [...shape.start, ...shape.end];
    case "ray":
      return [...shape.origin, ...shape.direction];
    case "sphere":
      return [...shape.center, shape.radius];
    case "aabb":
      return [...shape.min, ...shape.max];
    case "obb":
      return [...shape.center, ...shape.half_extents, shape.angle];
    case "half_space":
    case "plane":
      return [...shape.normal, shape.offset];
    case "triangle":
      return [...shape.a, ...shape.b, ...shape.c];
    case "capsule":
      return [...shape.a, ...shape.b, shape.radius];
    case "polytope":
      return shape.points.flat();
  }
}

/** How many numbers a shape has; a polygon any number of pairs. */
const lengths: Readonly<Partial<Record<FlatType, number>>> = {
  point: 2,
  segment: 4,
  ray: 4,
  sphere: 3,
  aabb: 4,
  obb: 5,
  half_space: 3,
  plane: 3,
  triangle: 6,
  capsule: 5,
};

function shapeOfText(text: string): FlatShape | undefined {
  const colon = text.indexOf(":");
  const type = (Object.keys(shapeNames) as FlatType[]).find((known) => known === text.slice(0, colon));
  const rest = text.slice(colon + 1);
  if (type === undefined) return undefined;
  if (type === "compound") {
    const parts = rest.split("|").map(shapeOfText);
    return parts.every((part) => part !== undefined) ? { type, parts } : undefined;
  }
  const values = rest.split(",").map((part) => (part.trim() === "" ? Number.NaN : Number(part)));
  const isWhole = type === "polytope" ? values.length % 2 === 0 : values.length === lengths[type];
  return isWhole && values.every(Number.isFinite) ? build(type, values) : undefined;
}

/** The shape of so many numbers as its type needs; nothing if they are against its rules. */
function build(type: Exclude<FlatType, "compound">, values: readonly number[]): FlatShape | undefined {
  const [v0 = 0, v1 = 0, v2 = 0, v3 = 0, v4 = 0] = values;
  const point = (index: number): Point2 => [values[2 * index] ?? 0, values[2 * index + 1] ?? 0];
  switch (type) {
    case "point":
      return { type, position: point(0) };
    case "segment":
      return { type, start: point(0), end: point(1) };
    case "ray":
      return dot(point(1), point(1)) > 0 ? { type, origin: point(0), direction: point(1) } : undefined;
    case "sphere":
      return v2 >= 0 ? { type, center: point(0), radius: v2 } : undefined;
    case "aabb":
      return v0 <= v2 && v1 <= v3 ? { type, min: point(0), max: point(1) } : undefined;
    case "obb":
      return v2 >= 0 && v3 >= 0 ? { type, center: point(0), half_extents: point(1), angle: v4 } : undefined;
    case "half_space":
    case "plane":
      return dot(point(0), point(0)) > 0 ? { type, normal: point(0), offset: v2 } : undefined;
    case "triangle":
      return { type, a: point(0), b: point(1), c: point(2) };
    case "capsule":
      return v4 >= 0 ? { type, a: point(0), b: point(1), radius: v4 } : undefined;
    case "polytope":
      return { type, points: Array.from({ length: values.length / 2 }, (_, index) => point(index)) };
  }
}
