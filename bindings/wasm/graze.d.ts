// SPDX-License-Identifier: MIT
// The types of graze's JavaScript module. Names and meanings are those of the C++ library.
//
// Numbers. Everything is calculated in double precision, like JavaScript's numbers. Where a typed array may be a
// Float32Array or a Float64Array, `overlappingPairs` and `PairFinder` use the given type; everything else converts
// floats to double, which is exact.
//
// Dimensions. The dimension of a query on shapes is that of their vectors: two numbers or three. Objects that hold many
// shapes or boxes (Scene, PairFinder, QuadTree, ...) get it on construction.
//
// Errors. An invalid argument throws an Error whose message states the fault and what is allowed; such a call has
// changed nothing.
//
// Memory. Objects with a `delete` method hold memory of the module. It is freed by `delete`, at the end of the block
// that contains `using scene = new graze.Scene(3)`, or some time after the last reference to the object is gone. After
// `delete`, every use throws an Error.

// As in TypeScript's library "esnext.disposable", for programs compiled without it. The module defines the symbol if
// the runtime lacks it.
declare global {
  interface SymbolConstructor {
    readonly dispose: unique symbol;
  }
  interface Disposable {
    [Symbol.dispose](): void;
  }
}

/** Two or three numbers, according to the dimension. */
export type Vector = readonly number[] | Float32Array | Float64Array;

/** A vector in a result. */
export type Point = number[];

export type Dimension = 2 | 3;

/** Consecutive numbers without further structure: boxes, points, offsets. */
export type Numbers = Float32Array | Float64Array;

