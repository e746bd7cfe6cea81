// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { before, test } from "node:test";

import { assertSameBits, contactNumbers, hitNumbers, loadGraze, manifoldNumbers, nativeAnswers } from "./native.mjs";

let graze;
let native;

before(async () => {
  graze = await loadGraze();
  native = nativeAnswers();
});

const relations = ["apart", "touching", "overlapping"];

const hasNumbers = (shape) => /\d/.test(JSON.stringify(shape));

function pairAnswers(a, b) {
  const near = graze.closestPoints(a, b);
  assert.equal(near.relation, graze.relation(a, b));
  assert.equal(graze.intersects(a, b), near.relation !== "apart");
  const found = graze.contact(a, b);
  const touching = graze.manifold(a, b);
  const { point, depth, ...rest } = found ?? {};
  assert.deepStrictEqual(graze.separation(a, b), found ? { ...near, ...rest, distance: 0 - depth } : near);
  return [
    relations.indexOf(near.relation),
    graze.distance(a, b),
    near.distance,
    ...near.pointA,
    ...near.pointB,
    ...near.normal,
    near.error,
    ...contactNumbers(found),
    ...manifoldNumbers(touching),
  ];
}

function shapeAnswers(shape, point, ray) {
  const hits = [graze.rayCast(shape, ray), graze.rayCast(shape, ray, { side: "exit" })];
  const box = graze.bounds(shape);
  return [
    ...hits.flatMap(hitNumbers),
    graze.contains(shape, point) ? 1 : 0,
    ...graze.closestPoint(shape, point),
    ...graze.closestBoundaryPoint(shape, point),
    graze.signedDistance(shape, point),
    ...box.min,
    ...box.max,
  ];
}

function castAnswers(a, b, point, { direction }) {
  const isFlat = point.length === 2;
  const back = direction.map((value) => -value);
  const first = { linear: direction, angular: isFlat ? 1 : [1, 0, -2], center: point };
  const second = { linear: back, angular: isFlat ? direction[0] : direction, center: direction };
  return [
    ...hitNumbers(graze.shapeCast(a, direction, b)),
    ...hitNumbers(graze.timeOfImpact(a, first, b, second)),
  ];
}

function optionAnswers(a, b, { direction }) {
  const options = [
    { ignoreInitialTouch: true }, { targetDistance: 0.25 }, { ignoreInitialTouch: true, targetDistance: 0.25 },
  ];
  return [
    ...options.flatMap((each) => hitNumbers(graze.shapeCast(a, direction, b, each))),
    ...contactNumbers(graze.contact(a, b, { margin: 2 })),
    ...manifoldNumbers(graze.manifold(a, b, { margin: 2 })),
  ];
}

test("every query gives native results for thousands of pairs of shapes, bit for bit", () => {
  const lines = native("queries.ndjson").toString().trimEnd().split("\n");
  assert.ok(lines.length >= 2000);
  const seen = { apart: 0, touching: 0, overlapping: 0, near: 0 };
  for (const line of lines) {
    const { a, b, point, ray, answers, casts, options } = JSON.parse(line);
    // A compound without parts has no vectors that determine the dimension.
    if (!hasNumbers(a) && !hasNumbers(b)) continue;
    const ours = [...pairAnswers(a, b), ...shapeAnswers(a, point.position, ray)];
    const compared = hasNumbers(a) ? answers.length : answers.length - 2 * point.position.length;
    assertSameBits(ours.slice(0, hasNumbers(a) ? ours.length : compared), answers.slice(0, compared), () => line);
    assertSameBits(castAnswers(a, b, point.position, ray), casts, () => line);
    assertSameBits(optionAnswers(a, b, ray), options, () => line);
    seen[graze.relation(a, b)] += 1;
    seen.near += graze.contact(a, b, { margin: 2 })?.depth < 0 ? 1 : 0;
  }
  for (const [what, count] of Object.entries(seen)) assert.ok(count > 100, `${what}: ${count} times`);
});

test("contacts keep their ids while a box, or a hull of the same corners, slides and tips", () => {
  const floor = { type: "obb", center: [0, 0, -1], half_extents: [9, 9, 1] };
  const corners = [1, -1].flatMap((x) => [1, -1].flatMap((y) => [-0.5, 1.5].map((z) => [x, y, z])));
  const moved = ([x, y, z], way) => [x + way * y, y - way * x, z + 0.49 + way * x];
  const box = (way) => ({ type: "obb", center: [way, way, 0.99], half_extents: [1, 1, 1] });
  const hull = (way) => ({ type: "polytope", points: corners.map((corner) => moved(corner, way)) });
  for (const shape of [box, hull]) {
    const idsAfter = (way) => graze.manifold(floor, shape(way)).points.map(({ id }) => id);
    const ids = idsAfter(0);
    assert.equal(new Set(ids.map((id) => JSON.stringify(id))).size, 4);
    for (const { a, b, partA, partB } of ids) {
      assert.deepEqual(a, { kind: "face", index: 5 });
      assert.equal(b.kind, "vertex");
      assert.deepEqual([partA, partB], [0, 0]);
      if (shape === hull) assert.equal(corners[b.index][2], -0.5);
    }
    for (const way of [1e-15, -1e-15, 1e-7, -1e-7]) assert.deepEqual(idsAfter(way), ids);
  }
});

