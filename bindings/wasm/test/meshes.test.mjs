// SPDX-License-Identifier: MIT
// Meshes that the module holds.
import assert from "node:assert/strict";
import { before, test } from "node:test";

import { assertSameBits, loadGraze, nativeAnswers } from "./native.mjs";

let graze;
let native;

before(async () => {
  graze = await loadGraze();
  native = nativeAnswers();
});

const relations = ["apart", "touching", "overlapping"];

/** A mesh as a line of the native results has it. */
const built = ({ vertices, faces, kind }, dimension) => graze.mesh(vertices, faces, { kind, dimension });

function assertNear(ours, wanted) {
  assert.equal(ours.length, wanted.length);
  wanted.forEach((value, i) => assert.ok(Math.abs(ours[i] - value) < 1e-12, `${ours[i]} and ${value}`));
}

/** In the order of mesh_answers.cpp. */
function hitNumbers(hits, dimension) {
  return Array.from(hits.t).flatMap((t, i) => {
    if (t === Infinity) return [t];
    const rows = (numbers, width) => Array.from(numbers.subarray(i * width, (i + 1) * width));
    return [t, ...rows(hits.points, dimension), ...rows(hits.normals, dimension), hits.errors[i], hits.faces[i], ...rows(hits.barycentrics, 3)];
  });
}

/** The answers about one line, each with the name of the native ones. */
function answersAbout(line, dimension) {
  const mesh = built(line.mesh, dimension);
  const unplaced = built(line.other, dimension);
  const other = unplaced.posed(line.pose);
  const changed = mesh.moved(Float64Array.from(line.places));
  const whole = changed.welded();
  const contact = graze.contact(mesh, other);
  const points = Float64Array.from(line.points);
  const found = {
    report: Object.values(mesh.report()).map(Number),
    windings: mesh.windingNumbers(points),
    distances: mesh.signedDistances(points),
    closest: mesh.closestPoints(points),
    hits: hitNumbers(mesh.rayCasts(Float64Array.from(line.rays)), dimension),
    crossings: mesh.selfIntersections(),
    touching: mesh.touchingFaces(other),
    pair: [
      relations.indexOf(graze.relation(mesh, other)), graze.distance(mesh, other),
      ...(contact === null ? [] : [...contact.point, ...contact.normal, contact.depth]),
    ],
    placed: other.vertices(),
    changedClosest: changed.closestPoints(points),
  };
  assert.deepStrictEqual(graze.normalised(whole), line.welded);
  assert.deepEqual([mesh.type, mesh.dimension, mesh.kind, mesh.vertexCount, mesh.faceCount],
    ["mesh", dimension, line.mesh.kind, line.mesh.vertices.length, line.mesh.faces.length]);
  assert.deepEqual(Array.from(mesh.vertices()), line.mesh.vertices.flat());
  assert.deepEqual(Array.from(mesh.faces()), line.mesh.faces.flat());
  for (const each of [mesh, unplaced, other, changed, whole]) each.delete();
  return found;
}

for (const dimension of [2, 3]) {
  test(`meshes give native results in ${dimension}D, bit for bit`, () => {
    const lines = native(`meshes_${dimension}d.ndjson`).toString().trimEnd().split("\n").map((text) => JSON.parse(text));
    assert.equal(lines.length, 24);
    const seen = { hits: 0, misses: 0, inside: 0, crossings: 0, touching: 0, open: 0 };
    for (const line of lines) {
      const isOpen = dimension === 3 && line.report.at(-1) === 0;
      for (const [name, ours] of Object.entries(answersAbout(line, dimension))) {
        // For each open edge they need an arc tangent, which the machine's own library computes.
        if (isOpen && name === "windings") assertNear(ours, line[name]);
        else assertSameBits(ours, line[name], () => name);
      }
      seen.misses += line.hits.filter((value) => value === "Infinity").length;
      seen.hits += line.hits.length;
      seen.inside += line.distances.filter((value) => value < 0).length;
      seen.crossings += line.crossings.length;
      seen.touching += line.touching.length;
      seen.open += line.report[0];
    }
    for (const [what, count] of Object.entries(seen)) assert.ok(count > 50 || (what === "inside" && dimension === 2), `${what}: ${count}`);
  });
}

