/* SPDX-License-Identifier: MIT */
/* graze in C: what touches what, where, how deep, how far and when. C99 and C++; link libgraze_c. The manual is
 * docs/c.md.
 *
 * - One function for all worlds (graze_types.h): 2D and 3D, float and double. Answers are those of the C++ library.
 * - Functions that can fail return a graze_status, and their outputs come last. GRAZE_OK is zero, so `if (status)`
 *   means that there is no complete answer. graze_error_message tells what was wrong.
 * - Results of any number go to a buffer of the caller: `out` with room for `capacity`, null if that is 0. `count`
 *   becomes their full number; if it exceeds the capacity, the first ones are written and GRAZE_TRUNCATED is returned.
 * - The library keeps no pointer that it is given, and what `graze_create_...` makes lives until its
 *   `graze_destroy_...`.
 * - Functions may be called from any threads at the same time; for scenes see graze_scene.h.
 * - Nothing throws, and no argument crashes but a pointer to memory that is not the caller's.
 */
#ifndef GRAZE_H
#define GRAZE_H

#include "graze_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Errors, versions ---- */

/* The version of the library that runs: major * 10000 + minor * 100 + patch; compare with GRAZE_VERSION. Libraries with
 * equal major and minor numbers have the same functions and layouts of structs. */
GRAZE_API int32_t graze_version(void);
#define GRAZE_VERSION 100

/* What was wrong in the last call of this thread that failed: a sentence with the function, the argument and what is
 * allowed, in UTF-8; empty before the first error. Valid until the next error of this thread. */
GRAZE_API const char* graze_error_message(void);

/* "GRAZE_OK" and so on; "unknown" for other numbers. */
GRAZE_API const char* graze_status_name(graze_status status);

/* The sizes and offsets of all structs, for interfaces of other languages to compare with their own: a line
 * "graze_sphere 32" for each struct, followed by "graze_sphere.radius 24 8" for each field: offset and size, in bytes.
 * Empty if there is no memory. */
GRAZE_API const char* graze_layout(void);

/* ---- Shapes ---- */

/* Shapes of fixed size. They are not checked here: queries refuse what is not valid, as graze_check does. Structs that
 * are filled by hand are as good. */
GRAZE_API graze_shape graze_make_point(graze_world world, graze_vec position);
GRAZE_API graze_shape graze_make_segment(graze_world world, graze_vec start, graze_vec end);
GRAZE_API graze_shape graze_make_ray(graze_world world, graze_vec origin, graze_vec direction);
GRAZE_API graze_shape graze_make_sphere(graze_world world, graze_vec center, double radius);
GRAZE_API graze_shape graze_make_aabb(graze_world world, graze_vec min, graze_vec max);
GRAZE_API graze_shape graze_make_obb(graze_world world, graze_vec center, graze_vec half_extents, graze_mat axes);
GRAZE_API graze_shape graze_make_plane(graze_world world, graze_vec normal, double offset);
GRAZE_API graze_shape graze_make_half_space(graze_world world, graze_vec normal, double offset);
GRAZE_API graze_shape graze_make_triangle(graze_world world, graze_vec a, graze_vec b, graze_vec c);
GRAZE_API graze_shape graze_make_capsule(graze_world world, graze_vec a, graze_vec b, double radius);

/* The rotation by an angle in radians about an axis of any length but zero, right-handed; in 2D about z, whatever the
 * axis. */
GRAZE_API graze_status graze_make_rotation(graze_world world, graze_vec axis, double radians, graze_mat* out);

/* The convex hull of points, at least one, in any order. The caller destroys it, as the next two. */
GRAZE_API graze_status graze_create_hull(graze_rows points, graze_shape* out);

/* The union of shapes of one world, in their order. It keeps copies: their geometries may be destroyed. */
GRAZE_API graze_status graze_create_compound(graze_world world, const graze_shape* parts, size_t count,
                                             graze_shape* out);

/* A mesh of vertices and faces, three indices each; seen from outside a solid they run counter-clockwise. Any faces are
 * accepted; graze_report_mesh tells what is unusual. `faces` may be null if there are none. */
