// SPDX-License-Identifier: MIT
// A part of a model: its triangles in the engine, and where it has been moved.
import * as THREE from "three";

import type { BuiltMesh, Graze } from "graze";
import type { MeshData } from "./mesh_data";

export class MeshPart {
  readonly name: string;
  /** Vertices with equal coordinates are one, because files without indices repeat them. */
  readonly data: MeshData;
  /** The center of its box before it was moved. */
  readonly #start: THREE.Vector3;
  readonly #graze: Graze;
  readonly #base: BuiltMesh;
  readonly #offset = new THREE.Vector3();
  readonly #rotation = new THREE.Quaternion();
  #placed: BuiltMesh | undefined;
  /** The faces alone, made when they are first asked for. */
  #surface: BuiltMesh | undefined;
  #placedSurface: BuiltMesh | undefined;

  /** Throws if a coordinate is not finite. */
  constructor(graze: Graze, data: MeshData, kind: "surface" | "solid") {
    this.#graze = graze;
    const given = graze.mesh(data.vertices, data.faces, { kind: data.isSheet === true ? "surface" : kind, dimension: 3 });
    this.#base = given.welded();
    given.delete();
    this.name = data.name;
    this.data = { name: data.name, vertices: this.#base.vertices(), faces: this.#base.faces() };
    const { min, max } = graze.bounds(this.#base);
    const middle = min.map((low, axis) => (low + (max[axis] ?? low)) / 2);
    this.#start = new THREE.Vector3(...(middle.every(Number.isFinite) ? middle : [0, 0, 0]));
  }

  /** In its place. */
  get mesh(): BuiltMesh {
    return this.#placed ?? this.#base;
  }

  /** Its faces in their place, without what they enclose: a ray that starts inside a solid hits no face of it. */
  get surface(): BuiltMesh {
    if (this.#base.kind === "surface") return this.mesh;
    this.#surface ??= this.#graze.mesh(this.data.vertices, this.data.faces, { dimension: 3 });
    if (!this.isMoved) return this.#surface;
    this.#placedSurface ??= this.#surface.posed(this.#pose());
    return this.#placedSurface;
  }

  /** The center of rotation. */
  get middle(): number[] {
    return this.#start.clone().add(this.#offset).toArray();
  }

  /** How far and by which quaternion it was moved; zero and the identity at the start. */
  get pose(): { readonly offset: readonly number[]; readonly rotation: readonly number[] } {
    return { offset: this.#offset.toArray(), rotation: this.#rotation.toArray() };
  }

  get isMoved(): boolean {
    return this.#placed !== undefined;
  }

  get matrix(): THREE.Matrix4 {
    return new THREE.Matrix4().compose(this.#position(), this.#rotation, new THREE.Vector3(1, 1, 1));
  }

  move(offset: readonly number[]): void {
    this.#offset.add(new THREE.Vector3(...offset));
    this.#place();
  }

  turn(degrees: number, axis: readonly number[] = [0, 0, 1]): void {
    const turned = new THREE.Quaternion().setFromAxisAngle(new THREE.Vector3(...axis).normalize(), THREE.MathUtils.degToRad(degrees));
    this.#rotation.premultiply(turned).normalize();
    this.#place();
  }

  put(offset: readonly number[], rotation: readonly number[]): void {
    this.#offset.fromArray([...offset]);
    this.#rotation.fromArray([...rotation]).normalize();
    this.#place();
  }

  close(): void {
    for (const mesh of [this.#placed, this.#placedSurface, this.#surface, this.#base]) mesh?.delete();
  }

  /** The engine rotates about the origin. */
  #position(): THREE.Vector3 {
    return this.#start.clone().applyQuaternion(this.#rotation).negate().add(this.#start).add(this.#offset);
  }

  #pose(): number[] {
    return [...this.#position().toArray(), ...this.#rotation.toArray()];
  }

  #place(): void {
    this.#placed?.delete();
    this.#placedSurface?.delete();
    [this.#placed, this.#placedSurface] = [undefined, undefined];
    const isAtStart = this.#offset.lengthSq() === 0 && this.#rotation.w === 1;
    if (!isAtStart) this.#placed = this.#base.posed(this.#pose());
  }
}
