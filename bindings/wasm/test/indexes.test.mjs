// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { before, test } from "node:test";

import { assertSameBits, loadGraze, nativeAnswers } from "./native.mjs";

let graze;
let native;

before(async () => {
  graze = await loadGraze();
  native = JSON.parse(nativeAnswers()("indexes.json"));
});

const makers = {
  QuadTree: () => new graze.QuadTree({ capacity: 4, maxDepth: 8 }),
  Octree: () => new graze.Octree({ capacity: 4, maxDepth: 8 }),
  Bvh2: () => new graze.Bvh(2),
  Bvh3: () => new graze.Bvh(3, { margin: 0.5 }),
};

/** All cells as consecutive numbers, in the format of the native program. */
function cellNumbers(index) {
  const { boxes, depths, counts, leaves } = index.cells();
  const width = 2 * index.dimension;
  return Array.from(depths, (_, i) => [
    ...boxes.subarray(i * width, (i + 1) * width), depths[i], counts[i], leaves[i],
  ]).flat();
}

for (const [name, make] of Object.entries(makers)) {
  test(`${name} gives native results for moved boxes, in the same order, and has the same cells`, () => {
    const expected = native[name];
    const index = make();
    const keys = index.insertMany(Float64Array.from(expected.boxes));
    index.updateMany(keys, Float64Array.from(expected.moved));
    const slots = (list) => Array.from(list, graze.slotOf);
    assertSameBits(slots(index.query(expected.region)), expected.found, () => "query");
    assert.ok(expected.found.length > 20);
    assertSameBits(index.rayCast(expected.ray).flatMap(({ key, t }) => [graze.slotOf(key), t]), expected.hits, () => "ray");
    const near = index.nearest(expected.center.position, 20);
    assertSameBits(near.flatMap((each) => [graze.slotOf(each.key), each.distanceSquared]), expected.near, () => "nearest");
    assertSameBits(cellNumbers(index), expected.cells, () => "cells");
    const inRow = Float64Array.from(expected.moved);
    assert.deepEqual(slots(index.pairs()), [...graze.overlappingPairs(inRow, index.dimension)]);
    index.delete();
  });

  test(`${name} inserts, moves and erases a box`, () => {
    const index = make();
    const at = (x) => ({ min: Array(index.dimension).fill(x), max: Array(index.dimension).fill(x + 1) });
    const key = index.insert(at(0));
    const other = index.insert(at(10));
    assert.deepEqual(index.box(key), at(0));
    index.update(key, at(9.5));
    assert.deepEqual([...index.pairs()], [key, other]);
    index.erase(key);
    assert.ok(!index.contains(key) && index.contains(other));
    assert.equal(index.size, 1);
    assert.throws(() => index.update(key, at(1)), /names no|was erased/);
    index.clear();
    assert.equal(index.size, 0);
    assert.equal(index.cells().depths.length, name.startsWith("Bvh") ? 0 : index.cells().depths.length);
  });

  test(`${name} changes nothing when it refuses one box of many`, () => {
    const index = make();
    const good = Array(index.dimension).fill(0).concat(Array(index.dimension).fill(1));
    const bad = good.map((number, i) => (i === 0 ? NaN : number));
    assert.throws(() => index.insertMany(Float64Array.from([...good, ...bad])), /not a number/);
    assert.equal(index.size, 0);
    const keys = index.insertMany(Float64Array.from([...good, ...good]));
    assert.throws(() => index.updateMany(keys, Float64Array.from([...good.map((x) => x + 5), ...bad])), /not a number/);
    assert.deepEqual(index.box(keys[0]).max, Array(index.dimension).fill(1));
  });
}

test("invalid options and keys are refused", () => {
  assert.throws(() => new graze.QuadTree({ capacity: 0 }), /capacity: 0 is not a whole number of at least 1/);
  assert.throws(() => new graze.QuadTree({ maxDepth: 33 }), /max_depth/);
  assert.throws(() => new graze.Bvh(2, { margin: -1 }), /margin/);
  assert.throws(() => new graze.Bvh(4), /dimension/);
  const tree = new graze.QuadTree();
  assert.throws(() => tree.erase(1.5), /an id is an integer returned by graze; 1.5 is not/);
  assert.throws(() => tree.insert({ min: [0, 0, 0], max: [1, 1, 1] }), /in dimension 2/);
});
