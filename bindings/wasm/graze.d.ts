// SPDX-License-Identifier: MIT
// The types of graze's module for JavaScript. All names and meanings are those of the C++ library.
//
// Numbers. Everything is calculated in double precision, which is JavaScript's own; where a typed array may be a
// Float32Array or a Float64Array, `overlappingPairs` and `PairFinder` work in the type they are given, all else widens
// floats, which is exact.
//
// Dimensions. A question about shapes has the dimension of their vectors: two numbers or three. Objects that hold many
// (Scene, PairFinder, QuadTree, ...) are given theirs.
//
// Errors. What is wrong with an argument is thrown as an Error whose message says what it is and what is allowed; the
// call has then changed nothing.
//
// Memory. Objects with a `delete` method hold memory of the module. It is given back by `delete`, at the end of the block of
// `using scene = new graze.Scene(3)`, or by itself some time after the last reference to the object is gone; after `delete`,
// every use is an Error.

// As in TypeScript's library "esnext.disposable", for programs that are compiled without it. Where the runtime lacks the
// symbol, the module defines it.
declare global {
  interface SymbolConstructor {
    readonly dispose: unique symbol;
  }
  interface Disposable {
    [Symbol.dispose](): void;
  }
}

/** Two or three numbers: as many as there are dimensions. */
export type Vector = readonly number[] | Float32Array | Float64Array;

/** A vector in an answer. */
export type Point = number[];

export type Dimension = 2 | 3;

/** Numbers in a row, without a structure of their own: boxes, points, offsets. */
export type Numbers = Float32Array | Float64Array;

// ---- Shapes: the vocabulary of scene files, see docs/scene_format.md

export interface PointShape {
  type: "point";
  position: Vector;
}
export interface Segment {
  type: "segment";
  start: Vector;
  end: Vector;
}
export interface Ray {
  type: "ray";
  origin: Vector;
  direction: Vector;
}
export interface Sphere {
  type: "sphere";
  center: Vector;
  radius: number;
}
export type Aabb = { type: "aabb"; min: Vector; max: Vector } | { type: "aabb"; center: Vector; half_extents: Vector };
/** Turned by at most one of: `angle` in degrees (2D), `rotation` (3D), or `axes` as vectors of length 1. */
export interface Obb {
  type: "obb";
  center: Vector;
  half_extents: Vector;
  axes?: readonly Vector[];
  angle?: number;
  rotation?: { axis: Vector; angle: number };
}
export interface Plane {
  type: "plane";
  normal: Vector;
  offset: number;
}
export interface HalfSpace {
  type: "half_space";
  normal: Vector;
  offset: number;
}
export interface Triangle {
  type: "triangle";
  a: Vector;
  b: Vector;
  c: Vector;
}
export interface Capsule {
  type: "capsule";
  a: Vector;
  b: Vector;
  radius: number;
}
/** The convex hull of the points. */
export interface Polytope {
  type: "polytope";
  points: readonly Vector[];
}
/** The union of its parts. */
export interface Compound {
  type: "compound";
  parts: readonly Shape[];
}
export type Shape =
  | PointShape
  | Segment
  | Ray
  | Sphere
  | Aabb
  | Obb
  | Plane
  | HalfSpace
  | Triangle
  | Capsule
  | Polytope
  | Compound;

/** A box in an answer, or where nothing but a box makes sense. Coordinates may be infinite. */
export interface Box {
  min: Point;
  max: Point;
}

// ---- Answers about one or two shapes

export type Relation = "apart" | "touching" | "overlapping";

/** How an iteration ended: the bounds met, or those given hold but are not as close as wanted. */
export type Status = "converged" | "best_bound";

/** Of closestPoints; `distance` is 0 if and only if the shapes touch or overlap. `normal` has length 1, or 0 where there is none. */
export interface Proximity {
  distance: number;
  pointA: Point;
  pointB: Point;
  normal: Point;
  relation: Relation;
  status: Status;
  error: number;
}

/** Moving b by normal * depth is the least translation that parts the shapes. */
export interface Contact {
  point: Point;
  pointA: Point;
  pointB: Point;
  /** From a to b. */
  normal: Point;
  depth: number;
  status: Status;
  error: number;
}

