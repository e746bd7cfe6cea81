// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { assertSameText, graze as cli, loadGraze, root } from "./native.mjs";

let graze;
let folder;

before(async () => {
  graze = await loadGraze();
  folder = mkdtempSync(join(tmpdir(), "graze-scenes-"));
});
after(() => rmSync(folder, { recursive: true }));

const read = (path) => readFileSync(join(root, path));
const tiledFiles = () => Object.fromEntries(
  ["platform_props.tsx", "platform_tiles.tsx", "templates/coin.tx", "templates/crate.tx", "templates/spike.tx"]
    .map((path) => [path, read(`data/${path}`)]));

const scenes = {
  "data/workshop.json": () => graze.readScene(read("data/workshop.json"), "data/workshop.json"),
  "data/platform_level.tmx": () =>
    graze.readScene(read("data/platform_level.tmx"), "data/platform_level.tmx", tiledFiles()),
};

const withoutTime = (report) => ({ ...report, summary: { ...report.summary, seconds: 0 } });

for (const [path, load] of Object.entries(scenes)) {
  test(`${path}: the check, the statistics and the scene as JSON are those of the command line`, () => {
    const scene = load();
    assert.deepEqual(withoutTime(scene.check()), withoutTime(JSON.parse(cli("check", "--format", "json", path))));
    assert.deepEqual(withoutTime(scene.check({ interior: true })),
      withoutTime(JSON.parse(cli("check", "--interior", "--format", "json", path))));
    assert.deepEqual(scene.info(), JSON.parse(cli("info", "--format", "json", path)));
    assertSameText(scene.toJson(), cli("convert", path, "-"));
    assert.ok(scene.check().pairs.length > 0);
    scene.delete();
  });

  test(`${path}: checkPairs gives the same by id`, () => {
    const scene = load();
    const { pairs, summary } = scene.check();
    const { ids, relations, candidates } = scene.checkPairs();
    assert.equal(candidates, summary.candidates);
    const name = (id) => scene.object(id).name;
    assert.deepEqual(
      Array.from(relations, (relation, i) => ({
        a: name(ids[2 * i]), b: name(ids[2 * i + 1]), relation: ["apart", "touching", "overlapping"][relation],
      })),
      pairs);
    assert.deepEqual(ids, scene.pairs());
  });
}

test("a large generated scene in CSV is checked as by the command line", () => {
  const path = join(folder, "many.csv");
  const lines = ["id,min_x,min_y,max_x,max_y"];
  for (let i = 0, seed = 1; i < 20000; ++i) {
    seed = (seed * 16807) % 2147483647;
    const x = seed % 300, y = (seed >> 10) % 300;
    lines.push(`b${i},${x},${y},${x + 1.5},${y + 1.25}`);
  }
  writeFileSync(path, lines.join("\n"));
  const scene = graze.readScene(readFileSync(path), path);
  assert.equal(scene.format, "csv");
  assert.deepEqual(withoutTime(scene.check()), withoutTime(JSON.parse(cli("check", "--format", "json", path))));
  assert.ok(scene.checkPairs().relations.length > 10000);
});

test("boxes rotated by angles have the same axes, bit for bit", () => {
  const turned = (dimension, turn) => ({
    schema: "graze.scene/1",
    dimension,
    objects: Array.from({ length: 4000 }, (_, i) => ({
      type: "obb", center: Array(dimension).fill(i), half_extents: Array(dimension).fill(1), ...turn(i),
    })),
  });
  const scenes = [
    turned(2, (i) => ({ angle: i * 0.37 - 700 })),
    turned(3, (i) => ({ rotation: { axis: [i, 1, 2 - i], angle: i * 0.11 } })),
  ];
  for (const scene of scenes) {
    const path = join(folder, "turned.json");
    writeFileSync(path, JSON.stringify(scene));
    assertSameText(graze.readScene(JSON.stringify(scene)).toJson(), cli("convert", path, "-"));
  }
});

