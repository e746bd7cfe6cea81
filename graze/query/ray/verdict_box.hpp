// SPDX-License-Identifier: MIT
// The closed forms of ray_cast.hpp for boxes. Include ray_cast.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/ray/verdict.hpp>
#include <graze/query/relation/unbounded.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>

namespace graze::detail {

/// The range of t in which a path is between two sides of a box (Kay and Kajiya, "Ray tracing complex scenes", 1986).
/// The default is an axis along which the box is infinite: the third one of a 2D box.
struct Slab {
  double near = -std::numeric_limits<double>::infinity();
  double far = std::numeric_limits<double>::infinity();
  double slack = 0;  ///< The change of t that moves the path by the margin across a side.

  double earliest() const { return near - slack; }
  double latest() const { return far + slack; }
  Slab without_slack() const { return {near, far, 0}; }
};

/// Coordinates of a direction are treated as at least this large. If the path does not move along an axis, it is
/// between the sides always or never: the inverse is so large that the slab is practically infinite, but finite, so
/// that zero is never multiplied by infinity.
inline constexpr double least_slope = 0x1p-500;

[[gnu::always_inline]] inline Slab slab_between(double min, double max, double slope, double margin) {
  const double inverse = std::fabs(slope) > least_slope ? 1 / slope : 1 / least_slope;
  const double to_min = min * inverse;
  const double to_max = max * inverse;
  return {std::min(to_min, to_max), std::max(to_min, to_max), margin * std::fabs(inverse)};
}

/// A 3D box and a path from zero.
struct PathAtBox {
  Vec<3, double> min;
  Vec<3, double> max;
  Vec<3, double> direction;
  double far;  ///< As in Path.
};

/// The slabs of a box. They are named, without arrays or loops, so that compilers keep all of it in registers.
struct Slabs {
  Slab x;
  Slab y;
  Slab z;

  /// Whether the path from 0 to t_max is outside of the box even if its sides are moved outwards by the slack. True for
  /// NaN.
  [[gnu::always_inline]] inline bool are_missed(double t_max) const {
    const double enter = std::max(std::max(x.earliest(), y.earliest()), std::max(z.earliest(), 0.0));
    const double leave = std::min(std::min(x.latest(), y.latest()), std::min(z.latest(), t_max));
    return !(enter <= leave) || std::isnan(x.slack);
  }

