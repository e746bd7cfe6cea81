// SPDX-License-Identifier: MIT
// Draws the parts of a model: their surfaces, with a paint for each face, and the edges where something is wrong with
// them. A plane may cut off what is in front of it.
import * as THREE from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";

import { Paint, paintShader, paintUniforms, placeShader, setPalette, type PaintUniforms } from "../drawing/paint";
import { castsShadow } from "../drawing/shadow";
import type { Stage } from "../stage";
import type { Palette } from "../theme";
import { cornerNormals, type MeshData } from "./mesh_data";
import type { MeshPart } from "./mesh_part";

/** Of all parts: points x with dot(x, xyz) > w are cut off. */
const cutUniform = { value: new THREE.Vector4(0, 0, 0, 1) };
/** The same for lines, which three cuts. */
const cutPlane = new THREE.Plane(new THREE.Vector3(0, 0, 0), 1);

/** Cuts off all points with dot(point, normal) > offset; none for a normal of zero and an offset of 1. */
export function setCut(normal: readonly number[], offset: number): void {
  const [x = 0, y = 0, z = 0] = normal;
  cutUniform.value.set(x, y, z, offset);
  cutPlane.setComponents(-x, -y, -z, offset);
}

const vertexShader = /* glsl */ `
  ${placeShader}
  attribute float paint;
  varying vec3 vPlace;
  varying vec3 vNormal;
  varying float vPaint;
  void main() {
    vPlace = (modelMatrix * vec4(position, 1.0)).xyz;
    vNormal = mat3(modelMatrix) * normal;
    vPaint = paint;
    gl_Position = seenPlace(position, paint);
  }
`;

const fragmentShader = /* glsl */ `
  ${paintShader}
  uniform vec4 cut;
  uniform float fillOpacity;
  varying vec3 vPlace;
  varying vec3 vNormal;
  varying float vPaint;
  void main() {
    if (dot(vPlace, cut.xyz) > cut.w) discard;
    vec3 fill = mix(fillOf(vPaint), strokeOf(vPaint), 0.55 * pattern(vPaint));
    if (!gl_FrontFacing) fill = mix(fill, paper, 0.45);
    gl_FragColor = vec4(lit(fill, vPlace, normalize(gl_FrontFacing ? vNormal : -vNormal)), fillOpacity);
    #include <colorspace_fragment>
  }
`;

/** More lines than this are drawn one pixel wide. */
const mostWideLines = 20_000;
/** Meshes with fewer faces show all their edges. */
const mostFacesWithEdges = 3000;

export type EdgeTone = "overlapping-line" | "third" | "second";

export class PartDrawing {
  readonly object = new THREE.Group();
  readonly #uniforms: PaintUniforms;
  readonly #paints: THREE.BufferAttribute;
  readonly #part: MeshPart;
  readonly #edges = new Map<EdgeTone, LineSegments2 | THREE.LineSegments>();
  #wires: THREE.LineSegments | undefined;
  #painted = "";