test("objects with a velocity have the positions of graze simulate, second by second", () => {
  const path = join(folder, "moving.json");
  const objects = Array.from({ length: 60 }, (_, i) => ({
    name: `o${i}`,
    ...[
      { type: "sphere", center: [i % 9, i / 7], radius: 0.5 },
      { type: "aabb", min: [i % 8, i / 9], max: [(i % 8) + 0.7, i / 9 + 0.4] },
      { type: "obb", center: [i % 7, i / 8], half_extents: [0.6, 0.2], angle: 7 * i },
    ][i % 3],
    ...(i % 4 === 0 ? {} : { velocity: [Math.sin(i) / 3, 0.1 * (i % 5)] }),
  }));
  writeFileSync(path, JSON.stringify({ schema: "graze.scene/1", dimension: 2, objects }));
  const lines = cli("simulate", path, "--frames", "40", "--seconds-per-frame", "0.25").trimEnd().split("\n");
  const scene = graze.readScene(readFileSync(path), path);
  assert.equal(scene.velocities().length, 45);
  assert.deepEqual(scene.velocities()[0], { id: scene.find("o1"), velocity: [Math.sin(1) / 3, 0.1] });
  const names = (pairs) => Array.from({ length: pairs.length / 2 }, (_, i) => [2 * i, 2 * i + 1].map((k) => scene.object(pairs[k]).name));
  let changes = 0;
  lines.forEach((line, frame) => {
    scene.moveToTime(frame * 0.25);
    const { began, stayed, ended } = scene.update();
    const told = JSON.parse(line);
    assert.deepEqual({ began: names(began), ended: names(ended), touching: (began.length + stayed.length) / 2 },
      { began: told.began, ended: told.ended, touching: told.touching }, `frame ${frame}`);
    changes += frame === 0 ? 0 : told.began.length + told.ended.length;
  });
  assert.ok(changes > 50, `${changes}`);
  scene.remove(scene.find("o1"));
  scene.moveToTime(0);
  assert.equal(scene.velocities().length, 44);
  assert.deepEqual(scene.object(scene.find("o2")).shape.center, [2, 0.25]);
  assert.throws(() => scene.moveToTime(Infinity), /seconds: it is Infinity; numbers must be finite/);
  scene.delete();
});

test("a scene has the data of its header", () => {
  const scene = scenes["data/platform_level.tmx"]();
  assert.equal(scene.dimension, 2);
  assert.equal(scene.source, "data/platform_level.tmx");
  assert.equal(scene.format, "tiled");
  assert.equal(scene.yAxis, "down");
  assert.ok(scene.omissions.every(({ what, count }) => typeof what === "string" && count > 0));
  assert.ok(scene.size > 10 && scene.ids().length === scene.size);
});

test("files that cannot be read are refused as by the command line", () => {
  const refusal = (content, files) => {
    try {
      graze.readScene(content, "level", files);
    } catch (error) {
      assert.ok(error instanceof Error);
      return error.message;
    }
    return assert.fail("it was read");
  };
  assert.match(refusal(""), /^level: this is empty/);
  assert.match(refusal('{"schema": "graze.scene/1",\n "dimension": 2,\n "objects": [{"type": "ball"}]}'),
    /^level: line 3, column \d+: object 0: unknown type "ball"; did you mean "sphere"\?$/);
  assert.match(refusal(new Uint8Array([0xff, 0xfe, 0x61, 0])), /UTF-16/);
  assert.match(refusal(read("data/platform_level.tmx")), /the template "templates\/crate.tx" cannot be read: there is no such/);
  assert.match(refusal("{}", { "/etc/passwd": "" }), /^files: "\/etc\/passwd" is not a path relative to the scene/);
  assert.match(refusal("{}", { "../../../../../../../../../../x": "" }), /at most eight folders up/);
});

test("files of one scene do not exist for the next", () => {
  scenes["data/platform_level.tmx"]();
  assert.throws(() => graze.readScene(read("data/platform_level.tmx")), /there is no such file/);
});

