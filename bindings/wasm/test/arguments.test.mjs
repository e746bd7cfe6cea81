// SPDX-License-Identifier: MIT
// Shapes are passed to C++ as numbers or, if that is impossible, as text; both give the same results.
import assert from "node:assert/strict";
import { before, test } from "node:test";

import { loadGraze } from "./native.mjs";

let graze;

before(async () => {
  graze = await loadGraze();
});

const isMadeUp = (name) => name === "nothing";

/** The same value, passed as text, because it seems to have an unknown field on first access. */
function asText(shape) {
  let isFirstLook = true;
  return new Proxy(shape, {
    ownKeys(target) {
      const names = Reflect.ownKeys(target);
      if (isFirstLook) names.push("nothing");
      isFirstLook = false;
      return names;
    },
    getOwnPropertyDescriptor: (target, name) =>
      isMadeUp(name)
        ? { value: 0, enumerable: true, configurable: true }
        : Reflect.getOwnPropertyDescriptor(target, name),
    get: (target, name) => (isMadeUp(name) ? 0 : target[name]),
  });
}

let seed = 1;
const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647;
const drawn = (n, size = 4) => Array.from({ length: n }, () => (random() - 0.5) * size);
const positive = (n) => drawn(n).map(Math.abs);

/** A shape of every form. */
const forms = {
  point: (n) => ({ type: "point", position: drawn(n) }),
  segment: (n) => ({ type: "segment", start: drawn(n), end: drawn(n) }),
  ray: (n) => ({ type: "ray", origin: drawn(n), direction: drawn(n) }),
  sphere: (n) => ({ type: "sphere", center: drawn(n), radius: random() }),
  "box by corners": (n) => ({ type: "aabb", min: drawn(n), max: drawn(n).map((value) => value + 5) }),
  "box by center": (n) => ({ type: "aabb", center: drawn(n), half_extents: positive(n) }),
  "upright box": (n) => ({ type: "obb", center: drawn(n), half_extents: positive(n) }),
  "turned box": (n) => ({
    type: "obb", center: drawn(n), half_extents: positive(n),
    ...(n === 2 ? { angle: 999 * random() } : { rotation: { axis: drawn(3), angle: 999 * random() } }),
  }),
  "box by axes": (n) => graze.normalised(forms["turned box"](n)),
  plane: (n) => ({ type: "plane", normal: drawn(n), offset: random() }),
  half_space: (n) => ({ type: "half_space", normal: drawn(n), offset: random() }),
  triangle: (n) => ({ type: "triangle", a: drawn(n), b: drawn(n), c: drawn(n) }),
  capsule: (n) => ({ type: "capsule", a: drawn(n), b: drawn(n), radius: random() }),
  polytope: (n) => ({ type: "polytope", points: Array.from({ length: 1 + 20 * random() }, () => drawn(n)) }),
  mesh: (n) => ({ ...forms["mesh of any kind"](n), kind: random() < 0.5 ? "surface" : "solid" }),
  "mesh of any kind": (n) => ({
    type: "mesh",
    vertices: Array.from({ length: 4 }, () => drawn(n)),
    faces: [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]].slice(0, 5 * random()),
  }),
  compound: (n) => ({
    type: "compound",
    parts: ["sphere", "turned box", "polytope", "ray"].map((name) => forms[name](n)),
  }),
};

const pairQueries = ["relation", "intersects", "distance", "closestPoints", "separation", "contact", "manifold"];
const pointQueries = ["contains", "closestPoint", "closestBoundaryPoint", "signedDistance"];

/** The results of every query about two shapes; `as` is applied to the first argument of each. */
function answersAbout(a, b, n, as) {
  const point = b.position ?? [1, -0, 0.5].slice(0, n);
  const ray = { origin: point, direction: [1, 2, 3].slice(0, n) };
  const motion = { linear: [1, 0, -1].slice(0, n), angular: n === 2 ? 1 : [1, 0, 0] };
  return [
    ...pairQueries.map((query) => graze[query](as(a), b)),
    ...pointQueries.map((query) => graze[query](as(a), point)),
    graze.rayCast(as(a), ray), graze.rayCast(a, as(ray)), graze.rayCast(as(a), { ...ray, type: "ray" }, { side: "exit" }),
    graze.shapeCast(as(a), motion.linear, b), graze.timeOfImpact(as(a), motion, b), graze.timeOfImpact(as(a), motion, b, motion),
    graze.bounds(as(a)), graze.normalised(as(a)),
  ];
}

for (const n of [2, 3]) {
  test(`numbers and text give the same results for every two forms of shapes, bit for bit, in ${n}D`, () => {
    const names = Object.keys(forms);
    const seen = new Map();
    for (const first of names) {
      for (const second of names) {
        for (let i = 0; i < 4; ++i) {
          const [a, b] = [forms[first](n), forms[second](n)];
          const wanted = answersAbout(a, b, n, asText);
          assert.deepStrictEqual(answersAbout(a, b, n, (value) => value), wanted, JSON.stringify([a, b]));
          seen.set(wanted[0], (seen.get(wanted[0]) ?? 0) + 1);
        }
      }
    }
    assert.ok(seen.get("apart") > 50 && seen.get("overlapping") > 50);
  });
}