/** A cube from 0 to 1 whose faces are two triangles each. */
const corners = Array.from({ length: 8 }, (_, i) => [i & 1, (i >> 1) & 1, i >> 2]);
const sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
const triangles = sides.flatMap(([a, b, c, d]) => [[a, b, c], [a, c, d]]);
const cube = (options = { kind: "solid" }, faces = triangles) => graze.mesh(corners, faces, options);

test("a mesh that is held gives the same as a plain one, wherever a shape is accepted", () => {
  const plain = { type: "mesh", vertices: corners, faces: triangles, kind: "solid" };
  const held = cube();
  const ball = { type: "sphere", center: [1.25, 0.5, 0.5], radius: 0.5 };
  const ray = { origin: [0.25, 0.5, 9], direction: [0, 0, -2] };
  const ask = (mesh) => [
    ...["relation", "intersects", "distance", "closestPoints", "separation", "contact", "manifold"].flatMap((name) => [graze[name](mesh, ball), graze[name](ball, mesh)]),
    ...["contains", "closestPoint", "closestBoundaryPoint", "signedDistance"].map((name) => graze[name](mesh, [0.5, 0.5, 0.25])),
    graze.rayCast(mesh, ray), graze.rayCast(mesh, ray, { side: "exit" }), graze.rayCast(mesh, ray, { tMax: 1 }),
    graze.shapeCast(ball, [-1, 0, 0], mesh), graze.timeOfImpact(mesh, { linear: [3, 0, 0] }, ball),
    graze.bounds(mesh), graze.normalised(mesh), graze.drawing(mesh),
    graze.distance({ type: "compound", parts: [ball, mesh] }, { type: "point", position: [-2, 0, 0] }),
    graze.touchingPairs([mesh, ball, mesh], Uint32Array.of(0, 1, 0, 2)),
  ];
  assert.deepStrictEqual(ask(held), ask(plain));
  assert.deepStrictEqual(graze.normalised(held), plain);
  const scene = new graze.Scene(3);
  const id = scene.add(held, { name: "cube" });
  held.delete();
  assert.deepStrictEqual(scene.object(id).shape, plain);
  assert.equal(scene.rayCast(ray).t, 4);
  const { face, barycentric } = graze.rayCast(plain, ray);
  assert.deepEqual({ face: scene.rayCast(ray).face, barycentric: scene.rayCast(ray).barycentric }, { face, barycentric });
  const small = graze.mesh(corners.map((corner) => corner.map((value) => value / 2)), triangles);
  scene.move(id, small);
  assert.ok(Math.abs(scene.rayCast(ray).t - 4.25) < 1e-12);
  assert.deepEqual(Array.from(scene.overlapping(small)), [id]);
});

test("a ray tells which face it hits, and where on it", () => {
  const hit = graze.rayCast(cube({}), { origin: [0.25, 0.5, 9], direction: [0, 0, -2] });
  assert.equal(hit.t, 4);
  const weighted = triangles[hit.face].map((vertex, i) => corners[vertex].map((value) => value * hit.barycentric[i]));
  assert.deepEqual([0, 1, 2].map((axis) => weighted.reduce((sum, corner) => sum + corner[axis], 0)), hit.point);
  const inside = graze.rayCast(cube(), { origin: [0.5, 0.5, 0.5], direction: [1, 0, 0] });
  assert.deepEqual([inside.t, inside.face, inside.barycentric], [0, null, [0, 0, 0]]);
  assert.equal("face" in graze.rayCast({ type: "sphere", center: [0, 0, 0], radius: 1 }, { origin: [9, 0, 0], direction: [-1, 0, 0] }), false);
  const { t, faces } = cube().rayCasts(Float32Array.of(0.5, 0.5, 0.5, 1, 0, 0, /**/ 2, 2, 2, 1, 0, 0));
  assert.deepEqual([[...t], [...faces]], [[0, Infinity], [-1, -1]]);
});

