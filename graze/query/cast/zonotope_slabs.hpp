// SPDX-License-Identifier: MIT
// The Minkowski difference of two zonotopes, inflated by a radius, and when a point that moves from zero is between all
// pairs of its faces (moving separating axes). Include shape_cast.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/convex/zonotope.hpp>
#include <graze/query/ray/verdict_box.hpp>

namespace graze::detail {

/// All center + sum of u[i] * half_edges[i] with |u[i]| <= 1, inflated by the radius. `directions[i]` is parallel to
/// half_edges[i], and not zero even if that is zero because a box is flat.
template <Dim N, std::size_t Edges>
struct RoundedZonotope {
  Vec<N, double> center;
  std::array<Vec<N, double>, Edges> directions;
  std::array<Vec<N, double>, Edges> half_edges;
  double radius;
};

/// The set b - a of two zonotopes: the edges of a come first.
template <Dim N, std::size_t A, std::size_t B>
RoundedZonotope<N, A + B> difference_of(const Zonotope<N, A>& a, const Zonotope<N, B>& b, double radius) {
  RoundedZonotope<N, A + B> result;
  result.center = between_centers(a, b);
  result.radius = radius;
  for (std::size_t i = 0; i < A; ++i) {
    result.directions[i] = a.directions[i];
    result.half_edges[i] = a.half_edges[i];
  }
  for (std::size_t i = 0; i < B; ++i) {
    result.directions[A + i] = b.directions[i];
    result.half_edges[A + i] = b.half_edges[i];
  }
  return result;
}

/// A bound on the sum of the coordinates' magnitudes of every point.
template <Dim N, std::size_t Edges>
double size_of(const RoundedZonotope<N, Edges>& solid) {
  double size = sum_abs(solid.center) + solid.radius;
  for (const Vec<N, double>& edge : solid.half_edges) size += sum_abs(edge);
  return size;
}

/// The extent of the zonotope from its center along a direction, in units of its length, without the radius.
template <Dim N, std::size_t Edges>
[[gnu::always_inline]] inline double reach_along(const RoundedZonotope<N, Edges>& solid,
                                                 const Vec<N, double>& direction) {
  double reach = 0;
  for (const Vec<N, double>& edge : solid.half_edges) reach += std::fabs(dot(direction, edge));
  return reach;
}

/// When a point that moves from zero along `motion`, with its end at t = 1, is between the two supporting planes across
/// each of some axes: a closed interval for each, whose intersection counts (the slabs of Kay and Kajiya, 1986, with
/// the axes of Gottschalk, Lin, Manocha, 1996). Every axis is valid, however it was rounded, since the planes across it
/// bound the set; for nearly parallel edges, the product is perpendicular to both, so that no point of their face is
/// off the plane by more than rounding.
template <Dim N>
class AxisTimes {
 public:
  /// `size` is that of the set; if two times differ by less than the time to move by tolerance::ray_side of that across
  /// a plane, their order is uncertain.
  AxisTimes(const Vec<N, double>& center, const Vec<N, double>& motion, double radius, double size)
      : center_(center), motion_(motion), radius_(radius), margin_(tolerance::ray_side * size) {}

  /// Adds the planes perpendicular to `axis` (any nonzero length), between which the set without its radius has this
  /// extent.
  [[gnu::always_inline]] inline void add(const Vec<N, double>& axis, double reach) {
    // For an axis perpendicular to the motion, the point is between its planes always or never: these times are
    // effectively infinite.
    const double slope = dot(axis, motion_);
    const double inverse = 1 / std::max(std::fabs(slope), least_slope);
    const double middle = slope < 0 ? -dot(axis, center_) : dot(axis, center_);
    const double length = radius_ > 0 ? std::sqrt(dot(axis, axis)) : 0;
    const double near = (middle - reach - radius_ * length) * inverse;
    const double far = (middle + reach + radius_ * length) * inverse;
    const double slack = margin_ * sum_abs(axis) * inverse;
    first_ = std::max(first_, near - slack);
    last_ = std::min(last_, far + slack);
    surely_first_ = std::max(surely_first_, near + slack);
    surely_last_ = std::min(surely_last_, far - slack);
    if (!(near > enter_)) return;
    enter_ = near;
    normal_ = slope < 0 ? -axis : axis;
  }

