// SPDX-License-Identifier: MIT
// Meshes that the module holds, so that their triangles are copied into it, and their trees built, only once.
import { HeldNumber, meshKinds } from "./arguments.js";
import { Held, knownDimension, numbersOf, rowsOf } from "./core.js";
import { known } from "./options.js";
import { dimensionOf, plain } from "./text.js";

/** In the order of the C++ enumeration. */
const edgeFaults = ["open", "non_manifold", "flipped"];

function wordOf(value, words, role) {
  const place = words.indexOf(value);
  if (place >= 0) return place;
  throw new Error(`${role}: it is ${value}; it must be one of ${words.join(", ")}`);
}

/** Consecutive numbers of points that are given as such or as vectors. */
function coordinatesOf(points, dimension, role) {
  if (ArrayBuffer.isView(points)) return points;
  if (!Array.isArray(points)) throw new Error(`${role}: must be an array of vectors, a Float32Array or a Float64Array`);
  const numbers = new Float64Array(points.length * dimension);
  points.forEach((point, i) => numbers.set(numbersOf(point, dimension, `${role}[${i}]`), i * dimension));
  return numbers;
}

/** Three indices for each face, one after the other. */
function indicesOf(faces) {
  if (ArrayBuffer.isView(faces)) return faces;
  if (!Array.isArray(faces)) throw new Error("faces: must be an array of three indices each, or a Uint32Array");
  const wrong = faces.findIndex((face) => face?.length !== 3);
  if (wrong >= 0) throw new Error(`faces: face ${wrong} does not have three indices of vertices`);
  return Float64Array.from(faces.flatMap((face) => Array.from(face, Number)));
}

class BuiltMesh extends Held {
  /** The own enumerable properties are those of a form of meshes that js/arguments.js writes. */
  constructor(core, handle) {
    super(core, handle);
    const number = new HeldNumber(handle.number(), handle.dimension());
    const held = () => this.handle && number;
    Object.defineProperty(this, "type", { enumerable: true, value: "mesh" });
    Object.defineProperty(this, "held", { enumerable: true, get: held });
  }

  /** As a plain object. */
  [plain]() {
    const { dimension, kind } = this;
    const rows = (numbers, width) => Array.from({ length: numbers.length / width }, (_, i) => Array.from(numbers.subarray(i * width, (i + 1) * width)));
    return { type: "mesh", vertices: rows(this.vertices(), dimension), faces: rows(this.faces(), 3), kind };
  }

  get dimension() {
    return this.core.checked(this.handle.dimension());
  }

  get kind() {
    return meshKinds[this.core.checked(this.handle.isSolid()) ? 1 : 0];
  }

  get vertexCount() {
    return this.core.checked(this.handle.vertexCount());
  }

  get faceCount() {
    return this.core.checked(this.handle.faceCount());
  }