// ---- Shapes: the types of scene files, see docs/scene_format.md

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
/** Rotated by at most one of: `angle` in degrees (2D), `rotation` (3D), or `axes` as unit vectors. */
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
/** Triangles: three indices of vertices for each face. A surface by default; a solid also has, in 3D, what it encloses. */
export interface Mesh {
  type: "mesh";
  vertices: readonly Vector[];
  faces: readonly (readonly [number, number, number])[];
  kind?: "surface" | "solid";
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
  | Compound
  | Mesh;

/** A shape as an argument: a mesh of many triangles should be one that `graze.mesh` has made. */
export type ShapeLike = Shape | BuiltMesh | { type: "compound"; parts: readonly ShapeLike[] };

/** A box in a result, or where only a box is allowed. Coordinates may be infinite. */
export interface Box {
  min: Point;
  max: Point;
}

// ---- Results about one or two shapes

export type Relation = "apart" | "touching" | "overlapping";

/** How an iteration ended: within the error bounds, or with valid but wider bounds. */
export type Status = "converged" | "best_bound";

/** The result of closestPoints; `distance` is 0 if and only if the shapes touch or overlap. `normal` has length 1, or 0
 * if there is none. */
export interface Proximity {
  distance: number;
  pointA: Point;
  pointB: Point;
  normal: Point;
  relation: Relation;
  status: Status;
  error: number;
}

/** Moving b by normal * depth is the minimum translation that separates the shapes. A negative depth is minus the
 * distance of shapes that are apart, which only a margin admits. */
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

/** A vertex, an edge or a face of a shape. Round shapes have one vertex; a capsule has two, and an edge between them.
 * */
export interface Feature {
  kind: "vertex" | "edge" | "face";
  index: number;
}

/** The features of two shapes on which a contact point lies. */
export interface ContactId {
  a: Feature;
  b: Feature;
  /** The index of the part in a compound; 0 without parts. */
  partA: number;
  partB: number;
}

export interface ManifoldPoint {
  point: Point;
  pointA: Point;
  pointB: Point;
  depth: number;
  /** Stays the same from frame to frame while the shapes touch with the same features, so that a solver can find the
   * impulse of the previous frame; `JSON.stringify(id)` is a key. Vertices of polytopes are numbered by their order in
   * `points`. */
  id: ContactId;
}

/** Up to two points in 2D and four in 3D; none if the shapes are apart. */
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

/** Where a ray meets a mesh. */
export interface MeshHit extends RayHit {
  /** The index of the face; null for a ray that starts inside a solid, at t = 0. */
  face: number | null;
  /** The weights of the face's vertices whose sum is the point: from 0 to 1, together 1 up to rounding. Zero without a
   * face. */
  barycentric: Point;
}

/** The time and place of the first contact of moving shapes. */
export interface Impact {
  /** From 0, the start of the motion, to 1, its end; never after the first contact. */
  t: number;
  /** Where they touch at t. */
  point: Point;
  /** From a to b, of length 1; 0 if shapes that touch at the start have no normal. */
  normal: Point;
  status: Status;
  /** How far apart the shapes may still be at t, a length. */
  error: number;
}

/** From t = 0 to t = 1 the center moves in a straight line, and the shape rotates about it at a constant rate. Missing
 * fields are zero. */
export interface Motion {
  /** The translation of the center. */
  linear?: Vector;
  /** The whole rotation: in 2D an angle in radians, in 3D a vector along the axis whose length is the angle. */
  angular?: number | Vector;
  /** The position of the center at t = 0. */
  center?: Vector;
}

export interface CastOptions {
  /** What is touched at the start and not approached does not stop the cast: a box that rests on a floor slides along
   * it, leaves it, and still hits a wall. Default: false. */
  ignoreInitialTouch?: boolean;
  /** The cast stops when the shapes are this near: a length of 0 or more. Default: 0, when they touch. */
  targetDistance?: number;
}

export interface ContactOptions {
  /** Shapes that are up to this far apart have contacts too, with a negative depth: a length of 0 or more.
   * Default: 0. */
  margin?: number;
}

/** A ray as an argument; `type` may be omitted. */
export interface RayLike {
  type?: "ray";
  origin: Vector;
  direction: Vector;
}

export interface RayCastOptions {
  /** Hits beyond this are ignored; default: infinity. */
  tMax?: number;
  /** Which end of the ray's path through the shape; default: "entry". */
  side?: "entry" | "exit";
}

/** Points as vectors, or as consecutive coordinates. */
export type Points = readonly Vector[] | Numbers;

// ---- Drawing

export interface OutlineOptions {
  /** Unbounded shapes are cut off at this box; required for rays, planes and half-spaces. */
  within?: { min: Vector; max: Vector };
  /** Corners of a full circle; default 64. */
  corners?: number;
}

/** The geometry for drawing a shape. */
export interface Drawing {
  /** Corners of all pieces, N numbers each. */
  positions: Float32Array;
  /** Triangles, three corners each: filled shapes in 2D, surfaces in 3D, corners counter-clockwise from outside. */
  triangles: Uint32Array;
  /** Lines, two corners each: outlines in 2D, edges in 3D (of round shapes: none). */
  lines: Uint32Array;
}

// ---- Meshes

export interface MeshOptions {
  /** Default: "surface". */
  kind?: "surface" | "solid";
  /** Required for vertices that are consecutive coordinates. */
  dimension?: Dimension;
}

/** Triangles as three indices of vertices each: one after the other, or as triples. */
export type Faces = Uint32Array | Uint16Array | Uint8Array | readonly (readonly number[])[];

/** What is unusual about a mesh; one that is closed and has no faults has zero everywhere but in `components`. Vertices
 * and edges are the same only if their indices are. */
export interface MeshReport {
  /** Edges of a single face. */
  openEdges: number;
  /** Edges of more than two faces. */
  nonManifoldEdges: number;
  /** Edges of two faces that both run along it in the same direction. */
  flippedEdges: number;
  /** Faces whose corners are collinear or equal, which is decided exactly. */
  degenerateFaces: number;
  /** Faces with the same three vertices, in any order, as one before. */
  duplicateFaces: number;
  /** Vertices of no face. */
  unusedVertices: number;
  /** Groups of faces that hang together by common vertices. */
  components: number;
  /** Whether each edge is used as often in one direction as in the other, so that winding numbers are integers. */
  isClosed: boolean;
}

/** The hits of many rays, in their order. */
export interface MeshHits {
  /** Infinity for a ray that misses. */
  t: Float64Array;
  /** -1 for a ray that misses, or that starts inside a solid. */
  faces: Int32Array;
  /** N numbers each; NaN for a ray that misses. */
  points: Float64Array;
  /** N numbers each. */
  normals: Float64Array;
  /** Three numbers each, as in MeshHit. */
  barycentrics: Float64Array;
  /** 0 converged, 1 best bound. */
  statuses: Uint8Array;
  errors: Float64Array;
}

/** A mesh that the module holds: its triangles are copied, and the tree behind its queries built, once. Accepted
 * wherever a shape is. It never changes; copies made by `posed` share its triangles. Arrays of points and rays have
 * finite numbers. */
export interface BuiltMesh extends Disposable {
  readonly type: "mesh";
  readonly dimension: Dimension;
  readonly kind: "surface" | "solid";
  readonly vertexCount: number;
  readonly faceCount: number;
  /** N coordinates each. */
  vertices(): Float64Array;
  /** Three indices of vertices each. */
  faces(): Uint32Array;

