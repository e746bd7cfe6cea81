// SPDX-License-Identifier: MIT
// Colours. A paint is a small number passed to the GPU with each object; shaders look up its appearance in the palette,
// so that highlighting an object or switching to dark mode changes no geometry.
import * as THREE from "three";

import type { Relation } from "graze";
import { isDark, type Palette } from "../theme";
import { shadowShader, shadowUniforms } from "./shadow";

export const Paint = {
  free: 0, touching: 1, overlapping: 2, found: 3, faint: 4, hidden: 5, ground: 6, touchingGround: 7, overlappingGround: 8,
} as const;
export type Paint = (typeof Paint)[keyof typeof Paint];

export type PaintUniforms = Record<string, THREE.IUniform>;

/** The paint of a shape by the relation of its closest pair. */
export const paintOfRelation: Readonly<Record<Relation, Paint>> = {
  apart: Paint.free, touching: Paint.touching, overlapping: Paint.overlapping,
};

/** For half-spaces, which extend beyond the picture and would dominate it. */
const paler: Readonly<Partial<Record<Paint, Paint>>> = {
  [Paint.free]: Paint.ground, [Paint.touching]: Paint.touchingGround, [Paint.overlapping]: Paint.overlappingGround,
};

export function paintOf(type: string, paint: Paint): Paint {
  return type === "half_space" ? (paler[paint] ?? paint) : paint;
}

/** The uniforms that all our materials share. */
export function paintUniforms(palette: Palette): PaintUniforms {
  const uniforms: PaintUniforms = { fills: { value: [] }, strokes: { value: [] }, paper: { value: null }, paperShare: { value: 0 }, ...shadowUniforms };
  setPalette(uniforms, palette);
  return uniforms;
}

/** In the order of Paint. */
export function setPalette(uniforms: PaintUniforms, palette: Palette): void {
  const colours = (names: readonly (keyof Palette)[]): THREE.Color[] => names.map((name) => new THREE.Color(palette[name]));
  const { fills, strokes, paper, paperShare } = uniforms;
  if (paperShare !== undefined) paperShare.value = isDark(palette) ? 0.88 : 0.68;
  if (paper !== undefined) paper.value = new THREE.Color(palette.ground);
  if (fills !== undefined) fills.value = colours(["free-fill", "touching-fill", "overlapping-fill", "answer", "faint"]);
  if (strokes !== undefined) strokes.value = colours(["free-line", "touching-line", "overlapping-line", "answer", "faint"]);
}

/** The colours of shapes' lines, in the order of Paint. */
export function strokeColours(palette: Palette): number[][] {
  const own = ["free-line", "touching-line", "overlapping-line", "answer", "faint", "ground"] as const;
  const grounds = ["free-line", "touching-line", "overlapping-line"] as const;
  return [...own, ...grounds].map((name) => new THREE.Color(palette[name]).toArray());
}

/** For vertex shaders: moves hidden objects outside the clip volume. Half-spaces cast no shadow, which would cover
 * everything. */
export const placeShader = /* glsl */ `
  uniform float isShadowPass;
  vec4 seenPlace(vec3 place, float paint) {
    bool isGone = abs(paint - ${Paint.hidden}.0) < 0.5 || (isShadowPass > 0.5 && paint > ${Paint.hidden}.5);
    return isGone ? vec4(2.0, 2.0, 2.0, 1.0) : projectionMatrix * modelViewMatrix * vec4(place, 1.0);
  }
`;

/** Chosen by comparison, because not every GPU supports dynamic indexing of uniform arrays. */
export const paintShader = /* glsl */ `
  uniform vec3 fills[5];
  uniform vec3 strokes[5];
  uniform vec3 paper;
  uniform float paperShare;
  bool isGround(float paint) { return paint > ${Paint.hidden}.5; }
  float ownPaint(float paint) { return isGround(paint) ? paint - ${Paint.ground}.0 : paint; }
  vec3 fillOf(float paint) {
    float own = ownPaint(paint);
    vec3 fill = own < 0.5 ? fills[0] : own < 1.5 ? fills[1] : own < 2.5 ? fills[2] : own < 3.5 ? fills[3] : fills[4];
    return isGround(paint) ? mix(fill, paper, paperShare) : fill;
  }
  vec3 strokeOf(float paint) {
    float own = ownPaint(paint);
    return own < 0.5 ? strokes[0] : own < 1.5 ? strokes[1] : own < 2.5 ? strokes[2] : own < 3.5 ? strokes[3] : strokes[4];
  }
  // Hatching on overlapping and dots on touching objects, fixed to the screen: also visible without colour.
  float pattern(float paint) {
    float own = ownPaint(paint);
    float strength = isGround(paint) ? 0.6 * (1.0 - paperShare) + 0.15 : 1.0;
    if (abs(own - 2.0) < 0.5) return mod(gl_FragCoord.x + gl_FragCoord.y, 10.0) > 2.5 ? 0.0 : strength;
    if (abs(own - 1.0) > 0.5) return 0.0;
    vec2 cell = mod(vec2(gl_FragCoord.x + gl_FragCoord.y, gl_FragCoord.x - gl_FragCoord.y), 9.0) - 4.5;
    return 0.8 * strength * (1.0 - smoothstep(1.3, 2.1, length(cell)));
  }
  ${shadowShader}
  // A sky that is brighter at the top, and a lamp whose light may be occluded.
  vec3 lit(vec3 colour, vec3 place, vec3 normal) {
    float sky = mix(0.5, 0.7, 0.5 + 0.5 * normal.z);
    float lamp = max(dot(normal, toLamp), 0.0);
    return colour * (sky + 0.36 * lamp * lampReaching(place, normal));
  }
`;