  /// Whether the path is between all sides at once, by more than the slack where two axes are compared: of one axis the
  /// near side comes first even if the box is flat.
  [[gnu::always_inline]] inline bool are_entered(double t_max) const {
    const auto enters = [t_max](const Slab& one, const Slab& two, const Slab& three) {
      const double leave = std::min(std::min(two.far - two.slack, three.far - three.slack), t_max);
      return one.near + one.slack <= leave && one.far >= one.slack;
    };
    return enters(x, y, z) && enters(y, z, x) && enters(z, x, y);
  }
};

template <Dim N>
[[gnu::always_inline]] inline Slabs slabs_of(const PathAtBox& path, double relative_margin) {
  const double margin = relative_margin * (sum_abs(path.min) + sum_abs(path.max) + path.far);
  return {slab_between(path.min.x, path.max.x, path.direction.x, margin),
          slab_between(path.min.y, path.max.y, path.direction.y, margin),
          N == 2 ? Slab() : slab_between(path.min.z, path.max.z, path.direction.z, margin)};
}

/// Where a path meets a box, in the box's own axes.
struct HitOfBox {
  RayVerdict verdict = RayVerdict::misses;
  double t = 0;
  Vec<3, double> point = Vec<3, double>(0.0);
  Vec<3, double> side = Vec<3, double>(0.0);  ///< -1 or 1 on the axis whose min or max side is met; else zero.
  bool is_known = true;                       ///< False if the path is beside that side only before or after.
};

/// One coordinate of a point on a box: that of the side that is met, or any between the two.
[[gnu::always_inline]] inline double coordinate_on(double side, double any, double min, double max) {
  const double low = side > 0 ? max : min;
  const double high = side < 0 ? min : max;
  return std::min(std::max(any, low), high);
}

/// Where the path enters a box that it hits, if its sides are moved outwards by the slack of `slabs`.
[[gnu::always_inline]] inline HitOfBox enter_box(RayVerdict verdict, const PathAtBox& path, const Slabs& slabs,
                                                 double t_max) {
  const auto& [min, max, direction, far] = path;
  const bool is_x = slabs.x.earliest() >= std::max(slabs.y.earliest(), slabs.z.earliest());
  const bool is_y = !is_x && slabs.y.earliest() >= slabs.z.earliest();
  const double near = is_x ? slabs.x.near : is_y ? slabs.y.near : slabs.z.near;
  HitOfBox hit{verdict};
  if (!(near >= 0)) return hit;
  const double slope = is_x ? direction.x : is_y ? direction.y : direction.z;
  const double low = is_x ? min.x : is_y ? min.y : min.z;
  const double high = is_x ? max.x : is_y ? max.y : max.z;
  // Divided again, which rounds once less, unless the near side belongs to an axis along which the path does not move.
  const double t = std::fabs(slope) > least_slope ? (slope > 0 ? low : high) / slope : near;
  const double leave = std::min(std::min(slabs.x.latest(), slabs.y.latest()), std::min(slabs.z.latest(), t_max));
  hit.t = std::min(t, std::max(0.0, leave));
  hit.is_known = hit.t == t;
  const double side = slope > 0 ? -1 : 1;
  hit.side = {is_x ? side : 0, is_y ? side : 0, is_x || is_y ? 0 : side};
  hit.point = {coordinate_on(hit.side.x, direction.x * hit.t, min.x, max.x),
               coordinate_on(hit.side.y, direction.y * hit.t, min.y, max.y),
               coordinate_on(hit.side.z, direction.z * hit.t, min.z, max.z)};
  return hit;
}

/// What the slack moves across a side is moved by tolerance::ray_side of the box's size, so all verdicts are correct
/// for the true box. If it is touched after all, then by no more than rounding.
template <Dim N>
[[gnu::always_inline]] inline HitOfBox touch_of_box(const PathAtBox& path, double t_max) {
  const Slabs slabs = slabs_of<N>(path, tolerance::ray_side);
  if (slabs.are_missed(t_max)) return {};
  // A box that is entered by a margin is entered where the last side is crossed, however nearly the path runs along it.
  if (slabs.are_entered(t_max)) {
    return enter_box(RayVerdict::hits, path,
                     {slabs.x.without_slack(), slabs.y.without_slack(), slabs.z.without_slack()}, t_max);
  }
  return enter_box(RayVerdict::unclear, path, slabs_of<N>(path, tolerance::rounding), t_max);
}

/// The error of the point where a path meets a box: by rounding and, if it may only have come near a side, by the slack
/// of that.
[[gnu::always_inline]] inline double error_at_box(const HitOfBox& found, const PathAtBox& path) {
  const double size = sum_abs(path.min) + sum_abs(path.max);
  return tolerance::rounding * (found.verdict == RayVerdict::unclear ? 2 * size + path.far : size);
}

template <Dim N>
[[gnu::always_inline]] inline PathAtBox path_at(const Aabb<N, double>& box, const Vec<N, double>& direction,
                                                double far) {
  return {lifted(box.min), lifted(box.max), lifted(direction), far};
}

/// Whether ray_verdict_of returns a miss for the box. For most paths this is enough, and a verdict alone needs no
/// memory.
template <Dim N>
[[gnu::always_inline]] inline bool is_missed(const Aabb<N, double>& box, const Path<N>& path) {
  return slabs_of<N>(path_at(box, path.direction, path.far), tolerance::ray_side).are_missed(path.t_max);
}

template <Dim N>
[[gnu::always_inline]] inline RayFinding<N> ray_verdict_of(const Aabb<N, double>& box, const Path<N>& path) {
  const PathAtBox seen = path_at(box, path.direction, path.far);
  const HitOfBox found = touch_of_box<N>(seen, path.t_max);
  return {found.verdict,
          {found.t, Vec<N, double>(found.point), Vec<N, double>(found.side), error_at_box(found, seen)},
          found.is_known};
}

/// The box's own coordinates of a point on a side, or one that was rounded out of the box. A normal along no axis is
/// GJK's, and does not identify a side, however close to an axis it is.
template <Dim N, class T>
[[gnu::always_inline]] inline void put_on_surface(RawHit<N>& hit, const Aabb<N, T>& box) {
  const Vec<N, double> min = wide<N, T>(box.min);
  const Vec<N, double> max = wide<N, T>(box.max);
  int axes = 0;
  for (Dim i = 0; i < N; ++i) axes += hit.normal[i] != 0 ? 1 : 0;
  const Vec<N, double> side = hit.normal * (axes == 1 ? 1.0 : 0.0);
  hit.point.x = coordinate_on(side.x, hit.point.x, min.x, max.x);
  hit.point.y = coordinate_on(side.y, hit.point.y, min.y, max.y);
  if constexpr (N == 3) hit.point.z = coordinate_on(side.z, hit.point.z, min.z, max.z);
}

/// The rows of the inverse of a matrix, all multiplied by `determinant`.
template <Dim N>
struct Inverse;

template <>
struct Inverse<2> {
  Vec<2, double> x;
  Vec<2, double> y;
  double determinant;

