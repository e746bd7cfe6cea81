// SPDX-License-Identifier: MIT
// The grid behind the shapes. In 2D it fills the view, and its step follows the zoom: 1, 2 or 5 times a power of ten.
// In 3D it lies on the floor, which receives shadows.
import * as THREE from "three";

import type { Extent, Stage } from "../stage";
import { isDark } from "../theme";
import { shadowShader, shadowUniforms } from "./shadow";

/** The approximate number of pixels between two grid lines in 2D. */
const pixelsBetweenLines = 60;

export class Grid {
  readonly #stage: Stage;
  readonly #lines = new THREE.LineSegments(
    new THREE.BufferGeometry(),
    new THREE.LineBasicMaterial({ vertexColors: true, depthWrite: false }),
  );

  /** Drawn behind everything in the stage's world, until the stage is cleared. */
  constructor(stage: Stage, floor?: Extent) {
    this.#stage = stage;
    this.#lines.frustumCulled = false;
    this.#lines.renderOrder = -1;
    stage.world.add(this.#lines);
    if (floor !== undefined) stage.world.add(shadedFloor(stage, floor));
    const draw = (): void => (floor === undefined ? this.#drawPlane() : this.#drawFloor(floor));
    if (floor === undefined) stage.onView(draw);
    stage.onTheme(draw);
    draw();
  }

  #drawPlane(): void {
    const seen = this.#stage.seenPlane();
    const step = niceStep(pixelsBetweenLines / this.#stage.pixelsPerUnit);
    this.#draw(seen, step, 0);
  }

  #drawFloor(floor: Extent): void {
    const width = Math.max((floor.max[0] ?? 0) - (floor.min[0] ?? 0), (floor.max[1] ?? 0) - (floor.min[1] ?? 0));
    this.#draw(floor, niceStep(width / 14 || 1), floor.min[2] ?? 0);
  }

  #draw(extent: Extent, step: number, height: number): void {
    const positions: number[] = [];
    const colours: number[] = [];
    const grid = new THREE.Color(this.#stage.palette.grid).toArray();
    const axis = new THREE.Color(this.#stage.palette.axis).toArray();
    for (const across of [0, 1]) {
      const along = 1 - across;
      const [low, high] = [extent.min[along] ?? 0, extent.max[along] ?? 0];
      const last = Math.floor((extent.max[across] ?? 0) / step);
      for (let i = Math.ceil((extent.min[across] ?? 0) / step); i <= last; ++i) {
        for (const end of [low, high]) positions.push(...(across === 0 ? [i * step, end] : [end, i * step]), height);
        colours.push(...(i === 0 ? axis : grid), ...(i === 0 ? axis : grid));
      }
    }
    this.#lines.geometry.dispose();
    this.#lines.geometry = new THREE.BufferGeometry();
    this.#lines.geometry.setAttribute("position", new THREE.Float32BufferAttribute(positions, 3));
    this.#lines.geometry.setAttribute("color", new THREE.Float32BufferAttribute(colours, 3));
    this.#stage.invalidate();
  }
}

/** The shadows on the floor. They are darker on a dark background, where they would otherwise be hard to see. */
function shadedFloor(stage: Stage, { min, max }: Extent): THREE.Mesh {
  const [minX = 0, minY = 0, minZ = 0] = min;
  const [maxX = 0, maxY = 0] = max;
  const geometry = new THREE.PlaneGeometry(maxX - minX, maxY - minY);
  geometry.translate((minX + maxX) / 2, (minY + maxY) / 2, minZ);
  const depth = { value: 0 };
  const setDepth = (): void => void (depth.value = isDark(stage.palette) ? 0.5 : 0.2);
  setDepth();
  stage.onTheme(setDepth);
  const material = new THREE.ShaderMaterial({
    uniforms: { ...shadowUniforms, depth },
    vertexShader: "varying vec3 vPlace; void main() { vPlace = position; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }",
    fragmentShader: `${shadowShader}
      uniform float depth;
      varying vec3 vPlace;
      void main() { gl_FragColor = vec4(0.0, 0.0, 0.0, depth * (1.0 - lampReaching(vPlace, vec3(0.0, 0.0, 1.0)))); }`,
    transparent: true,
    depthWrite: false,
    polygonOffset: true,
    polygonOffsetFactor: 2,
    polygonOffsetUnits: 2,
  });
  const mesh = new THREE.Mesh(geometry, material);
  mesh.renderOrder = -1;
  return mesh;
}

/** The smallest of 1, 2, 5, 10, ... (and decimal fractions) that is at least the step. */
function niceStep(step: number): number {
  const power = 10 ** Math.floor(Math.log10(step));
  return power * ([1, 2, 5].find((factor) => factor * power >= step) ?? 10);
}
