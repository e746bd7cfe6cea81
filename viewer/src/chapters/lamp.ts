// SPDX-License-Identifier: MIT
// A lamp that sends rays all round: in the plane what they reach is lit, in space the points where they end.
import * as THREE from "three";

import { heading } from "../shapes/flat_shape";
import type { Stage } from "../stage";
import { lengthOf, minus, plus, times } from "../vectors";

/** How large a point that is lit in space is drawn, in pixels. */
const dotSize = 5;
/** How far before its surface, so that it is seen whole, in parts of the size of the picture. */
const lift = 0.004;
const goldenAngle = 360 * (2 - (1 + Math.sqrt(5)) / 2);

/** So many directions of length 1, evenly all round. In space they wind from the top to the bottom by golden angles. */
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

  /** The part of the plane between the lamp and where its rays end, which are in order. */
  lightArea(lamp: readonly number[], rim: readonly (readonly number[])[]): void {
    this.#set(this.#area, rim.flatMap((point, i) => [...lamp, 0, ...point, 0, ...(rim[(i + 1) % rim.length] ?? point), 0]));
  }

  /** The points of space where rays end. */
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
