/* SPDX-License-Identifier: MIT */
/* The types of graze's C interface: include <graze.h>. */
#ifndef GRAZE_TYPES_H
#define GRAZE_TYPES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32) && defined(GRAZE_C_BUILDS)
#define GRAZE_API __declspec(dllexport)
#elif defined(_WIN32)
#define GRAZE_API __declspec(dllimport)
#elif defined(__GNUC__)
#define GRAZE_API __attribute__((visibility("default")))
#else
#define GRAZE_API
#endif

/* How a call ended. Negative: an error, which graze_error_message describes; then no output is written. Every function
 * that returns a status refuses null pointers, except where its comment allows them. */
typedef int32_t graze_status;
enum {
  GRAZE_OK = 0,
  GRAZE_NONE = 1,              /* No error, but there is no answer: no hit, no contact. The output is set to zero. */
  GRAZE_TRUNCATED = 2,         /* No error, but there are more results than fit: the first ones have been written. */
  GRAZE_INVALID_ARGUMENT = -1, /* A value that is not allowed: null, NaN, a negative length, an unknown constant. */
  GRAZE_OUT_OF_RANGE = -2,     /* A handle, id or index that names nothing, or no longer does. */
  GRAZE_WRONG_WORLD = -3,      /* Arguments of different worlds. */
  GRAZE_INPUT_ERROR = -4,      /* A file that cannot be read; the message names the place and what is allowed. */
  GRAZE_TOO_MANY = -5,         /* More than a limit allows. */
  GRAZE_OUT_OF_MEMORY = -6,
  GRAZE_INTERNAL_ERROR = -7 /* Anything else; please report it. */
};

/* A dimension and the type in which numbers are stored. Arguments of a call have the same world, and answers have the
 * bits of the C++ library for that world. Numbers pass as double: in a world of float they are rounded to float first,
 * and every float is a double. In 2D, z is ignored in arguments and 0 in answers. */
typedef int32_t graze_world;
enum { GRAZE_3D = 0, GRAZE_2D = 1, GRAZE_3D_FLOAT = 2, GRAZE_2D_FLOAT = 3 };

typedef struct graze_vec {
  double x, y, z;
} graze_vec;

/* A matrix by its columns. In 2D the first two columns count; answers have (0, 0, 1) as the third. */
typedef struct graze_mat {
  graze_vec columns[3];
} graze_mat;

/* A rigid transform: x becomes rotation * x + position. The columns of the rotation are orthonormal. */
typedef struct graze_pose {
  graze_mat rotation;
  graze_vec position;
} graze_pose;

/* A motion from t = 0 to t = 1: the center moves straight by `linear`, and the body rotates about it by the length of
 * `angular`, in radians, right-handed about that vector. In 2D the rotation is angular.z, and z of the others is
 * ignored. All zero: no motion. */
typedef struct graze_motion {
  graze_vec linear, angular, center;
} graze_motion;

/* ---- Shapes: plain values, except those of any size, which refer to a geometry. Sets are closed and solid. ---- */

typedef int32_t graze_kind;
enum {
  GRAZE_POINT = 0,
  GRAZE_SEGMENT = 1,
  GRAZE_RAY = 2,
  GRAZE_SPHERE = 3, /* In 2D a disc. */
  GRAZE_AABB = 4,
  GRAZE_OBB = 5,
  GRAZE_PLANE = 6,      /* In 2D a line. */
  GRAZE_HALF_SPACE = 7, /* Its inside is on the side against the normal. */
  GRAZE_TRIANGLE = 8,
  GRAZE_CAPSULE = 9,
  GRAZE_POLYTOPE = 10, /* A convex hull, by graze_create_hull. */
  GRAZE_COMPOUND = 11, /* The union of other shapes, by graze_create_compound. */
  GRAZE_MESH = 12      /* Triangles, by graze_create_mesh. */
};

/* The handle of a polytope, compound or mesh, which never changes and may be used by many threads. Zero names none. */
typedef struct graze_geometry {
  uint64_t handle;
} graze_geometry;

/* Directions have any length but zero; the points x of a plane have dot(normal, x) == offset, those of a half-space at
 * most offset; axes are orthonormal. */
typedef struct graze_segment {
  graze_vec start, end;
} graze_segment;
typedef struct graze_ray {
  graze_vec origin, direction;
} graze_ray;
typedef struct graze_sphere {
  graze_vec center;
  double radius;
} graze_sphere;
typedef struct graze_box {
  graze_vec min, max;
} graze_box;
typedef struct graze_obb {
  graze_vec center, half_extents;
  graze_mat axes;
} graze_obb;
typedef struct graze_plane {
  graze_vec normal;
  double offset;
} graze_plane;
typedef struct graze_triangle {
  graze_vec a, b, c;
} graze_triangle;
typedef struct graze_capsule {
  graze_vec a, b;
  double radius;
} graze_capsule;

/* A shape of any kind. A struct of zeros is the point at the origin in 3D. */
typedef struct graze_shape {
  graze_kind kind;
  graze_world world;
  union {
    graze_vec point;
    graze_segment segment;
    graze_ray ray;
    graze_sphere sphere;
    graze_box aabb;
    graze_obb obb;
    graze_plane plane;
    graze_plane half_space;
    graze_triangle triangle;
    graze_capsule capsule;
    graze_geometry geometry; /* Of a polytope, compound or mesh. */
    double numbers[15];      /* Of the others: their fields in order. */
  } as;
} graze_shape;

