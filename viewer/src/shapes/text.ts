// SPDX-License-Identifier: MIT
// Shapes as text in a link: "sphere:0,1,0.5;segment:0,0,2,1" in 2D, with a third number for each point in 3D. The
// rotation of an oriented box is an angle in degrees in 2D, and in 3D an axis whose length is the angle. A mesh, in
// 3D, has its vertices, its faces and its kind: "mesh:0,0,0,1,0,0,0,1,0/0,1,2/surface".
import type { Mesh, Shape, Vector } from "graze";
import * as THREE from "three";

import { rounded } from "../numbers";
import { dot, lengthOf, times } from "../vectors";
import { flatNames, type ShapeType } from "./flat_shape";

const types = Object.keys(flatNames) as ShapeType[];

export function textOfShapes(shapes: readonly Shape[]): string {
  return shapes.map(textOfShape).join(";");
}

/** Undefined if any part is invalid: a link is applied completely or not at all. */
export function shapesOfText(text: string, dimension: 2 | 3): Shape[] | undefined {
  const shapes = text.split(";").map((part) => shapeOfText(part, dimension));
  return shapes.every((shape) => shape !== undefined) ? shapes : undefined;
}

function textOfShape(shape: Shape): string {
  if (shape.type === "compound") return `compound:${shape.parts.map(textOfShape).join("|")}`;
  if (shape.type === "mesh") return textOfMesh(shape);
  return `${shape.type}:${numbersOf(shape).map(rounded).join(",")}`;
}

function textOfMesh({ vertices, faces, kind }: Mesh): string {
  const numbers = vertices.flatMap((vertex) => Array.from(vertex, rounded));
  return `mesh:${numbers.join(",")}/${faces.flat().join(",")}/${kind ?? "surface"}`;
}

function meshOfText(text: string): Mesh | undefined {
  const [vertices, faces, kind] = text.split("/");
  const numbers = (list = ""): number[] => (list === "" ? [] : list.split(",").map(Number));
  const rows = (list: readonly number[], width: number): number[][] =>
    Array.from({ length: Math.ceil(list.length / width) }, (_, row) => list.slice(width * row, width * (row + 1)));
  const points = rows(numbers(vertices), 3);
  const corners = rows(numbers(faces), 3);
  const isVertex = (index: number): boolean => Number.isInteger(index) && index >= 0 && index < points.length;
  if (!points.every((point) => point.length === 3 && point.every(Number.isFinite))) return undefined;
  if (!corners.every((face) => face.length === 3 && face.every(isVertex))) return undefined;
  if (kind !== "surface" && kind !== "solid") return undefined;
  return { type: "mesh", vertices: points, faces: corners.map(([a = 0, b = 0, c = 0]) => [a, b, c]), kind };
}

function numbersOf(shape: Exclude<Shape, { type: "compound" | "mesh" }>): number[] {
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
      return "min" in shape ? [...shape.min, ...shape.max] : [...shape.center, ...shape.half_extents];
    case "obb":
      return [...shape.center, ...shape.half_extents, ...(shape.center.length === 2 ? [shape.angle ?? 0] : rotationOf(shape.axes ?? []))];
    case "half_space":
    case "plane":
      return [...shape.normal, shape.offset];
    case "triangle":
      return [...shape.a, ...shape.b, ...shape.c];
    case "capsule":
      return [...shape.a, ...shape.b, shape.radius];
    case "polytope":
      return shape.points.flatMap((point) => [...point]);
  }
}

/** The rotation axis from the world's axes to these; its length is the angle in degrees. */
function rotationOf(axes: readonly Vector[]): number[] {
  const [x, y, z] = axes.map((axis) => new THREE.Vector3().fromArray(Array.from(axis)));
  if (x === undefined || y === undefined || z === undefined) return [0, 0, 0];
  const turn = new THREE.Quaternion().setFromRotationMatrix(new THREE.Matrix4().makeBasis(x, y, z));
  const axis = [turn.x, turn.y, turn.z];
  const sine = lengthOf(axis);
  const degrees = (2 * Math.atan2(sine, turn.w) * 180) / Math.PI;
  return sine > 0 ? times(axis, degrees / sine) : [0, 0, 0];
}

/** The number of numbers of a shape; a polytope has any number of points. */
function lengthIn(type: ShapeType, dimension: 2 | 3): number {
  const points: Readonly<Partial<Record<ShapeType, number>>> = { point: 1, segment: 2, ray: 2, sphere: 1, aabb: 2, obb: 2, half_space: 1, plane: 1, triangle: 3, capsule: 2 };
  const more: Readonly<Partial<Record<ShapeType, number>>> = { sphere: 1, obb: dimension === 2 ? 1 : 3, half_space: 1, plane: 1, capsule: 1 };
  return (points[type] ?? 0) * dimension + (more[type] ?? 0);
}

function shapeOfText(text: string, dimension: 2 | 3): Shape | undefined {
  const colon = text.indexOf(":");
  if (text.slice(0, colon) === "mesh") return dimension === 3 ? meshOfText(text.slice(colon + 1)) : undefined;
  const type = types.find((known) => known === text.slice(0, colon));
  const rest = text.slice(colon + 1);
  if (type === undefined) return undefined;
  if (type === "compound") {
    const parts = rest.split("|").map((part) => shapeOfText(part, dimension));
    return parts.every((part) => part !== undefined) ? { type, parts } : undefined;
  }
  const values = rest.split(",").map((part) => (part.trim() === "" ? Number.NaN : Number(part)));
  const isWhole = type === "polytope" ? values.length % dimension === 0 : values.length === lengthIn(type, dimension);
  return isWhole && values.every(Number.isFinite) ? build(type, values, dimension) : undefined;
}

/** The shape with these numbers; undefined if they violate its rules. */
function build(type: Exclude<ShapeType, "compound">, values: readonly number[], dimension: 2 | 3): Shape | undefined {
  const point = (index: number): number[] => values.slice(dimension * index, dimension * (index + 1));
  const last = values.at(-1) ?? 0;
  const [first, second] = [point(0), point(1)];
  switch (type) {
    case "point":
      return { type, position: first };
    case "segment":
      return { type, start: first, end: second };
    case "ray":
      return dot(second, second) > 0 ? { type, origin: first, direction: second } : undefined;
    case "sphere":
      return last >= 0 ? { type, center: first, radius: last } : undefined;
    case "aabb":
      return first.every((low, axis) => low <= (second[axis] ?? low)) ? { type, min: first, max: second } : undefined;
    case "obb":
      return second.every((half) => half >= 0) ? { type, center: first, half_extents: second, ...turnOf(values.slice(2 * dimension)) } : undefined;
    case "half_space":
    case "plane":
      return dot(first, first) > 0 ? { type, normal: first, offset: last } : undefined;
    case "triangle":
      return { type, a: first, b: second, c: point(2) };
    case "capsule":
      return last >= 0 ? { type, a: first, b: second, radius: last } : undefined;
    case "polytope":
      return { type, points: Array.from({ length: values.length / dimension }, (_, index) => point(index)) };
  }
}

/** The rotation of a box, from one number or three. */
function turnOf(turn: readonly number[]): { angle: number } | { rotation: { axis: number[]; angle: number } } {
  const [angle = 0, ...rest] = turn;
  if (rest.length === 0) return { angle };
  const length = lengthOf(turn);
  return { rotation: length > 0 ? { axis: [...turn], angle: length } : { axis: [0, 0, 1], angle: 0 } };
}
