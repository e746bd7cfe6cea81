// SPDX-License-Identifier: MIT
// The drawing area: one canvas with a 2D view (orthographic, y up) and a 3D view (perspective, z up).
import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

import { Shadow } from "./drawing/shadow";
import type { Palette, Theme } from "./theme";

export type Point2 = readonly [number, number];

/** The minimum height of the 3D camera above the floor: an elevation angle in radians, and a fraction of the height of
 * the scene. */
const leastAngle = 0.04;
const leastHeight = 0.12;

/** What a view shows initially and after "fit": a box in 2D or 3D. */
export interface Extent {
  readonly min: readonly number[];
  readonly max: readonly number[];
}

export class Stage {
  readonly canvas: HTMLCanvasElement;
  /** The objects that a chapter draws; cleared when the next one opens. */
  readonly world = new THREE.Group();
  /** Called whenever the view has moved, independent of the chapter, to update the overlay. */
  afterView: (() => void) | undefined;

  readonly #renderer: THREE.WebGLRenderer;
  readonly #scene = new THREE.Scene();
  readonly #flat = new THREE.OrthographicCamera(-1, 1, 1, -1, -1000, 1000);
  readonly #deep = new THREE.PerspectiveCamera(38, 1, 0.1, 1000);
  readonly #theme: Theme;
  readonly #shadow = new Shadow();
  #controls: OrbitControls;
  #isFlat = true;
  #extent: Extent = { min: [-1, -1], max: [1, 1] };
  #yDown = false;
  #queued = false;
  /** Whether the scene has changed since its shadows were rendered. */
  #isChanged = true;
  #onFrame: ((now: number) => boolean) | undefined;
  #onView: (() => void)[] = [];
  #onTheme: (() => void)[] = [];

