// SPDX-License-Identifier: MIT
// The version, and the layout of all structs.
#include <array>
#include <cstddef>
#include <string>

#include "../graze.h"

namespace {

/// A struct, or a field of one.
struct Row {
  const char* name;
  std::size_t size;
  std::size_t offset;
  bool is_field;
};

// Only macros know names and offsets. A test reads the headers and finds what is missing here.
#define GRAZE_STRUCT(type) \
  Row { #type, sizeof(type), 0, false }
#define GRAZE_FIELD(type, field) \
  Row { #type "." #field, sizeof(type::field), offsetof(type, field), true }

constexpr std::array rows{GRAZE_STRUCT(graze_vec),
                          GRAZE_FIELD(graze_vec, x),
                          GRAZE_FIELD(graze_vec, y),
                          GRAZE_FIELD(graze_vec, z),
                          GRAZE_STRUCT(graze_mat),
                          GRAZE_FIELD(graze_mat, columns),
                          GRAZE_STRUCT(graze_pose),
                          GRAZE_FIELD(graze_pose, rotation),
                          GRAZE_FIELD(graze_pose, position),
                          GRAZE_STRUCT(graze_motion),
                          GRAZE_FIELD(graze_motion, linear),
                          GRAZE_FIELD(graze_motion, angular),
                          GRAZE_FIELD(graze_motion, center),
                          GRAZE_STRUCT(graze_geometry),
                          GRAZE_FIELD(graze_geometry, handle),
                          GRAZE_STRUCT(graze_segment),
                          GRAZE_FIELD(graze_segment, start),
                          GRAZE_FIELD(graze_segment, end),
                          GRAZE_STRUCT(graze_ray),
                          GRAZE_FIELD(graze_ray, origin),
                          GRAZE_FIELD(graze_ray, direction),
                          GRAZE_STRUCT(graze_sphere),
                          GRAZE_FIELD(graze_sphere, center),
                          GRAZE_FIELD(graze_sphere, radius),
                          GRAZE_STRUCT(graze_box),
                          GRAZE_FIELD(graze_box, min),
                          GRAZE_FIELD(graze_box, max),
                          GRAZE_STRUCT(graze_obb),
                          GRAZE_FIELD(graze_obb, center),
                          GRAZE_FIELD(graze_obb, half_extents),
                          GRAZE_FIELD(graze_obb, axes),
                          GRAZE_STRUCT(graze_plane),
                          GRAZE_FIELD(graze_plane, normal),
                          GRAZE_FIELD(graze_plane, offset),
                          GRAZE_STRUCT(graze_triangle),
                          GRAZE_FIELD(graze_triangle, a),
                          GRAZE_FIELD(graze_triangle, b),
                          GRAZE_FIELD(graze_triangle, c),
                          GRAZE_STRUCT(graze_capsule),
                          GRAZE_FIELD(graze_capsule, a),
                          GRAZE_FIELD(graze_capsule, b),
                          GRAZE_FIELD(graze_capsule, radius),
                          GRAZE_STRUCT(graze_shape),
                          GRAZE_FIELD(graze_shape, kind),
                          GRAZE_FIELD(graze_shape, world),
                          GRAZE_FIELD(graze_shape, as),
                          GRAZE_STRUCT(graze_mesh_report),
                          GRAZE_FIELD(graze_mesh_report, open_edges),
                          GRAZE_FIELD(graze_mesh_report, non_manifold_edges),
                          GRAZE_FIELD(graze_mesh_report, flipped_edges),
                          GRAZE_FIELD(graze_mesh_report, degenerate_faces),
                          GRAZE_FIELD(graze_mesh_report, duplicate_faces),
                          GRAZE_FIELD(graze_mesh_report, unused_vertices),
                          GRAZE_FIELD(graze_mesh_report, components),
                          GRAZE_FIELD(graze_mesh_report, is_closed),
                          GRAZE_STRUCT(graze_proximity),
                          GRAZE_FIELD(graze_proximity, distance),
                          GRAZE_FIELD(graze_proximity, point_a),
                          GRAZE_FIELD(graze_proximity, point_b),
                          GRAZE_FIELD(graze_proximity, normal),
                          GRAZE_FIELD(graze_proximity, error),
                          GRAZE_FIELD(graze_proximity, relation),
                          GRAZE_FIELD(graze_proximity, status),
                          GRAZE_STRUCT(graze_contact),
                          GRAZE_FIELD(graze_contact, point),
                          GRAZE_FIELD(graze_contact, normal),
                          GRAZE_FIELD(graze_contact, depth),
                          GRAZE_FIELD(graze_contact, point_a),
                          GRAZE_FIELD(graze_contact, point_b),
                          GRAZE_FIELD(graze_contact, error),
                          GRAZE_FIELD(graze_contact, status),
                          GRAZE_STRUCT(graze_manifold_point),
                          GRAZE_FIELD(graze_manifold_point, point),
                          GRAZE_FIELD(graze_manifold_point, point_a),
                          GRAZE_FIELD(graze_manifold_point, point_b),
                          GRAZE_FIELD(graze_manifold_point, depth),
                          GRAZE_FIELD(graze_manifold_point, feature_a),
                          GRAZE_FIELD(graze_manifold_point, feature_b),
                          GRAZE_FIELD(graze_manifold_point, index_a),
                          GRAZE_FIELD(graze_manifold_point, index_b),
                          GRAZE_FIELD(graze_manifold_point, part_a),
                          GRAZE_FIELD(graze_manifold_point, part_b),
                          GRAZE_STRUCT(graze_manifold),
                          GRAZE_FIELD(graze_manifold, points),
                          GRAZE_FIELD(graze_manifold, normal),
                          GRAZE_FIELD(graze_manifold, error),
                          GRAZE_FIELD(graze_manifold, count),
                          GRAZE_FIELD(graze_manifold, status),
                          GRAZE_STRUCT(graze_ray_hit),
                          GRAZE_FIELD(graze_ray_hit, t),
                          GRAZE_FIELD(graze_ray_hit, point),
                          GRAZE_FIELD(graze_ray_hit, normal),
                          GRAZE_FIELD(graze_ray_hit, error),
                          GRAZE_FIELD(graze_ray_hit, barycentric),
                          GRAZE_FIELD(graze_ray_hit, face),
                          GRAZE_FIELD(graze_ray_hit, status),
                          GRAZE_FIELD(graze_ray_hit, is_hit),
                          GRAZE_STRUCT(graze_impact),
                          GRAZE_FIELD(graze_impact, t),
                          GRAZE_FIELD(graze_impact, point),
                          GRAZE_FIELD(graze_impact, normal),
                          GRAZE_FIELD(graze_impact, error),
                          GRAZE_FIELD(graze_impact, status),
                          GRAZE_STRUCT(graze_mass),
                          GRAZE_FIELD(graze_mass, volume),
                          GRAZE_FIELD(graze_mass, centroid),
                          GRAZE_FIELD(graze_mass, inertia),
                          GRAZE_STRUCT(graze_rows),
                          GRAZE_FIELD(graze_rows, data),
                          GRAZE_FIELD(graze_rows, count),
                          GRAZE_FIELD(graze_rows, stride),
                          GRAZE_FIELD(graze_rows, world),
                          GRAZE_STRUCT(graze_pair),
                          GRAZE_FIELD(graze_pair, a),
                          GRAZE_FIELD(graze_pair, b),
                          GRAZE_STRUCT(graze_pair_contact),
                          GRAZE_FIELD(graze_pair_contact, pair),
                          GRAZE_FIELD(graze_pair_contact, manifold),
                          GRAZE_STRUCT(graze_ray_options),
                          GRAZE_FIELD(graze_ray_options, is_limited),
                          GRAZE_FIELD(graze_ray_options, is_exit),
                          GRAZE_FIELD(graze_ray_options, t_max),
                          GRAZE_STRUCT(graze_cast_options),
                          GRAZE_FIELD(graze_cast_options, ignore_initial_touch),
                          GRAZE_FIELD(graze_cast_options, target_distance),
                          GRAZE_STRUCT(graze_pair_options),
                          GRAZE_FIELD(graze_pair_options, any_order),
                          GRAZE_FIELD(graze_pair_options, threads),
                          GRAZE_FIELD(graze_pair_options, margin),
                          GRAZE_STRUCT(graze_scene),
                          GRAZE_FIELD(graze_scene, handle),
                          GRAZE_STRUCT(graze_id),
                          GRAZE_FIELD(graze_id, index),
                          GRAZE_FIELD(graze_id, generation),
                          GRAZE_FIELD(graze_id, owner),
                          GRAZE_STRUCT(graze_id_pair),
                          GRAZE_FIELD(graze_id_pair, a),
                          GRAZE_FIELD(graze_id_pair, b),
                          GRAZE_STRUCT(graze_object_options),
                          GRAZE_FIELD(graze_object_options, name),
                          GRAZE_FIELD(graze_object_options, user),
                          GRAZE_FIELD(graze_object_options, ignored_layers),
                          GRAZE_FIELD(graze_object_options, layer),
                          GRAZE_FIELD(graze_object_options, is_fixed),
                          GRAZE_STRUCT(graze_object),
                          GRAZE_FIELD(graze_object, options),
                          GRAZE_FIELD(graze_object, box),
                          GRAZE_STRUCT(graze_query),
                          GRAZE_FIELD(graze_query, ignored_layers),
                          GRAZE_FIELD(graze_query, except),  // NOLINT(bugprone-sizeof-expression): of the pointer
                          GRAZE_FIELD(graze_query, except_count),
                          GRAZE_FIELD(graze_query, ignore_initial_touch),
                          GRAZE_STRUCT(graze_near_object),
                          GRAZE_FIELD(graze_near_object, id),
                          GRAZE_FIELD(graze_near_object, distance),
                          GRAZE_STRUCT(graze_near_pair),
                          GRAZE_FIELD(graze_near_pair, pair),
                          GRAZE_FIELD(graze_near_pair, distance),
                          GRAZE_STRUCT(graze_object_hit),
                          GRAZE_FIELD(graze_object_hit, id),
                          GRAZE_FIELD(graze_object_hit, hit),
                          GRAZE_STRUCT(graze_object_impact),
                          GRAZE_FIELD(graze_object_impact, id),
                          GRAZE_FIELD(graze_object_impact, impact),
                          GRAZE_STRUCT(graze_object_touch),
                          GRAZE_FIELD(graze_object_touch, id),
                          GRAZE_FIELD(graze_object_touch, manifold),
                          GRAZE_STRUCT(graze_object_contact),
                          GRAZE_FIELD(graze_object_contact, pair),
                          GRAZE_FIELD(graze_object_contact, manifold)};

std::string layout() {
  std::string text;
  for (const Row& row : rows) {
    text += row.name;
    if (row.is_field) text += " " + std::to_string(row.offset);
    text += " " + std::to_string(row.size) + "\n";
  }
  return text;
}

}  // namespace

static_assert(GRAZE_VERSION == GRAZE_C_VERSION, "GRAZE_VERSION in graze.h must be the version in CMakeLists.txt");

int32_t graze_version(void) { return GRAZE_VERSION; }

const char* graze_layout(void) {
  try {
    static const std::string text = layout();
    return text.c_str();
  } catch (...) {
    return "";
  }
}
