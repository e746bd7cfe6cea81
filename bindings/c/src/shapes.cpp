// SPDX-License-Identifier: MIT
// Shapes are made, moved and read.
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <graze/math/rotation.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/transformed.hpp>

#include "arrays.hpp"
#include "shape_in.hpp"
#include "vectors.hpp"

namespace graze::c {
namespace {

graze_shape blank(graze_kind kind, graze_world world) {
  graze_shape shape{};
  shape.kind = kind;
  shape.world = world;
  return shape;
}

MeshKind mesh_kind_of(graze_mesh_kind kind) {
  if (kind == GRAZE_SURFACE) return MeshKind::surface;
  if (kind == GRAZE_SOLID) return MeshKind::solid;
  throw Error(GRAZE_INVALID_ARGUMENT, "kind is " + std::to_string(kind) + "; GRAZE_SURFACE or GRAZE_SOLID is needed");
}

template <Dim N, class T>
Mat<N, T> rotation_matrix(const graze_vec& axis, double radians) {
  if constexpr (N == 2) {
    return Mat<N, T>(rotation_from_angle(radians));
  } else {
    return Mat<N, T>(rotation_from_axis_angle(Vec<3, double>(axis.x, axis.y, axis.z), radians));
  }
}

}  // namespace
}  // namespace graze::c

using namespace graze;
using namespace graze::c;

graze_shape graze_make_point(graze_world world, graze_vec position) {
  graze_shape shape = blank(GRAZE_POINT, world);
  shape.as.point = position;
  return shape;
}

graze_shape graze_make_segment(graze_world world, graze_vec start, graze_vec end) {
  graze_shape shape = blank(GRAZE_SEGMENT, world);
  shape.as.segment = {start, end};
  return shape;
}

graze_shape graze_make_ray(graze_world world, graze_vec origin, graze_vec direction) {
  graze_shape shape = blank(GRAZE_RAY, world);
  shape.as.ray = {origin, direction};
  return shape;
}

graze_shape graze_make_sphere(graze_world world, graze_vec center, double radius) {
  graze_shape shape = blank(GRAZE_SPHERE, world);
  shape.as.sphere = {center, radius};
  return shape;
}

graze_shape graze_make_aabb(graze_world world, graze_vec min, graze_vec max) {
  graze_shape shape = blank(GRAZE_AABB, world);
  shape.as.aabb = {min, max};
  return shape;
}

graze_shape graze_make_obb(graze_world world, graze_vec center, graze_vec half_extents, graze_mat axes) {
  graze_shape shape = blank(GRAZE_OBB, world);
  shape.as.obb = {center, half_extents, axes};
  return shape;
}

graze_shape graze_make_plane(graze_world world, graze_vec normal, double offset) {
  graze_shape shape = blank(GRAZE_PLANE, world);
  shape.as.plane = {normal, offset};
  return shape;
}

graze_shape graze_make_half_space(graze_world world, graze_vec normal, double offset) {
  graze_shape shape = blank(GRAZE_HALF_SPACE, world);
  shape.as.half_space = {normal, offset};
  return shape;
}

graze_shape graze_make_triangle(graze_world world, graze_vec a, graze_vec b, graze_vec c) {
  graze_shape shape = blank(GRAZE_TRIANGLE, world);
  shape.as.triangle = {a, b, c};
  return shape;
}

graze_shape graze_make_capsule(graze_world world, graze_vec a, graze_vec b, double radius) {
  graze_shape shape = blank(GRAZE_CAPSULE, world);
  shape.as.capsule = {a, b, radius};
  return shape;
}

graze_status graze_make_rotation(graze_world world, graze_vec axis, double radians, graze_mat* out) {
  return guarded(__func__, [&] {
    graze_mat& result = required("out", out);
    in_world(world, [&]<Dim N, class T>(In<N, T>) { result = mat_out<N, T>(rotation_matrix<N, T>(axis, radians)); });
  });
}

