// SPDX-License-Identifier: MIT
// The plane of a slice, coloured by the values on it.
import * as THREE from "three";

import type { Stage } from "../stage";
import type { Palette } from "../theme";
import type { Quantity, SliceGrid } from "./slice_field";

const vertexShader = /* glsl */ `
  varying vec2 vAt;
  void main() {
    vAt = uv;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }
`;

const fragmentShader = /* glsl */ `
  uniform sampler2D values;
  uniform float isDistance;
  uniform vec3 paper;
  uniform vec3 inside;
  uniform vec3 beyond;
  uniform vec3 below;
  uniform vec3 ink;
  varying vec2 vAt;
  // Where a value passes through a level: a line of about two pixels.
  float lineAt(float value, float level) {
    float slope = max(fwidth(value), 1e-6);
    return 1.0 - smoothstep(0.5, 1.5, abs(value - level) / slope);
  }
  vec3 windingColour(float winding) {
    vec3 colour = mix(paper, inside, clamp(winding, 0.0, 1.0));
    colour = mix(colour, beyond, clamp(winding - 1.0, 0.0, 1.0));
    return mix(colour, below, clamp(-winding, 0.0, 1.0));
  }
  // In steps, at each of which there is a line.
  vec3 distanceColour(float level) {
    float share = clamp(abs(level) / 8.0, 0.0, 1.0);
    vec3 colour = level < 0.0 ? mix(inside, ink, 0.45 * share) : mix(mix(beyond, paper, 0.45), paper, share);
    float slope = max(fwidth(level), 1e-6);
    float contour = 1.0 - smoothstep(0.3, 1.1, abs(fract(level + 0.5) - 0.5) / slope);
    return mix(colour, ink, 0.22 * contour * (1.0 - smoothstep(0.25, 0.6, slope)));
  }
  void main() {
    float value = texture2D(values, vAt).r;
    vec3 colour = isDistance > 0.5 ? distanceColour(value) : windingColour(value);
    float border = lineAt(value, isDistance > 0.5 ? 0.0 : 0.5);
    float opacity = isDistance > 0.5 ? 0.94 : mix(0.55, 0.96, clamp(abs(value), 0.0, 1.0));
    gl_FragColor = vec4(mix(colour, ink, 0.85 * border), max(opacity, border));
    #include <colorspace_fragment>
  }
`;

export class SliceDrawing {
  readonly object: THREE.Mesh<THREE.BufferGeometry, THREE.ShaderMaterial>;
  #texture: THREE.DataTexture | undefined;

  constructor(stage: Stage) {
    const names = ["paper", "inside", "beyond", "below", "ink"] as const;
    const colours = Object.fromEntries(names.map((name) => [name, { value: new THREE.Color() }]));
    const uniforms = { values: { value: null }, isDistance: { value: 0 }, ...colours };
    const material = new THREE.ShaderMaterial({ uniforms, vertexShader, fragmentShader, transparent: true, side: THREE.DoubleSide });
    this.object = new THREE.Mesh(new THREE.BufferGeometry(), material);
    this.object.frustumCulled = false;
    this.object.renderOrder = 1;
    this.#setPalette(stage.palette);
    stage.onTheme(() => this.#setPalette(stage.palette));
  }

  place({ size, origin, right, up }: SliceGrid, quantity: Quantity): void {
    // The cells around the centers.
    const corner = (column: number, row: number): number[] => origin.map((value, axis) => value + (column - 0.5) * (right[axis] ?? 0) + (row - 0.5) * (up[axis] ?? 0));
    const { geometry } = this.object;
    const corners = [corner(0, 0), corner(size, 0), corner(size, size), corner(0, size)];
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(corners.flat(), 3));
    geometry.setAttribute("uv", new THREE.Float32BufferAttribute([0, 0, 1, 0, 1, 1, 0, 1], 2));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    this.#set("isDistance", quantity === "distance" ? 1 : 0);
  }

  /** Shows values divided by a unit, which for distances is that between two lines. Half floats, because the graphics
   * card interpolates between them. */
  show(values: Float32Array, size: number, unit: number): void {
    if (this.#texture?.image.width !== size) {
      this.#texture?.dispose();
      this.#texture = new THREE.DataTexture(new Uint16Array(size * size), size, size, THREE.RedFormat, THREE.HalfFloatType);
      this.#texture.magFilter = this.#texture.minFilter = THREE.LinearFilter;
      this.#set("values", this.#texture);
    }
    const { data } = this.#texture.image;
    values.forEach((value, i) => ((data as Uint16Array)[i] = THREE.DataUtils.toHalfFloat(Math.min(65504, Math.max(-65504, value / unit)))));
    this.#texture.needsUpdate = true;
  }

  close(): void {
    this.#texture?.dispose();
  }

  #setPalette(palette: Palette): void {
    const colours = { paper: palette.ground, inside: palette["free-fill"], beyond: palette["overlapping-fill"], below: palette.third, ink: palette.ink };
    for (const [name, colour] of Object.entries(colours)) (this.object.material.uniforms[name]?.value as THREE.Color).set(colour);
  }

  #set(name: string, value: unknown): void {
    const uniform = this.object.material.uniforms[name];
    if (uniform !== undefined) uniform.value = value;
  }
}
