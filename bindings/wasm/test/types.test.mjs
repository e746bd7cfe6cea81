// SPDX-License-Identifier: MIT
// Everything declared in graze.d.ts exists.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { before, test } from "node:test";

import { loadGraze, packageFolder } from "./native.mjs";

const types = readFileSync(join(packageFolder, "graze.d.ts"), "utf8");

/** The names of an interface's members. */
function membersOf(name) {
  const body = new RegExp(`^export interface ${name}\\b[^{]*\\{\\n([^]*?)^\\}`, "m").exec(types)[1];
  return [...body.matchAll(/^ {2}(?:readonly )?(\w+)(?=[(<:?])/gm)].map((match) => match[1]);
}

/** The names of an object's members, including inherited ones. */
function membersAt(object) {
  const names = new Set();
  for (let at = object; at && at !== Object.prototype; at = Object.getPrototypeOf(at)) {
    for (const name of Object.getOwnPropertyNames(at)) names.add(name);
  }
  return names;
}

let graze;

before(async () => {
  graze = await loadGraze();
});

/** A recording of one frame with one box, which is a point at the origin. */
const oneBox = new Uint8Array(304 + 32);
oneBox[256] = 1;

const objects = {
  Graze: () => graze,
  Scene: () => new graze.Scene(2),
  SpatialIndex: () => new graze.QuadTree(),
  PairFinder: () => new graze.PairFinder(2, 1),
  BuiltMesh: () => graze.mesh([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]]),
  Recording: () => graze.readRecording(oneBox, "one"),
};

for (const [name, make] of Object.entries(objects)) {
  test(`every declared member of ${name} exists`, () => {
    const wanted = membersOf(name);
    assert.ok(wanted.length > 5);
    const found = membersAt(make());
    assert.deepEqual(wanted.filter((member) => !found.has(member)), []);
  });
}

test("every member of the module has a type", () => {
  const known = new Set(membersOf("Graze"));
  assert.deepEqual(Object.keys(graze).filter((name) => !known.has(name)), []);
});
