// SPDX-License-Identifier: MIT
// Shapes of C++ as those of C, each type by itself, for tests of the conversion that derives from descriptions.
#pragma once

#include <cstddef>
#include <type_traits>
#include <variant>
#include <vector>

#include <graze.h>
#include <gtest/gtest.h>

#include <graze/math/vec.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::test {

template <Dim N, class T>
inline constexpr graze_world world_of_c = std::is_same_v<T, double> ? (N == 2 ? GRAZE_2D : GRAZE_3D)
                                                                    : (N == 2 ? GRAZE_2D_FLOAT : GRAZE_3D_FLOAT);

/// In 2D, z is a number that must not matter.
template <Dim N, class T>
graze_vec vec_with_any_z(const Vec<N, T>& v) {
  if constexpr (N == 2) {
    return {double(v.x), double(v.y), 77};
  } else {
    return {double(v.x), double(v.y), double(v.z)};
  }
}

template <Dim N, class T>
graze_vec vec_of_c(const Vec<N, T>& v) {
  graze_vec result = vec_with_any_z<N, T>(v);
  if (N == 2) result.z = 0;
  return result;
}

/// A shape of C, whose geometry ends with it.
template <Dim N, class T>
class ShapeOfC {
 public:
  explicit ShapeOfC(const AnyShape<N, T>& shape)
      : shape_(std::visit([](const auto& held) { return made(held); }, shape)) {}
  ShapeOfC(const ShapeOfC&) = delete;
  ShapeOfC& operator=(const ShapeOfC&) = delete;
  ~ShapeOfC() {
    if (shape_.kind < GRAZE_POLYTOPE) return;
    EXPECT_EQ(graze_destroy_geometry(shape_.as.geometry), GRAZE_OK) << graze_error_message();
  }

  const graze_shape& operator*() const { return shape_; }

 private:
  static constexpr graze_world world = world_of_c<N, T>;

  static graze_vec vec(const Vec<N, T>& v) { return vec_with_any_z<N, T>(v); }
  static graze_rows rows(std::span<const Vec<N, T>> points) { return {points.data(), points.size(), 0, world}; }

  static graze_shape made(const Vec<N, T>& point) { return graze_make_point(world, vec(point)); }
  static graze_shape made(const Segment<N, T>& s) { return graze_make_segment(world, vec(s.start), vec(s.end)); }
  static graze_shape made(const Ray<N, T>& s) { return graze_make_ray(world, vec(s.origin), vec(s.direction)); }
  static graze_shape made(const Sphere<N, T>& s) {
    return graze_make_sphere(world, vec(s.center), static_cast<double>(s.radius));
  }
  static graze_shape made(const Aabb<N, T>& s) { return graze_make_aabb(world, vec(s.min), vec(s.max)); }
  static graze_shape made(const Obb<N, T>& s) {
    graze_mat axes{};
    for (Dim j = 0; j < N; ++j) axes.columns[j] = vec(s.axes[j]);
    return graze_make_obb(world, vec(s.center), vec(s.half_extents), axes);
  }
  static graze_shape made(const Plane<N, T>& s) {
    return graze_make_plane(world, vec(s.normal), static_cast<double>(s.offset));
  }
  static graze_shape made(const HalfSpace<N, T>& s) {
    return graze_make_half_space(world, vec(s.normal), static_cast<double>(s.offset));
  }
  static graze_shape made(const Triangle<N, T>& s) { return graze_make_triangle(world, vec(s.a), vec(s.b), vec(s.c)); }
  static graze_shape made(const Capsule<N, T>& s) {
    return graze_make_capsule(world, vec(s.a), vec(s.b), static_cast<double>(s.radius));
  }
  static graze_shape made(const Polytope<N, T>& s) {
    graze_shape result{};
    EXPECT_EQ(graze_create_hull(rows(s.vertices()), &result), GRAZE_OK) << graze_error_message();
    return result;
  }
  static graze_shape made(const Mesh<N, T>& s) {
    graze_shape result{};
    const graze_mesh_kind kind = s.kind() == MeshKind::solid ? GRAZE_SOLID : GRAZE_SURFACE;
    const auto* const faces = reinterpret_cast<const std::uint32_t(*)[3]>(s.faces().data());
    EXPECT_EQ(graze_create_mesh(rows(s.vertices()), faces, s.faces().size(), kind, &result), GRAZE_OK)
        << graze_error_message();
    return result;
  }
  static graze_shape made(const Compound<N, T>& s) {
    std::vector<graze_shape> parts;
    for (const Part<N, T>& part : s.parts) {
      parts.push_back(std::visit([](const auto& held) { return made(held); }, part.shape));
    }
    graze_shape result{};
    EXPECT_EQ(graze_create_compound(world, parts.data(), parts.size(), &result), GRAZE_OK) << graze_error_message();
    for (const graze_shape& part : parts) {
      if (part.kind >= GRAZE_POLYTOPE) {
        EXPECT_EQ(graze_destroy_geometry(part.as.geometry), GRAZE_OK);
      }
    }
    return result;
  }

  graze_shape shape_;
};

}  // namespace graze::test