  constructor(stage: Stage, part: MeshPart) {
    this.#part = part;
    this.#uniforms = { ...paintUniforms(stage.palette), fillOpacity: { value: 1 }, cut: cutUniform };
    const { vertices, faces } = part.data;
    const positions = new Float32Array(3 * faces.length);
    faces.forEach((vertex, corner) => positions.set(vertices.subarray(3 * vertex, 3 * vertex + 3), 3 * corner));
    this.#paints = new THREE.BufferAttribute(new Uint8Array(faces.length), 1);
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(cornerNormals(part.data), 3));
    geometry.setAttribute("paint", this.#paints);
    const offset = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };
    const material = new THREE.ShaderMaterial({ uniforms: this.#uniforms, vertexShader, fragmentShader, side: THREE.DoubleSide, ...offset });
    const surface = new THREE.Mesh(geometry, material);
    castsShadow(surface);
    this.object.add(surface);
    if (faces.length / 3 <= mostFacesWithEdges) this.#addWires(stage.palette);
    for (const drawn of this.object.children) drawn.frustumCulled = false;
    this.object.matrixAutoUpdate = false;
    this.place();
    stage.onTheme(() => this.#setPalette(stage.palette));
  }

  /** Moves it to where its part is. */
  place(): void {
    this.object.matrix.copy(this.#part.matrix);
    this.object.matrixWorldNeedsUpdate = true;
  }

  /** All faces in one paint, and some in another. */
  paint(paint: Paint, faces: Iterable<number> = [], paintOfFaces: Paint = paint): void {
    const some = [...faces];
    const wanted = `${paint} ${paintOfFaces} ${some.join()}`;
    if (wanted === this.#painted) return;
    this.#painted = wanted;
    const { array } = this.#paints;
    array.fill(paint);
    for (const face of some) array.fill(paintOfFaces, 3 * face, 3 * face + 3);
    this.#paints.needsUpdate = true;
  }

  /** Shows edges, each given by two vertices, or none of this tone. */
  showEdges(tone: EdgeTone, edges: Uint32Array, palette: Palette): void {
    const before = this.#edges.get(tone);
    before?.removeFromParent();
    before?.geometry.dispose();
    this.#edges.delete(tone);
    if (edges.length === 0) return;
    const lines = edgeLines(this.#part.data, edges, palette[tone]);
    this.#edges.set(tone, lines);
    this.object.add(lines);
  }

  #addWires(palette: Palette): void {
    const { vertices, faces } = this.#part.data;
    const ends = new Uint32Array(2 * faces.length);
    faces.forEach((vertex, corner) => ends.set([vertex, faces[corner % 3 === 2 ? corner - 2 : corner + 1] ?? vertex], 2 * corner));
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(Float32Array.from(vertices), 3));
    geometry.setIndex(new THREE.BufferAttribute(ends, 1));
    const uniforms = { cut: cutUniform, colour: { value: new THREE.Color(palette["free-line"]) } };
    const material = new THREE.ShaderMaterial({
      uniforms, transparent: true, depthWrite: false,
      vertexShader: "varying vec3 vPlace; void main() { vPlace = (modelMatrix * vec4(position, 1.0)).xyz; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }",
      fragmentShader: "uniform vec4 cut; uniform vec3 colour; varying vec3 vPlace; void main() { if (dot(vPlace, cut.xyz) > cut.w) discard; gl_FragColor = vec4(colour, 0.18);\n#include <colorspace_fragment>\n}",
    });
    this.#wires = new THREE.LineSegments(geometry, material);
    this.object.add(this.#wires);
  }

  #setPalette(palette: Palette): void {
    setPalette(this.#uniforms, palette);
    const wires = this.#wires?.material;
    if (wires instanceof THREE.ShaderMaterial) wires.uniforms["colour"] = { value: new THREE.Color(palette["free-line"]) };
    for (const [tone, { material }] of this.#edges) {
      if (material instanceof LineMaterial || material instanceof THREE.LineBasicMaterial) material.color.set(palette[tone]);
    }
  }
}

function edgeLines({ vertices }: MeshData, edges: Uint32Array, colour: string): LineSegments2 | THREE.LineSegments {
  const ends = new Float32Array(3 * edges.length);
  edges.forEach((vertex, end) => ends.set(vertices.subarray(3 * vertex, 3 * vertex + 3), 3 * end));
  const isWide = edges.length / 2 <= mostWideLines;
  const lines = isWide
    ? new LineSegments2(new LineSegmentsGeometry().setPositions(ends), new LineMaterial({ color: colour, linewidth: 3, clippingPlanes: [cutPlane] }))
    : new THREE.LineSegments(new THREE.BufferGeometry().setAttribute("position", new THREE.BufferAttribute(ends, 3)), new THREE.LineBasicMaterial({ color: colour, clippingPlanes: [cutPlane] }));
  lines.frustumCulled = false;
  return lines;
}
