// SPDX-License-Identifier: MIT
// Queries that find objects of a scene: compared with native results, and their filters and options.
import assert from "node:assert/strict";
import { before, test } from "node:test";

import { assertSameBits, hitNumbers, loadGraze, manifoldNumbers, nativeAnswers } from "./native.mjs";

let graze;
let native;

before(async () => {
  graze = await loadGraze();
  native = nativeAnswers();
});

const impactNumbers = ({ id, ...impact }) => [graze.slotOf(id), ...hitNumbers(impact)];

/** The same questions as in scene_answers.cpp. */
function answers(scene, shape, way, filter) {
  const n = scene.dimension;
  const slots = (ids) => Array.from(ids, graze.slotOf);
  const back = way.map((value) => -value);
  const nearest = [scene.nearest(shape, 4, filter), scene.nearest(way, 4, filter)].flat();
  const hits = scene.rayCastAll({ origin: way, direction: back }, filter);
  assert.deepEqual(scene.rayCast({ origin: way, direction: back }, filter), hits[0] ?? null);
  const turning = scene.timeOfImpact(shape, { linear: way, angular: n === 2 ? 2 : [0, 1, -2] }, filter);
  const climbing = { ...filter, maxSlope: 0.8, stepHeight: 0.5, clearance: 0.01, ...(n === 3 ? { up: [0, 0, 2] } : {}) };
  return [
    ...slots(scene.overlapping(shape, filter)),
    ...slots(scene.cull(shape, filter)),
    ...scene.contactsWith(shape, filter).flatMap(({ id, ...manifold }) => [graze.slotOf(id), ...manifoldNumbers(manifold)]),
    ...nearest.flatMap(({ id, distance }) => [graze.slotOf(id), distance]),
    ...hits.flatMap(impactNumbers),
    ...[turning].filter((found) => found !== null).flatMap(impactNumbers),
    ...[false, true].flatMap((ignoreInitialTouch) => {
      const options = { ...filter, ignoreInitialTouch };
      const first = scene.shapeCast(shape, way, options);
      return [...(first === null ? [] : [first]), ...scene.shapeCastAll(shape, way, options)].flatMap(impactNumbers);
    }),
    ...[filter, climbing].flatMap((options) => {
      const { motion, touches } = scene.slide(shape, way, options);
      return [...motion, ...touches.flatMap(impactNumbers)];
    }),
  ];
}

for (const n of [2, 3]) {
  test(`in ${n}D, casts, contacts, neighbours and slides through a scene are those of the native library, bit for bit`, () => {
    const { shapes, asked, near, excepted } = JSON.parse(native(`scenes_${n}d.json`));
    const scene = new graze.Scene(n);
    for (const layer of [0, 1, 2]) scene.layer(`layer ${layer}`);
    const ids = shapes.map((shape, i) => scene.add(shape, { layer: i % 3 }));
    const except = ids.slice(3, 30);
    const layers = ["layer 0", 2];
    const filters = [
      {}, { layers }, { except }, { layers, except: Float64Array.from(except), predicate: (id) => graze.slotOf(id) % 7 !== 0 },
    ];
    const seen = { touched: 0, free: 0, ignored: 0, slid: 0 };
    asked.forEach(({ shape, motion, answers: wanted }, i) => {
      const filter = filters[i % 4];
      assertSameBits(answers(scene, shape, motion, filter), wanted, () => `question ${i}`);
      const first = scene.shapeCast(shape, motion, filter);
      seen.touched += first?.t > 0 ? 1 : 0;
      seen.free += first === null ? 1 : 0;
      seen.ignored += first?.t === 0 && scene.shapeCast(shape, motion, { ...filter, ignoreInitialTouch: true })?.t !== 0 ? 1 : 0;
      seen.slid += scene.slide(shape, motion, filter).touches.length > 1 ? 1 : 0;
    });
    for (const [what, count] of Object.entries(seen)) assert.ok(count > 3, `${what}: ${count} times`);

    scene.except(ids[0], ids[1]);
    const pairs = scene.pairs();
    for (let i = 0; i < pairs.length; i += 2) {
      if (graze.slotOf(pairs[i]) % 2 === 0) scene.except(pairs[i + 1], pairs[i]);
    }
    assert.deepEqual(Array.from(scene.exceptedPairs(), graze.slotOf), excepted);
    assert.ok(excepted.length > 20);
    const distances = scene.closestPairs(0.5).flatMap(({ a, b, distance }) => [graze.slotOf(a), graze.slotOf(b), distance]);
    assertSameBits(distances, near, () => "closest pairs");
    assert.ok(near.length > 60);
    scene.delete();
  });
}