test("files above the scene are found", () => {
  const map = read("data/platform_level.tmx").toString().replaceAll('source="platform', 'source="../tiles/platform')
    .replaceAll('template="templates', 'template="../tiles/templates');
  const files = Object.fromEntries(Object.entries(tiledFiles()).map(([path, text]) => [`../tiles/${path}`, text]));
  assert.equal(graze.readScene(map, "m", files).size, scenes["data/platform_level.tmx"]().size);
});

test("a scene made in memory reports what begins, stays and ends", () => {
  const scene = new graze.Scene(2);
  const ball = scene.add({ type: "sphere", center: [0, 0], radius: 1 }, { name: "ball" });
  const [left, right] = scene.addBoxes(new Float64Array([-3, -1, -2, 1, /**/ 2, -1, 3, 1]), { fixed: true });
  assert.deepEqual(scene.update(), { began: new Float64Array(), stayed: new Float64Array(), ended: new Float64Array() });
  scene.translate(Float64Array.of(ball), new Float32Array([1, 0]));
  assert.deepEqual([...scene.update().began], [ball, right]);
  assert.deepEqual([...scene.update().stayed], [ball, right]);
  scene.place(Float64Array.of(ball), [-1, 0]);
  const { began, ended } = scene.update();
  assert.deepEqual([[...began], [...ended]], [[ball, left], [ball, right]]);
  scene.remove(left);
  assert.deepEqual([...scene.update().ended], [ball, left]);
  assert.ok(!scene.contains(left));
  assert.throws(() => scene.remove(left), /was removed/);
  const again = scene.add({ type: "point", position: [0, 0] });
  assert.notEqual(again, left);
  assert.equal(graze.slotOf(again), graze.slotOf(left));
});

test("bulk moves: boxes, spheres, and shapes of every type", () => {
  const scene = new graze.Scene(3);
  const shapes = [
    { type: "point", position: [0, 0, 0] },
    { type: "segment", start: [0, 0, 0], end: [1, 0, 0] },
    { type: "ray", origin: [0, 0, 0], direction: [1, 0, 0] },
    { type: "sphere", center: [0, 0, 0], radius: 1 },
    { type: "aabb", min: [0, 0, 0], max: [1, 1, 1] },
    { type: "obb", center: [0, 0, 0], half_extents: [1, 1, 1], axes: [[1, 0, 0], [0, 1, 0], [0, 0, 1]] },
    { type: "plane", normal: [0, 0, 2], offset: 0 },
    { type: "half_space", normal: [0, 0, 2], offset: 0 },
    { type: "triangle", a: [0, 0, 0], b: [1, 0, 0], c: [0, 1, 0] },
    { type: "capsule", a: [0, 0, 0], b: [1, 0, 0], radius: 1 },
    { type: "polytope", points: [[0, 0, 0], [1, 0, 0]] },
    { type: "compound", parts: [{ type: "point", position: [0, 0, 0] }] },
  ];
  const ids = scene.addMany(shapes);
  scene.translate(ids, Float64Array.from(shapes.flatMap(() => [1, 2, 3])));
  const moved = Array.from(ids, (id) => scene.object(id).shape);
  const expected = JSON.parse(JSON.stringify(shapes), (key, value) =>
    ["position", "start", "end", "origin", "center", "min", "max", "a", "b", "c"].includes(key)
      ? value.map((number, i) => number + i + 1) : value);
  Object.assign(expected[6], { offset: 6 });
  Object.assign(expected[7], { offset: 6 });
  Object.assign(expected[10], { points: [[1, 2, 3], [2, 2, 3]] });
  assert.deepEqual(moved, expected);
  const two = ids.slice(0, 2);
  scene.moveSpheres(two, new Float32Array([0, 0, 0, 1, 5, 5, 5, 2]));
  assert.deepEqual(scene.object(two[1]).shape, { type: "sphere", center: [5, 5, 5], radius: 2 });
  scene.moveBoxes(two, new Float32Array([0, 0, 0, 1, 1, 1, 5, 5, 5, 6, 6, 6]));
  assert.deepEqual([...scene.boxes(two)], [0, 0, 0, 1, 1, 1, 5, 5, 5, 6, 6, 6]);
  assert.throws(() => scene.place(ids.slice(6, 7), [0, 0, 0]), /has no finite bounds/);
  assert.throws(() => scene.moveBoxes(two, new Float32Array([0, 0, 0, 1, 1, 1, 5, 5, 5, 6, 6, -6])), /^Error: box 1 has/);
  assert.deepEqual([...scene.boxes(two)], [0, 0, 0, 1, 1, 1, 5, 5, 5, 6, 6, 6]);
});