/** A corner, an edge or a face of a shape. What is round has one vertex; a capsule two, and an edge between. */
export interface Feature {
  kind: "vertex" | "edge" | "face";
  index: number;
}

/** Which features of two shapes a contact point lies on. */
export interface ContactId {
  a: Feature;
  b: Feature;
  /** The place of the part in a compound; 0 without parts. */
  partA: number;
  partB: number;
}

export interface ManifoldPoint {
  point: Point;
  pointA: Point;
  pointB: Point;
  depth: number;
  /**
   * The same from frame to frame as long as the shapes touch with the same features, so that a solver finds the impulse
   * of the frame before; `JSON.stringify(id)` is a key. Corners of polytopes are numbered as they come in `points`.
   */
  id: ContactId;
}

/** Up to two points in 2D, four in 3D; none if the shapes are apart. */
export interface Manifold {
  points: ManifoldPoint[];
  normal: Point;
  status: Status;
  error: number;
}

/** `t` is in units of the ray's direction; 0 if the ray starts in the shape. */
export interface RayHit {
  t: number;
  point: Point;
  normal: Point;
  status: Status;
  error: number;
}

/** When shapes that move first touch, and where. */
export interface Impact {
  /** From 0, the start of the motion, to 1, its end; never after the first touch. */
  t: number;
  /** Where they touch at t. */
  point: Point;
  /** From a to b; of length 1, or 0 where shapes that meet at the start have none. */
  normal: Point;
  status: Status;
  /** How far apart the shapes may still be at t, a length. */
  error: number;
}

/** From t = 0 to t = 1 the center goes straight on, and everything turns about it evenly. What is left out is zero. */
export interface Motion {
  /** The way of the center. */
  linear?: Vector;
  /** The whole turn: in 2D an angle in radians, in 3D a vector along the axis, as long as the angle. */
  angular?: number | Vector;
  /** Where the center is at t = 0. */
  center?: Vector;
}

/** A ray as an argument; `type` may be left out. */
export interface RayLike {
  type?: "ray";
  origin: Vector;
  direction: Vector;
}

export interface RayCastOptions {
  /** No hits beyond; default: infinity. */
  tMax?: number;
  /** Which end of the way through the shape; default: "entry". */
  side?: "entry" | "exit";
}

/** Points as vectors, or their coordinates in a row. */
export type Points = readonly Vector[] | Numbers;

// ---- Drawing

export interface OutlineOptions {
  /** What is unbounded is cut off at this box; needed for rays, planes and half-spaces. */
  within?: { min: Vector; max: Vector };
  /** Corners of a whole circle; default 64. */
  corners?: number;
}

/** What to draw of a shape. */
export interface Drawing {
  /** Corners of all pieces, N numbers each. */
  positions: Float32Array;
  /** Triangles, three corners each: filled shapes in 2D, surfaces in 3D, corners counter-clockwise from outside. */
  triangles: Uint32Array;
  /** Lines, two corners each: outlines in 2D, edges in 3D (of round shapes: none). */
  lines: Uint32Array;
}

// ---- Many boxes

export type PairMethod = "automatic" | "brute_force" | "dense" | "tree";

export interface PairOptions {
  /** "sorted": ascending by a, then b. "any": as they are found, which is quicker. Default: "sorted". */
  order?: "sorted" | "any";
  /** Every box is first grown by this much on every side; 0 or more. Default: 0. */
  margin?: number;
  /** The pairs never depend on it. Default: "automatic". */
  method?: PairMethod;
}

/**
 * `overlappingPairs` for boxes that move: keeps its memory from frame to frame. Nothing is copied: write the boxes into
 * `boxes`, call `find`, read the pairs that it gives.
 */
export interface PairFinder<A extends Numbers = Numbers> extends Disposable {
  readonly dimension: Dimension;

  /** How many boxes there are. Setting it keeps the boxes below the new count; new ones hold zeros. */
  count: number;

  /**
   * The boxes in the module's memory, 2 N numbers each: min, then max. Ask for it anew after setting `count` or any call
   * that may allocate: when the module's memory grows, earlier views have length 0.
   */
  readonly boxes: A;

