// SPDX-License-Identifier: MIT
// How things are coloured. A paint is a small number that goes to the graphics card with each object; what it looks like is
// decided there, from the palette, so that lighting up an object or switching to dark moves no geometry.
import * as THREE from "three";

import type { Palette } from "../theme";

export const Paint = { free: 0, touching: 1, found: 2, faint: 3, hidden: 4, ground: 5, touchingGround: 6 } as const;
export type Paint = (typeof Paint)[keyof typeof Paint];

export type PaintUniforms = Record<string, THREE.IUniform>;

/** What goes on beyond the picture is painted paler, or it would outshine the rest. */
export function paintOf(type: string, paint: Paint): Paint {
  if (type !== "half_space") return paint;
  return paint === Paint.free ? Paint.ground : paint === Paint.touching ? Paint.touchingGround : paint;
}

/** The uniforms that every material of ours shares. */
export function paintUniforms(palette: Palette): PaintUniforms {
  const uniforms: PaintUniforms = { fills: { value: [] }, strokes: { value: [] }, paper: { value: null } };
  setPalette(uniforms, palette);
  return uniforms;
}

/** In the order of Paint. */
export function setPalette(uniforms: PaintUniforms, palette: Palette): void {
  const colours = (names: readonly (keyof Palette)[]): THREE.Color[] => names.map((name) => new THREE.Color(palette[name]));
  const { fills, strokes, paper } = uniforms;
  if (paper !== undefined) paper.value = new THREE.Color(palette.ground);
  if (fills !== undefined) fills.value = colours(["free-fill", "touching-fill", "answer", "faint"]);
  if (strokes !== undefined) strokes.value = colours(["free-line", "touching-line", "answer", "faint"]);
}

/** Chosen by comparison: not every graphics card indexes arrays of uniforms by a computed number. */
export const paintShader = /* glsl */ `
  uniform vec3 fills[4];
  uniform vec3 strokes[4];
  uniform vec3 paper;
  vec3 fillOf(float paint) {
    if (paint > 4.5) return mix(paint > 5.5 ? fills[1] : fills[0], paper, 0.68);
    return paint < 0.5 ? fills[0] : paint < 1.5 ? fills[1] : paint < 2.5 ? fills[2] : fills[3];
  }
  vec3 strokeOf(float paint) {
    if (paint > 4.5) return paint > 5.5 ? strokes[1] : strokes[0];
    return paint < 0.5 ? strokes[0] : paint < 1.5 ? strokes[1] : paint < 2.5 ? strokes[2] : strokes[3];
  }
  // Slanted lines, fixed to the screen: what touches is seen without colour as well.
  float hatch(float paint) {
    float across = mod(gl_FragCoord.x + gl_FragCoord.y, 10.0);
    if (across > 2.5) return 0.0;
    return abs(paint - 1.0) < 0.5 ? 1.0 : paint > 5.5 ? 0.4 : 0.0;
  }
  float lightOn(vec3 normal) {
    return 0.66 + 0.22 * dot(normal, normalize(vec3(-0.35, -0.55, 0.75))) + 0.14 * max(normal.z, 0.0);
  }
`;