test("a shape is returned with every bit of its numbers", () => {
  for (const numbers of [[-0, 0], [5e-324, -1.7976931348623157e308], [0.1, 1 / 3]]) {
    assert.deepStrictEqual(graze.normalised({ type: "point", position: numbers }).position, numbers);
  }
  for (const name of Object.keys(forms).filter((form) => !/by center|upright|turned|polytope|compound|of any kind/.test(form))) {
    const shape = forms[name](3);
    assert.deepStrictEqual(graze.normalised(shape), shape);
  }
});

test("fields may be in any order, and undefined ones are ignored", () => {
  const wanted = graze.normalised({ type: "capsule", a: [0, 1], b: [2, 3], radius: 4 });
  assert.deepEqual(graze.normalised({ radius: 4, b: [2, 3], type: "capsule", a: [0, 1], c: undefined }), wanted);
  assert.deepEqual(graze.normalised({ type: "obb", center: [0, 1], half_extents: [1, 1], angle: undefined, axes: undefined }).axes,
    [[1, 0], [0, 1]]);
  class Ball {
    type = "sphere";
    center = Float32Array.of(1, 2);
    radius = 3;
  }
  assert.equal(graze.distance(new Ball(), { type: "point", position: [1, 6] }), 1);
  assert.equal(graze.distance({ type: "sphere", center: [0n, 1n], radius: 2n }, { type: "point", position: [0, 6] }), 3);
});

test("shapes may have many numbers", () => {
  const around = Array.from({ length: 20000 }, (_, i) => [Math.cos(i), Math.sin(i), 0]);
  const hull = graze.normalised({ type: "polytope", points: [...around, [0, 0, 9]] });
  assert.ok(hull.points.length > 10000);
  assert.equal(graze.distance({ type: "point", position: [0, 0, 10] }, hull), 1);
  const parts = around.map((center) => ({ type: "sphere", center, radius: 0.5 }));
  const hole = graze.distance({ type: "compound", parts }, { type: "sphere", center: [0, 0, 0], radius: 0.25 });
  assert.ok(Math.abs(hole - 0.25) < 1e-14, String(hole));
  assert.equal(graze.touchingPairs(parts, Uint32Array.of(0, 3, 0, 44)).length, 2);
});

test("compounds may be nested as deep as in scene files", () => {
  const nested = (depth) => (depth === 0 ? { type: "point", position: [3, 4] } : { type: "compound", parts: [nested(depth - 1)] });
  const origin = { type: "point", position: [0, 0] };
  assert.equal(graze.distance(nested(32), origin), 5);
  assert.throws(() => graze.distance(nested(33), origin), /^Error: a: part 0, .*compounds are nested deeper than 32$/);
});

test("the dimension is that of the first vector, also after a compound without parts", () => {
  const nothing = { type: "compound", parts: [] };
  assert.equal(graze.distance(nothing, { type: "point", position: [0, 0, 0] }), Infinity);
  assert.deepEqual(graze.bounds(nothing), { min: [Infinity, Infinity], max: [-Infinity, -Infinity] });
  assert.equal(graze.shapeCast(nothing, [1, 2, 3], nothing), null);
});

test("a getter may call the module and let its memory grow while arguments are written", () => {
  const point = { type: "point", position: [0, 0, 7] };
  const finders = [];
  const greedy = {
    type: "capsule",
    get a() {
      assert.equal(graze.distance({ type: "sphere", center: [0, 3], radius: 1 }, { type: "point", position: [0, 0] }), 2);
      return [0, 0, 1];
    },
    get b() {
      const before = graze.memoryBytes;
      while (graze.memoryBytes === before) finders.push(new graze.PairFinder(3, 1e6, "double"));
      return [0, 0, 2];
    },
    get radius() {
      assert.throws(() => graze.distance({ type: "sphere", center: [0, 3], radius: -1 }, point), /a: /);
      return 3;
    },
  };
  assert.equal(graze.distance(greedy, point), 2);
  assert.equal(graze.distance(point, greedy), 2);
  for (const finder of finders) finder.delete();
});

test("a getter that throws has no other effect", () => {
  const broken = {
    type: "sphere",
    center: [0, 0],
    get radius() {
      throw new RangeError("mine");
    },
  };
  const point = { type: "point", position: [3, 4] };
  for (let i = 0; i < 2000; ++i) assert.throws(() => graze.distance(point, broken), /^RangeError: mine$/);
  assert.equal(graze.distance(point, { type: "point", position: [0, 0] }), 5);
});

const point = { type: "point", position: [0, 0] };

