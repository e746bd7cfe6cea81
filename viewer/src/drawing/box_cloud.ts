// SPDX-License-Identifier: MIT
// Draws very many boxes in one draw call. Their coordinates are laid out as in the engine: min, then max.
import * as THREE from "three";

import type { Palette } from "../theme";
import { paintShader, paintUniforms, placeShader, setPalette, type PaintUniforms } from "./paint";
import { castsShadow } from "./shadow";

export interface BoxCloudLook {
  /** Opacity of the faces; 0 draws edges only. */
  readonly fill: number;
  /** Opacity of the edges. */
  readonly edge: number;
  /** Width of the edges, in pixels; 1.7 by default. */
  readonly width?: number;
}

const vertexShader = /* glsl */ `
  ${placeShader}
  attribute vec3 corner;
  attribute float paint;
  #ifdef IS_FLAT
    attribute vec2 low;
    attribute vec2 high;
  #else
    attribute vec3 low;
    attribute vec3 high;
  #endif
  varying vec3 vCorner;
  varying vec3 vPlace;
  varying vec3 vNormal;
  varying float vPaint;
  void main() {
    #ifdef IS_FLAT
      vec3 place = vec3(mix(low, high, corner.xy), 0.0);
    #else
      vec3 place = mix(low, high, corner);
    #endif
    vCorner = corner;
    vPlace = place;
    vNormal = normal;
    vPaint = paint;
    gl_Position = seenPlace(place, paint);
  }
`;

const fragmentShader = /* glsl */ `
  ${paintShader}
  uniform float fillOpacity;
  uniform float edgeOpacity;
  uniform float edgeWidth;
  varying vec3 vCorner;
  varying vec3 vPlace;
  varying vec3 vNormal;
  varying float vPaint;
  // The distance to the nearest edge of this face, in pixels.
  float pixelsToEdge() {
    vec3 inside = min(vCorner, 1.0 - vCorner);
    vec3 pixels = inside / max(fwidth(vCorner), vec3(1e-6));
    pixels += step(vec3(0.5), abs(vNormal)) * 1e6;
    return min(pixels.x, min(pixels.y, pixels.z));
  }
  // The approximate width of this face on screen. The coordinate across the face does not change, so its factor is 1.
  float pixelsWide(vec3 perPixel) {
    vec3 wide = mix(1.0 / max(perPixel, vec3(1e-6)), vec3(1.0), step(vec3(0.5), abs(vNormal)));
    return sqrt(wide.x * wide.y * wide.z);
  }
  void main() {
    // A box of a few pixels would consist of edges only: it is filled with an intermediate colour instead.
    float fade = edgeWidth > 1.0 ? smoothstep(3.0, 16.0, pixelsWide(fwidth(vCorner))) : 1.0;
    float edge = fade * (1.0 - smoothstep(max(0.0, edgeWidth - 1.0), edgeWidth, pixelsToEdge()));
    vec3 fill = mix(fillOf(vPaint), strokeOf(vPaint), max(0.4 * (1.0 - fade), 0.6 * fade * pattern(vPaint)));
    #ifdef IS_FLAT
      float alpha = mix(mix(0.9 * edgeOpacity, fillOpacity, fade), edgeOpacity, edge);
    #else
      fill = lit(fill, vPlace, vNormal);
      float alpha = mix(fillOpacity, edgeOpacity, edge);
    #endif
    if (alpha < 0.01) discard;
    gl_FragColor = vec4(mix(fill, strokeOf(vPaint), edge), alpha);
    #include <colorspace_fragment>
  }
`;

export class BoxCloud {
  readonly object: THREE.Mesh;
  readonly #geometry = new THREE.InstancedBufferGeometry();
  readonly #uniforms: PaintUniforms;
  readonly #dimension: 2 | 3;
  #boxes = new THREE.InstancedInterleavedBuffer(new Float32Array(0), 1);
  #paints = new THREE.InstancedBufferAttribute(new Uint8Array(0), 1);

  constructor(dimension: 2 | 3, palette: Palette, look: BoxCloudLook) {
    this.#dimension = dimension;
    const isFlat = dimension === 2;
    this.#uniforms = {
      ...paintUniforms(palette),
      fillOpacity: { value: look.fill },
      edgeOpacity: { value: look.edge },
      edgeWidth: { value: look.width ?? 1.7 },
    };
    const one = isFlat ? new THREE.PlaneGeometry(1, 1) : new THREE.BoxGeometry(1, 1, 1);
    const corners = Float32Array.from(one.getAttribute("position").array, (value) => value + 0.5);
    this.#geometry.setIndex(one.getIndex());
    this.#geometry.setAttribute("corner", new THREE.BufferAttribute(corners, 3));
    this.#geometry.setAttribute("normal", one.getAttribute("normal"));
    const isOpaque = look.fill === 1;
    const material = new THREE.ShaderMaterial({
      uniforms: this.#uniforms,
      vertexShader,
      fragmentShader,
      defines: isFlat ? { IS_FLAT: "" } : {},
      transparent: !isOpaque,
      depthWrite: isOpaque && !isFlat,
      depthTest: !isFlat,
      side: isOpaque && !isFlat ? THREE.FrontSide : THREE.DoubleSide,
    });
    this.object = new THREE.Mesh(this.#geometry, material);
    this.object.frustumCulled = false;
    if (isOpaque && !isFlat) castsShadow(this.object);
    this.resize(0);
  }

  get count(): number {
    return this.#paints.array.length;
  }

  /** The array of the boxes' coordinates, 2 N numbers each; call `boxesChanged` after writing. */
  get boxes(): Float32Array {
    return this.#boxes.array as Float32Array;
  }

  /** One paint for each box; call `paintsChanged` after writing. */
  get paints(): Uint8Array {
    return this.#paints.array as Uint8Array;
  }

  /** Allocates arrays for this many boxes, whose coordinates must then be set. */
  resize(count: number): void {
    this.#boxes = new THREE.InstancedInterleavedBuffer(new Float32Array(count * 2 * this.#dimension), 2 * this.#dimension);
    this.#paints = new THREE.InstancedBufferAttribute(new Uint8Array(count), 1);
    this.#boxes.setUsage(THREE.DynamicDrawUsage);
    this.#paints.setUsage(THREE.DynamicDrawUsage);
    const part = (offset: number): THREE.InterleavedBufferAttribute => {
      return new THREE.InterleavedBufferAttribute(this.#boxes, this.#dimension, offset);
    };
    this.#geometry.dispose();
    this.#geometry.setAttribute("low", part(0));
    this.#geometry.setAttribute("high", part(this.#dimension));
    this.#geometry.setAttribute("paint", this.#paints);
    this.#geometry.instanceCount = count;
    this.object.visible = count > 0;
  }

  boxesChanged(): void {
    this.#boxes.needsUpdate = true;
  }

  paintsChanged(): void {
    this.#paints.needsUpdate = true;
  }

  setPalette(palette: Palette): void {
    setPalette(this.#uniforms, palette);
  }
}