  /** What is unusual about it. */
  report(): MeshReport;
  /** The edges that the report counts as such: two indices of vertices each. */
  edges(fault: "open" | "non_manifold" | "flipped"): Uint32Array;
  /** All pairs of faces that share more than their common vertices and edges: a0, b0, a1, b1, ...; ascending. Decided
   * exactly. */
  selfIntersections(): Uint32Array;
  /** All pairs of a face of this mesh and one of the other that share a point: a0, b0, a1, b1, ...; ascending. Decided
   * exactly; the inside of solids does not count. */
  touchingFaces(other: BuiltMesh): Uint32Array;

  /** How often the faces run around a point: an integer for a closed mesh, and meaningful for open and broken ones. */
  windingNumber(point: Vector): number;
  /** The same for many points, N coordinates each, in their order. */
  windingNumbers(points: Numbers): Float64Array;
  /** `signedDistance` of many points: negative inside a solid. */
  signedDistances(points: Numbers): Float64Array;
  /** `closestPoint` of many points, N coordinates each. */
  closestPoints(points: Numbers): Float64Array;
  /** `rayCast` of many rays, 2 N numbers each: origin, then direction. */
  rayCasts(rays: Numbers): MeshHits;

  /** The same faces on vertices without duplicates: of vertices with equal coordinates only the first is kept. */
  welded(): BuiltMesh;
  /** The same faces with as many other vertices: faster than a new mesh. */
  moved(vertices: Points): BuiltMesh;
  /** Rotated about the origin, then moved, without copying triangles. A pose is that of `Scene.pose`. */
  posed(pose: Vector): BuiltMesh;

  delete(): void;
}

// ---- Many boxes

export type PairMethod = "automatic" | "brute_force" | "dense" | "tree";

export interface PairOptions {
  /** "sorted": ascending by a, then b. "any": in the order of discovery, which is faster. Default: "sorted". */
  order?: "sorted" | "any";
  /** Every box is first enlarged by this much on every side; 0 or more. Default: 0. */
  margin?: number;
  /** The pairs do not depend on it. Default: "automatic". */
  method?: PairMethod;
}

/** `overlappingPairs` for moving boxes: reuses its memory from frame to frame. Nothing is copied: write the boxes into
 * `boxes`, call `find`, and read the pairs that it returns. */
export interface PairFinder<A extends Numbers = Numbers> extends Disposable {
  readonly dimension: Dimension;

  /** The number of boxes. Setting it keeps the boxes below the new count; new ones are zero. */
  count: number;

  /** The boxes in the module's memory, 2 N numbers each: min, then max. Get a new view after setting `count` and after
   * any call that may allocate: when the module's memory grows, earlier views have length 0. */
  readonly boxes: A;