/** Invalid shapes and their messages. */
const faulty = [
  [null, "must be an object, not null"],
  [[1, 2], "must be an object, not an array"],
  ["sphere", "must be an object, not a string"],
  [{ center: [0, 0], radius: 1 }, 'a shape needs the field "type"'],
  [Object.create({ ...point }), 'a shape needs the field "type"'],
  [{ type: "ball", center: [0, 0], radius: 1 }, 'unknown type "ball"; did you mean "sphere"?'],
  [{ type: "sphere", center: [0, 0] }, 'a sphere needs the field "radius"'],
  [{ type: "sphere", center: [0, 0], radius: "1" }, '"radius" must be a number, not a string'],
  [{ type: "sphere", center: [0, 0], radius: -1 }, '"radius" is -1; it must not be negative'],
  [{ type: "sphere", center: [0, 0], radius: NaN }, '"radius" is NaN; numbers must be finite'],
  [{ type: "sphere", center: [0, -Infinity], radius: 1 }, '"center"[1] is -Infinity; numbers must be finite'],
  [{ type: "sphere", center: [0], radius: 1 }, '"center" has 1 number; this scene has dimension 3'],
  [{ type: "sphere", center: [0, null], radius: 1 }, '"center" must hold numbers; coordinate 1 is null'],
  [{ type: "sphere", center: { x: 0, y: 0 }, radius: 1 }, '"center" must be an array of 2 numbers, not an object'],
  [{ type: "sphere", center: [0, 0], radius: 1, color: 3 }, 'unknown field "color"; known: "type", "center", "radius"'],
  [{ type: "ray", origin: [0, 0], direction: [0, 0] }, '"direction" is zero and so has no direction; any other length is allowed'],
  [{ type: "plane", normal: [0, 0], offset: 1 }, '"normal" is zero and so has no direction; any other length is allowed'],
  [{ type: "aabb", min: [0, 2], max: [1, 1] }, '"min" is above "max" in coordinate 1: 2 > 1'],
  [{ type: "aabb", min: [0, 2] }, 'an aabb needs the field "max"'],
  [{ type: "aabb", min: [0, 0], max: [1, 1], center: [0, 0] }, 'an aabb needs either "min" and "max" or "center" and "half_extents"'],
  [{ type: "aabb", center: [0, 0], half_extents: [1, -1] }, '"half_extents" has -1 as coordinate 1; none may be negative'],
  [{ type: "aabb", center: [1e308, 0], half_extents: [1e308, 1] }, '"half_extents" is too large: the box exceeds the largest number, about 1.8e308'],
  [{ type: "obb", center: [0, 0], half_extents: [1, 1], axes: [[1, 0], [1, 0]] },
    '"axes" are not orthonormal: columns must have length 1 and be at right angles'],
  [{ type: "obb", center: [0, 0], half_extents: [1, 1], axes: [[1, 0]] }, '"axes" must be 2 columns, not 1'],
  [{ type: "obb", center: [0, 0], half_extents: [1, 1], rotation: { axis: [0, 0, 1], angle: 1 } },
    '"rotation" belongs to dimension 3; in dimension 2 give "angle"'],
  [{ type: "obb", center: [0, 0, 0], half_extents: [1, 1, 1], rotation: { axis: [0, 0, 0], angle: 1 } },
    '"axis" is zero and so has no direction; any other length is allowed'],
  [{ type: "obb", center: [0, 0], half_extents: [1, 1], angle: 1, axes: [[1, 0], [0, 1]] },
    '"angle" and "axes" both give the rotation; give only one'],
  [{ type: "polytope", points: [] }, '"points" is empty; a polytope needs at least one point'],
  [{ type: "polytope", points: [[0, 0], [1]] }, '"points"[1] has 1 number; this scene has dimension 2'],
  [{ type: "compound", parts: [point, { type: "sphere", center: [0, 0], radius: -2 }] },
    'part 1: "radius" is -2; it must not be negative'],
  [{ type: "mesh", vertices: [[0, 0], [1, 0], [0, 1]], faces: [[0, 1, 2], [0, 1, 3]] },
    'face 1 has vertex 3, but there are 3 vertices, numbered from 0'],
  [{ type: "mesh", vertices: [[0, 0]], faces: [[0, 0]] }, 'face 0 must be three indices of vertices, not 2'],
  [{ type: "mesh", vertices: [[0, 0]], faces: [[0, 0, -1]] }, '"faces"[0] is -1; it must be a whole number from 0 to 18446744073709551615'],
  [{ type: "mesh", vertices: [], faces: [], kind: "shell" }, '"kind" is "shell"; a mesh is a "surface" or a "solid"'],
];

test("errors of shapes name the field and the value", () => {
  for (const [shape, message] of faulty) {
    for (const ask of [graze.normalised, graze.bounds]) {
      assert.throws(() => ask(shape), { name: "Error", message: `shape: ${message}` });
    }
    const dot = { type: "point", position: shape?.center?.length === 3 || shape?.center?.length === 1 ? [0, 0, 0] : [0, 0] };
    assert.throws(() => graze.distance(dot, shape), { name: "Error", message: `b: ${message}` });
  }
});