test("shapes are returned in the library's representation", () => {
  assert.deepEqual(graze.normalised({ type: "aabb", center: [1, 2], half_extents: [1, 0.5] }), {
    type: "aabb",
    min: [0, 1.5],
    max: [2, 2.5],
  });
  const { axes } = graze.normalised({ type: "obb", center: [0, 0], half_extents: [1, 1], angle: 90 });
  assert.deepEqual(axes.flat().map((number) => number + 0), [0, 1, -1, 0]);
});

test("negative zero keeps its sign on the way in and out", () => {
  assert.ok(Object.is(graze.bounds({ type: "point", position: [-0, 1] }).min[0], -0));
  assert.ok(Object.is(graze.normalised({ type: "point", position: [-0, 1] }).position[0], -0));
});

test("vectors may be typed arrays", () => {
  const sphere = { type: "sphere", center: new Float32Array([1, 2, 3]), radius: 1 };
  assert.equal(graze.distance(sphere, { type: "point", position: new Float64Array([1, 2, 6]) }), 2);
});

test("bounding volumes contain all points, however these are given", () => {
  const square = [[0, 0], [4, 0], [4, 4], [0, 4]];
  const inRow = new Float32Array(square.flat());
  assert.deepEqual(graze.boundingSphere(square).center, [2, 2]);
  assert.ok(Math.abs(graze.boundingSphere(inRow, 2).radius - Math.sqrt(8)) < 1e-14);
  assert.ok(graze.boundingSphereFast(square).radius >= Math.sqrt(8));
  assert.deepEqual(graze.boundingBox(inRow, 2), { type: "aabb", min: [0, 0], max: [4, 4] });
  assert.deepEqual(graze.boundingObb(square).half_extents, [2, 2]);
  assert.deepEqual(graze.convexHull([...square, [2, 2]]).points, square);
});

test("errors are of type Error, with the library's message and without a position in a text that nobody wrote", () => {
  const point = { type: "point", position: [0, 0] };
  const thrown = (call, message) => assert.throws(call, (error) => error instanceof Error && error.message === message);
  thrown(() => graze.distance({ type: "sphere", center: [0, 0], raduis: 1 }, point),
    'a: unknown field "raduis"; did you mean "radius"?');
  thrown(() => graze.distance(point, { type: "sphere", center: [0, 0], radius: -1 }), 'b: "radius" is -1; it must not be negative');
  thrown(() => graze.contains(point, [NaN, 0]), 'point: "position"[0] is NaN; numbers must be finite');
  thrown(() => graze.convexHull([], 2), "convex_hull: there are no points");
  thrown(() => graze.convexHull(new Float32Array(5), 2), "points: 5 numbers are not a multiple of 2");
  thrown(() => graze.boundingSphere([[0, 0], [0, 0, 0]]), "points: one has 3 numbers; this set has dimension 2");
  thrown(() => graze.rayCast(point, { origin: [0, 0], direction: [0, 0] }), 'ray: "direction" is zero and so has no direction; any other length is allowed');
  assert.throws(() => graze.relation(point, { type: "point", position: [0, 0, 0] }), /^Error: b: .*3 numbers/);
});

test("an error has no other effect: the next call works", () => {
  assert.throws(() => graze.distance(null, null), Error);
  assert.equal(graze.distance({ type: "point", position: [0, 0] }, { type: "point", position: [3, 4] }), 5);
});

test("a ball that flies at a wall touches it with its side", () => {
  const ball = { type: "sphere", center: [0, 0], radius: 1 };
  const wall = { type: "aabb", min: [5, -3], max: [6, 3] };
  const { t, point, normal } = graze.shapeCast(ball, [8, 0], wall);
  assert.deepEqual({ t, point, normal: normal.map((value) => value + 0) }, { t: 0.5, point: [5, 0], normal: [1, 0] });
  assert.equal(graze.shapeCast(ball, [3, 0], wall), null);
  assert.equal(graze.shapeCast(ball, [-8, 0], wall), null);
});

test("a plank that rotates by 90 degrees about its center hits what is beside it", () => {
  const plank = { type: "obb", center: [0, 0], half_extents: [2, 0] };
  const nail = { type: "point", position: [0, 1] };
  const impact = graze.timeOfImpact(plank, { angular: Math.PI }, nail);
  assert.ok(Math.abs(impact.t - 0.5) < 1e-9, String(impact.t));
  assert.ok(impact.t <= 0.5);
  assert.equal(graze.timeOfImpact(plank, { angular: 1 }, nail), null);
  const cross = { type: "compound", parts: [plank] };
  assert.equal(graze.timeOfImpact(cross, { angular: Math.PI }, nail).t, impact.t);
});

test("invalid motions are refused with their name", () => {
  const ball = { type: "sphere", center: [0, 0], radius: 1 };
  const refused = (call, message) => assert.throws(call, (error) => error instanceof Error && message.test(error.message));
  refused(() => graze.shapeCast(ball, [1, 2, 3], ball), /^motion: it has 3 numbers; it must have 2$/);
  refused(() => graze.shapeCast(ball, 1, ball), /^motion: it is not a vector; it must have 2$/);
  refused(() => graze.shapeCast(ball, [NaN, 0], ball), /^motion: it is NaN; numbers must be finite$/);
  refused(() => graze.timeOfImpact(ball, { linear: [1] }, ball), /^motionA\.linear: it has 1 numbers; it must have 2$/);
  refused(() => graze.timeOfImpact(ball, {}, ball, { turn: 1 }), /^motionB: unknown field "turn"; the fields are/);
  refused(() => graze.timeOfImpact(ball, { angular: [1] }, ball), /^motionA\.angular: it is 1; numbers must be finite$/);
});