test("vertices and faces may be vectors or consecutive numbers", () => {
  const rows = [
    cube(),
    graze.mesh(Float32Array.from(corners.flat()), Uint16Array.from(triangles.flat()), { kind: "solid", dimension: 3 }),
    graze.mesh(corners.map((corner) => Float64Array.from(corner)), triangles.map((face) => Uint32Array.from(face)), { kind: "solid" }),
  ];
  for (const mesh of rows) assert.deepStrictEqual(graze.normalised(mesh), graze.normalised(rows[0]));
  assert.equal(graze.mesh([], [], { dimension: 3 }).dimension, 3);
});

test("the edges of a report are where the faults are", () => {
  const whole = cube().report();
  assert.deepEqual(whole, {
    openEdges: 0, nonManifoldEdges: 0, flippedEdges: 0, degenerateFaces: 0, duplicateFaces: 0, unusedVertices: 0, components: 1, isClosed: true,
  });
  const holed = cube({}, triangles.slice(1));
  assert.equal(holed.report().openEdges, 3);
  assert.deepEqual(Array.from(holed.edges("open")), [0, 2, 0, 3, 2, 3]);
  assert.equal(holed.report().isClosed, false);
  const [first, ...others] = triangles;
  const turned = cube({}, [[first[0], first[2], first[1]], ...others]);
  assert.deepEqual([turned.report().flippedEdges, turned.edges("flipped").length, turned.edges("open").length], [3, 6, 0]);
  const finned = cube({}, [...triangles, [0, 3, 4]]);
  assert.deepEqual(Array.from(finned.edges("non_manifold")), [0, 3, 0, 4]);
  const loose = graze.mesh(triangles.flat().map((vertex) => corners[vertex]), triangles.map((_, i) => [3 * i, 3 * i + 1, 3 * i + 2]));
  assert.equal(loose.report().openEdges, 36);
  const welded = loose.welded();
  assert.deepEqual([welded.vertexCount, welded.report().isClosed, loose.vertexCount], [8, true, 36]);
});

test("a moved part touches another with the faces that share a point", () => {
  const fixed = cube({});
  assert.equal(fixed.touchingFaces(fixed.posed([2, 0, 0, 0, 0, 0, 1])).length, 0);
  const beside = fixed.posed([1, 0, 0, 0, 0, 0, 2]);
  assert.equal(graze.relation(fixed, beside), "touching");
  const sideOf = (faces, x) => new Set(faces.filter((face) => triangles[face].every((vertex) => corners[vertex][0] === x)));
  const pairs = Array.from(fixed.touchingFaces(beside));
  assert.equal(sideOf(pairs.filter((_, i) => i % 2 === 0), 1).size, 2);
  assert.equal(sideOf(pairs.filter((_, i) => i % 2 === 1), 0).size, 2);
  assert.deepEqual(Array.from(beside.vertices().subarray(0, 3)), [1, 0, 0]);
  assert.deepEqual(fixed.moved(beside.vertices()).vertices(), beside.vertices());
  const quarter = graze.mesh([[1, 0], [2, 0], [2, 1]], [[0, 1, 2]]).posed([5, 0, Math.PI / 2]).vertices();
  assert.ok(Math.abs(quarter[0] - 5) < 1e-15 && quarter[1] === 1, String(quarter));
});

test("a hundred thousand faces are picked without copying them", () => {
  const width = 230;
  const vertices = new Float64Array(3 * width * width);
  const faces = [];
  for (let y = 0; y < width; ++y) {
    for (let x = 0; x < width; ++x) {
      vertices.set([x, y, Math.sin(x / 9) * Math.cos(y / 7)], 3 * (y * width + x));
      if (x > 0 && y > 0) faces.push((y - 1) * width + x - 1, y * width + x - 1, y * width + x, (y - 1) * width + x - 1, y * width + x, (y - 1) * width + x);
    }
  }
  const terrain = graze.mesh(vertices, Uint32Array.from(faces), { dimension: 3 });
  assert.ok(terrain.faceCount > 100_000);
  const before = graze.usedBytes;
  const start = performance.now();
  for (let i = 0; i < 1000; ++i) assert.ok(graze.rayCast(terrain, { origin: [7 + i / 10, 100.3, 50], direction: [0.01, 0, -1] }) !== null);
  const spent = performance.now() - start;
  assert.ok(spent < 1000, `${spent} ms`);
  const placed = terrain.posed([1, 2, 3, 0, 0, 0, 1]);
  assert.ok(graze.usedBytes - before < 100_000, "posed shares the triangles");
  placed.delete();
  terrain.delete();
});