  /**
   * The pairs a0, b0, a1, b1, ... with a < b, by the boxes' places. A view of the module's memory, good until the next
   * call of anything in the module; `slice()` keeps a copy.
   */
  find(options?: PairOptions): Uint32Array;

  /** The method that the last `find` used. */
  readonly method: PairMethod;

  /** The memory that is held, in bytes, without boxes and pairs. */
  readonly bytes: number;

  delete(): void;
}

// ---- Recordings

/** Boxes that move, frame by frame, from a file in Broadmark's format `.aabbs`: docs/cli.md says what it holds. */
export interface Recording extends Disposable {
  readonly dimension: Dimension;
  /** The name that it was read under. */
  readonly source: string;
  /** What the file calls the scene, and its objects. */
  readonly scene: string;
  readonly objectsType: string;
  /** How many boxes every frame has. */
  readonly count: number;
  /** How many frames there are, at least one. */
  readonly frames: number;
  /** Holds all boxes of all frames. */
  readonly world: Box;

  /** The boxes of a frame, the first of which is 0, 2 N numbers each: min, then max. Frames may be asked for in any order;
   * an Error says which box is none. */
  boxes(frame: number): Float32Array;

  delete(): void;
}

// ---- Indexes of boxes

/** Names a box of an index, or an object of a scene, for as long as it is held there: a whole number. */
export type Key = number;

/** Up to so many boxes stay in a cell; cells are cut up to so often, 0 to 32. */
export interface OrthtreeOptions {
  capacity?: number;
  maxDepth?: number;
}

export interface BvhOptions {
  /** How far a box may move before the tree has to change. */
  margin?: number;
}

export interface IndexHit {
  key: Key;
  t: number;
}

export interface IndexNeighbour {
  key: Key;
  distanceSquared: number;
}

/** The cells or nodes of an index, parents before their children. */
export interface Cells {
  /** 2 N numbers each: min, then max. Cells of a quad tree or octree are squares or cubes; nodes of a Bvh their bounds. */
  boxes: Float64Array;
  /** The root has 0. */
  depths: Uint32Array;
  /** How many boxes a cell holds itself, a node of a Bvh below it. */
  counts: Uint32Array;
  /** 1 for a leaf. */
  leaves: Uint8Array;
}

/** An index of boxes that come, move and go. Boxes in bulk are 2 N numbers each: min, then max. */
export interface SpatialIndex extends Disposable {
  readonly dimension: Dimension;
  readonly size: number;

  insert(box: { min: Vector; max: Vector }): Key;
  /** All of them or, with an Error, none. */
  insertMany(boxes: Numbers): Float64Array;
  update(key: Key, box: { min: Vector; max: Vector }): void;
  /** All of them or, with an Error, none. */
  updateMany(keys: Float64Array, boxes: Numbers): void;
  erase(key: Key): void;
  clear(): void;

  contains(key: Key): boolean;
  box(key: Key): Box;

  /** The keys of all boxes that meet the region, each once, in an order that depends on the index only. */
  query(region: Shape): Float64Array;
  /** All boxes that the ray enters, in order of t. */
  rayCast(ray: RayLike): IndexHit[];
  nearest(point: Vector, count: number): IndexNeighbour[];
  /** Every two boxes that share a point, a0, b0, a1, b1, ...; ascending. */
  pairs(): Float64Array;

  cells(): Cells;

  delete(): void;
}

// ---- Scenes

/** Names an object of one scene for as long as it lives: a whole number. `slotOf` says its place. */
export type ObjectId = number;

/** A layer by its name or number. */
export type LayerName = string | number;

export interface ObjectOptions {
  /** Unique in the scene; default: none. */
  name?: string;
  /** The layer it is on; one of an unknown name is made. Default: layer 0. */
  layer?: LayerName;
  /** The layers it can touch; default: all. */
  mask?: readonly LayerName[];
  /** For your own use: 0 to 2^64 - 1. */
  user?: number | bigint;
  /** Two fixed objects are never a pair. Default: false. */
  fixed?: boolean;
}

export interface SceneObject {
  shape: Shape;
  /** Of the shape; never smaller than it. */
  box: Box;
  name: string;
  /** By number; `layerNames` has its name. */
  layer: number;
  /** By number; "all" also holds layers that are yet to be made. */
  mask: number[] | "all";
  user: bigint;
  fixed: boolean;
}