  /// Whether the point is never between all planes, even if they are moved out by the margin.
  bool are_missed() const { return first_ > last_; }
  /// Whether it is at some time, even if they are moved in.
  bool are_entered() const { return surely_first_ <= surely_last_; }

  /// The time at which the last plane is crossed, possibly before the start, and its normal, of any length, along the
  /// motion.
  double enter() const { return enter_; }
  const Vec<N, double>& normal() const { return normal_; }

 private:
  Vec<N, double> center_;
  Vec<N, double> motion_;
  double radius_;
  double margin_;
  double first_ = 0;
  double last_ = 1;
  double surely_first_ = 0;
  double surely_last_ = 1;
  double enter_ = -std::numeric_limits<double>::infinity();
  Vec<N, double> normal_ = Vec<N, double>(0.0);
};

/// Whether two directions, and with them the shapes along them, cannot be distinguished from parallel ones: `squared`
/// is the squared length of their cross product.
template <Dim N>
bool are_parallel(const Vec<N, double>& a, const Vec<N, double>& b, double squared) {
  return !(squared > tolerance::rounding * tolerance::rounding * (dot(a, a) * dot(b, b)));
}

template <std::size_t Edges>
[[gnu::always_inline]] inline double reach_beside(const RoundedZonotope<3, Edges>& solid, const Vec<3, double>& axis,
                                                  std::size_t i, std::size_t j) {
  double reach = 0;
  for (std::size_t k = 0; k < Edges; ++k) {
    if (k != i && k != j) reach += std::fabs(dot(axis, solid.half_edges[k]));
  }
  return reach;
}

/// The normals of all faces: each is spanned by two edges.
template <std::size_t Edges>
void add_axes(const RoundedZonotope<3, Edges>& solid, const Vec<3, double>&, AxisTimes<3>& times) {
#pragma GCC unroll 6
  for (std::size_t i = 0; i + 1 < Edges; ++i) {
#pragma GCC unroll 6
    for (std::size_t j = i + 1; j < Edges; ++j) {
      const Vec<3, double> axis = cross_of_directions(solid.directions[i], solid.directions[j]);
      if (are_parallel(solid.directions[i], solid.directions[j], dot(axis, axis))) continue;
      times.add(axis, reach_beside(solid, axis, i, j));
    }
  }
}

/// A parallelogram has sides as well. One as narrow as a segment has no plane: then the ends count, and the direction
/// from which its line is approached.
inline void add_axes(const RoundedZonotope<3, 2>& solid, const Vec<3, double>& motion, AxisTimes<3>& times) {
  const auto& [u, v] = solid.directions;
  const Vec<3, double> across = cross_of_directions(u, v);
  if (!are_parallel(u, v, dot(across, across))) {
    times.add(across, 0);
    const Vec<3, double> beside_u = cross(across, u);
    const Vec<3, double> beside_v = cross(across, v);
    times.add(beside_u, std::fabs(dot(beside_u, solid.half_edges[1])));
    times.add(beside_v, std::fabs(dot(beside_v, solid.half_edges[0])));
    return;
  }
  const Vec<3, double>& along = dot(u, u) >= dot(v, v) ? u : v;
  const double whole = dot(along, along);
  if (!(whole > 0)) return;
  times.add(along, reach_along(solid, along));
  const Vec<3, double> beside = motion - along * (dot(motion, along) / whole);
  if (dot(beside, beside) > tolerance::ray_side * dot(motion, motion)) times.add(beside, reach_along(solid, beside));
}

template <std::size_t Edges>
void add_axes(const RoundedZonotope<2, Edges>& solid, const Vec<2, double>&, AxisTimes<2>& times) {
  for (const Vec<2, double>& direction : solid.directions) {
    if (max_abs(direction) == 0) continue;
    const Vec<2, double> axis = perpendicular<double>(direction);
    times.add(axis, reach_along(solid, axis));
    if constexpr (Edges == 2) times.add(direction, reach_along(solid, direction));
  }
}

}  // namespace graze::detail