graze_status graze_create_hull(graze_rows points, graze_shape* out) {
  return guarded(__func__, [&] {
    graze_shape& result = required("out", out);
    in_world(points.world, [&]<Dim N, class T>(In<N, T>) {
      const RowsIn<Vec<N, T>> corners("points", points);
      result = shape_out<N, T>(convex_hull_in_order<N, T>(corners.span()));
    });
  });
}

graze_status graze_create_compound(graze_world world, const graze_shape* parts, size_t count, graze_shape* out) {
  return guarded(__func__, [&] {
    graze_shape& result = required("out", out);
    in_world(world, [&]<Dim N, class T>(In<N, T>) {
      result = shape_out<N, T>(compound_of<N, T>(shapes_in<N, T>("parts", parts, count)));
    });
  });
}

graze_status graze_create_mesh(graze_rows vertices, const uint32_t (*faces)[3], size_t face_count, graze_mesh_kind kind,
                               graze_shape* out) {
  return guarded(__func__, [&] {
    graze_shape& result = required("out", out);
    require_array("faces", faces, face_count);
    const MeshKind kind_of_mesh = mesh_kind_of(kind);
    std::vector<std::array<std::uint32_t, 3>> corners;
    corners.reserve(face_count);
    for (std::size_t i = 0; i < face_count; ++i) corners.push_back({faces[i][0], faces[i][1], faces[i][2]});
    in_world(vertices.world, [&]<Dim N, class T>(In<N, T>) {
      const RowsIn<Vec<N, T>> points("vertices", vertices);
      result = shape_out<N, T>(mesh_of<N, T>(points.span(), corners, kind_of_mesh));
    });
  });
}

graze_status graze_destroy_geometry(graze_geometry geometry) {
  return guarded(__func__, [&] {
    if (geometry.handle != 0) geometries().end(geometry.handle);
  });
}

graze_status graze_vertices(const graze_shape* shape, graze_vec* out, size_t capacity, size_t* count) {
  return guarded(__func__, [&] {
    return on_shape("shape", shape, [&]<Dim N, class T>(const AnyShape<N, T>& any) {
      const Buffer<graze_vec> buffer(out, capacity, count);
      if (const auto* const mesh = std::get_if<Mesh<N, T>>(&any)) return buffer.fill(mesh->vertices(), vec_out<N, T>);
      const auto* const polytope = std::get_if<Polytope<N, T>>(&any);
      if (polytope == nullptr) refuse_kind("shape", shape->kind, "a polytope or mesh");
      return buffer.fill(polytope->vertices(), vec_out<N, T>);
    });
  });
}

graze_status graze_faces(const graze_shape* mesh, uint32_t (*out)[3], size_t capacity, size_t* count) {
  return guarded(__func__, [&] {
    return on_mesh("mesh", mesh, [&](const auto& in) {
      std::size_t& total = required("count", count);
      require_array("out", out, capacity);
      const auto faces = in.faces();
      for (std::size_t i = 0; i < faces.size() && i < capacity; ++i) std::copy_n(faces[i].data(), 3, out[i]);
      total = faces.size();
      return faces.size() > capacity ? GRAZE_TRUNCATED : GRAZE_OK;
    });
  });
}

graze_status graze_transformed(const graze_shape* shape, const graze_pose* pose, graze_shape* out) {
  return guarded(__func__, [&] {
    const graze_pose& given = required("pose", pose);
    graze_shape& result = required("out", out);
    on_shape("shape", shape, [&]<Dim N, class T>(const AnyShape<N, T>& any) {
      AnyShape<N, T> moved = transformed(any, pose_in<N, T>("pose", given));
      require_valid("the result", defect(moved));
      result = shape_out<N, T>(std::move(moved));
    });
  });
}

graze_status graze_check(const graze_shape* shape) {
  return guarded(__func__, [&] { on_shape("shape", shape, [](const auto&) {}); });
}
