// SPDX-License-Identifier: MIT
// Draws shapes of every kind as the engine provides them, all in one geometry: surfaces, and lines of constant width.
import * as THREE from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";

import type { Drawing } from "graze";
import type { Palette } from "../theme";
import { paintShader, paintUniforms, placeShader, setPalette, strokeColours, type PaintUniforms } from "./paint";
import { castsShadow } from "./shadow";

const vertexShader = /* glsl */ `
  ${placeShader}
  attribute float paint;
  varying vec3 vPlace;
  varying vec3 vNormal;
  varying float vPaint;
  void main() {
    vPlace = position;
    vNormal = normal;
    vPaint = paint;
    gl_Position = seenPlace(position, paint);
  }
`;

const fragmentShader = /* glsl */ `
  ${paintShader}
  uniform float fillOpacity;
  varying vec3 vPlace;
  varying vec3 vNormal;
  varying float vPaint;
  void main() {
    vec3 fill = mix(fillOf(vPaint), strokeOf(vPaint), 0.55 * pattern(vPaint));
    #ifndef IS_FLAT
      fill = lit(fill, vPlace, normalize(gl_FrontFacing ? vNormal : -vNormal));
    #endif
    gl_FragColor = vec4(fill, fillOpacity);
    #include <colorspace_fragment>
  }
`;

/** More lines than this are drawn one pixel wide, which is much faster. */
const mostWideLines = 20_000;

/** The ranges of one shape's corners and lines in the shared arrays. */
interface Span {
  readonly corner: number;
  readonly corners: number;
  readonly line: number;
  readonly lines: number;
}

export interface MeshLook {
  readonly fill: number;
  readonly lineWidth: number;
  /** Lines are visible through objects in front of them. */
  readonly isSeenThrough?: boolean;
}

export class MeshDrawing {
  readonly object = new THREE.Group();
  readonly #dimension: 2 | 3;
  readonly #uniforms: PaintUniforms;
  readonly #look: MeshLook;
  #palette: Palette;
  #spans: Span[] = [];
  #paints: Uint8Array = new Uint8Array(0);
  #surface: THREE.Mesh | undefined;
  #lines: LineSegments2 | THREE.LineSegments | undefined;

  constructor(dimension: 2 | 3, palette: Palette, look: MeshLook = { fill: dimension === 2 ? 0.55 : 1, lineWidth: 2 }) {
    this.#dimension = dimension;
    this.#palette = palette;
    this.#look = look;
    this.#uniforms = { ...paintUniforms(palette), fillOpacity: { value: look.fill } };
  }

