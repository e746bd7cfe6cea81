// SPDX-License-Identifier: MIT
// The contacts of a scene's objects, and objects moved by poses.
import assert from "node:assert/strict";
import { before, test } from "node:test";

import { loadGraze } from "./native.mjs";

let graze;

before(async () => {
  graze = await loadGraze();
});

let seed = 7;
const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647;
const drawn = (n, size) => Array.from({ length: n }, () => random() * size);

/** Many shapes of every type with an interior, and a floor. */
function crowd(n) {
  const shapes = Array.from({ length: 200 }, (_, i) => [
    () => ({ type: "sphere", center: drawn(n, 6), radius: 0.7 }),
    () => ({ type: "aabb", center: drawn(n, 6), half_extents: drawn(n, 1) }),
    () => ({ type: "obb", center: drawn(n, 6), half_extents: drawn(n, 1),
      ...(n === 2 ? { angle: 360 * random() } : { rotation: { axis: drawn(3, 1), angle: 360 * random() } }) }),
    () => ({ type: "capsule", a: drawn(n, 6), b: drawn(n, 6), radius: 0.2 }),
    () => ({ type: "polytope", points: [drawn(n, 6), drawn(n, 6), drawn(n, 6), drawn(n, 6)] }),
    () => ({ type: "compound", parts: [{ type: "sphere", center: drawn(n, 6), radius: 0.5 }, { type: "point", position: drawn(n, 6) }] }),
  ][i % 6]());
  return [...shapes, { type: "half_space", normal: [0, 0, 1].slice(-n), offset: 0.5 }];
}

for (const n of [2, 3]) {
  test(`the contacts of a scene are the manifolds of its pairs, bit for bit, in ${n}D`, () => {
    const scene = new graze.Scene(n);
    const ids = scene.addMany(crowd(n));
    scene.remove(ids[3]);
    scene.update();
    const contacts = scene.contacts();
    assert.deepEqual(contacts.flatMap(({ a, b }) => [a, b]), [...scene.pairs()]);
    assert.ok(contacts.length > 300);
    for (const { a, b, ...found } of contacts) {
      assert.deepStrictEqual(found, graze.manifold(scene.object(a).shape, scene.object(b).shape));
    }
    const arrays = scene.contactArrays();
    const features = ["vertex", "edge", "face"];
    assert.deepStrictEqual(arrays, {
      ids: scene.pairs(),
      starts: Uint32Array.from([0, ...contacts].map((sum => (each) => (sum += each === 0 ? 0 : each.points.length))(0))),
      normals: Float64Array.from(contacts.flatMap(({ normal }) => normal)),
      statuses: Uint8Array.from(contacts, ({ status }) => (status === "converged" ? 0 : 1)),
      errors: Float64Array.from(contacts, ({ error }) => error),
      points: Float64Array.from(contacts.flatMap(({ points }) => points.flatMap(({ point }) => point))),
      pointsA: Float64Array.from(contacts.flatMap(({ points }) => points.flatMap(({ pointA }) => pointA))),
      pointsB: Float64Array.from(contacts.flatMap(({ points }) => points.flatMap(({ pointB }) => pointB))),
      depths: Float64Array.from(contacts.flatMap(({ points }) => points.map(({ depth }) => depth))),
      contactIds: Uint32Array.from(contacts.flatMap(({ points }) => points.flatMap(({ id: { a, b, partA, partB } }) =>
        [features.indexOf(a.kind), a.index, features.indexOf(b.kind), b.index, partA, partB]))),
    });
    scene.delete();
  });
}

test("a scene in which nothing touches has no contacts", () => {
  const scene = new graze.Scene(3);
  assert.deepEqual(scene.contacts(), []);
  assert.deepEqual(scene.contactArrays().starts, Uint32Array.of(0));
  scene.delete();
});

/** The numbers of a shape up to rounding. */
const rounded = (shape) => JSON.parse(JSON.stringify(shape), (key, value) =>
  (typeof value === "number" ? Math.round(value * 1e12) / 1e12 + 0 : value));

