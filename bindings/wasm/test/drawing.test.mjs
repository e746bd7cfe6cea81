// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { before, test } from "node:test";

import { loadGraze } from "./native.mjs";

let graze;

before(async () => {
  graze = await loadGraze();
});

const corner = ({ positions }, n, i) => Array.from(positions.subarray(i * n, (i + 1) * n));
const minus = (a, b) => a.map((number, i) => number - b[i]);
const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
const dot = (a, b) => a.reduce((sum, number, i) => sum + number * b[i], 0);

function area(drawing) {
  let sum = 0;
  for (let i = 0; i < drawing.triangles.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => corner(drawing, 2, drawing.triangles[i + k]));
    const [p, q] = [minus(b, a), minus(c, a)];
    sum += (p[0] * q[1] - p[1] * q[0]) / 2;
  }
  return sum;
}

/** Positive and correct only if the surface is closed and all triangles are counter-clockwise from outside. */
function volume(drawing) {
  let sum = 0;
  for (let i = 0; i < drawing.triangles.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => corner(drawing, 3, drawing.triangles[i + k]));
    sum += dot(a, cross(b, c)) / 6;
  }
  return sum;
}

const near = (value, expected, share = 1e-6) =>
  assert.ok(Math.abs(value - expected) <= share * Math.abs(expected), `${value} is not ${expected}`);

test("2D shapes are filled, counter-clockwise", () => {
  near(area(graze.drawing({ type: "aabb", min: [1, 1], max: [3, 4] })), 6);
  near(area(graze.drawing({ type: "obb", center: [1, 1], half_extents: [1, 2], angle: 30 })), 8);
  near(area(graze.drawing({ type: "triangle", a: [0, 0], b: [0, 1], c: [1, 0] })), 0.5);
  near(area(graze.drawing({ type: "sphere", center: [5, 0], radius: 2 }, { corners: 1024 })), 4 * Math.PI, 1e-4);
  const capsule = { type: "capsule", a: [0, 0], b: [3, 0], radius: 1 };
  near(area(graze.drawing(capsule, { corners: 1024 })), Math.PI + 6, 1e-4);
  near(area(graze.drawing({ type: "polytope", points: [[0, 0], [2, 0], [2, 2], [0, 2], [1, 1]] })), 4);
});

test("solids have closed surfaces that face outward", () => {
  near(volume(graze.drawing({ type: "aabb", min: [1, 1, 1], max: [3, 4, 2] })), 6);
  const rotation = { axis: [1, 2, 3], angle: 40 };
  near(volume(graze.drawing({ type: "obb", center: [1, 1, 5], half_extents: [1, 2, 3], rotation })), 48, 1e-5);
  near(volume(graze.drawing({ type: "sphere", center: [5, 0, 1], radius: 2 }, { corners: 128 })), (32 / 3) * Math.PI, 2e-3);
  for (const b of [[0, 0, 3], [3, 0, 0], [0, -3, 0], [0, 0, -3]]) {
    const capsule = { type: "capsule", a: [0, 0, 0], b, radius: 1 };
    near(volume(graze.drawing(capsule, { corners: 128 })), (4 / 3 + 3) * Math.PI, 2e-3);
  }
  const corners = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [2, 2, 0], [1, 1, 3], [1, 1, 1], [1, 0, 0]];
  near(volume(graze.drawing({ type: "polytope", points: corners })), 4);
});

test("a box has twelve edges, a round shape has none, a pyramid eight", () => {
  const edges = (shape) => graze.drawing(shape).lines.length / 2;
  assert.equal(edges({ type: "aabb", min: [0, 0, 0], max: [1, 1, 1] }), 12);
  assert.equal(edges({ type: "sphere", center: [0, 0, 0], radius: 1 }), 0);
  assert.equal(edges({ type: "polytope", points: [[0, 0, 0], [2, 0, 0], [0, 2, 0], [2, 2, 0], [1, 1, 3]] }), 8);
});

test("flat and thin 3D shapes are polygons, lines and points", () => {
  const parts = (shape) => {
    const { positions, triangles, lines } = graze.drawing(shape);
    return [positions.length / 3, triangles.length / 3, lines.length / 2];
  };
  assert.deepEqual(parts({ type: "point", position: [1, 2, 3] }), [1, 0, 0]);
  assert.deepEqual(parts({ type: "segment", start: [0, 0, 0], end: [1, 0, 0] }), [2, 0, 1]);
  assert.deepEqual(parts({ type: "triangle", a: [0, 0, 0], b: [1, 0, 0], c: [0, 1, 0] }), [3, 1, 3]);
  assert.deepEqual(parts({ type: "aabb", min: [0, 0, 0], max: [1, 1, 0] }), [4, 2, 4]);
  assert.deepEqual(parts({ type: "compound", parts: [] }), [0, 0, 0]);
});

test("unbounded shapes are cut off at a box, and not drawn without one", () => {
  const within = { min: [-2, -2], max: [2, 2] };
  const plane = { type: "plane", normal: [1, 0], offset: 1 };
  assert.equal(graze.drawing(plane).positions.length, 0);
  assert.deepEqual([...graze.drawing(plane, { within }).positions].sort(), [-2, 1, 1, 2]);
  near(area(graze.drawing({ type: "half_space", normal: [1, 0], offset: 1 }, { within })), 12);
  const ray = { type: "ray", origin: [0, 0], direction: [1, 0] };
  assert.deepEqual([...graze.drawing(ray, { within }).positions].sort(), [0, 0, 0, 2]);
  const sheet = graze.drawing({ type: "plane", normal: [0, 0, 5], offset: 0 },
    { within: { min: [-1, -1, -1], max: [1, 1, 1] } });
  assert.deepEqual([sheet.positions.length / 3, sheet.triangles.length / 3, sheet.lines.length / 2], [4, 2, 4]);
});

test("a circle has 3 to 4096 corners", () => {
  const circle = { type: "sphere", center: [0, 0], radius: 1 };
  assert.equal(graze.drawing(circle, { corners: 3 }).positions.length / 2, 3);
  assert.throws(() => graze.drawing(circle, { corners: 2 }), /3 to 4096/);
});

test("a compound in 2D has the outline of all its parts together", () => {
  const parts = [
    { type: "aabb", min: [0, 0], max: [3, 1] },
    { type: "aabb", min: [1, 1], max: [2, 4] },
    { type: "segment", start: [5, 0], end: [6, 0] },
    { type: "compound", parts: [{ type: "aabb", min: [1.25, 0.5], max: [1.75, 2] }] },
  ];
  const drawing = graze.drawing({ type: "compound", parts });
  near(area(drawing), 3 + 3 + 0.75);
  assert.equal(drawing.lines.length / 2, 8 + 1);
});