  /** The pairs a0, b0, a1, b1, ... with a < b, by index of the boxes. A view of the module's memory, valid until the
   * next call of anything in the module; `slice()` makes a copy. */
  find(options?: PairOptions): Uint32Array;

  /** The method that the last `find` used. */
  readonly method: PairMethod;

  /** The memory in use, in bytes, without boxes and pairs. */
  readonly bytes: number;

  delete(): void;
}

// ---- Recordings

/** Moving boxes, frame by frame, from a file in Broadmark's format `.aabbs`, which docs/cli.md documents. */
export interface Recording extends Disposable {
  readonly dimension: Dimension;
  /** The name given when it was read. */
  readonly source: string;
  /** The names of the scene and its objects in the file. */
  readonly scene: string;
  readonly objectsType: string;
  /** The number of boxes in every frame. */
  readonly count: number;
  /** The number of frames, at least one. */
  readonly frames: number;
  /** Contains all boxes of all frames. */
  readonly world: Box;

  /** The boxes of a frame (numbered from 0), 2 N numbers each: min, then max. Frames can be read in any order; an Error
   * names an invalid box. */
  boxes(frame: number): Float32Array;

  delete(): void;
}

// ---- Indexes of boxes

/** Identifies a box of an index or an object of a scene while it is stored there: an integer. */
export type Key = number;

/** A cell holds up to `capacity` boxes before it splits; cells split up to `maxDepth` times, 0 to 32. */
export interface OrthtreeOptions {
  capacity?: number;
  maxDepth?: number;
}

export interface BvhOptions {
  /** How far a box may move before the tree changes. */
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
  /** 2 N numbers each: min, then max. Cells of a quad tree or octree are squares or cubes; nodes of a Bvh are bounds.
   * */
  boxes: Float64Array;
  /** The root has depth 0. */
  depths: Uint32Array;
  /** The number of boxes that a cell itself stores; for a node of a Bvh, the number below it. */
  counts: Uint32Array;
  /** 1 for a leaf. */
  leaves: Uint8Array;
}

/** A dynamic index of boxes. Many boxes are passed as 2 N numbers each: min, then max. */
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

  /** The keys of all boxes that meet the region, each once, in an order that depends only on the index. */
  query(region: ShapeLike): Float64Array;
  /** All boxes that the ray enters, in order of t. */
  rayCast(ray: RayLike): IndexHit[];
  nearest(point: Vector, count: number): IndexNeighbour[];
  /** All pairs of boxes that share a point, a0, b0, a1, b1, ...; ascending. */
  pairs(): Float64Array;

  cells(): Cells;

  delete(): void;
}

// ---- Scenes

/** Identifies an object of one scene during its lifetime: an integer. `slotOf` returns its slot. */
export type ObjectId = number;

/** A layer by its name or number. */
export type LayerName = string | number;

export interface ObjectOptions {
  /** Unique in the scene; default: none. */
  name?: string;
  /** The layer of the object; created if the name is unknown. Default: layer 0. */
  layer?: LayerName;
  /** The layers it can touch; default: all. */
  mask?: readonly LayerName[];
  /** For your own use: 0 to 2^64 - 1. */
  user?: number | bigint;
  /** Two fixed objects never form a pair. Default: false. */
  fixed?: boolean;
}

export interface SceneObject {
  shape: Shape;
  /** Contains the shape. */
  box: Box;
  name: string;
  /** By number; `layerNames` has its name. */
  layer: number;
  /** By number; "all" includes layers created later. */
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
  /** If the object's shape is a mesh and the ray does not start inside it: where on it, as in MeshHit. */
  face?: number;
  barycentric?: Point;
}

/** An object that a moving shape touches, and the first touch; the normal points towards the object. */
export interface ObjectImpact extends Impact {
  id: ObjectId;
}

/** An object that a shape touches or overlaps, and their contact; the normal points towards the object. At least one
 * point. */
export interface ObjectTouch extends Manifold {
  id: ObjectId;
}