test("poses rotate and move objects of every type, starting from their initial shapes", () => {
  const scene = new graze.Scene(2);
  const shapes = [
    { type: "point", position: [1, 0] },
    { type: "sphere", center: [1, 0], radius: 2 },
    { type: "obb", center: [1, 0], half_extents: [2, 1] },
    { type: "aabb", min: [0, -1], max: [2, 1] },
    { type: "half_space", normal: [1, 0], offset: 1 },
    { type: "polytope", points: [[0, 0], [1, 0], [0, 1]] },
    { type: "compound", parts: [{ type: "capsule", a: [0, 0], b: [1, 0], radius: 1 }] },
  ];
  const ids = scene.addMany(shapes);
  const all = (pose) => Float64Array.from(shapes.flatMap(() => pose));
  const now = () => Array.from(ids, (id) => rounded(scene.object(id).shape));
  for (let i = 0; i < 100; ++i) scene.pose(ids, all([i, i / 7, i / 3]));
  scene.pose(ids, all([10, 20, Math.PI / 2]));
  const turned = { type: "obb", center: [10, 21], half_extents: [2, 1], axes: [[0, 1], [-1, 0]] };
  assert.deepEqual(now(), [
    { type: "point", position: [10, 21] },
    { type: "sphere", center: [10, 21], radius: 2 },
    turned,
    { ...turned, half_extents: [1, 1] },
    { type: "half_space", normal: [0, 1], offset: 21 },
    { type: "polytope", points: [[10, 20], [10, 21], [9, 20]] },
    { type: "compound", parts: [{ type: "capsule", a: [10, 20], b: [10, 21], radius: 1 }] },
  ]);
  const exactly = (id) => scene.object(id).shape;
  scene.pose(ids, all([0, 0, 0]));
  assert.deepStrictEqual([...ids].filter((_, i) => i !== 2 && i !== 3).map(exactly).map((shape) => shape.type === "point" ? shape : shape),
    shapes.filter((_, i) => i !== 2 && i !== 3));
  scene.delete();
});

test("poses in 3D accept quaternions of any nonzero length", () => {
  const scene = new graze.Scene(3);
  const ids = scene.addMany([{ type: "obb", center: [1, 0, 0], half_extents: [1, 2, 3] }, { type: "point", position: [0, 0, 1] }]);
  // A third of a turn about the diagonal takes x to y, y to z and z to x.
  for (const length of [1, 3, 1e-200, 1e200]) {
    scene.pose(ids, Float64Array.from([5, 6, 7, 0.5, 0.5, 0.5, 0.5, 0, 0, 0, 0.5, 0.5, 0.5, 0.5], (x, i) => (i % 7 > 2 ? x * length : x)));
    assert.deepEqual(Array.from(ids, (id) => rounded(scene.object(id).shape)), [
      { type: "obb", center: [5, 7, 7], half_extents: [1, 2, 3], axes: [[0, 1, 0], [0, 0, 1], [1, 0, 0]] },
      { type: "point", position: [1, 0, 0] },
    ]);
  }
  const [first] = ids;
  const one = Float64Array.of(first);
  const turn = (angle) => [0, 0, Math.sin(angle / 2), Math.cos(angle / 2)];
  for (let i = 0; i < 500; ++i) {
    scene.pose(one, Float64Array.of(random(), random(), random(), ...turn(random() * 9)));
    const { axes } = scene.object(first).shape;
    for (const axis of axes) assert.ok(Math.abs(Math.hypot(...axis) - 1) < 1e-15 * 4);
  }
  scene.delete();
});

test("a pose starts from the shape that another method has set", () => {
  const scene = new graze.Scene(2);
  const ids = scene.addSpheres(new Float64Array([0, 0, 1]));
  const center = () => scene.object(ids[0]).shape.center;
  scene.pose(ids, [3, 4, 0]);
  scene.pose(ids, [1, 1, 0]);
  assert.deepEqual(center(), [1, 1]);
  const others = [
    () => scene.translate(ids, [1, 0]),
    () => scene.place(ids, [2, 1]),
    () => scene.moveSpheres(ids, [2, 1, 1]),
    () => scene.move(ids[0], { type: "sphere", center: [2, 1], radius: 1 }),
  ];
  for (const other of others) {
    scene.moveSpheres(ids, [1, 1, 1]);
    other();
    assert.deepEqual(center(), [2, 1]);
    scene.pose(ids, [10, 10, 0]);
    scene.pose(ids, [20, 20, 0]);
    assert.deepEqual(center(), [22, 21]);
  }
  scene.remove(ids[0]);
  const again = scene.addSpheres(new Float64Array([5, 5, 1]));
  assert.equal(graze.slotOf(again[0]), graze.slotOf(ids[0]));
  scene.pose(again, [1, 0, 0]);
  assert.deepEqual(scene.object(again[0]).shape.center, [6, 5]);
  scene.delete();
});

test("invalid poses are refused, and nothing moves", () => {
  const flat = new graze.Scene(2);
  const ids = flat.addSpheres(new Float64Array([0, 0, 1, 5, 0, 1]));
  const refused = (call, message) => assert.throws(call, (error) => error instanceof Error && error.message === message);
  refused(() => flat.pose(ids, [1, 1, 0, 1, 1, NaN]), "pose 1 has a number that is not finite");
  refused(() => flat.pose(ids, [1, 1, 0]), "poses: there are 1 for 2 ids");
  refused(() => flat.pose(ids, [1, 1]), "poses: 2 numbers are not a multiple of 3");
  assert.deepEqual([...flat.boxes(ids)], [-1, -1, 1, 1, 4, -1, 6, 1]);
  const deep = new graze.Scene(3);
  const ball = deep.addSpheres(new Float64Array([0, 0, 0, 1]));
  refused(() => deep.pose(ball, [1, 1, 1, 0, 0, 0, 0]), "pose 0 has a quaternion of length zero");
  for (const scene of [flat, deep]) scene.delete();
});
