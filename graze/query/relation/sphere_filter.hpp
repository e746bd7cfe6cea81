// SPDX-License-Identifier: MIT
// Filters for a sphere against a point, an axis-aligned box or a ray: decide, branch-free, all pairs but those that
// nearly touch, and leave those to the precise closed forms of bounded.hpp. No answer means "too close to tell", too
// large or small to square, or NaN.
#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// The verdict on a squared distance and a squared reach, each off by 3 epsilon of itself at most. They are compared
/// with the tolerance tolerance::squares, and with that of the smallest numbers, whose rounding is coarser.
template <Scalar T>
[[gnu::always_inline]] inline std::optional<Relation> filter_of_squares(T squared_distance, T squared_reach) {
  const T slack = tolerance::squares<T> * (squared_distance + squared_reach) + std::numeric_limits<T>::min();
  if (!(std::fabs(squared_distance - squared_reach) > slack)) return std::nullopt;
  return squared_distance < squared_reach ? Relation::overlapping : Relation::apart;
}

/// The verdict on two points, widened by `reach` in all.
template <Dim N, Scalar T>
[[gnu::always_inline]] inline std::optional<Relation> filter_of_spheres(const Vec<N, T>& a, const Vec<N, T>& b,
                                                                        T reach) {
  T squared_distance = 0;
  for (Dim i = 0; i < N; ++i) squared_distance += (b[i] - a[i]) * (b[i] - a[i]);
  return filter_of_squares(squared_distance, reach * reach);
}

/// The verdict on a point, widened by `reach`, and a box. |x| + x is twice what x is above zero, and NaN for NaN.
template <Dim N, Scalar T>
[[gnu::always_inline]] inline std::optional<Relation> filter_of_sphere(const Vec<N, T>& center, const Aabb<N, T>& box,
                                                                       T reach) {
  T four_squares = 0;
  for (Dim i = 0; i < N; ++i) {
    const T below = box.min[i] - center[i];
    const T above = center[i] - box.max[i];
    const T twice_outside = (std::fabs(below) + below) + (std::fabs(above) + above);  // one of the two is zero
    four_squares += twice_outside * twice_outside;
  }
  return filter_of_squares(four_squares, T(4) * (reach * reach));
}

/// x, or 0 if x is negative; NaN for NaN. Arithmetic, because a branch would be mispredicted half of the time.
inline double above_zero(double x) { return 0.5 * (x + std::fabs(x)); }

/// The verdict on a ray from zero and a sphere. The squared distance of the center from the ray, |c|^2 - (c.d)^2 / d.d
/// or |c|^2, is known to 10 epsilon of |c|^2; where the precise test lets the ray end, up to four times as far as the
/// sphere reaches, its band is 300 epsilon of that.
template <Dim N>
std::optional<Relation> filter_of_ray_and_sphere(const Vec<N, double>& direction, const Vec<N, double>& center,
                                                 double radius) {
  const double along = above_zero(dot(center, direction));
  const double whole = dot(direction, direction);
  const double squares = dot(center, center) + radius * radius;
  // All products are in the range of double.
  if (!(whole > 0x1p-400 && whole < 0x1p400 && squares > 0x1p-400 && squares < 0x1p400)) return std::nullopt;
  const double squared_distance = dot(center, center) - along * (along / whole);
  const double squared_radius = radius * radius;
  if (!(std::fabs(squared_distance - squared_radius) > tolerance::ray_filter * squares)) return std::nullopt;
  return squared_distance < squared_radius ? Relation::overlapping : Relation::apart;
}

}  // namespace graze::detail
