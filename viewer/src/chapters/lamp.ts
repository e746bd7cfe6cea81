// SPDX-License-Identifier: MIT
// A lamp that casts rays in all directions: in 2D the area that they reach is lit, in 3D their end points.
import * as THREE from "three";

import { heading } from "../shapes/flat_shape";
import type { Stage } from "../stage";
import { lengthOf, minus, plus, times } from "../vectors";

/** The size of a lit point in 3D, in pixels. */
const dotSize = 5;
/** The offset of a lit point from its surface, so that it is not clipped, as a fraction of the size of the picture. */
const lift = 0.004;
const goldenAngle = 360 * (2 - (1 + Math.sqrt(5)) / 2);

/** Unit vectors, evenly distributed. In 3D they follow a spiral from top to bottom with golden-angle steps. */
export function directionsAllRound(dimension: 2 | 3, count: number): (readonly number[])[] {
  return Array.from({ length: count }, (_, i) => {
    if (dimension === 2) return heading((360 * i) / count);
    const height = 1 - (2 * i + 1) / count;
    const [x, y] = heading((goldenAngle * i) % 360);
    const radius = Math.sqrt(1 - height * height);
    return [x * radius, y * radius, height];
  });
}

export class Lamp {
  readonly #stage: Stage;
  readonly #area = new THREE.Mesh(
    new THREE.BufferGeometry(),
    new THREE.MeshBasicMaterial({ transparent: true, opacity: 0.2, depthTest: false, side: THREE.DoubleSide }),
  );
  readonly #dots = new THREE.Points(new THREE.BufferGeometry(), new THREE.PointsMaterial({ size: dotSize, sizeAttenuation: false }));

  constructor(stage: Stage) {
    this.#stage = stage;
    this.#area.frustumCulled = false;
    this.#dots.frustumCulled = false;
    this.#dots.material.size = dotSize * Math.min(window.devicePixelRatio, 2);
    stage.world.add(this.#area, this.#dots);
    const colour = (): void => [this.#area, this.#dots].forEach((part) => part.material.color.set(stage.palette.answer));
    stage.onTheme(colour);
    colour();
  }

  hide(): void {
    this.#area.visible = false;
    this.#dots.visible = false;
  }

  /** The 2D area between the lamp and the ends of its rays, which are in angular order. */
  lightArea(lamp: readonly number[], rim: readonly (readonly number[])[]): void {
    this.#set(this.#area, rim.flatMap((point, i) => [...lamp, 0, ...point, 0, ...(rim[(i + 1) % rim.length] ?? point), 0]));
  }

  /** The 3D points where rays end. */
  lightPoints(hits: readonly { readonly point: readonly number[]; readonly normal: readonly number[] }[]): void {
    const { min, max } = this.#stage.extent;
    const height = lift * lengthOf(minus(max, min));
    this.#set(this.#dots, hits.flatMap(({ point, normal }) => plus(point, times(normal, height))));
  }

  #set(shown: THREE.Mesh | THREE.Points, positions: readonly number[]): void {
    shown.geometry.dispose();
    shown.geometry = new THREE.BufferGeometry().setAttribute("position", new THREE.Float32BufferAttribute(positions, 3));
    shown.visible = positions.length > 0;
    this.#stage.invalidate();
  }
}
