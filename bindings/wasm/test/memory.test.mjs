// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { setTimeout } from "node:timers/promises";
import { join } from "node:path";
import { before, test } from "node:test";
import { setFlagsFromString } from "node:v8";
import { runInNewContext } from "node:vm";

import { loadGraze, packageFolder, root } from "./native.mjs";

let graze;

before(async () => {
  graze = await loadGraze();
});

/** Uses every kind of object and deletes it, or leaves it to garbage collection. */
function useEverything(givesBack) {
  const scene = new graze.Scene(3);
  scene.addSpheres(Float32Array.from({ length: 4000 }, (_, i) => (i % 4 === 3 ? 1 : (i * 7919) % 20)));
  scene.update();
  const file = graze.readScene(readFileSync(join(root, "data/workshop.json")), "workshop");
  file.check();
  const tree = new graze.Octree();
  tree.insertMany(Float64Array.from({ length: 6000 }, (_, i) => i % 50 + (i % 6 > 2 ? 100 : 0)));
  const bvh = new graze.Bvh(2);
  bvh.insert({ min: [0, 0], max: [1, 1] });
  const finder = new graze.PairFinder(3, 1000);
  finder.find();
  assert.throws(() => graze.readScene("nonsense"), Error);
  assert.throws(() => scene.add({ type: "sphere" }), Error);
  graze.overlappingPairs(new Float32Array(6000), 3);
  const mesh = graze.mesh(Float64Array.from({ length: 9000 }, (_, i) => (i * 7919) % 23), Uint32Array.from({ length: 9000 }, (_, i) => (i * 31) % 3000), { dimension: 3 });
  const placed = mesh.posed([1, 2, 3, 0, 0, 0, 1]);
  placed.windingNumber([1, 1, 1]);
  assert.throws(() => mesh.posed([1]), Error);
  if (givesBack) for (const held of [scene, file, tree, bvh, finder, mesh, placed]) held.delete();
}

test("delete frees memory", () => {
  for (let i = 0; i < 3; ++i) useEverything(true);  // buffers are kept
  const before = graze.usedBytes;
  for (let i = 0; i < 20; ++i) useEverything(true);
  assert.equal(graze.usedBytes, before);
  assert.ok(graze.memoryBytes > graze.usedBytes);
});

test("garbage collection frees memory some time", async () => {
  setFlagsFromString("--expose-gc");
  const collect = runInNewContext("gc");
  useEverything(true);
  const before = graze.usedBytes;
  useEverything(false);
  assert.ok(graze.usedBytes > before);
  for (let i = 0; i < 100 && graze.usedBytes > before; ++i) {
    await setTimeout(10);
    collect();
  }
  assert.equal(graze.usedBytes, before);
});

test("using a deleted object throws", () => {
  const scene = new graze.Scene(2);
  scene.delete();
  for (const use of [() => scene.size, () => scene.update(), () => scene.delete(), () => scene.pairs()]) {
    assert.throws(use, /^Error: this object was deleted$/);
  }
});

test("objects that hold memory can be disposed of, as `using` does at the end of a block", () => {
  const held = [new graze.Scene(2), new graze.QuadTree(), new graze.Bvh(3), new graze.PairFinder(2, 5), graze.mesh([], [])];
  for (const each of held) {
    each[Symbol.dispose]();
    each[Symbol.dispose]();
    assert.throws(() => each.delete(), /^Error: this object was deleted$/);
  }
  const scene = new graze.Scene(2);
  scene.delete();
  scene[Symbol.dispose]();
});

test("a runtime without Symbol.dispose gets it when the module is loaded", () => {
  const program = `
    const { dispose, ...older } = Object.getOwnPropertyDescriptors(Symbol);
    globalThis.Symbol = Object.defineProperties((description) => dispose.value.constructor(description), older);
    if (Symbol.dispose !== undefined) throw new Error("it is there already");
    const { createGraze } = await import(${JSON.stringify(join(packageFolder, "graze.js"))});
    const graze = await createGraze();
    const scene = new graze.Scene(2);
    scene[Symbol.dispose]();
    if (Object.keys(Symbol).includes("dispose")) throw new Error("it is enumerable");
    console.log(String(Symbol.dispose));`;
  assert.equal(execFileSync(process.execPath, ["--input-type=module", "-e", program], { encoding: "utf8" }), "Symbol(Symbol.dispose)\n");
});