  [[gnu::always_inline]] Vec<2, double> rows_times(const Vec<2, double>& v) const { return {dot(x, v), dot(y, v)}; }
  [[gnu::always_inline]] Vec<2, double> times_rows(const Vec<2, double>& v) const { return x * v.x + y * v.y; }
};

template <>
struct Inverse<3> {
  Vec<3, double> x;
  Vec<3, double> y;
  Vec<3, double> z;
  double determinant;

  [[gnu::always_inline]] Vec<3, double> rows_times(const Vec<3, double>& v) const {
    return {dot(x, v), dot(y, v), dot(z, v)};
  }
  [[gnu::always_inline]] Vec<3, double> times_rows(const Vec<3, double>& v) const {
    return x * v.x + y * v.y + z * v.z;
  }
};

[[gnu::always_inline]] inline Inverse<2> inverse_of(const Mat<2, double>& m) {
  return {{m[1].y, -m[1].x}, {-m[0].y, m[0].x}, cross_2d(m[0], m[1])};
}
[[gnu::always_inline]] inline Inverse<3> inverse_of(const Mat<3, double>& m) {
  const Vec<3, double> first = cross(m[1], m[2]);
  return {first, cross(m[2], m[0]), cross(m[0], m[1]), dot(first, m[0])};
}

/// The box in its own axes. They are orthonormal only up to rounding and the set is defined as stored, so coordinates
/// are found with their inverse; the transpose would be off by as much as they are. The inverse is not divided by the
/// determinant, which is positive or negative and nearly 1: box and direction are scaled alike.
template <Dim N>
[[gnu::always_inline]] inline RayFinding<N> ray_verdict_of(const Obb<N, double>& box, const Path<N>& path) {
  const Inverse<N> inverse = inverse_of(box.axes);
  const double scale = std::fabs(inverse.determinant);
  const double sign = inverse.determinant < 0 ? -1 : 1;
  const Vec<N, double> center = inverse.rows_times(box.center) * sign;
  const Vec<N, double> half = box.half_extents * scale;
  const Aabb<N, double> seen{center - half, center + half};
  const Vec<N, double> slope = inverse.rows_times(path.direction) * sign;
  const PathAtBox path_seen = path_at(seen, slope, path.far);
  const HitOfBox found = touch_of_box<N>(path_seen, path.t_max);
  const Vec<N, double> side(found.side);
  // The coordinates along the axis of the side that is met are exact.
  const Vec<N, double> place =
      (Vec<N, double>(found.point) - center) / scale * (1.0 - abs(side)) + box.half_extents * side;
  const bool is_inside = max_abs(side) == 0;
  return {found.verdict,
          {found.t, is_inside ? Vec<N, double>(0.0) : box.center + box.axes * place, inverse.times_rows(side) * sign,
           error_at_box(found, path_seen)},
          found.is_known};
}

}  // namespace graze::detail
