// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { graze as cli, loadGraze } from "./native.mjs";

let graze;
let folder;

before(async () => {
  graze = await loadGraze();
  folder = mkdtempSync(join(tmpdir(), "graze-recordings-"));
});
after(() => rmSync(folder, { recursive: true }));

function generated(world, frames) {
  const path = join(folder, `${world.replaceAll(":", "_")}.aabbs`);
  cli("generate", world, "--frames", String(frames), "--output", path);
  return readFileSync(path);
}

/** The boxes of a frame in the file format of docs/cli.md. */
function boxesIn(bytes, dimension, frame) {
  const numbers = new Float32Array(Uint8Array.from(bytes.subarray(304)).buffer);
  const count = bytes.readInt32LE(256);
  const own = numbers.subarray(8 * count * frame, 8 * count * (frame + 1));
  const axes = dimension === 2 ? [0, 1, 4, 5] : [0, 1, 2, 4, 5, 6];
  return Float32Array.from({ length: count * axes.length }, (_, i) =>
    own[8 * Math.floor(i / axes.length) + axes[i % axes.length]]);
}

for (const [dimension, world] of [[2, "2d:brownian:500"], [3, "brownian:5000"]]) {
  test(`a recording in ${dimension}D has the boxes of its file, frame by frame and in any order`, () => {
    const bytes = generated(world, 5);
    const recording = graze.readRecording(bytes, "r.aabbs");
    const { count, frames, source } = recording;
    assert.deepEqual({ dimension: recording.dimension, count, frames, source },
      { dimension, count: bytes.readInt32LE(256), frames: 5, source: "r.aabbs" });
    for (const frame of [0, 1, 2, 3, 4, 4, 0, 3, 1]) {
      assert.deepEqual(recording.boxes(frame), boxesIn(bytes, dimension, frame), `frame ${frame}`);
    }
    const { min, max } = recording.world;
    const inside = recording.boxes(2).every((value, i) => value >= min[i % dimension] && value <= max[i % dimension]);
    assert.ok(inside);
    recording.delete();
    assert.throws(() => recording.boxes(0), /deleted/);
  });
}

test("incomplete recordings are refused as by the command line", () => {
  const bytes = generated("brownian:100", 3);
  const refused = (content, message) => assert.throws(() => graze.readRecording(content, "cut.aabbs"), { message });
  refused(bytes.subarray(0, 100), /^cut\.aabbs: holds 100 bytes; a recording in Broadmark's format begins with a header of 304$/);
  refused(bytes.subarray(0, bytes.length - 5), /^cut\.aabbs: holds \d+ bytes, but its header announces 304 bytes and 3 frames of 100 boxes/);
  const broken = Buffer.from(bytes);
  broken.writeFloatLE(NaN, 304 + 32 * 107 + 4);
  const recording = graze.readRecording(broken, "nan.aabbs");
  assert.throws(() => recording.boxes(1), { message: "nan.aabbs: frame 1, box 7: min_y is nan; it must be a finite number" });
  assert.equal(recording.boxes(2).length, 600);
  assert.throws(() => recording.boxes(3), { message: "frame: there is no frame 3; the last is 2" });
  assert.throws(() => recording.boxes(-1), /frame: -1 is not a whole number/);
});

test("deleting a recording frees its memory", () => {
  const bytes = generated("brownian:5000", 8);
  const read = () => {
    const recording = graze.readRecording(bytes);
    recording.boxes(7);
    recording.delete();
  };
  read();
  const before = graze.usedBytes;
  for (let i = 0; i < 20; ++i) read();
  assert.ok(graze.usedBytes - before < bytes.length / 2, `${graze.usedBytes - before}`);
});
