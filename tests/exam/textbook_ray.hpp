// SPDX-License-Identifier: MIT
// Where a ray enters, as in textbooks and tutorials, in the shapes' own number type: the distance from the origin, for
// a unit direction. Compared with graze, which does not use it.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/plane.hpp>
#include <graze/shape/sphere.hpp>
#include <graze/shape/triangle.hpp>

#include "exam/textbook.hpp"

namespace graze::exam::textbook {

/// The quadratic (Ericson 2005, 5.3.2).
template <class T>
std::optional<T> entry(const Sphere<3, T>& sphere, const Vec3<T>& origin, const Vec3<T>& way) {
  const Vec3<T> off = origin - sphere.center;
  const T b = dot(off, way);
  const T c = dot(off, off) - sphere.radius * sphere.radius;
  if (c > 0 && b > 0) return std::nullopt;
  const T discriminant = b * b - c;
  if (discriminant < 0) return std::nullopt;
  return std::max(-b - std::sqrt(discriminant), T(0));
}

/// The interval between one pair of planes, with the usual constant for parallel rays.
template <class T>
bool cut_to_slab(T start, T step, T half, std::pair<T, T>& inside) {
  constexpr T usual = T(1e-6);
  if (std::fabs(step) < usual) return std::fabs(start) <= half;
  const auto [first, last] = std::minmax({(-half - start) / step, (half - start) / step});
  inside = {std::max(inside.first, first), std::min(inside.second, last)};
  return inside.first <= inside.second;
}

/// Slab by slab (Ericson 2005, 5.3.3).
template <class T>
std::optional<T> entry(const Obb<3, T>& box, const Vec3<T>& origin, const Vec3<T>& way) {
  std::pair<T, T> inside{T(0), std::numeric_limits<T>::max()};
  for (Dim i = 0; i < 3; ++i) {
    const Vec3<T>& axis = box.axes[i];
    if (!cut_to_slab(dot(origin - box.center, axis), dot(way, axis), box.half_extents[i], inside)) return std::nullopt;
  }
  return inside.first;
}

template <class T>
std::optional<T> entry(const Aabb<3, T>& box, const Vec3<T>& origin, const Vec3<T>& way) {
  return entry(oriented(box), origin, way);
}

template <class T>
std::optional<T> entry(const Plane<3, T>& plane, const Vec3<T>& origin, const Vec3<T>& way) {
  const T t = (plane.offset - dot(plane.normal, origin)) / dot(plane.normal, way);
  return t >= 0 ? std::optional<T>(t) : std::nullopt;
}

/// Moeller and Trumbore 1997, with the usual constant.
template <class T>
std::optional<T> entry(const Triangle<3, T>& triangle, const Vec3<T>& origin, const Vec3<T>& way) {
  constexpr T usual = T(1e-6);
  const Vec3<T> edge_1 = triangle.b - triangle.a;
  const Vec3<T> edge_2 = triangle.c - triangle.a;
  const Vec3<T> p = cross(way, edge_2);
  const T determinant = dot(edge_1, p);
  if (std::fabs(determinant) < usual) return std::nullopt;
  const Vec3<T> to_start = origin - triangle.a;
  const T u = dot(to_start, p) / determinant;
  if (u < 0 || u > 1) return std::nullopt;
  const Vec3<T> q = cross(to_start, edge_1);
  const T v = dot(way, q) / determinant;
  if (v < 0 || u + v > 1) return std::nullopt;
  const T t = dot(edge_2, q) / determinant;
  return t >= 0 ? std::optional<T>(t) : std::nullopt;
}

}  // namespace graze::exam::textbook