  /** Shows these shapes; each may have several drawings (the parts of a compound). */
  set(shapes: readonly (readonly Drawing[])[], paints: Uint8Array): void {
    this.clear();
    this.#paints = paints;
    this.#surface = this.#makeSurface(shapes);
    this.#lines = this.#makeLines(shapes);
    this.object.add(this.#surface);
    if (this.#lines !== undefined) this.object.add(this.#lines);
    this.#paintLines();
  }

  /** Updates these shapes, given by index. Returns false without a change if one of them now has another number of
   * triangles or lines. */
  replace(shapes: ReadonlyMap<number, readonly Drawing[]>): boolean {
    const surface = this.#surface?.geometry;
    const positions = surface?.getAttribute("position");
    if (surface === undefined || positions === undefined) return false;
    for (const [shape, drawings] of shapes) {
      const span = this.#spans[shape];
      const corners = drawings.reduce((sum, drawing) => sum + drawing.triangles.length, 0);
      const lines = drawings.reduce((sum, drawing) => sum + drawing.lines.length / 2, 0);
      if (span?.corners !== corners || span.lines !== lines) return false;
    }
    const normals = this.#dimension === 3 ? surface.getAttribute("normal") : undefined;
    const ends = this.#lineBuffer("instanceStart", "position");
    for (const [shape, drawings] of shapes) {
      let corner = this.#spans[shape]?.corner ?? 0;
      let end = 2 * (this.#spans[shape]?.line ?? 0);
      for (const drawing of drawings) {
        const first = corner;
        for (const own of drawing.triangles) this.#copy(drawing, own, positions.array as Float32Array, corner++);
        if (normals !== undefined) writeNormals(drawing, positions.array as Float32Array, normals.array as Float32Array, first);
        for (const own of drawing.lines) if (ends !== undefined) this.#copy(drawing, own, ends.array as Float32Array, end++);
      }
    }
    for (const changed of [positions, normals, ends]) if (changed !== undefined) changed.needsUpdate = true;
    return true;
  }

  /** One for each shape. Fast: no geometry is rebuilt. */
  setPaints(paints: Uint8Array): void {
    this.#paints = paints;
    const attribute = this.#surface?.geometry.getAttribute("paint");
    if (attribute instanceof THREE.BufferAttribute) {
      this.#spans.forEach((span, shape) => {
        attribute.array.fill(paints[shape] ?? 0, span.corner, span.corner + span.corners);
      });
      attribute.needsUpdate = true;
    }
    this.#paintLines();
  }

  setPalette(palette: Palette): void {
    this.#palette = palette;
    setPalette(this.#uniforms, palette);
    this.#paintLines();
  }

  clear(): void {
    for (const object of [this.#surface, this.#lines]) {
      object?.geometry.dispose();
      for (const material of [object?.material ?? []].flat()) material.dispose();
    }
    this.object.clear();
  }

  #makeSurface(shapes: readonly (readonly Drawing[])[]): THREE.Mesh {
    const corners = shapes.flat().reduce((sum, drawing) => sum + drawing.triangles.length, 0);
    const positions = new Float32Array(corners * 3);
    const paints = new Uint8Array(corners);
    const spans: Span[] = [];
    let next = 0;
    let line = 0;
    shapes.forEach((drawings, shape) => {
      const first = next;
      const firstLine = line;
      for (const drawing of drawings) {
        for (const corner of drawing.triangles) this.#copy(drawing, corner, positions, next++);
        line += drawing.lines.length / 2;
      }
      paints.fill(this.#paints[shape] ?? 0, first, next);
      spans.push({ corner: first, corners: next - first, line: firstLine, lines: line - firstLine });
    });
    this.#spans = spans;
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
    geometry.setAttribute("paint", new THREE.BufferAttribute(paints, 1));
    if (this.#dimension === 3) geometry.setAttribute("normal", new THREE.BufferAttribute(this.#normals(shapes, positions), 3));
    const isOpaque = this.#look.fill === 1;
    const isFlat = this.#dimension === 2;
    const material = new THREE.ShaderMaterial({
      uniforms: this.#uniforms,
      vertexShader: isFlat ? vertexShader.replace("vNormal = normal;", "vNormal = vec3(0.0);") : vertexShader,
      fragmentShader,
      defines: isFlat ? { IS_FLAT: "" } : {},
      transparent: !isOpaque,
      depthWrite: isOpaque,
      depthTest: !isFlat,
      side: THREE.DoubleSide,
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1,
    });
    const mesh = new THREE.Mesh(geometry, material);
    mesh.frustumCulled = false;
    if (isOpaque && !isFlat) castsShadow(mesh);
    return mesh;
  }

  #normals(shapes: readonly (readonly Drawing[])[], positions: Float32Array): Float32Array {
    const normals = new Float32Array(positions.length);
    let first = 0;
    for (const drawing of shapes.flat()) {
      writeNormals(drawing, positions, normals, first);
      first += drawing.triangles.length;
    }
    return normals;
  }

  #makeLines(shapes: readonly (readonly Drawing[])[]): LineSegments2 | THREE.LineSegments | undefined {
    const drawings = shapes.flat();
    const ends = drawings.reduce((sum, drawing) => sum + drawing.lines.length, 0);
    if (ends === 0) return undefined;
    const positions = new Float32Array(ends * 3);
    let next = 0;
    for (const drawing of drawings) {
      for (const corner of drawing.lines) this.#copy(drawing, corner, positions, next++);
    }
    const colours = new Float32Array(positions.length);
    const depthTest = this.#dimension === 3 && this.#look.isSeenThrough !== true;
    if (ends / 2 > mostWideLines) {
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
      geometry.setAttribute("color", new THREE.BufferAttribute(colours, 3));
      const thin = new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ vertexColors: true, depthTest }));
      thin.frustumCulled = false;
      return thin;
    }
    const geometry = new LineSegmentsGeometry().setPositions(positions).setColors(colours);
    const linewidth = this.#look.lineWidth;
    const wide = new LineSegments2(geometry, new LineMaterial({ vertexColors: true, linewidth, depthTest }));
    wide.frustumCulled = false;
    return wide;
  }

  /** The line attribute's array, six numbers for each line, for wide or thin lines. */
  #lineBuffer(wide: string, thin: string): THREE.InterleavedBuffer | THREE.BufferAttribute | undefined {
    const lines = this.#lines;
    const attribute = lines?.geometry.getAttribute(lines instanceof LineSegments2 ? wide : thin);
    return attribute instanceof THREE.InterleavedBufferAttribute ? attribute.data : (attribute as THREE.BufferAttribute | undefined);
  }

  #paintLines(): void {
    const buffer = this.#lineBuffer("instanceColorStart", "color");
    if (buffer === undefined) return;
    const strokes = strokeColours(this.#palette);
    this.#spans.forEach((span, shape) => {
      const stroke = strokes[this.#paints[shape] ?? 0] ?? [0, 0, 0];
      for (let i = span.line * 6; i < (span.line + span.lines) * 6; ++i) buffer.array[i] = stroke[i % 3] ?? 0;
    });
    buffer.needsUpdate = true;
  }

  #copy(drawing: Drawing, corner: number, positions: Float32Array, place: number): void {
    for (let axis = 0; axis < this.#dimension; ++axis) {
      positions[place * 3 + axis] = drawing.positions[corner * this.#dimension + axis] ?? 0;
    }
  }
}

/** Faces are flat if a drawing has edges; without edges it is round, and corners get the average normal of their
 * triangles. */
function writeNormals(drawing: Drawing, positions: Float32Array, normals: Float32Array, first: number): void {
  const last = first + drawing.triangles.length;
  for (let corner = first; corner < last; corner += 3) writeFaceNormal(positions, normals, corner * 3);
  if (drawing.lines.length === 0) smooth(drawing, normals, first);
}

function writeFaceNormal(positions: Float32Array, normals: Float32Array, at: number): void {
  const corner = (index: number): THREE.Vector3 => new THREE.Vector3().fromArray(positions, at + 3 * index);
  const origin = corner(0);
  const normal = corner(1).sub(origin).cross(corner(2).sub(origin)).normalize();
  for (let index = 0; index < 3; ++index) normal.toArray(normals, at + 3 * index);
}

function smooth(drawing: Drawing, normals: Float32Array, first: number): void {
  const sums = new Float32Array(drawing.positions.length);
  drawing.triangles.forEach((corner, index) => {
    for (let axis = 0; axis < 3; ++axis) {
      const sum = (sums[corner * 3 + axis] ?? 0) + (normals[(first + index) * 3 + axis] ?? 0);
      sums[corner * 3 + axis] = sum;
    }
  });
  drawing.triangles.forEach((corner, index) => {
    new THREE.Vector3().fromArray(sums, corner * 3).normalize().toArray(normals, (first + index) * 3);
  });
}