/* What a mesh contains: its closed faces or, in 3D, also all points with a winding number above 1/2. */
typedef int32_t graze_mesh_kind;
enum { GRAZE_SURFACE = 0, GRAZE_SOLID = 1 };

/* What is unusual about a mesh: counts, and whether every edge is used as often in one direction as in the other. */
typedef struct graze_mesh_report {
  uint64_t open_edges, non_manifold_edges, flipped_edges;
  uint64_t degenerate_faces, duplicate_faces, unused_vertices, components;
  bool is_closed;
} graze_mesh_report;

/* ---- Answers; members as in the C++ headers of the same names. ---- */

/* `apart` and `overlapping` are certain; `touching`: the gap or depth is below the rounding error. */
typedef int32_t graze_relation;
enum { GRAZE_APART = 0, GRAZE_TOUCHING = 1, GRAZE_OVERLAPPING = 2 };

/* How an iteration ended: within its tolerance, or earlier, with bounds that hold but are wider. */
typedef int32_t graze_convergence;
enum { GRAZE_CONVERGED = 0, GRAZE_BEST_BOUND = 1 };

/* The distance of two shapes a and b, and a nearest point of each. The normal, of length 1 or 0, points from a to b. */
typedef struct graze_proximity {
  double distance;
  graze_vec point_a, point_b, normal;
  double error; /* The largest error of the distance. */
  graze_relation relation;
  graze_convergence status;
} graze_proximity;

/* Moving b by normal * depth separates the shapes by the shortest way. Below zero, the depth is a distance. */
typedef struct graze_contact {
  graze_vec point, normal;
  double depth;
  graze_vec point_a, point_b;
  double error; /* The largest error of the depth. */
  graze_convergence status;
} graze_contact;

/* A corner, edge or face of a shape. */
typedef int32_t graze_feature_kind;
enum { GRAZE_VERTEX = 0, GRAZE_EDGE = 1, GRAZE_FACE = 2 };

/* One point of a manifold. The features and parts identify it across frames. */
typedef struct graze_manifold_point {
  graze_vec point, point_a, point_b;
  double depth;
  graze_feature_kind feature_a, feature_b;
  uint32_t index_a, index_b; /* Of the features. */
  uint32_t part_a, part_b;   /* Parts of compounds, faces of meshes; else 0. */
} graze_manifold_point;

/* The contact points of two shapes: up to 2 in 2D, 4 in 3D, 0 if they are apart. */
typedef struct graze_manifold {
  graze_manifold_point points[4];
  graze_vec normal;
  double error;
  uint32_t count;
  graze_convergence status;
} graze_manifold;

/* The face of a hit that is on no face of a mesh. */
#define GRAZE_NO_FACE UINT64_MAX

/* Where a ray enters or leaves a shape: at origin + t * direction. */
typedef struct graze_ray_hit {
  double t;
  graze_vec point, normal;
  double error;          /* The largest error of the point. */
  graze_vec barycentric; /* Of the point, in the face that is hit; else 0. */
  uint64_t face;         /* Of a mesh; else GRAZE_NO_FACE. */
  graze_convergence status;
  bool is_hit; /* Of ray_casts: whether this ray hits; else always true. */
} graze_ray_hit;

/* When and where moving shapes first touch; t is from 0 to 1, and the normal points from a to b. */
typedef struct graze_impact {
  double t;
  graze_vec point, normal;
  double error; /* The largest gap left at t. */
  graze_convergence status;
} graze_impact;

/* At density 1: volume (in 2D area), centroid, and inertia about it. In 2D the inertia is columns[2].z. */
typedef struct graze_mass {
  double volume;
  graze_vec centroid;
  graze_mat inertia;
} graze_mass;

/* ---- Many things: arrays of the caller. ---- */

/* Rows of numbers in the type of the world: N for points; 2N for boxes (minimum, maximum) and rays (origin, direction),
 * with N = 2 or 3. `data` may be null if count is 0. */
typedef struct graze_rows {
  const void* data;
  size_t count;
  size_t stride; /* From row to row, in bytes; 0 if there is nothing between them. */
  graze_world world;
} graze_rows;

/* Two members of arrays, by their indices. */
typedef struct graze_pair {
  uint32_t a, b;
} graze_pair;

typedef struct graze_pair_contact {
  graze_pair pair;
  graze_manifold manifold; /* From pair.a to pair.b. */
} graze_pair_contact;

/* ---- Options: a null pointer and a struct of zeros mean the defaults. ---- */

typedef struct graze_ray_options {
  bool is_limited; /* Whether t_max counts; otherwise the ray has no end. */
  bool is_exit;    /* The last point on the shape instead of the first. */
  double t_max;    /* In units of the ray's direction; 1 makes it a segment. */
} graze_ray_options;

typedef struct graze_cast_options {
  bool ignore_initial_touch; /* What is touched at the start, and not approached, does not stop the shape. */
  double target_distance;    /* The cast stops this near: a length. */
} graze_cast_options;

typedef struct graze_pair_options {
  bool any_order;   /* The order in which pairs are found, which is faster, instead of ascending. */
  uint32_t threads; /* At most; 0: all. The pairs do not depend on it. */
  double margin;    /* Every box is grown by this length first. */
} graze_pair_options;

#endif
