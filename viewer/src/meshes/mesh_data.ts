// SPDX-License-Identifier: MIT
// Triangles as read from a file or made by a sample, before the engine has them.
import type { Extent } from "../stage";

export interface MeshData {
  readonly name: string;
  /** Three coordinates each. */
  readonly vertices: Float64Array;
  /** Three indices of vertices each. */
  readonly faces: Uint32Array;
  /** A part that encloses nothing, such as a terrain, is a surface even among solids. */
  readonly isSheet?: boolean;
}

/** Parts that are shown together. */
export interface MeshSource {
  readonly name: string;
  readonly parts: readonly MeshData[];
}

/** Collects vertices and faces. */
export class MeshBuilder {
  readonly #vertices: number[] = [];
  readonly #faces: number[] = [];

  get isEmpty(): boolean {
    return this.#faces.length === 0;
  }

  /** Returns the index of the vertex. */
  vertex(x: number, y: number, z: number): number {
    return this.#vertices.push(x, y, z) / 3 - 1;
  }

  face(a: number, b: number, c: number): void {
    this.#faces.push(a, b, c);
  }

  /** Counter-clockwise as seen from outside. */
  quad(a: number, b: number, c: number, d: number): void {
    this.face(a, b, c);
    this.face(a, c, d);
  }

  data(name: string): MeshData {
    return { name, vertices: Float64Array.from(this.#vertices), faces: Uint32Array.from(this.#faces) };
  }
}

/** The box around all parts; around the origin if there are no vertices. */
export function extentOf(parts: readonly MeshData[]): Extent {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  for (const { vertices } of parts) {
    for (let i = 0; i < vertices.length; ++i) {
      const value = vertices[i] ?? 0;
      min[i % 3] = Math.min(min[i % 3] ?? value, value);
      max[i % 3] = Math.max(max[i % 3] ?? value, value);
    }
  }
  return min[0] === Infinity ? { min: [-1, -1, -1], max: [1, 1, 1] } : { min, max };
}

/** Turned by a right angle about x, from y up to z up. */
export function turnedUp(part: MeshData): MeshData {
  const vertices = part.vertices.slice();
  for (let i = 0; i < vertices.length; i += 3) {
    vertices[i + 1] = -(part.vertices[i + 2] ?? 0);
    vertices[i + 2] = part.vertices[i + 1] ?? 0;
  }
  return { ...part, vertices };
}

/** Faces that meet at a smaller angle are drawn as one smooth surface. */
const leastCrease = Math.cos((35 * Math.PI) / 180);

/** A normal for each corner of each face, three numbers each: the mean of the normals of the faces around the vertex
 * that differ by less than the crease. Each face counts by its area. */
export function cornerNormals({ vertices, faces }: MeshData): Float32Array {
  const areas = faceAreas(vertices, faces);
  const { starts, around } = facesAround(vertices.length / 3, faces);
  const normals = new Float32Array(3 * faces.length);
  for (let corner = 0; corner < faces.length; ++corner) {
    const own = 3 * Math.floor(corner / 3);
    const vertex = faces[corner] ?? 0;
    let [x, y, z] = [0, 0, 0];
    for (let i = starts[vertex] ?? 0; i < (starts[vertex + 1] ?? 0); ++i) {
      const other = 3 * (around[i] ?? 0);
      if (cosine(areas, own, other) < leastCrease) continue;
      x += areas[other] ?? 0;
      y += areas[other + 1] ?? 0;
      z += areas[other + 2] ?? 0;
    }
    const length = Math.hypot(x, y, z) || 1;
    normals.set([x / length, y / length, z / length], 3 * corner);
  }
  return normals;
}

/** The cross product of two edges of each face. */
function faceAreas(vertices: Float64Array, faces: Uint32Array): Float64Array {
  const areas = new Float64Array(faces.length);
  for (let face = 0; face < faces.length; face += 3) {
    const [a, b, c] = [3 * (faces[face] ?? 0), 3 * (faces[face + 1] ?? 0), 3 * (faces[face + 2] ?? 0)];
    const edge = (to: number, axis: number): number => (vertices[to + axis] ?? 0) - (vertices[a + axis] ?? 0);
    for (let axis = 0; axis < 3; ++axis) {
      const [next, last] = [(axis + 1) % 3, (axis + 2) % 3];
      areas[face + axis] = edge(b, next) * edge(c, last) - edge(b, last) * edge(c, next);
    }
  }
  return areas;
}

/** For each vertex the faces that have it, in one list. */
function facesAround(vertices: number, faces: Uint32Array): { starts: Uint32Array; around: Uint32Array } {
  const starts = new Uint32Array(vertices + 1);
  for (const vertex of faces) starts[vertex + 1] = (starts[vertex + 1] ?? 0) + 1;
  for (let i = 0; i < vertices; ++i) starts[i + 1] = (starts[i + 1] ?? 0) + (starts[i] ?? 0);
  const next = starts.slice();
  const around = new Uint32Array(faces.length);
  faces.forEach((vertex, corner) => {
    const place = next[vertex] ?? 0;
    around[place] = Math.floor(corner / 3);
    next[vertex] = place + 1;
  });
  return { starts, around };
}

/** Of the angle between two of the vectors; 1 if one of them is zero. */
function cosine(vectors: Float64Array, a: number, b: number): number {
  const [ax = 0, ay = 0, az = 0] = [vectors[a], vectors[a + 1], vectors[a + 2]];
  const [bx = 0, by = 0, bz = 0] = [vectors[b], vectors[b + 1], vectors[b + 2]];
  const lengths = Math.sqrt((ax * ax + ay * ay + az * az) * (bx * bx + by * by + bz * bz));
  return lengths > 0 ? (ax * bx + ay * by + az * bz) / lengths : 1;
}
