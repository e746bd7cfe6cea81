// SPDX-License-Identifier: MIT
/// @file
/// The result of ray_cast(mesh, ray).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
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

inline double size_of_area(double area) { return std::fabs(area); }
inline double size_of_area(const Vec<3, double>& area) { return max_abs(area); }

inline double product(double a, double b) { return a * b; }
inline double product(const Vec<3, double>& a, const Vec<3, double>& b) { return dot(a, b); }

/// The weights of the corners of a triangle, of a point on it up to rounding. If the point is beside the triangle,
/// which has perhaps no area, those of the nearest point of its edges.
template <Dim N, class T>
Vec<3, T> barycentric_of(const Triangle<N, T>& triangle, const Vec<N, T>& point) {
  const T largest = std::max({max_abs(triangle.a), max_abs(triangle.b), max_abs(triangle.c)});
  const double scale = scale_to_moderate(static_cast<double>(largest));  // so that no difference overflows
  const Vec<N, double> a = wide<N, T>(triangle.a) * scale;
  Vec<N, double> to_b = wide<N, T>(triangle.b) * scale - a;
  Vec<N, double> to_c = wide<N, T>(triangle.c) * scale - a;
  Vec<N, double> to_point = wide<N, T>(point) * scale - a;
  const double size = std::max(max_abs(to_b), max_abs(to_c));
  if (!(size > 0)) return {T(1), T(0), T(0)};
  // To a largest coordinate of 1, so that no square leaves the range of numbers.
  to_b /= size;
  to_c /= size;
  to_point /= size;
  auto area = accurate_cross(to_b, to_c);
  const double height = size_of_area(area);
  if (height > least_product_with_error) {
    area /= height;
    const double squared = product(area, area);
    const double of_b = product(accurate_cross(to_point, to_c) / height, area) / squared;
    const double of_c = product(accurate_cross(to_b, to_point) / height, area) / squared;
    const double of_a = 1 - of_b - of_c;
    if (of_a >= 0 && of_b >= 0 && of_c >= 0) return {static_cast<T>(of_a), static_cast<T>(of_b), static_cast<T>(of_c)};
  }
  Vec<3, T> nearest(T(1), T(0), T(0));
  double least = std::numeric_limits<double>::infinity();
  const std::array<Vec<N, double>, 3> corners = {Vec<N, double>(0.0), to_b, to_c};
  for (Dim i = 0; i < 3; ++i) {
    const Dim next = (i + 1) % 3;
    const Vec<N, double> from_start = to_point - corners[static_cast<std::size_t>(i)];
    const Vec<N, double> edge = corners[static_cast<std::size_t>(next)] - corners[static_cast<std::size_t>(i)];
    const double share = share_along<N>(edge, from_start);
    const Vec<N, double> beside = from_start - edge * share;
    if (!(dot(beside, beside) < least)) continue;
    least = dot(beside, beside);
    nearest = Vec<3, T>(T(0));
    nearest[i] = static_cast<T>(1 - share);
    nearest[next] = static_cast<T>(share);
  }
  return nearest;
}

}  // namespace detail
}  // namespace graze