/** A floor, and a wall to the right of a ball that lies on the floor. */
function room() {
  const scene = new graze.Scene(2);
  const floor = scene.add({ type: "half_space", normal: [0, 1], offset: 0 }, { layer: "ground", fixed: true });
  const wall = scene.add({ type: "aabb", min: [6, 0], max: [7, 5] }, { layer: "walls", fixed: true });
  const ball = { type: "sphere", center: [0, 1], radius: 1 };
  return { scene, floor, wall, ball };
}

test("a ball that lies on a floor hits the wall, if touches that it does not approach are ignored", () => {
  const { scene, floor, wall, ball } = room();
  assert.equal(scene.shapeCast(ball, [10, 0]).id, floor);
  const { id, t, normal } = scene.shapeCast(ball, [10, 0], { ignoreInitialTouch: true });
  assert.deepEqual([id, t, ...normal], [wall, 0.5, 1, 0]);
  assert.deepEqual(scene.shapeCastAll(ball, [10, 0]).map((found) => found.id), [floor, wall]);
  const shape = scene.object(wall).shape;
  assert.equal(graze.shapeCast(ball, [16, 0], shape, { targetDistance: 1 }).t, 0.25);
  assert.equal(graze.shapeCast(ball, [10, 0], scene.object(floor).shape, { ignoreInitialTouch: true }), null);
  const impact = scene.timeOfImpact(ball, { linear: [10, 1], center: [0, 1] }, { except: [floor] });
  assert.equal(impact.id, wall);
  scene.delete();
});

test("a margin gives contacts of shapes that are near, with a negative depth", () => {
  const { scene, wall } = room();
  const near = { type: "sphere", center: [4.5, 3], radius: 1 };
  const shape = scene.object(wall).shape;
  assert.equal(graze.contact(near, shape), null);
  assert.equal(graze.contact(near, shape, { margin: 0.25 }), null);
  assert.equal(graze.contact(near, shape, { margin: 0.5 }).depth, -0.5);
  assert.deepEqual(graze.manifold(near, shape).points, []);
  assert.deepEqual(graze.manifold(near, shape, { margin: 1 }).points.map(({ depth }) => depth), [-0.5]);
  scene.delete();
});

test("an excepted pair is not reported, until it is accepted again", () => {
  const scene = new graze.Scene(2);
  const [a, b] = scene.addSpheres(Float64Array.of(0, 0, 1, 1, 0, 1));
  scene.update();
  scene.except(b, a);
  assert.ok(scene.excepted(a, b) && scene.excepted(b, a));
  assert.deepEqual([...scene.exceptedPairs()], [a, b]);
  assert.deepEqual([...scene.pairs()], []);
  assert.deepEqual(scene.closestPairs(9), []);
  assert.deepEqual([...scene.update().ended], [a, b]);
  assert.deepEqual([...graze.readScene(scene.toJson()).pairs()], []);
  assert.deepEqual([...scene.overlapping({ type: "point", position: [0.5, 0] })], [a, b]);
  scene.accept(a, b);
  assert.ok(!scene.excepted(a, b));
  assert.deepEqual([...scene.update().began], [a, b]);
  assert.deepEqual(scene.closestPairs(0), [{ a, b, distance: 0 }]);
  assert.throws(() => scene.except(a, a), /^Error: Scene: an object is never a pair with itself; except names two objects$/);
  scene.remove(b);
  assert.throws(() => scene.except(a, b), /was removed/);
  assert.throws(() => scene.excepted(a, b), /was removed/);
  assert.throws(() => scene.except(a), /an id is an integer returned by graze/);
  scene.delete();
});