/** Pairs of ids a0, b0, a1, b1, ...; each list ascending. */
export interface SceneEvents {
  began: Float64Array;
  stayed: Float64Array;
  ended: Float64Array;
}

export interface NearObject {
  id: ObjectId;
  distance: number;
}

export interface ObjectHit extends RayHit {
  id: ObjectId;
}

/** Where the objects a and b touch, as `manifold` of their shapes has it; at least one point. */
export interface ObjectContact extends Manifold {
  a: ObjectId;
  b: ObjectId;
}

/** The same for many pairs, without an object for each. N is the dimension. */
export interface ContactArrays {
  /** a0, b0, a1, b1, ...; ascending. */
  ids: Float64Array;
  /** The points of pair i are those from starts[i] up to, but without, starts[i + 1]. */
  starts: Uint32Array;
  /** N numbers for each pair, from a to b. */
  normals: Float64Array;
  /** One for each pair: 0 converged, 1 best_bound. */
  statuses: Uint8Array;
  /** One for each pair. */
  errors: Float64Array;
  /** N numbers for each point; so have the next two. */
  points: Float64Array;
  pointsA: Float64Array;
  pointsB: Float64Array;
  /** One for each point. */
  depths: Float64Array;
  /** Six for each point: kind (0 vertex, 1 edge, 2 face) and index of a's feature, those of b's, the part of a and of b. */
  contactIds: Uint32Array;
}

/** Only objects on these layers are found; default: all. */
export interface LayerOptions {
  layers?: readonly LayerName[];
}

export interface CheckOptions {
  /** Only pairs whose interiors overlap. */
  interior?: boolean;
}

/** As `graze check --format json` writes it. */
export interface CheckReport {
  schema: "graze.check/1";
  scene: string;
  dimension: Dimension;
  objects: number;
  /** What the file holds and graze did not read. */
  not_read: Omission[];
  pairs: { a: string; b: string; relation: Relation }[];
  summary: { pairs: number; candidates: number; seconds: number };
}

/** The same by id, for programs and for pictures of large scenes. */
export interface CheckedPairs {
  /** a0, b0, a1, b1, ...; ascending. */
  ids: Float64Array;
  /** One for each pair: 1 touching, 2 overlapping. */
  relations: Uint8Array;
  candidates: number;
  seconds: number;
}

/** As `graze info --format json` writes it. */
export interface SceneInfo {
  schema: "graze.info/1";
  scene: string;
  dimension: Dimension;
  objects: number;
  format: string;
  types: { name: string; objects: number }[];
  layers: { name: string; objects: number }[];
  bounds: Box | null;
  unbounded: number;
  empty: number;
  sizes: {
    min: number;
    median: number;
    p90: number;
    max: number;
    bins: { from: number; to: number; objects: number }[];
  } | null;
  not_read: Omission[];
}

/** Something that a file holds and graze did not read. */
export interface Omission {
  what: string;
  count: number;
  /** "shape": a shape that could touch others is missing; "precision": one is not exactly that of the file. */
  loss: "none" | "precision" | "shape";
  /** Where the first one is, and why it was not read; "" where that is not known. */
  where: string;
  why: string;
}

/** Shapes with names, layers and lifetimes. Lists of ids are ascending: in the order of adding while nothing is removed. */
export interface Scene extends Disposable {
  readonly dimension: Dimension;
  /** How many objects there are. */
  readonly size: number;
  /** The name of the file it was read from, else "". */
  readonly source: string;
  /** "graze.scene/1", "csv" or "tiled". */
  readonly format: string;
  /** Which way y grows on a picture. */
  readonly yAxis: "up" | "down";
  /** What the file holds and graze did not read. */
  readonly omissions: Omission[];

  add(shape: Shape, options?: ObjectOptions): ObjectId;
  /** All of them or, with an Error, none. The options count for each; they have no name. */
  addMany(shapes: readonly Shape[], options?: Omit<ObjectOptions, "name">): Float64Array;
  /** Boxes along the axes, 2 N numbers each: min, then max. */
  addBoxes(boxes: Numbers, options?: Omit<ObjectOptions, "name">): Float64Array;
  /** Spheres or circles, N + 1 numbers each: center, then radius. */
  addSpheres(spheres: Numbers, options?: Omit<ObjectOptions, "name">): Float64Array;