test("invalid meshes, points and rays are refused, and the message names what is wrong", () => {
  const thrown = (call, message) => assert.throws(call, (error) => error instanceof Error && message.test(error.message));
  const mesh = cube();
  thrown(() => graze.mesh(corners, [[0, 1, 8]]), /^mesh_of: face 0 has vertex 8, but there are 8 vertices, numbered from 0$/);
  thrown(() => graze.mesh(corners, [[0, 1, -1]]), /^faces: face 0 has -1, which is not the index of a vertex$/);
  thrown(() => graze.mesh(corners, [[0, 1, 2], [0, 1.5, 2]]), /^faces: face 1 has 1\.5, which is not the index of a vertex$/);
  thrown(() => graze.mesh(corners, [[0, 1]]), /^faces: face 0 does not have three indices of vertices$/);
  thrown(() => graze.mesh(corners, Uint32Array.of(0, 1)), /^faces: 2 numbers are not a multiple of 3$/);
  thrown(() => graze.mesh([[0, 0], [1, 0, 0]], []), /^vertices\[1\]: it has 3 numbers; it must have 2$/);
  thrown(() => graze.mesh(Float64Array.of(0, 0, NaN), [], { dimension: 3 }), /^mesh_of: vertex 0 has a coordinate that is not finite$/);
  thrown(() => graze.mesh(Float64Array.of(0, 0, 0), []), /^vertices: consecutive coordinates need a dimension$/);
  thrown(() => graze.mesh(corners, triangles, { kind: "hollow" }), /^kind: it is hollow; it must be one of surface, solid$/);
  thrown(() => graze.mesh(corners, triangles, "solid"), /^options: must be an object with any of the fields "kind", "dimension"$/);
  thrown(() => mesh.windingNumbers(Float64Array.of(1, 2)), /^points: 2 numbers are not a multiple of 3$/);
  thrown(() => mesh.closestPoints(Float64Array.of(1, 2, 3, 1, NaN, 3)), /^points: point 1 is not finite$/);
  thrown(() => mesh.rayCasts(Float64Array.of(1, 2, 3, 0, 0, 0)), /^rays: ray 0 has a direction/);
  thrown(() => mesh.windingNumber([1, 2]), /^point: it has 2 numbers; it must have 3$/);
  thrown(() => mesh.moved([[0, 0, 0]]), /^moved: the mesh has 8 vertices, but 1 are given$/);
  thrown(() => mesh.posed([0, 0, 0, 0, 0, 0, 0]), /^pose 0 has a quaternion of length zero$/);
  thrown(() => mesh.touchingFaces({ type: "mesh", vertices: [], faces: [] }), /^other: must be a mesh that graze\.mesh has made$/);
  thrown(() => mesh.touchingFaces(graze.mesh([[0, 0]], [])), /^the mesh does not have dimension 3$/);
  thrown(() => mesh.edges("sharp"), /^fault: it is sharp; it must be one of open, non_manifold, flipped$/);
  thrown(() => graze.distance({ type: "mesh", held: 1 }, mesh), /^a: /);
  thrown(() => graze.distance(mesh, { type: "point", position: [0, 0] }), /^b: .*2 numbers/);
  thrown(() => graze.distance({ type: "point", position: [0, 0] }, mesh), /^b: .*3 numbers/);
  assert.equal(graze.distance(mesh, { type: "point", position: [3, 0, 0] }), 2);
  mesh.delete();
  thrown(() => graze.distance(mesh, { type: "point", position: [3, 0, 0] }), /^this object was deleted$/);
  thrown(() => mesh.faceCount, /^this object was deleted$/);
});