test("an object has all its properties", () => {
  const scene = new graze.Scene(2);
  const id = scene.add({ type: "aabb", min: [0, 0], max: [1, 1] },
    { name: 'a "box"', layer: "walls", mask: ["player", 40], user: 2n ** 64n - 1n, fixed: true });
  assert.deepEqual(scene.layerNames, ["walls", "player"]);
  assert.deepEqual(scene.object(id), {
    shape: { type: "aabb", min: [0, 0], max: [1, 1] },
    box: { min: [0, 0], max: [1, 1] },
    name: 'a "box"', layer: 0, mask: [1, 40], user: 2n ** 64n - 1n, fixed: true,
  });
  assert.equal(scene.find('a "box"'), id);
  assert.equal(scene.find("nobody"), null);
  assert.equal(scene.layer("player"), 1);
});

test("a refused add does not change the scene", () => {
  const scene = new graze.Scene(2);
  const dot = { type: "point", position: [0, 0] };
  scene.add(dot, { name: "dot" });
  const refused = (call, message) => assert.throws(call, message);
  refused(() => scene.add(dot, { name: "dot", layer: "new" }), /^Error: Scene: there is already an object "dot"$/);
  refused(() => scene.add(dot, { nmae: "x" }), /^Error: options: unknown field "nmae"; did you mean "name"\?$/);
  refused(() => scene.add(dot, { layer: 64 }), /its number from 0 to 63/);
  refused(() => scene.add(dot, { user: -1 }), /"user" is -1/);
  refused(() => scene.addMany([dot, { type: "point", position: [0] }]), /^Error: shapes: shape 1: "position" has 1 number/);
  refused(() => scene.addSpheres(new Float32Array([0, 0, 1, 0, 0, -1])), /^Error: sphere 1 has a negative radius|sphere 1/);
  assert.equal(scene.size, 1);
  assert.deepEqual(scene.layerNames, []);
});

test("queries find objects on their layers", () => {
  const scene = new graze.Scene(2);
  const near = scene.add({ type: "sphere", center: [2, 0], radius: 1 }, { layer: "near" });
  const far = scene.add({ type: "sphere", center: [5, 0], radius: 1 }, { layer: "far" });
  const ray = { origin: [0, 0], direction: [1, 0] };
  assert.deepEqual([...scene.overlapping({ type: "aabb", min: [1, 0], max: [6, 1] })], [near, far]);
  assert.deepEqual([...scene.cull({ type: "aabb", min: [1, 0], max: [6, 1] }, { layers: ["far"] })], [far]);
  assert.deepEqual(scene.nearest([0, 0], 2), [{ id: near, distance: 1 }, { id: far, distance: 4 }]);
  assert.deepEqual(scene.rayCast(ray), { id: near, t: 1, point: [1, 0], normal: [-1, 0], status: "converged", error: scene.rayCast(ray).error });
  assert.equal(scene.rayCast(ray, { layers: ["far"] }).id, far);
  assert.equal(scene.rayCast(ray, { tMax: 0.5 }), null);
  assert.deepEqual(scene.rayCastAll(ray).map((hit) => hit.id), [near, far]);
  assert.throws(() => scene.rayCast(ray, { layers: ["fra"] }), /there is no layer "fra"; did you mean "far"\?/);
});
