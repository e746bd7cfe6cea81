// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <graze/broad/index/region.hpp>
#include <graze/broad/spatial_index.hpp>
#include <graze/math/motion.hpp>
#include <graze/math/platform/throw.hpp>
#include <graze/math/rotation.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// A box that moves along a vector from t = 0 to t = 1. Finds the boxes that it may touch, and when: a ray from zero
/// along the motion enters the box of all differences of their points.
template <Dim N>
class SweptBox {
 public:
  /// The box may have infinite sides; if it is empty, it enters no bounded box. The motion must be finite. Other boxes
  /// are grown by `growth` times their largest coordinate.
  SweptBox(const Aabb<N, double>& box, const Vec<N, double>& motion, double growth = 0)
      : box_(box), motion_(motion), growth_(growth) {}

  /// The t at which the boxes first share a point, with two roundings; none if they do not, or only by less than that.
  /// Never later for a box that contains another, because differences, quotients and maxima round monotonically.
  /// Infinite differences are correct: a difference that overflows is longer than any motion.
  template <class T>
  std::optional<double> touch(const Aabb<N, T>& other) const {
    const double slack = growth_ > 0 ? growth_ * finite_size(other) : 0;
    double enter = 0;
    double leave = 1;
    for (Dim i = 0; i < N; ++i) {
      const double low = static_cast<double>(other.min[i]) - slack - box_.max[i];
      const double high = static_cast<double>(other.max[i]) + slack - box_.min[i];
      if (motion_[i] == 0) {
        if (!(low <= 0 && high >= 0)) return std::nullopt;
        continue;
      }
      enter = std::max(enter, (motion_[i] > 0 ? low : high) / motion_[i]);
      leave = std::min(leave, (motion_[i] > 0 ? high : low) / motion_[i]);
    }
    if (!(enter <= leave * (1 + tolerance::ray_slabs))) return std::nullopt;
    return std::min(enter, 1.0);
  }

  /// A lower bound on that t; none only if they certainly share no point.
  template <class T>
  std::optional<double> entry(const Aabb<N, T>& other) const {
    std::optional<double> t = touch(other);
    if (t) *t *= 1 - tolerance::ray_slabs;
    return t;
  }

  /// A box in T around the whole path. It overlaps every box with coordinates up to `size` that has an entry.
  template <class T>
  Aabb<N, T> reach(double size) const {
    Aabb<N, T> around;
    for (Dim i = 0; i < N; ++i) {
      const double slack = 2 * growth_ * size + tolerance::rounding * std::fabs(motion_[i]);
      around.min[i] = round_down<T>(next_down(box_.min[i] + std::min(0.0, motion_[i]) - slack));
      around.max[i] = round_up<T>(next_up(box_.max[i] + std::max(0.0, motion_[i]) + slack));
    }
    return around;
  }

 private:
  Aabb<N, double> box_;
  Vec<N, double> motion_;
  double growth_;
};

/// The path of a box in an index. Throws std::invalid_argument for a box that no index accepts and a motion that is not
/// finite.
template <Dim N, class T>
SweptBox<N> swept_box_in_index(const Aabb<N, T>& box, const Vec<N, T>& motion) {
  require_box(box);
  if (!is_finite(motion))
    GRAZE_THROW(std::invalid_argument("SpatialIndex: the motion has a number that is not finite"));
  return {{wide<N, T>(box.min), wide<N, T>(box.max)}, wide<N, T>(motion)};
}

/// The length of a vector that may be infinite, or too long or short for squares.
template <Dim N>
double length_in_range(const Vec<N, double>& v) {
  const double size = max_abs(v);
  if (!(size > 0 && std::isfinite(size))) return size;
  const Vec<N, double> scaled = v / size;
  return size * std::sqrt(dot(scaled, scaled));
}

/// The path of a shape that translates, from its touching_bounds. Together with the touching_bounds of other shapes, no
/// box is missed whose shape `shape_cast` reports.
template <Dim N, class T>
SweptBox<N> swept_box_of(const Aabb<N, T>& grown, const Vec<N, T>& motion) {
  const Vec<N, double> way = wide<N, T>(motion);
  const double slack = tolerance::box_slack * sum_abs(way);
  return {{wide<N, T>(grown.min) - slack, wide<N, T>(grown.max) + slack}, way};
}

/// The same for a shape that also rotates, and for `time_of_impact`. Every point stays within a ball around the center,
/// and no farther from its start, apart from the translation, than the angle times its distance from the center.
template <Dim N, class T>
SweptBox<N> swept_box_of(const Aabb<N, T>& grown, const Motion<N, T>& motion) {
  // Shapes that come nearer than `impact` times their size and path count as touching. Size and path are sums of up to
  // eight lengths, none of which is above this one or the largest coordinate of the other shape.
  constexpr double growth = 16 * tolerance::impact;
  const Vec<N, double> center = wide<N, T>(motion.center);
  const Vec<N, double> way = wide<N, T>(motion.linear);
  const Aabb<N, double> box{wide<N, T>(grown.min), wide<N, T>(grown.max)};
  const double slack = growth * (finite_size(box) + max_abs(center) + max_abs(way));
  Aabb<N, double> turned{box.min - slack, box.max + slack};
  const Turn<N, double> turn(motion.angular);
  double angle = 0;
  if constexpr (N == 2) angle = std::fabs(turn);
  if constexpr (N == 3) angle = std::sqrt(dot(turn, turn));
  if (angle > 0) {
    const double reach = length_in_range(max(abs(box.min - center), abs(box.max - center))) + slack;
    const double most = std::min(angle, 2.0) * reach;
    turned = {max(turned.min - most, center - reach), min(turned.max + most, center + reach)};
  }
  return {turned, way, growth};
}

}  // namespace graze::detail