/** Two objects and their distance; 0 if they touch. */
export interface NearPair {
  a: ObjectId;
  b: ObjectId;
  distance: number;
}

/** The contact of the objects a and b, like `manifold` of their shapes; at least one point. */
export interface ObjectContact extends Manifold {
  a: ObjectId;
  b: ObjectId;
}

/** The same for many pairs, as arrays instead of objects. N is the dimension. */
export interface ContactArrays {
  /** a0, b0, a1, b1, ...; ascending. */
  ids: Float64Array;
  /** The points of pair i are those from starts[i] up to, but not including, starts[i + 1]. */
  starts: Uint32Array;
  /** N numbers for each pair, from a to b. */
  normals: Float64Array;
  /** One for each pair: 0 converged, 1 best_bound. */
  statuses: Uint8Array;
  /** One for each pair. */
  errors: Float64Array;
  /** N numbers for each point; the same for the next two. */
  points: Float64Array;
  pointsA: Float64Array;
  pointsB: Float64Array;
  /** One for each point. */
  depths: Float64Array;
  /** Six for each point: kind (0 vertex, 1 edge, 2 face) and index of a's feature, those of b's, the parts of a and b.
   * */
  contactIds: Uint32Array;
}

/** Which objects a query may find: those on some layers that are not excepted and that a predicate accepts; by default
 * all. Rays and moving shapes pass through the others. */
export interface SceneQuery {
  /** The layers of the objects, by name or number. */
  layers?: readonly LayerName[];
  /** Objects to leave out; ids of removed objects are ignored. For many ids use the predicate. */
  except?: readonly ObjectId[] | Float64Array;
  /** True for the objects that may be found. It is called for some objects, in any order, perhaps more than once. It
   * may query the scene but must not change it. What it throws ends the query and reaches its caller. */
  predicate?: (id: ObjectId) => boolean;
}

export interface SceneRayOptions extends SceneQuery {
  /** Hits beyond this are ignored; default: infinity. */
  tMax?: number;
}

export interface SceneCastOptions extends SceneQuery {
  /** As in CastOptions. */
  ignoreInitialTouch?: boolean;
}

/** What blocks a sliding shape, and what it can climb. The shape's own object should be among the exceptions. */
export interface SlideOptions extends SceneQuery {
  /** Against gravity, of any length but zero; default: along y. */
  up?: Vector;
  /** In radians, from 0 to a right angle: a steeper surface cannot be climbed. The shape glides down along it, but
   * stops before it like before a wall when it walks towards it. Default: a right angle, so that every slope can be
   * climbed. */
  maxSlope?: number;
  /** The height of the steps that the shape climbs, if it finds a place to stand there; a length. Default: 0. */
  stepHeight?: number;
  /** The shape stops this far from what is in its way; a length. What it is nearer to than half of that at the start,
   * it first moves away from. Default: 0.001. */
  clearance?: number;
}

/** Where a sliding shape ends, and what it met on its way. */
export interface Slide {
  /** From the start to the end of its path: move the shape by it. */
  motion: Point;
  /** In order of t. One object may be there several times. */
  touches: ObjectImpact[];
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
  /** What the file contains and graze did not read. */
  not_read: Omission[];
  pairs: { a: string; b: string; relation: Relation }[];
  summary: { pairs: number; candidates: number; seconds: number };
}

/** The same by id, for programs and for drawing large scenes. */
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

/** Something in a file that graze did not read. */
export interface Omission {
  what: string;
  count: number;
  /** "shape": a shape that could touch others is missing; "precision": a shape is approximated. */
  loss: "none" | "precision" | "shape";
  /** The place of the first one, and why it was not read; "" if unknown. */
  where: string;
  why: string;
}

/** Shapes with names, layers and lifetimes. Lists of ids are ascending: in the order of adding unless objects were
 * removed. */