  move(id: ObjectId, shape: Shape): void;
  /** Moves objects by N numbers each. All of them or, with an Error, none; so do the next four. */
  translate(ids: Float64Array, offsets: Numbers): void;
  /** Moves objects so that the centers of their boxes come to lie at these points, but for rounding; of spheres and
   * oriented boxes the center, exactly. Not for unbounded shapes. */
  place(ids: Float64Array, positions: Numbers): void;
  /** The objects' shapes are now these boxes, 2 N numbers each. */
  moveBoxes(ids: Float64Array, boxes: Numbers): void;
  /** The objects' shapes are now these spheres, N + 1 numbers each. */
  moveSpheres(ids: Float64Array, spheres: Numbers): void;
  /**
   * Turns objects about the origin and moves them then. Three numbers each in 2D: position and angle in radians,
   * counter-clockwise where y points up; seven in 3D: position and quaternion x, y, z, w, of any length but zero. Poses do
   * not add up: each starts from the shape that the object had before its first pose, or that another method has given it
   * since. Boxes along the axes become oriented ones.
   */
  pose(ids: Float64Array, poses: Numbers): void;
  remove(id: ObjectId): void;
  /** Moves the objects that have a velocity to where they are so many seconds after what the file says, as
   * `graze simulate` does: by where they were when it was read, whatever has moved them since. All of them or, with an
   * Error, none. */
  moveToTime(seconds: number): void;

  /** Finds the pairs that touch now, and what has changed since the last update. */
  update(): SceneEvents;
  /** All pairs that touch or overlap, exactly tested: a0, b0, a1, b1, ...; ascending. */
  pairs(): Float64Array;
  /** Where they do, in the same order. */
  contacts(): ObjectContact[];
  /** The same as typed arrays. */
  contactArrays(): ContactArrays;
  /** All pairs whose boxes overlap and that may touch. */
  candidates(): Float64Array;

  contains(id: ObjectId): boolean;
  object(id: ObjectId): SceneObject;
  find(name: string): ObjectId | null;
  ids(): Float64Array;
  /** The objects to which the file gives a velocity, in units per second. */
  velocities(): { id: ObjectId; velocity: Point }[];
  /** The boxes of these objects, or of all in the order of `ids`: 2 N numbers each. */
  boxes(ids?: Float64Array): Float64Array;
  /** The number of the layer of that name; made if there is none yet. */
  layer(name: string): number;
  readonly layerNames: string[];

  /** The objects that touch or overlap a region. */
  overlapping(region: Shape, options?: LayerOptions): Float64Array;
  /** The objects whose boxes do, such as what a camera sees: quicker. */
  cull(region: Shape, options?: LayerOptions): Float64Array;
  nearest(point: Vector, count: number, options?: LayerOptions): NearObject[];
  /** The first hit. */
  rayCast(ray: RayLike, options?: LayerOptions & { tMax?: number }): ObjectHit | null;
  /** All hits, in order of t. */
  rayCastAll(ray: RayLike, options?: LayerOptions & { tMax?: number }): ObjectHit[];

  check(options?: CheckOptions): CheckReport;
  checkPairs(options?: CheckOptions): CheckedPairs;
  info(): SceneInfo;
  /** In graze's own format; numbers survive bit for bit. */
  toJson(): string;

  delete(): void;
}

/** Files that a scene file refers to (tilesets and templates of Tiled), by their path relative to it. */
export type SceneFiles = Readonly<Record<string, string | Uint8Array>>;

// ---- The module

export interface Graze {
  /** Of the library: "0.1.0". */
  readonly version: string;

  relation(a: Shape, b: Shape): Relation;
  intersects(a: Shape, b: Shape): boolean;
  distance(a: Shape, b: Shape): number;
  closestPoints(a: Shape, b: Shape): Proximity;
  /** The signed distance: where the shapes meet, minus the depth of their contact, with its points and normal. */
  separation(a: Shape, b: Shape): Proximity;
  contact(a: Shape, b: Shape): Contact | null;
  manifold(a: Shape, b: Shape): Manifold;