  constructor(canvas: HTMLCanvasElement, theme: Theme) {
    this.canvas = canvas;
    this.#theme = theme;
    this.#renderer = new THREE.WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: false });
    this.#renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.#renderer.localClippingEnabled = true;
    this.#scene.add(this.world);
    this.#deep.up.set(0, 0, 1);
    this.#controls = this.#controlsFor(this.#flat);
    theme.onChange(() => {
      for (const listener of this.#onTheme) listener();
      this.invalidate();
    });
    new ResizeObserver(() => this.#resize()).observe(canvas.parentElement ?? canvas);
    this.#resize();
  }

  get palette(): Palette {
    return this.#theme.palette;
  }

  get isFlat(): boolean {
    return this.#isFlat;
  }

  get isYDown(): boolean {
    return this.#isFlat && this.#yDown;
  }

  get extent(): Extent {
    return this.#extent;
  }

  /** Unbounded shapes are drawn only inside this box. */
  isInExtent(point: readonly number[]): boolean {
    const { min, max } = this.#extent;
    const slack = 1e-6 * Math.max(...max.map((high, axis) => high - (min[axis] ?? 0)));
    return point.every((value, axis) => value >= (min[axis] ?? value) - slack && value <= (max[axis] ?? value) + slack);
  }

  /** Removes everything that the last chapter drew, and its listeners. */
  clear(): void {
    this.clearDrawing();
    this.#onFrame = undefined;
    this.canvas.style.cursor = "";
  }

  /** Removes what was drawn, and the listeners to view and theme that belong to it. */
  clearDrawing(): void {
    this.world.traverse((object) => {
      if (object instanceof THREE.Mesh || object instanceof THREE.Line || object instanceof THREE.Points) {
        object.geometry.dispose();
        for (const material of [object.material].flat()) material.dispose();
      }
    });
    this.world.clear();
    this.#onView = [];
    this.#onTheme = [];
  }

  /** Shows a 2D world. */
  showFlat(extent: Extent, yDown = false): void {
    this.#isFlat = true;
    this.#yDown = yDown;
    this.#extent = extent;
    this.#replaceControls(this.#flat);
    this.fit();
  }

  /** Shows a 3D world from a corner; z is up, and the lower end of the extent is the floor. */
  showDeep(extent: Extent): void {
    this.#isFlat = false;
    this.#extent = extent;
    this.#replaceControls(this.#deep);
    this.fit();
  }

  /** Shows the whole extent, or another one. */
  fit(extent: Extent = this.#extent): void {
    const [minX = 0, minY = 0, minZ = 0] = extent.min;
    const [maxX = 0, maxY = 0, maxZ = 0] = extent.max;
    const center = new THREE.Vector3((minX + maxX) / 2, (minY + maxY) / 2, this.#isFlat ? 0 : (minZ + maxZ) / 2);
    const size = new THREE.Vector3(maxX - minX, maxY - minY, this.#isFlat ? 0 : maxZ - minZ);
    if (this.#isFlat) this.#fitFlat(center, size);
    else this.#fitDeep(center, size);
    this.#controls.target.copy(center);
    this.#controls.update();
    this.#viewChanged();
  }

  /** Pixels per unit in 2D. */
  get pixelsPerUnit(): number {
    return (this.#flat.zoom * this.#height) / (this.#flat.top - this.#flat.bottom);
  }

  /** The 2D point under the pointer. */
  planePoint(event: { clientX: number; clientY: number }): Point2 {
    const point = this.#normalised(event).unproject(this.#flat);
    return [point.x, point.y];
  }

  /** The 3D line of sight under the pointer. */
  sightLine(event: { clientX: number; clientY: number }): { origin: THREE.Vector3; direction: THREE.Vector3 } {
    const caster = new THREE.Raycaster();
    const point = this.#normalised(event);
    caster.setFromCamera(new THREE.Vector2(point.x, point.y), this.#deep);
    return caster.ray;
  }

  /** The point under the pointer at the same distance as another point: in 3D on the plane through it that faces the
   * camera or, if `level`, on the horizontal one. If that plane is seen edge-on, the other point itself. */
  pointAt(event: { clientX: number; clientY: number }, through: readonly number[], level = false): number[] {
    if (this.#isFlat) return [...this.planePoint(event)];
    const place = new THREE.Vector3(through[0], through[1], through[2] ?? 0);
    const normal = level ? new THREE.Vector3(0, 0, 1) : this.#deep.getWorldDirection(new THREE.Vector3());
    const plane = new THREE.Plane().setFromNormalAndCoplanarPoint(normal, place);
    const { origin, direction } = this.sightLine(event);
    return (new THREE.Ray(origin, direction).intersectPlane(plane, new THREE.Vector3()) ?? place).toArray();
  }

  /** The same for a position in pixels of the stage. */
  pointAtPixels([x, y]: Point2, through: readonly number[], level = false): number[] {
    const { left, top } = this.canvas.getBoundingClientRect();
    return this.pointAt({ clientX: left + x, clientY: top + y }, through, level);
  }

  /** The screen position of a point, in pixels of the stage. */
  toPixels(point: readonly number[]): Point2 {
    const seen = new THREE.Vector3(point[0], point[1], point[2] ?? 0).project(this.#camera);
    return [((seen.x + 1) / 2) * this.#width, ((1 - seen.y) / 2) * this.#height];
  }

  /** The place of the 3D camera. */
  get eye(): number[] {
    return this.#deep.position.toArray();
  }

  /** The direction of view, of length 1. */
  get sight(): number[] {
    return this.#camera.getWorldDirection(new THREE.Vector3()).toArray();
  }

  /** The size of a pixel at a point, in world units. */
  lengthOfPixel(at: readonly number[]): number {
    if (this.#isFlat) return 1 / this.pixelsPerUnit;
    const height = 2 * Math.tan(THREE.MathUtils.degToRad(this.#deep.fov / 2)) * (this.#depthOf(at) + this.#deep.near);
    return Math.max(height, 0) / this.#height;
  }

  isBeforeEye(point: readonly number[]): boolean {
    return this.#isFlat || this.#depthOf(point) > 0;
  }

  /** The part of a line in front of the camera; undefined if there is none. */
  partBeforeEye(a: readonly number[], b: readonly number[]): [readonly number[], readonly number[]] | undefined {
    if (this.#isFlat) return [a, b];
    const [depthA, depthB] = [this.#depthOf(a), this.#depthOf(b)];
    if (depthA <= 0 && depthB <= 0) return undefined;
    if (depthA > 0 && depthB > 0) return [a, b];
    const share = depthA / (depthA - depthB);
    const cut = a.map((value, axis) => value + ((b[axis] ?? 0) - value) * share);
    return depthA > 0 ? [a, cut] : [cut, b];
  }

  /** The visible part of a 2D world. */
  seenPlane(): Extent {
    const a = new THREE.Vector3(-1, -1, 0).unproject(this.#flat);
    const b = new THREE.Vector3(1, 1, 0).unproject(this.#flat);
    return { min: [Math.min(a.x, b.x), Math.min(a.y, b.y)], max: [Math.max(a.x, b.x), Math.max(a.y, b.y)] };
  }

  /** Whether dragging moves the view; off while a shape is dragged. */
  set movesView(moves: boolean) {
    this.#controls.enabled = moves;
  }

  zoomBy(factor: number): void {
    if (this.#isFlat) {
      this.#flat.zoom *= factor;
      this.#flat.updateProjectionMatrix();
    } else {
      const target = this.#controls.target;
      this.#deep.position.sub(target).divideScalar(factor).add(target);
    }
    this.#controls.update();
    this.#viewChanged();
  }

  /** Rotates a 3D view or pans a 2D view. Steps are tenths of the view. */
  nudge(right: number, up: number): void {
    const offset = this.#camera.position.clone().sub(this.#controls.target);
    if (this.#isFlat) {
      const step = (this.#flat.top - this.#flat.bottom) / this.#flat.zoom / 10;
      const move = new THREE.Vector3(right * step, (this.#yDown ? -up : up) * step, 0);
      this.#controls.target.add(move);
      this.#flat.position.add(move);
    } else {
      const turned = new THREE.Spherical().setFromVector3(new THREE.Vector3(offset.x, offset.z, -offset.y));
      turned.theta += right * 0.15;
      turned.phi = Math.min(Math.PI / 2 - leastAngle, Math.max(0.05, turned.phi - up * 0.15));
      const back = new THREE.Vector3().setFromSpherical(turned);
      this.#deep.position.copy(this.#controls.target).add(new THREE.Vector3(back.x, -back.z, back.y));
    }
    this.#controls.update();
    this.#viewChanged();
  }

  /** Called before each frame of an animation; returns whether it continues. */
  animate(frame: (now: number) => boolean): void {
    this.#onFrame = frame;
    this.invalidate();
  }

  /** Called when the view or the size of the canvas has changed. */
  onView(listener: () => void): void {
    this.#onView.push(listener);
  }

  onTheme(listener: () => void): void {
    this.#onTheme.push(listener);
  }

  /** Requests one redraw because the scene has changed. */
  invalidate(): void {
    this.#isChanged = true;
    this.#drawSoon();
  }

  #drawSoon(): void {
    if (this.#queued) return;
    this.#queued = true;
    requestAnimationFrame((now) => {
      this.#queued = false;
      const goesOn = this.#onFrame?.(now) ?? false;
      this.#scene.background = new THREE.Color(this.palette.ground);
      if (this.#isChanged && !this.#isFlat) this.#shadow.cast(this.#renderer, this.#scene, this.#extent);
      this.#isChanged = false;
      this.#renderer.render(this.#scene, this.#camera);
      if (goesOn) this.#drawSoon();
    });
  }

  get #camera(): THREE.OrthographicCamera | THREE.PerspectiveCamera {
    return this.#isFlat ? this.#flat : this.#deep;
  }

  /** The distance of a 3D point beyond the near plane. */
  #depthOf([x = 0, y = 0, z = 0]: readonly number[]): number {
    const sight = this.#deep.getWorldDirection(new THREE.Vector3());
    return new THREE.Vector3(x, y, z).sub(this.#deep.position).dot(sight) - this.#deep.near;
  }

  get #width(): number {
    return Math.max(1, this.canvas.clientWidth);
  }

  get #height(): number {
    return Math.max(1, this.canvas.clientHeight);
  }

  #normalised(event: { clientX: number; clientY: number }): THREE.Vector3 {
    const place = this.canvas.getBoundingClientRect();
    const x = ((event.clientX - place.left) / place.width) * 2 - 1;
    return new THREE.Vector3(x, 1 - ((event.clientY - place.top) / place.height) * 2, 0);
  }

  #fitFlat(center: THREE.Vector3, size: THREE.Vector3): void {
    const margin = 1.08;
    const aspect = this.#width / this.#height;
    const half = (Math.max(size.y, size.x / aspect, Number.MIN_VALUE * 1e10) / 2) * margin || 1;
    const flip = this.#yDown ? -1 : 1;
    Object.assign(this.#flat, { left: -half * aspect, right: half * aspect, top: half * flip, bottom: -half * flip, zoom: 1 });
    this.#flat.position.set(center.x, center.y, 100);
    this.#flat.updateProjectionMatrix();
  }

  /** As close as possible with all corners of the extent visible. */
  #fitDeep(center: THREE.Vector3, size: THREE.Vector3): void {
    const radius = size.length() / 2 || 1;
    const back = new THREE.Vector3(-0.62, -0.92, 0.62).normalize();
    const right = new THREE.Vector3(0, 0, 1).cross(back).normalize();
    const up = back.clone().cross(right);
    const tangent = Math.tan(THREE.MathUtils.degToRad(this.#deep.fov / 2));
    const aspect = this.#width / this.#height;
    let distance = radius * 0.1;
    for (let which = 0; which < 8; ++which) {
      const signs = new THREE.Vector3((which & 1) - 0.5, ((which >> 1) & 1) - 0.5, ((which >> 2) & 1) - 0.5);
      const corner = size.clone().multiply(signs);
      const beside = Math.max(Math.abs(corner.dot(right)) / aspect, Math.abs(corner.dot(up)));
      distance = Math.max(distance, corner.dot(back) + (beside / tangent) * 1.05);
    }
    this.#deep.near = radius / 100;
    this.#deep.far = distance + radius * 40;
    this.#deep.position.copy(center).add(back.multiplyScalar(distance));
    this.#deep.updateProjectionMatrix();
  }

  #resize(): void {
    this.#renderer.setSize(this.#width, this.#height, false);
    const aspect = this.#width / this.#height;
    const half = this.#flat.top;
    this.#flat.left = -Math.abs(half) * aspect;
    this.#flat.right = Math.abs(half) * aspect;
    this.#flat.updateProjectionMatrix();
    this.#deep.aspect = aspect;
    this.#deep.updateProjectionMatrix();
    this.#viewChanged();
  }

  #controlsFor(camera: THREE.Camera): OrbitControls {
    const controls = new OrbitControls(camera, this.canvas);
    controls.enableDamping = false;
    controls.addEventListener("change", () => this.#viewChanged());
    if (camera === this.#flat) {
      controls.enableRotate = false;
      controls.mouseButtons = { LEFT: THREE.MOUSE.PAN, MIDDLE: THREE.MOUSE.DOLLY, RIGHT: THREE.MOUSE.PAN };
      controls.touches = { ONE: THREE.TOUCH.PAN, TWO: THREE.TOUCH.DOLLY_PAN };
      controls.zoomToCursor = true;
    } else {
      controls.maxPolarAngle = Math.PI / 2 - leastAngle;
    }
    return controls;
  }

  #replaceControls(camera: THREE.Camera): void {
    this.#controls.dispose();
    this.#controls = this.#controlsFor(camera);
  }

  /** Updates the camera's matrices, which otherwise are those of the last frame, and notifies listeners. */
  #viewChanged(): void {
    if (!this.#isFlat) this.#stayAboveFloor();
    this.#camera.updateMatrixWorld();
    this.afterView?.();
    for (const listener of this.#onView) listener();
    this.#drawSoon();
  }

  /** Lifts the camera and its target if they were moved too low. */
  #stayAboveFloor(): void {
    const [floor = 0, top = 0] = [this.#extent.min[2], this.#extent.max[2]];
    const lift = floor + leastHeight * (top - floor) - this.#deep.position.z;
    if (lift <= 0) return;
    this.#deep.position.z += lift;
    this.#controls.target.z += lift;
  }
}