export interface Scene extends Disposable {
  readonly dimension: Dimension;
  /** The number of objects. */
  readonly size: number;
  /** The name of its file, or "". */
  readonly source: string;
  /** "graze.scene/1", "csv" or "tiled". */
  readonly format: string;
  /** The direction of y in a picture. */
  readonly yAxis: "up" | "down";
  /** What the file contains and graze did not read. */
  readonly omissions: Omission[];

  add(shape: ShapeLike, options?: ObjectOptions): ObjectId;
  /** All of them or, with an Error, none. The options apply to each; they have no name. */
  addMany(shapes: readonly ShapeLike[], options?: Omit<ObjectOptions, "name">): Float64Array;
  /** Axis-aligned boxes, 2 N numbers each: min, then max. */
  addBoxes(boxes: Numbers, options?: Omit<ObjectOptions, "name">): Float64Array;
  /** Spheres or circles, N + 1 numbers each: center, then radius. */
  addSpheres(spheres: Numbers, options?: Omit<ObjectOptions, "name">): Float64Array;

  move(id: ObjectId, shape: ShapeLike): void;
  /** Moves objects by N numbers each. All of them or, with an Error, none; the same for the next four. */
  translate(ids: Float64Array, offsets: Numbers): void;
  /** Moves objects so that the centers of their boxes are at these points, up to rounding; for spheres and oriented
   * boxes their own centers, exactly. Not for unbounded shapes. */
  place(ids: Float64Array, positions: Numbers): void;
  /** Replaces the objects' shapes by these boxes, 2 N numbers each. */
  moveBoxes(ids: Float64Array, boxes: Numbers): void;
  /** Replaces the objects' shapes by these spheres, N + 1 numbers each. */
  moveSpheres(ids: Float64Array, spheres: Numbers): void;
  /** Rotates objects about the origin, then moves them. Three numbers each in 2D: position and angle in radians,
   * counter-clockwise if y points up; seven in 3D: position and quaternion x, y, z, w, of any nonzero length. Poses do
   * not accumulate: each starts from the shape that the object had before its first pose, or that another method has
   * set since. Axis-aligned boxes become oriented ones. */
  pose(ids: Float64Array, poses: Numbers): void;
  remove(id: ObjectId): void;
  /** Excludes a pair of objects, in any order: `update`, `pairs` and all other queries about pairs no longer report it.
   * If it touched at the last update, the next one ends it. Files keep it. An Error if an id names no object, or both
   * name the same. */
  except(a: ObjectId, b: ObjectId): void;
  /** Undoes `except`. */
  accept(a: ObjectId, b: ObjectId): void;
  /** Moves the objects with a velocity to their positions at the given time in seconds, as `graze simulate` does:
   * relative to their positions in the file, whatever has moved them since. All of them or, with an Error, none. */
  moveToTime(seconds: number): void;

  /** Finds the pairs that touch now, and the changes since the last update. */
  update(): SceneEvents;
  /** All pairs that touch or overlap, exactly tested: a0, b0, a1, b1, ...; ascending. */
  pairs(): Float64Array;
  /** The contacts of these pairs, in the same order. */
  contacts(): ObjectContact[];
  /** The same as typed arrays. */
  contactArrays(): ContactArrays;
  /** All pairs whose boxes overlap and whose layers may touch. */
  candidates(): Float64Array;
  /** All pairs that are at most this far apart, with their distances; ascending by pair. */
  closestPairs(within: number): NearPair[];
  /** Whether `except` has named these two objects, in any order. */
  excepted(a: ObjectId, b: ObjectId): boolean;
  /** All excepted pairs: a0, b0, a1, b1, ...; ascending. */
  exceptedPairs(): Float64Array;

  contains(id: ObjectId): boolean;
  object(id: ObjectId): SceneObject;
  find(name: string): ObjectId | null;
  ids(): Float64Array;
  /** The objects with a velocity in the file, in units per second. */
  velocities(): { id: ObjectId; velocity: Point }[];
  /** The boxes of these objects, or of all in the order of `ids`: 2 N numbers each. */
  boxes(ids?: Float64Array): Float64Array;
  /** The number of the layer with that name; created if there is none. */
  layer(name: string): number;
  readonly layerNames: string[];