test("a predicate is asked for ids, and may query the module", () => {
  const { scene, floor, wall, ball } = room();
  const region = { type: "aabb", min: [-9, -1], max: [9, 9] };
  const asked = [];
  const predicate = (id) => {
    asked.push(id);
    assert.equal(graze.distance(ball, { type: "point", position: [0, 4] }), 2);
    assert.deepEqual([...scene.overlapping(region, { predicate: (inner) => inner === id })], [id]);
    assert.throws(() => scene.overlapping({ type: "sphere", center: [0], radius: 1 }), /region: /);
    return id === wall;
  };
  assert.deepEqual([...scene.overlapping(region, { predicate })], [wall]);
  assert.deepEqual([...new Set(asked)].sort(), [floor, wall]);
  assert.deepEqual(scene.nearest(ball, 5, { predicate }), [{ id: wall, distance: 5 }]);
  assert.deepEqual(scene.contactsWith(ball, { predicate }), []);
  assert.equal(scene.slide(ball, [10, 0], { predicate }).touches[0].id, wall);
  scene.delete();
});

test("what a predicate throws ends the query, and reaches its caller", () => {
  const { scene, ball } = room();
  const mine = new RangeError("mine");
  const predicate = () => {
    throw mine;
  };
  const region = { type: "aabb", min: [-9, -1], max: [9, 9] };
  const used = graze.usedBytes;
  for (let i = 0; i < 200; ++i) assert.throws(() => scene.shapeCast(ball, [9, 0], { predicate }), (error) => error === mine);
  assert.ok(graze.usedBytes < used + 4096, "memory is lost");
  assert.throws(() => scene.overlapping(region, { predicate: () => { throw undefined; } }), (error) => error === undefined);
  assert.equal(scene.overlapping(region).length, 2);
  scene.delete();
});

test("a predicate cannot change the scene that asks it", () => {
  const { scene, wall, ball } = room();
  const other = new graze.Scene(2);
  const changes = [
    () => scene.remove(wall), () => scene.add(ball), () => scene.addMany([ball]), () => scene.addSpheres(Float64Array.of(0, 0, 1)),
    () => scene.move(wall, ball), () => scene.translate(Float64Array.of(wall), [1, 1]), () => scene.update(), () => scene.layer("new"),
    () => scene.except(0, 1), () => scene.delete(),
  ];
  for (const change of changes) {
    const predicate = () => {
      other.add(ball);
      scene.overlapping(ball, { predicate: () => true });
      change();
      return true;
    };
    assert.throws(() => scene.shapeCast(ball, [9, 0], { predicate }), /^Error: predicate: it must not change the scene that asks it/, String(change));
  }
  assert.equal(scene.size, 2);
  scene.move(wall, ball);
  assert.ok(other.size >= changes.length);
  for (const each of [scene, other]) each.delete();
});

