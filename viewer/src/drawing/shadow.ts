// SPDX-License-Identifier: MIT
// Shadow mapping in 3D: a depth map of the scene as seen from a distant lamp, by which each point of a surface
// determines whether it is in shadow. Rendered again only if the scene has changed, not if the view has.
import * as THREE from "three";

import type { Extent } from "../stage";

/** Objects on this layer cast shadows. */
const castingLayer = 1;
const mapSize = 1024;
/** With more triangles, rendering shadows would take too long. */
const mostTriangles = 400_000;
const toLamp = new THREE.Vector3(-0.35, -0.55, 0.75).normalize();

/** Shared by all materials: there is one lamp. */
export const shadowUniforms = {
  shadowMap: { value: null as THREE.Texture | null },
  shadowMatrix: { value: new THREE.Matrix4() },
  shadowTexel: { value: 0 },
  hasShadows: { value: 0 },
  isShadowPass: { value: 0 },
  toLamp: { value: toLamp },
};

/** For fragment shaders: the fraction of the lamp's light that reaches a point, soft at the edges of shadows. */
export const shadowShader = /* glsl */ `
  uniform sampler2D shadowMap;
  uniform mat4 shadowMatrix;
  uniform float shadowTexel;
  uniform float hasShadows;
  uniform vec3 toLamp;
  float lampReaching(vec3 place, vec3 normal) {
    if (hasShadows < 0.5) return 1.0;
    vec3 at = (shadowMatrix * vec4(place + 2.5 * shadowTexel * normal, 1.0)).xyz;
    if (any(lessThan(at, vec3(0.0))) || any(greaterThan(at, vec3(1.0)))) return 1.0;
    float reaching = 0.0;
    for (int x = -1; x <= 1; ++x) {
      for (int y = -1; y <= 1; ++y) {
        vec2 beside = at.xy + vec2(float(x), float(y)) * (2.0 / ${mapSize}.0);
        vec2 grid = beside * ${mapSize}.0 - 0.5;
        vec2 share = fract(grid);
        vec2 corner = (floor(grid) + 0.5) / ${mapSize}.0;
        vec4 four = vec4(
          texture2D(shadowMap, corner).r, texture2D(shadowMap, corner + vec2(1.0, 0.0) / ${mapSize}.0).r,
          texture2D(shadowMap, corner + vec2(0.0, 1.0) / ${mapSize}.0).r, texture2D(shadowMap, corner + vec2(1.0) / ${mapSize}.0).r);
        vec4 free = step(vec4(at.z - 0.0008), four);
        reaching += mix(mix(free.x, free.y, share.x), mix(free.z, free.w, share.x), share.y);
      }
    }
    return reaching / 9.0;
  }
`;

/** Makes the object cast a shadow, unless too many triangles do. */
export function castsShadow(object: THREE.Object3D): void {
  object.layers.enable(castingLayer);
}

export class Shadow {
  readonly #camera = new THREE.OrthographicCamera();
  readonly #target: THREE.WebGLRenderTarget;

  constructor() {
    const depthTexture = new THREE.DepthTexture(mapSize, mapSize, THREE.UnsignedIntType);
    this.#target = new THREE.WebGLRenderTarget(mapSize, mapSize, { depthTexture });
    this.#camera.layers.set(castingLayer);
    this.#camera.up.set(0, 0, 1);
  }

  /** Renders the depth map of what lies in the extent. */
  cast(renderer: THREE.WebGLRenderer, scene: THREE.Scene, extent: Extent): void {
    const count = trianglesOf(scene);
    shadowUniforms.hasShadows.value = 0;
    if (count === 0 || count > mostTriangles) return;
    this.#aim(extent);
    // A material must not sample the render target that it is drawn to.
    shadowUniforms.shadowMap.value = null;
    shadowUniforms.isShadowPass.value = 1;
    renderer.setRenderTarget(this.#target);
    renderer.render(scene, this.#camera);
    renderer.setRenderTarget(null);
    shadowUniforms.isShadowPass.value = 0;
    shadowUniforms.shadowMap.value = this.#target.depthTexture;
    shadowUniforms.hasShadows.value = 1;
  }

  #aim({ min, max }: Extent): void {
    const low = new THREE.Vector3().fromArray([...min]);
    const high = new THREE.Vector3().fromArray([...max]);
    const center = low.clone().add(high).multiplyScalar(0.5);
    const radius = high.sub(low).length() / 2 || 1;
    const camera = this.#camera;
    Object.assign(camera, { left: -radius, right: radius, top: radius, bottom: -radius, near: 0, far: 2 * radius });
    camera.position.copy(center).addScaledVector(toLamp, radius);
    camera.lookAt(center);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    const toUnit = new THREE.Matrix4().makeTranslation(0.5, 0.5, 0.5).scale(new THREE.Vector3(0.5, 0.5, 0.5));
    shadowUniforms.shadowMatrix.value.copy(toUnit).multiply(camera.projectionMatrix).multiply(camera.matrixWorldInverse);
    shadowUniforms.shadowTexel.value = (2 * radius) / mapSize;
  }
}

function trianglesOf(scene: THREE.Scene): number {
  const casting = new THREE.Layers();
  casting.set(castingLayer);
  let count = 0;
  scene.traverse((object) => {
    if (!(object instanceof THREE.Mesh) || !object.visible || !object.layers.test(casting)) return;
    const geometry = object.geometry as THREE.BufferGeometry;
    const corners = geometry.index?.count ?? geometry.getAttribute("position")?.count ?? 0;
    const copies = geometry instanceof THREE.InstancedBufferGeometry ? geometry.instanceCount : 1;
    count += (corners / 3) * copies;
  });
  return count;
}
