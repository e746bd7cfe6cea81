// SPDX-License-Identifier: MIT
// The cores of capsules and boxes in the plane as one kind of thing, for boxes_2d.hpp: a rectangle, which may have no
// height. Include manifold.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <graze/math/vec.hpp>
#include <graze/query/patch/clipped.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/obb.hpp>

namespace graze::detail {

/// In double, seen from near the pair. The corners are at the center and a half edge, or minus that, along each of so
/// many axes: a segment has one.
template <std::size_t axes>
struct Core2d {
  using V = Vec<2, double>;

  V center = V(0.0);
  std::array<V, 2> half_edge{V(0.0), V(0.0)};
  std::array<V, 2> along{V(0.0), V(0.0)};  ///< The same of length 1.
  std::array<double, 2> half_length{0, 0};
  std::array<V, 2> normal{V(0.0), V(0.0)};  ///< Of length 1: of the sides across an axis, of those at half_edge.
  double radius = 0;

  /// The sum of the coordinates.
  double size() const {
    double sum = std::fabs(center.x) + std::fabs(center.y) + radius;
    for (std::size_t i = 0; i < axes; ++i) sum += std::fabs(half_edge[i].x) + std::fabs(half_edge[i].y);
    return sum;
  }

  double shortest() const { return axes == 1 ? half_length[0] : std::min(half_length[0], half_length[1]); }

  /// With how far along the axes a corner is, 1 or -1.
  V corner(const V& sides) const { return center + half_edge[0] * sides.x + half_edge[1] * sides.y; }

  /// One of two that belong to the axes. Never by a place that is looked up: arrays would have to be in memory for it.
  template <class V2>
  [[gnu::always_inline]] static V2 of_axis(bool is_second, const std::array<V2, 2>& of_axes) {
    return is_second ? of_axes[1] : of_axes[0];
  }

  /// The feature of the side across an axis, at its half edge or, with -1, against it.
  [[gnu::always_inline]] static Feature side(bool across_second, double at) {
    return {FeatureKind::edge, axes == 2 ? (across_second ? 2U : 0U) | (at > 0 ? 1U : 0U) : 0U};
  }
  /// Of the corner at one end of that: `end` along the other axis.
  [[gnu::always_inline]] static Feature corner_of_side(bool across_second, double at, double end) {
    return corner_feature(across_second ? V(end, at) : V(at, end));
  }
  [[gnu::always_inline]] static Feature corner_feature(const V& sides) {
    return {FeatureKind::vertex, (sides.x > 0 ? 1U : 0U) | (axes > 1 && sides.y > 0 ? 2U : 0U)};
  }

  /// On which side of the center along each axis a place is.
  V sides_of(const V& place) const {
    const V off = place - center;
    return {std::copysign(1.0, dot(off, half_edge[0])), std::copysign(1.0, dot(off, half_edge[1]))};
  }

  [[gnu::always_inline]] void set_edge(std::size_t i, const V& half) {
    half_edge[i] = half;
    half_length[i] = std::sqrt(dot(half, half));
    along[i] = half * (1 / half_length[i]);
  }
};

template <class T>
Core2d<1> core_2d(const Capsule<2, T>& capsule, const Vec<2, double>& origin) {
  const Vec<2, double> start = wide<2, T>(capsule.a) - origin;
  const Vec<2, double> end = wide<2, T>(capsule.b) - origin;
  Core2d<1> core;
  core.center = (start + end) * 0.5;
  core.set_edge(0, (end - start) * 0.5);
  core.normal[1] = perpendicular(core.along[0]);
  core.radius = static_cast<double>(capsule.radius);
  return core;
}

template <class T>
[[gnu::always_inline]] inline Core2d<2> core_2d(const Obb<2, T>& box, const Vec<2, double>& origin) {
  Core2d<2> core;
  core.center = wide<2, T>(box.center) - origin;
  const Mat<2, double> axes = wide_matrix<2, T>(box.axes);
  const Vec<2, double> half = wide<2, T>(box.half_extents);
  core.set_edge(0, axes[0] * half[0]);
  core.set_edge(1, axes[1] * half[1]);
  const double turn = std::copysign(1.0, cross_2d<double>(axes[0], axes[1]));
  core.normal[0] = perpendicular(core.along[1]) * -turn;
  core.normal[1] = perpendicular(core.along[0]) * turn;
  return core;
}

template <class T>
[[gnu::always_inline]] inline Core2d<2> core_2d(const Aabb<2, T>& box, const Vec<2, double>& origin) {
  const Vec<2, double> low = wide<2, T>(box.min) - origin;
  const Vec<2, double> high = wide<2, T>(box.max) - origin;
  const Vec<2, double> half = (high - low) * 0.5;
  Core2d<2> core;
  core.center = (low + high) * 0.5;
  core.half_edge = {Vec<2, double>(half.x, 0), Vec<2, double>(0, half.y)};
  core.half_length = {half.x, half.y};
  core.along = core.normal = {Vec<2, double>(1, 0), Vec<2, double>(0, 1)};
  return core;
}

/// Where a pair that begins with such a shape is seen from.
template <class T>
Vec<2, double> origin_2d(const Capsule<2, T>& capsule) {
  return wide<2, T>(capsule.a);
}
template <class T>
Vec<2, double> origin_2d(const Obb<2, T>& box) {
  return wide<2, T>(box.center);
}
template <class T>
Vec<2, double> origin_2d(const Aabb<2, T>& box) {
  return wide<2, T>(box.min);
}

}  // namespace graze::detail
