/* SPDX-License-Identifier: MIT */
/* The layout of the structs on every 64-bit machine: a change breaks programs that were compiled before, so it takes a
 * new minor version. */
#include <graze.h>

#define SIZE(type, bytes) typedef char size_of_##type[sizeof(type) == (bytes) ? 1 : -1]
#define OFFSET(type, field, bytes) typedef char offset_of_##type##_##field[offsetof(type, field) == (bytes) ? 1 : -1]

SIZE(graze_vec, 24);
SIZE(graze_mat, 72);
SIZE(graze_pose, 96);
SIZE(graze_motion, 72);
SIZE(graze_geometry, 8);
SIZE(graze_segment, 48);
SIZE(graze_ray, 48);
SIZE(graze_sphere, 32);
SIZE(graze_box, 48);
SIZE(graze_obb, 120);
SIZE(graze_plane, 32);
SIZE(graze_triangle, 72);
SIZE(graze_capsule, 56);
SIZE(graze_shape, 128);
OFFSET(graze_shape, world, 4);
OFFSET(graze_shape, as, 8);
SIZE(graze_mesh_report, 64);
OFFSET(graze_mesh_report, is_closed, 56);
SIZE(graze_proximity, 96);
OFFSET(graze_proximity, relation, 88);
SIZE(graze_contact, 120);
SIZE(graze_manifold_point, 104);
OFFSET(graze_manifold_point, part_b, 100);
SIZE(graze_manifold, 456);
OFFSET(graze_manifold, count, 448);
SIZE(graze_ray_hit, 104);
OFFSET(graze_ray_hit, is_hit, 100);
SIZE(graze_impact, 72);
SIZE(graze_mass, 104);
SIZE(graze_pair, 8);
SIZE(graze_pair_contact, 464);
SIZE(graze_ray_options, 16);
SIZE(graze_cast_options, 16);
SIZE(graze_pair_options, 16);
SIZE(graze_scene, 8);
SIZE(graze_id, 12);
SIZE(graze_id_pair, 24);
SIZE(graze_near_object, 24);
SIZE(graze_near_pair, 32);
SIZE(graze_object_hit, 120);
SIZE(graze_object_impact, 88);
SIZE(graze_object_touch, 472);
SIZE(graze_object_contact, 480);
#if UINTPTR_MAX == UINT64_MAX
SIZE(graze_rows, 32);
SIZE(graze_object_options, 32);
SIZE(graze_object, 80);
SIZE(graze_query, 32);
#endif