  /** The objects that touch or overlap a region. */
  overlapping(region: ShapeLike, options?: SceneQuery): Float64Array;
  /** The objects whose boxes touch or overlap a region, such as a view volume: faster. */
  cull(region: ShapeLike, options?: SceneQuery): Float64Array;
  /** The objects that touch or overlap a shape, and where: for each the `manifold` of the shape and the object. The
   * shape need not be an object. Ascending by id. */
  contactsWith(shape: ShapeLike, options?: SceneQuery): ObjectTouch[];
  /** The `count` objects nearest to a point or a shape, or all if there are fewer: by `distance`, ties by id; 0 for all
   * that touch the shape. */
  nearest(from: Vector | ShapeLike, count: number, options?: SceneQuery): NearObject[];
  /** The first hit. */
  rayCast(ray: RayLike, options?: SceneRayOptions): ObjectHit | null;
  /** All hits, in order of t. */
  rayCastAll(ray: RayLike, options?: SceneRayOptions): ObjectHit[];

  /** The first object that a shape touches as it moves by `motion`, of several the one with the lowest id: the earliest
   * `shapeCast` of the shape at any object. The shape need not be an object; an object that is cast from its own place
   * excepts itself. */
  shapeCast(shape: ShapeLike, motion: Vector, options?: SceneCastOptions): ObjectImpact | null;
  /** All objects that it touches, each with its first touch, in order of t: it passes through what it touches. */
  shapeCastAll(shape: ShapeLike, motion: Vector, options?: SceneCastOptions): ObjectImpact[];
  /** The first object that a shape touches as it moves and rotates: the earliest `timeOfImpact` of the shape and any
   * object, which does not move. `shapeCast` is cheaper without rotation. */
  timeOfImpact(shape: ShapeLike, motion: Motion, options?: SceneQuery): ObjectImpact | null;
  /** Moves a shape along `motion`, and where it meets an object, along its surface: a character that walks along walls,
   * up slopes and steps. The scene does not change; move the shape by the resulting motion. It passes through nothing,
   * and never ends in an overlap with an object that it did not overlap at the start. */
  slide(shape: ShapeLike, motion: Vector, options?: SlideOptions): Slide;

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
  /** The version of the library: "0.1.0". */
  readonly version: string;

  relation(a: ShapeLike, b: ShapeLike): Relation;
  intersects(a: ShapeLike, b: ShapeLike): boolean;
  distance(a: ShapeLike, b: ShapeLike): number;
  closestPoints(a: ShapeLike, b: ShapeLike): Proximity;
  /** The distance or, if the shapes touch or overlap, minus the depth of their contact, with its points and normal. */
  separation(a: ShapeLike, b: ShapeLike): Proximity;
  contact(a: ShapeLike, b: ShapeLike, options?: ContactOptions): Contact | null;
  manifold(a: ShapeLike, b: ShapeLike, options?: ContactOptions): Manifold;

  /** The first contact of a, which moves by `motion` without rotation, and b, which does not move; null if there is
   * none. For any two shapes. */
  shapeCast(a: ShapeLike, motion: Vector, b: ShapeLike, options?: CastOptions): Impact | null;
  /** The first contact of moving and rotating shapes, for any two. A missing motion means no motion. */
  timeOfImpact(a: ShapeLike, motionA: Motion, b: ShapeLike, motionB?: Motion): Impact | null;

  rayCast(shape: Mesh | BuiltMesh, ray: RayLike, options?: RayCastOptions): MeshHit | null;
  rayCast(shape: ShapeLike, ray: RayLike, options?: RayCastOptions): RayHit | null;
  contains(shape: ShapeLike, point: Vector): boolean;
  closestPoint(shape: ShapeLike, point: Vector): Point;
  closestBoundaryPoint(shape: ShapeLike, point: Vector): Point;
  signedDistance(shape: ShapeLike, point: Vector): number;
  /** Infinite sides for unbounded shapes. */
  bounds(shape: ShapeLike): Box;
  /** The shape in the library's representation: boxes by min and max, oriented ones by axes, polytopes by their
   * vertices. */
  normalised(shape: ShapeLike): Shape;

