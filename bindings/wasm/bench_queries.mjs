// SPDX-License-Identifier: MIT
// Measures one query in the module, from plain objects to the result: node bindings/wasm/bench_queries.mjs [ROUNDS].
// Each query is called for eight positions of a shape in turn, and its results are checked. Times are those of the
// fastest of many short rounds, in microseconds, because other load on the machine only adds to them. The row "far
// apart" is almost entirely overhead: two shapes are passed, and one test shows that they do not touch.
import assert from "node:assert/strict";

import { loadGraze } from "./test/native.mjs";

const rounds = Number(process.argv[2] ?? 500);
const warmUp = 40;
const calls = 64;
const variants = 8;
const graze = await loadGraze();

/** Copies of a shape, each moved a little farther along x, by an exact number. */
const copies = (make) => Array.from({ length: variants }, (_, i) => make(i / 64));

const cube = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [i & 1, (i >> 1) & 1, i >> 2]);
const circle = Array.from({ length: 32 }, (_, i) => [Math.cos((i * Math.PI) / 16), Math.sin((i * Math.PI) / 16)]);
const unit = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

const sphere2 = (x) => ({ type: "sphere", center: [x, 0], radius: 1 });
const box2 = (x) => ({ type: "obb", center: [x, 0], half_extents: [1, 1], angle: 90 });
const sphere3 = (x) => ({ type: "sphere", center: [x, 0, 0], radius: 1 });
const box3 = (x) => ({ type: "obb", center: [x, 0, 0], half_extents: [1, 1, 1], axes: unit });
const turned3 = (x) => ({
  type: "obb", center: [x, 0, 0], half_extents: [1, 1, 1], rotation: { axis: [1, 0, 0], angle: 90 },
});
const hull3 = (x) => ({ type: "polytope", points: cube.map(([a, b, c]) => [x - 1 + 2 * a, 2 * b - 1, 2 * c - 1]) });
const capsule3 = (x) => ({ type: "capsule", a: [x, 0, -1], b: [x, 0, 1], radius: 1 });
const pair3 = (x) => ({ type: "compound", parts: [sphere3(x), box3(x)] });
const disc2 = (x) => ({ type: "polytope", points: circle.map(([a, b]) => [x + a, b]) });

const shapes = {
  "circle": [sphere2, 2], "rectangle": [box2, 2], "polygon of 32": [disc2, 2], "sphere": [sphere3, 3], "capsule": [capsule3, 3],
  "oriented box": [box3, 3], "box by rotation": [turned3, 3], "hull of 8": [hull3, 3], "compound of 2": [pair3, 3],
};

/** A polygon of 32 corners equals a circle up to half a percent. */
const isNear = (value, wanted) => Math.abs(value - wanted) < 5e-3;

/** A query: its call for a shape at x and a similar one at x + 3 or x + 1.5, and a check of the result. */
const pairQueries = {
  "far apart": [99, (a, b) => graze.relation(a, b), (answer) => answer === "apart"],
  intersects: [1.5, (a, b) => graze.intersects(a, b), (answer) => answer],
  relation: [1.5, (a, b) => graze.relation(a, b), (answer) => answer === "overlapping"],
  distance: [3, (a, b) => graze.distance(a, b), (answer) => isNear(answer, 1)],
  closestPoints: [3, (a, b) => graze.closestPoints(a, b), (answer) => isNear(answer.distance, 1)],
  separation: [3, (a, b) => graze.separation(a, b), (answer) => isNear(answer.distance, 1)],
  contact: [1.5, (a, b) => graze.contact(a, b), (answer) => isNear(answer.depth, 0.5)],
  manifold: [1.5, (a, b) => graze.manifold(a, b), (answer) => isNear(answer.points[0].depth, 0.5)],
};
const way = { 2: [2, 0], 3: [2, 0, 0] };
const casts = {
  shapeCast: [3, (a, b, n) => graze.shapeCast(a, way[n], b), (answer) => isNear(answer.t, 0.5)],
  timeOfImpact: [3, (a, b, n) => graze.timeOfImpact(a, { linear: way[n] }, b), (answer) => isNear(answer.t, 0.5)],
};
const origins = { 2: [-9, 0], 3: [-9, 0, 0] };
const shapeQueries = {
  contains: [0, (a, b, n) => graze.contains(a, origins[n]), (answer) => !answer],
  closestPoint: [0, (a, b, n) => graze.closestPoint(a, origins[n]), (answer, x) => isNear(answer[0], x - 1)],
  signedDistance: [0, (a, b, n) => graze.signedDistance(a, origins[n]), (answer, x) => isNear(answer, 8 + x)],
  rayCast: [0, (a, b, n) => graze.rayCast(a, { origin: origins[n], direction: way[n] }), (answer, x) => isNear(answer.t, 4 + x / 2)],
  bounds: [0, (a) => graze.bounds(a), (answer, x) => isNear(answer.min[0], x - 1)],
};

function timed([offset, ask, isRight], [make, n]) {
  const first = copies(make);
  const second = copies((x) => make(x + offset));
  for (let i = 0; i < variants; ++i) {
    const answer = ask(first[i], second[i], n);
    assert.ok(isRight(answer, i / 64), `${ask}: ${JSON.stringify(answer)}`);
  }
  let quickest = Infinity;
  for (let round = -warmUp; round < rounds; ++round) {
    const start = performance.now();
    for (let i = 0; i < calls; ++i) ask(first[i % variants], second[i % variants], n);
    if (round >= 0) quickest = Math.min(quickest, ((performance.now() - start) * 1000) / calls);
  }
  return quickest;
}

/** All queries that the module has. */
const queries = Object.entries({ ...pairQueries, ...casts, ...shapeQueries }).filter(([name]) => name in graze || name === "far apart");
const names = Object.keys(shapes);
console.log("microseconds per call");
console.log(["".padEnd(15), ...names.map((name) => name.padStart(16))].join(""));
for (const [query, row] of queries) {
  const cells = names.map((name) => timed(row, shapes[name]).toFixed(2).padStart(16));
  console.log([query.padEnd(15), ...cells].join(""));
}