  /** The first touch of a, which moves by `motion` without turning, and b, which stays; null if there is none. For every
   * two shapes. */
  shapeCast(a: Shape, motion: Vector, b: Shape): Impact | null;
  /** The first touch of shapes that move and turn, for every two. A motion that is left out is rest. */
  timeOfImpact(a: Shape, motionA: Motion, b: Shape, motionB?: Motion): Impact | null;

  rayCast(shape: Shape, ray: RayLike, options?: RayCastOptions): RayHit | null;
  contains(shape: Shape, point: Vector): boolean;
  closestPoint(shape: Shape, point: Vector): Point;
  closestBoundaryPoint(shape: Shape, point: Vector): Point;
  signedDistance(shape: Shape, point: Vector): number;
  /** Infinite sides for unbounded shapes. */
  bounds(shape: Shape): Box;
  /** The shape as graze holds it: boxes by min and max, oriented ones by axes, polytopes by their corners. */
  normalised(shape: Shape): Shape;

  /** The exact minimum. Coordinates in a row need a dimension; so do the next four. */
  boundingSphere(points: Points, dimension?: Dimension): Sphere;
  /** At most a few percent larger, in two passes. */
  boundingSphereFast(points: Points, dimension?: Dimension): Sphere;
  boundingBox(points: Points, dimension?: Dimension): Aabb & { min: Point; max: Point };
  /** Of least area in 2D, of small surface in 3D. */
  boundingObb(points: Points, dimension?: Dimension): Obb & { axes: Point[] };
  /** The corners: in 2D in counter-clockwise order from the least, in 3D in lexicographic order. */
  convexHull(points: Points, dimension?: Dimension): Polytope & { points: Point[] };

  drawing(shape: Shape, options?: OutlineOptions): Drawing;

  /** Boxes of 2 N numbers each, min, then max. The pairs a0, b0, a1, b1, ... with a < b that share a point. */
  overlappingPairs(boxes: Numbers, dimension: Dimension, options?: PairOptions): Uint32Array;
  /** Between two sets, of one type of numbers: a is of the first, b of the second. */
  overlappingPairsBetween<A extends Numbers>(
    boxesA: A,
    boxesB: A,
    dimension: Dimension,
    options?: PairOptions,
  ): Uint32Array;

  /** Those of the candidates, pairs a0, b0, a1, b1, ... of places in `shapes`, that touch or overlap, in their order: the
   * answers of `intersects`, for many pairs at once. */
  touchingPairs(shapes: readonly Shape[], candidates: Uint32Array): Uint32Array;

  readonly PairFinder: {
    new (dimension: Dimension, count: number, scalar?: "float"): PairFinder<Float32Array>;
    new (dimension: Dimension, count: number, scalar: "double"): PairFinder<Float64Array>;
  };
  readonly QuadTree: new (options?: OrthtreeOptions) => SpatialIndex;
  readonly Octree: new (options?: OrthtreeOptions) => SpatialIndex;
  readonly Bvh: new (dimension: Dimension, options?: BvhOptions) => SpatialIndex;

  readonly Scene: new (dimension: Dimension) => Scene;
  /** Reads graze's own JSON, CSV of boxes, or a map of Tiled; told apart by content. `name` stands in messages. */
  readScene(content: string | Uint8Array, name?: string, files?: SceneFiles): Scene;

  /** Reads a recording of moving boxes. `name` stands in messages. */
  readRecording(content: Uint8Array, name?: string): Recording;

  /** An object's place: a small number that is used again when the object is gone, good as an index into an array. */
  slotOf(id: ObjectId | Key): number;

  /** The size of the module's memory, in bytes. */
  readonly memoryBytes: number;
  /** How many of it are taken. */
  readonly usedBytes: number;
}

export interface GrazeOptions {
  /** The content of graze_wasm.wasm, if it is at hand: nothing is then fetched. */
  wasmBinary?: ArrayBuffer | Uint8Array;
  /** Where graze_wasm.wasm lies, given the place it is looked for by default. */
  locateFile?: (name: string, folder: string) => string;
}

/** Loads the module. In node it reads graze_wasm.wasm from beside itself; in browsers and workers it fetches it. */
export function createGraze(options?: GrazeOptions): Promise<Graze>;
export default createGraze;
