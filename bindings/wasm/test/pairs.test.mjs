// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { before, test } from "node:test";

import { loadGraze, nativeAnswers } from "./native.mjs";

let graze;
let native;

before(async () => {
  graze = await loadGraze();
  native = nativeAnswers();
});

/** The numbers in a file, aligned. */
const numbersOf = (file, type) => new type(Uint8Array.from(native(file)).buffer);

const spaces = [
  { dimension: 2, scalar: "float", type: Float32Array },
  { dimension: 3, scalar: "float", type: Float32Array },
  { dimension: 2, scalar: "double", type: Float64Array },
  { dimension: 3, scalar: "double", type: Float64Array },
];

for (const { dimension, scalar, type } of spaces) {
  const name = `pairs_${dimension}d_${scalar}`;

  test(`100,000 boxes in ${dimension}D of type ${scalar} have the native pairs, in their order`, () => {
    const boxes = numbersOf(`${name}.boxes`, type);
    assert.equal(boxes.length, 100000 * 2 * dimension);
    const expected = numbersOf(`${name}.pairs`, Uint32Array);
    assert.ok(expected.length > 2 * 50000);
    assert.deepEqual(graze.overlappingPairs(boxes, dimension), expected);
  });

  test(`a finder finds the same pairs of boxes in ${dimension}D of type ${scalar}`, () => {
    const boxes = numbersOf(`${name}.boxes`, type);
    const finder = new graze.PairFinder(dimension, boxes.length / (2 * dimension), scalar);
    finder.boxes.set(boxes);
    const expected = numbersOf(`${name}.pairs`, Uint32Array);
    for (let frame = 0; frame < 3; ++frame) assert.deepEqual(finder.find().slice(), expected);
    finder.delete();
  });
}

for (const dimension of [2, 3]) {
  test(`the touching pairs of many candidates in ${dimension}D are the native ones`, () => {
    const { shapes, candidates, touching } = JSON.parse(native(`touching_${dimension}d.json`));
    assert.ok(touching.length > 2000 && touching.length < 0.9 * candidates.length, `${touching.length}`);
    assert.deepEqual([...graze.touchingPairs(shapes, Uint32Array.from(candidates))], touching);
  });
}

test("candidates with invalid indexes are refused", () => {
  const ball = { type: "sphere", center: [0, 0], radius: 1 };
  assert.throws(() => graze.touchingPairs([ball, ball], new Uint32Array([0, 2])), /^Error: candidates: there is no shape 2; there are 2$/);
  assert.throws(() => graze.touchingPairs([ball], new Uint32Array(3)), /3 numbers are not a multiple of 2/);
  assert.throws(() => graze.touchingPairs([ball], [0, 0]), /must be a Uint32Array/);
  assert.deepEqual([...graze.touchingPairs([], new Uint32Array(0))], []);
});

const row = new Float32Array([0, 0, 1, 1, /**/ 1, 0, 2, 1, /**/ 2.5, 0, 3, 1]);

test("every method finds the known pairs of three boxes, with and without a margin", () => {
  for (const method of ["automatic", "brute_force", "dense", "tree"]) {
    assert.deepEqual([...graze.overlappingPairs(row, 2, { method })], [0, 1]);
    assert.deepEqual([...graze.overlappingPairs(row, 2, { method, margin: 0.25 })], [0, 1, 1, 2]);
  }
});

test("pairs between two sets name the first set's box first", () => {
  assert.deepEqual([...graze.overlappingPairsBetween(row, row.slice(0, 4), 2)], [0, 0, 1, 0]);
});

test("boxes and pairs of a finder are in the module's memory", () => {
  const finder = new graze.PairFinder(2, 3);
  const { boxes } = finder;
  boxes.set(row);
  assert.deepEqual([...finder.find()], [0, 1]);
  boxes[8] = 2;  // the third box now touches the second
  assert.deepEqual([...finder.find({ order: "any" })].sort(), [0, 1, 1, 2]);
  assert.equal(finder.method, "dense");
  assert.ok(finder.bytes > 0);
});

test("a finder keeps the boxes below its new count, and the view of them is new", () => {
  const finder = new graze.PairFinder(2, 3);
  finder.boxes.set(row);
  finder.count = 100000;
  assert.deepEqual([...finder.boxes.slice(0, 12)], [...row]);
  assert.equal(finder.boxes.length, 400000);
  assert.equal(finder.boxes[12], 0);
  finder.count = 2;
  assert.deepEqual([...finder.find()], [0, 1]);
});

test("invalid arguments are refused with a message", () => {
  const refused = (call, message) => assert.throws(call, (error) => error instanceof Error && message.test(error.message));
  refused(() => graze.overlappingPairs(new Float32Array([NaN, 0, 1, 1]), 2), /NaN|not a number/);
  refused(() => graze.overlappingPairs(row, 2, { margin: -1 }), /margin/);
  refused(() => graze.overlappingPairs(row, 2, { method: "grid" }),
    /no method "grid"; the methods are "automatic", "brute_force", "dense", "tree"/);
  refused(() => graze.overlappingPairs(row, 2, { order: "up" }), /order: it is up; it must be sorted or any/);
  refused(() => graze.overlappingPairs(row, 4), /dimension must be 2 or 3, not 4/);
  refused(() => graze.overlappingPairs(row.slice(1), 2), /11 numbers are not a multiple of 4/);
  refused(() => graze.overlappingPairsBetween(row, new Float64Array(4), 2), /of one type/);
  refused(() => new graze.PairFinder(2, -1), /count: -1 is not a whole number/);
  refused(() => new graze.PairFinder(2, 1, "half"), /scalar: it is half/);
});
