// SPDX-License-Identifier: MIT
/// @file
/// The result of ray_cast(mesh, ray).
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include <graze/math/rounding.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/ray_hit.hpp>
#include <graze/shape/triangle.hpp>

namespace graze {

/// The face of a hit that is not on a face: that of a ray which starts inside a solid.
inline constexpr std::size_t no_face = std::numeric_limits<std::size_t>::max();

/// Where a ray meets a mesh.
template <Dim N, class T = float>
struct MeshHit : RayHit<N, T> {
  std::size_t face = no_face;  ///< Its index in `faces()`.
  /// The weights of the face's vertices whose sum is the point: from 0 to 1, together 1 up to rounding. Zero without a
  /// face.
  Vec<3, T> barycentric = Vec<3, T>(T(0));

  friend bool operator==(const MeshHit&, const MeshHit&) = default;
};

namespace detail {

/// How far a point is along an edge, from 0 to 1; 0 for an edge without length.
template <Dim N>
double share_along(const Vec<N, double>& edge, const Vec<N, double>& from_start) {
  const double squared = dot(edge, edge);
  return squared > 0 ? std::clamp(dot(edge, from_start) / squared, 0.0, 1.0) : 0;
}

inline double product(double a, double b) { return a * b; }
inline double product(const Vec<3, double>& a, const Vec<3, double>& b) { return dot(a, b); }

/// The weights of the corners of a triangle, of a point on it up to rounding; along its longest edge if it has no area.
template <Dim N, class T>
Vec<3, T> barycentric_of(const Triangle<N, T>& triangle, const Vec<N, T>& point) {
  const Vec<N, double> a = wide<N, T>(triangle.a);
  // Scaled to a largest coordinate of 1, so that no square leaves the range of numbers.
  Vec<N, double> to_b = wide<N, T>(triangle.b) - a;
  Vec<N, double> to_c = wide<N, T>(triangle.c) - a;
  Vec<N, double> to_point = wide<N, T>(point) - a;
  const double size = std::max(max_abs(to_b), max_abs(to_c));
  if (!(size > 0)) return {T(1), T(0), T(0)};
  to_b /= size;
  to_c /= size;
  to_point /= size;
  const auto area = accurate_cross(to_b, to_c);
  const double squared = product(area, area);
  double of_b = 0;
  double of_c = 0;
  if (squared > 0) {
    of_b = std::clamp(product(accurate_cross(to_point, to_c), area) / squared, 0.0, 1.0);
    of_c = std::clamp(product(accurate_cross(to_b, to_point), area) / squared, 0.0, 1.0 - of_b);
  } else if (dot(to_b, to_c) < 0) {
    of_c = share_along<N>(to_c - to_b, to_point - to_b);
    of_b = 1 - of_c;
  } else if (dot(to_b, to_b) > dot(to_c, to_c)) {
    of_b = share_along<N>(to_b, to_point);
  } else {
    of_c = share_along<N>(to_c, to_point);
  }
  return {static_cast<T>(1 - of_b - of_c), static_cast<T>(of_b), static_cast<T>(of_c)};
}

}  // namespace detail
}  // namespace graze