GRAZE_API graze_status graze_create_mesh(graze_rows vertices, const uint32_t (*faces)[3], size_t face_count,
                                         graze_mesh_kind kind, graze_shape* out);

/* Ends a geometry. What was made from it, scenes and compounds, is unaffected. Does nothing for a handle of zero, and
 * refuses one that has ended. */
GRAZE_API graze_status graze_destroy_geometry(graze_geometry geometry);

/* The vertices of a polytope or mesh, and the faces of a mesh. The indices of contacts' features refer to them. */
GRAZE_API graze_status graze_vertices(const graze_shape* shape, graze_vec* out, size_t capacity, size_t* count);
GRAZE_API graze_status graze_faces(const graze_shape* mesh, uint32_t (*out)[3], size_t capacity, size_t* count);

/* The shape moved by a pose. An axis-aligned box becomes an oriented one. Of a geometry it makes a new one, which the
 * caller destroys and which shares its triangles. */
GRAZE_API graze_status graze_transformed(const graze_shape* shape, const graze_pose* pose, graze_shape* out);

/* GRAZE_OK for a valid shape; otherwise the error with which every query refuses it. */
GRAZE_API graze_status graze_check(const graze_shape* shape);

/* ---- Two shapes ---- */

/* Whether two shapes are apart, touch or overlap. */
GRAZE_API graze_status graze_relation_of(const graze_shape* a, const graze_shape* b, graze_relation* out);

/* Whether they share a point; touching counts. */
GRAZE_API graze_status graze_intersects(const graze_shape* a, const graze_shape* b, bool* out);

/* Their distance: 0 if and only if they touch or overlap, infinite for an empty compound or mesh. */
GRAZE_API graze_status graze_distance(const graze_shape* a, const graze_shape* b, double* out);

/* The distance and a nearest point of each; a common point if they meet, NaN for an empty compound or mesh. */
GRAZE_API graze_status graze_closest_points(const graze_shape* a, const graze_shape* b, graze_proximity* out);

/* The same with minus the depth as the distance of shapes that overlap, and the deepest points. */
GRAZE_API graze_status graze_separation(const graze_shape* a, const graze_shape* b, graze_proximity* out);

/* How deep they overlap and which way out is shortest. Shapes up to `margin` apart have contacts, too, of negative
 * depth. GRAZE_NONE if they are farther apart. */
GRAZE_API graze_status graze_contact_of(const graze_shape* a, const graze_shape* b, double margin, graze_contact* out);

/* The contact points on which a physics engine rests them; GRAZE_NONE as for graze_contact_of. */
GRAZE_API graze_status graze_manifold_of(const graze_shape* a, const graze_shape* b, double margin,
                                         graze_manifold* out);

/* When a, moving by `motion` from t = 0 to 1, first touches b; GRAZE_NONE if it does not. Options may be null. */
GRAZE_API graze_status graze_shape_cast(const graze_shape* a, graze_vec motion, const graze_shape* b,
                                        const graze_cast_options* options, graze_impact* out);

/* When two shapes that move and rotate first touch; a motion that is null means that the shape rests. */
GRAZE_API graze_status graze_time_of_impact(const graze_shape* a, const graze_motion* motion_a, const graze_shape* b,
                                            const graze_motion* motion_b, graze_impact* out);

/* ---- One shape ---- */

/* Whether a point belongs to a shape, its surface included. */
GRAZE_API graze_status graze_contains(const graze_shape* shape, graze_vec point, bool* out);

/* The nearest point of a shape, the point itself if it is inside; NaN for an empty compound or mesh. */
GRAZE_API graze_status graze_closest_point(const graze_shape* shape, graze_vec point, graze_vec* out);

/* The nearest point of its surface. */
GRAZE_API graze_status graze_closest_boundary_point(const graze_shape* shape, graze_vec point, graze_vec* out);

/* The distance from its surface, negative inside; infinite for an empty compound or mesh. */
GRAZE_API graze_status graze_signed_distance(const graze_shape* shape, graze_vec point, double* out);