  #list(method, ...args) {
    this.core.checked(this.handle[method](...args));
    return this.core.answer();
  }

  vertices() {
    return this.#list("vertices").slice();
  }

  faces() {
    return Uint32Array.from(this.#list("faces"));
  }

  report() {
    const [openEdges, nonManifoldEdges, flippedEdges, degenerateFaces, duplicateFaces, unusedVertices, components, isClosed] =
      this.#list("report");
    return {
      openEdges, nonManifoldEdges, flippedEdges, degenerateFaces, duplicateFaces, unusedVertices, components,
      isClosed: isClosed === 1,
    };
  }

  edges(fault) {
    return Uint32Array.from(this.#list("edges", wordOf(fault, edgeFaults, "fault")));
  }

  /** Calls a function of the module with the rows that it reads from the input. */
  #ask(name, rows, width, role) {
    const { handle } = this;
    const count = rowsOf(rows, width, role);
    this.core.give([rows]);
    this.core.checked(this.core.module[name](handle, count));
    return count;
  }

  windingNumber(point) {
    return this.windingNumbers(numbersOf(point, this.dimension, "point"))[0];
  }

  windingNumbers(points) {
    this.#ask("meshWindingNumbers", points, this.dimension, "points");
    return this.core.answer().slice();
  }

  signedDistances(points) {
    this.#ask("meshSignedDistances", points, this.dimension, "points");
    return this.core.answer().slice();
  }

  closestPoints(points) {
    this.#ask("meshClosestPoints", points, this.dimension, "points");
    return this.core.answer().slice();
  }

  rayCasts(rays) {
    const { dimension } = this;
    const count = this.#ask("meshRayCasts", rays, 2 * dimension, "rays");
    const hits = {
      t: new Float64Array(count).fill(Infinity),
      faces: new Int32Array(count).fill(-1),
      points: new Float64Array(count * dimension).fill(NaN),
      normals: new Float64Array(count * dimension),
      barycentrics: new Float64Array(count * 3),
      statuses: new Uint8Array(count),
      errors: new Float64Array(count),
    };
    const answer = this.core.reader(dimension);
    for (let i = 0; i < count; ++i) {
      if (answer.number() === 0) continue;
      hits.t[i] = answer.number();
      hits.points.set(answer.numbersAhead(dimension), i * dimension);
      hits.normals.set(answer.numbersAhead(dimension), i * dimension);
      hits.statuses[i] = answer.number();
      hits.errors[i] = answer.number();
      hits.faces[i] = answer.number();
      hits.barycentrics.set(answer.numbersAhead(3), i * 3);
    }
    return hits;
  }

  touchingFaces(other) {
    if (!(other instanceof BuiltMesh)) throw new Error("other: must be a mesh that graze.mesh has made");
    this.core.checked(this.core.module.meshTouchingFaces(this.handle, other.handle));
    return Uint32Array.from(this.core.answer());
  }

  selfIntersections() {
    this.core.checked(this.core.module.meshSelfIntersections(this.handle));
    return Uint32Array.from(this.core.answer());
  }

  welded() {
    return new BuiltMesh(this.core, this.core.checked(this.handle.welded()));
  }

  moved(vertices) {
    const { core, dimension, handle } = this;
    const numbers = coordinatesOf(vertices, dimension, "vertices");
    const count = rowsOf(numbers, dimension, "vertices");
    core.give([numbers]);
    return new BuiltMesh(core, core.checked(handle.moved(count)));
  }

  posed(pose) {
    const { core, dimension, handle } = this;
    core.give([numbersOf(pose, dimension === 2 ? 3 : 7, "pose")]);
    return new BuiltMesh(core, core.checked(handle.posed()));
  }
}

/** Where on a mesh a hit is, from the output. */
export function readFace(answer) {
  const face = answer.number();
  return { face: face < 0 ? null : face, barycentric: Array.from(answer.numbersAhead(3)) };
}

/** What a ray hits, from the output: of a mesh with the face. */
export function readRayHit(answer) {
  if (answer.isAtEnd) return null;
  const hit = answer.hit();
  return answer.isAtEnd ? hit : { ...hit, ...readFace(answer) };
}

export const meshParts = (core) => ({
  mesh(vertices, faces, options) {
    const { kind = "surface", dimension } = known(options, ["kind", "dimension"]);
    const isSolid = wordOf(kind, meshKinds, "kind") === 1;
    if (dimension === undefined && ArrayBuffer.isView(vertices)) throw new Error("vertices: consecutive coordinates need a dimension");
    const n = knownDimension(dimension ?? dimensionOf(vertices));
    const numbers = coordinatesOf(vertices, n, "vertices");
    const indices = indicesOf(faces);
    const counts = [rowsOf(numbers, n, "vertices"), rowsOf(indices, 3, "faces")];
    core.give([numbers, indices]);
    return new BuiltMesh(core, core.checked(core.module.Mesh.make(n, ...counts, isSolid)));
  },
});