test("a walker climbs a step and a slope, and stops at a wall", () => {
  const level = new graze.Scene(2);
  level.addBoxes(Float64Array.of(-2, -1, 30, 0, /**/ 3, 0, 6, 0.3, /**/ 14, 0, 18, 2, /**/ 18, 0, 19, 6));
  level.add({ type: "triangle", a: [9, 0], b: [14, 2], c: [14, 0] });
  const end = (options) => {
    let [x, y, fall] = [0, 0, 0];
    for (let frame = 0; frame < 240; ++frame) {
      const hero = { type: "capsule", a: [x, y + 0.5], b: [x, y + 1.5], radius: 0.4 };
      fall -= 0.4 / 60;
      const { motion, touches } = level.slide(hero, [0.1, fall], options);
      [x, y] = [x + motion[0], y + motion[1]];
      if (touches.some(({ normal }) => normal[1] < -0.7)) fall = 0;
    }
    return [x, y].map((value) => Math.round(value * 10) / 10);
  };
  assert.deepEqual(end({ maxSlope: 0.8, stepHeight: 0.4 }), [17.6, 1.9]);
  assert.deepEqual(end({ maxSlope: 0.8 }), [2.6, -0.1]);
  assert.deepEqual(end({ maxSlope: 0.3, stepHeight: 0.4 })[1], -0.1);
  level.delete();
});

test("wrong filters and options are refused, with what is allowed", () => {
  const { scene, ball } = room();
  const refused = (call, message) => assert.throws(call, (error) => error instanceof Error && message.test(error.message), String(call));
  refused(() => scene.shapeCast(ball, [1, 0], { layer: ["walls"] }), /^options: unknown field "layer"; the fields are "layers", "except", "predicate", "ignoreInitialTouch"$/);
  refused(() => scene.overlapping(ball, ["walls"]), /^options: must be an object with any of the fields "layers", "except", "predicate"$/);
  refused(() => scene.cull(ball, { layers: ["wals"] }), /^layers: there is no layer "wals"; did you mean "walls"\?$/);
  refused(() => scene.nearest(ball, 1, { except: 1 }), /^except: must be an array of ids; for one id write \[id\]$/);
  refused(() => scene.nearest(ball, 1, { except: ["wall"] }), /^except: it is wall; numbers must be finite$/);
  refused(() => scene.nearest(ball, 1, { except: [0.5] }), /^an id is an integer returned by graze; 0.5 is not$/);
  refused(() => scene.nearest({ type: "ball" }, 1), /^shape: unknown type "ball"; did you mean "sphere"\?$/);
  refused(() => scene.contactsWith(ball, { predicate: 3 }), /^predicate: must be a function that takes an id/);
  refused(() => scene.shapeCast(ball, [1, 0], { ignoreInitialTouch: 1 }), /^ignoreInitialTouch: it must be true or false, not 1$/);
  refused(() => scene.shapeCast(ball, [1, 0, 0]), /^motion: it has 3 numbers; it must have 2$/);
  refused(() => scene.timeOfImpact(ball, 3), /^motion: must be an object with any of the fields "linear"/);
  refused(() => scene.timeOfImpact(ball, { turn: 3 }), /^motion: unknown field "turn"; the fields are/);
  refused(() => scene.closestPairs(-1), /^within: it is -1; it must not be negative$/);
  refused(() => scene.slide(ball, [1, 0], { up: [0, 0, 1] }), /^up: it has 3 numbers; it must have 2$/);
  refused(() => scene.slide(ball, [1, 0], { up: [0, 0] }), /^slide: up is zero or not finite$/);
  refused(() => scene.slide(ball, [1, 0], { maxSlope: 45 }), /^slide: the slope is not between 0 and a right angle$/);
  refused(() => scene.slide(ball, [1, 0], { maxSlope: NaN }), /^maxSlope: it is NaN; numbers must be finite$/);
  refused(() => scene.slide(ball, [1, 0], { stepHeight: -1 }), /^stepHeight: it is -1; it must not be negative$/);
  refused(() => scene.slide(ball, [1, 0], { clearance: "1" }), /^clearance: it is 1; numbers must be finite$/);
  refused(() => graze.contact(ball, ball, { margin: -1 }), /^margin: it is -1; it must not be negative$/);
  refused(() => graze.manifold(ball, ball, { margn: 1 }), /^options: unknown field "margn"; the fields are "margin"$/);
  refused(() => graze.shapeCast(ball, [1, 0], ball, { targetDistance: Infinity }), /^targetDistance: it is Infinity; numbers must be finite$/);
  scene.delete();
});