  /** The exact minimum. Consecutive coordinates need a dimension; the same for the next four. */
  boundingSphere(points: Points, dimension?: Dimension): Sphere;
  /** At most a few percent larger, in two passes. */
  boundingSphereFast(points: Points, dimension?: Dimension): Sphere;
  boundingBox(points: Points, dimension?: Dimension): Aabb & { min: Point; max: Point };
  /** Of minimum area in 2D, of small surface area in 3D. */
  boundingObb(points: Points, dimension?: Dimension): Obb & { axes: Point[] };
  /** The vertices: in 2D counter-clockwise from the smallest, in 3D in lexicographic order. */
  convexHull(points: Points, dimension?: Dimension): Polytope & { points: Point[] };

  /** A mesh of triangles that the module keeps until `delete`. Any faces are accepted: open or closed, crossing each
   * other, flat, equal, or none. Vertices are equal only if their indices are; see `welded`. */
  mesh(vertices: Points, faces: Faces, options?: MeshOptions): BuiltMesh;

  drawing(shape: ShapeLike, options?: OutlineOptions): Drawing;

  /** Boxes of 2 N numbers each, min, then max. Returns the pairs a0, b0, a1, b1, ... with a < b that share a point. */
  overlappingPairs(boxes: Numbers, dimension: Dimension, options?: PairOptions): Uint32Array;
  /** Between two sets with the same number type: a is in the first, b in the second. */
  overlappingPairsBetween<A extends Numbers>(
    boxesA: A,
    boxesB: A,
    dimension: Dimension,
    options?: PairOptions,
  ): Uint32Array;

  /** The candidates (pairs a0, b0, a1, b1, ... of indexes in `shapes`) that touch or overlap, in their order:
   * `intersects` for many pairs at once. */
  touchingPairs(shapes: readonly ShapeLike[], candidates: Uint32Array): Uint32Array;

  readonly PairFinder: {
    new (dimension: Dimension, count: number, scalar?: "float"): PairFinder<Float32Array>;
    new (dimension: Dimension, count: number, scalar: "double"): PairFinder<Float64Array>;
  };
  readonly QuadTree: new (options?: OrthtreeOptions) => SpatialIndex;
  readonly Octree: new (options?: OrthtreeOptions) => SpatialIndex;
  readonly Bvh: new (dimension: Dimension, options?: BvhOptions) => SpatialIndex;

  readonly Scene: new (dimension: Dimension) => Scene;
  /** Reads graze's own JSON, CSV of boxes and round shapes, or a Tiled map, recognized by content. `name` is for
   * messages. */
  readScene(content: string | Uint8Array, name?: string, files?: SceneFiles): Scene;

  /** Reads a recording of moving boxes. `name` is for messages. */
  readRecording(content: Uint8Array, name?: string): Recording;

  /** An object's slot: a small integer that is reused after the object is removed, suitable as an array index. */
  slotOf(id: ObjectId | Key): number;

  /** The size of the module's memory, in bytes. */
  readonly memoryBytes: number;
  /** The number of bytes in use. */
  readonly usedBytes: number;
}

export interface GrazeOptions {
  /** The content of graze_wasm.wasm; if given, nothing is fetched. */
  wasmBinary?: ArrayBuffer | Uint8Array;
  /** Returns the location of graze_wasm.wasm, given the default location. */
  locateFile?: (name: string, folder: string) => string;
}

/** Loads the module. Node reads graze_wasm.wasm from the module's folder; browsers and workers fetch it. */
export function createGraze(options?: GrazeOptions): Promise<Graze>;
export default createGraze;