/* Where a ray enters a shape: GRAZE_NONE if it misses. Of a mesh, also which face and where on it. The options may
 * be null. */
GRAZE_API graze_status graze_ray_cast(const graze_shape* shape, const graze_ray* ray, const graze_ray_options* options,
                                      graze_ray_hit* out);

/* The box around a shape, rounded outward; infinite where the shape is, and with min above max if it is empty. */
GRAZE_API graze_status graze_bounds(const graze_shape* shape, graze_box* out);

/* Volume, centroid and inertia. */
GRAZE_API graze_status graze_mass_properties(const graze_shape* shape, graze_mass* out);

/* How often the faces of a mesh run around a point: 1 inside a closed mesh, 0 outside; fractions for open ones. */
GRAZE_API graze_status graze_winding_number(const graze_shape* mesh, graze_vec point, double* out);

/* What is unusual about a mesh; a closed one without faults has zero everywhere but in `components`. */
GRAZE_API graze_status graze_report_mesh(const graze_shape* mesh, graze_mesh_report* out);

/* The pairs of faces of two meshes that share a point, and those of one mesh that share more than their common vertices
 * and edges; decided exactly, ascending. */
GRAZE_API graze_status graze_touching_faces(const graze_shape* mesh_a, const graze_shape* mesh_b, graze_pair* out,
                                            size_t capacity, size_t* count);
GRAZE_API graze_status graze_self_intersections(const graze_shape* mesh, graze_pair* out, size_t capacity,
                                                size_t* count);

/* ---- Many at once, on `threads` threads; 0: all. Answers are those of single calls and do not depend on them. ---- */

/* Every pair of boxes that share a point, once, with a < b. Boxes may be infinite; NaN is refused. */
GRAZE_API graze_status graze_overlapping_pairs(graze_rows boxes, const graze_pair_options* options, graze_pair* out,
                                               size_t capacity, size_t* count);

/* Every pair of a box of one array (a) and a box of another (b). */
GRAZE_API graze_status graze_overlapping_pairs_between(graze_rows boxes_a, graze_rows boxes_b,
                                                       const graze_pair_options* options, graze_pair* out,
                                                       size_t capacity, size_t* count);

/* Receives pairs in blocks, in the calling thread; returns whether to go on. It must return: no exception and
 * no longjmp. */
typedef bool (*graze_pair_visitor)(const graze_pair* pairs, size_t count, void* context);

/* The pairs of graze_overlapping_pairs as they are found, in any order, without a buffer for all of them. */
GRAZE_API graze_status graze_visit_overlapping_pairs(graze_rows boxes, const graze_pair_options* options,
                                                     graze_pair_visitor visit, void* context);

/* Those of the candidates whose shapes intersect, in their order. */
GRAZE_API graze_status graze_touching_pairs(const graze_shape* shapes, size_t shape_count, const graze_pair* candidates,
                                            size_t candidate_count, uint32_t threads, graze_pair* out, size_t capacity,
                                            size_t* count);

/* The contact points of those candidates, in their order. */
GRAZE_API graze_status graze_contacts(const graze_shape* shapes, size_t shape_count, const graze_pair* candidates,
                                      size_t candidate_count, uint32_t threads, graze_pair_contact* out,
                                      size_t capacity, size_t* count);

/* An answer for each ray or point, in their order: `out` has room for them. */
GRAZE_API graze_status graze_ray_casts(const graze_shape* shape, graze_rows rays, const graze_ray_options* options,
                                       uint32_t threads, graze_ray_hit* out);
GRAZE_API graze_status graze_contains_points(const graze_shape* shape, graze_rows points, uint32_t threads, bool* out);
GRAZE_API graze_status graze_closest_points_to(const graze_shape* shape, graze_rows points, uint32_t threads,
                                               graze_vec* out);
GRAZE_API graze_status graze_signed_distances(const graze_shape* shape, graze_rows points, uint32_t threads,
                                              double* out);
GRAZE_API graze_status graze_winding_numbers(const graze_shape* mesh, graze_rows points, uint32_t threads, double* out);

#ifdef __cplusplus
}
#endif

#include "graze_scene.h"

#endif
