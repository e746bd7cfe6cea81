// SPDX-License-Identifier: MIT
// The first filters of a ray and a 2D box, axis-aligned or oriented. Include ray_cast.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include <graze/math/lanes/lanes.hpp>
#include <graze/math/lanes/paired.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/ray/verdict.hpp>
#include <graze/query/ray_hit.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/ray.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// Two slabs and a ray from zero, in double, as RaySlabFilter has three in float: with all sides moved outwards and
/// inwards by tolerance::ray_side of their size.
class RayTwoSlabs {
 public:
  [[gnu::always_inline]] void cross(LanePair low, LanePair high, LanePair slope, double t_max, double latest) {
    const LanePair inverse = 1.0 / slope;
    const LanePair sizes = magnitude(low) + magnitude(high);
    size_ = sizes[0] + sizes[1];
    const double margin = tolerance::ray_side * size_;
    const LanePair to_low = (low - margin) * inverse;
    const LanePair to_high = (high + margin) * inverse;
    const LanePair entered = smaller(to_low, to_high);
    const LanePair left = larger(to_low, to_high);
    const LanePair to_low_inside = (low + margin) * inverse;
    const LanePair to_high_inside = (high - margin) * inverse;
    const LanePair late = smaller(to_low_inside, to_high_inside);
    const LanePair early = larger(to_low_inside, to_high_inside);
    const double enter = std::max(entered[0], entered[1]);
    const double leave = std::min(std::min(left[0], left[1]), latest);
    const bool is_moderate = (size_ > 0x1p-400) & (size_ < 0x1p400);
    is_missed_ = is_moderate & (std::max(enter, 0.0) > leave) & (leave < 0x1p500);
    is_x_ = entered[0] > late[1];
    const bool is_y = entered[1] > late[0];
    const double last = is_x_ ? late[0] : late[1];
    const bool is_thick = ((high - low) > 2 * margin)[0] & ((high - low) > 2 * margin)[1];
    is_hit_ = is_moderate & is_thick & (is_x_ | is_y) & (enter > 0) & (last < std::min(early[0], early[1])) &
              (last < t_max) & (last < 0x1p500);
  }

  [[gnu::always_inline]] RayVerdict verdict() const {
    if (is_hit_) return RayVerdict::hits;
    return is_missed_ ? RayVerdict::misses : RayVerdict::unclear;
  }
  [[gnu::always_inline]] bool is_x() const { return is_x_; }
  [[gnu::always_inline]] double size() const { return size_; }

 private:
  [[gnu::always_inline]] static LanePair larger(LanePair a, LanePair b) { return a > b ? a : b; }
  [[gnu::always_inline]] static LanePair smaller(LanePair a, LanePair b) { return a < b ? a : b; }

  double size_ = 0;
  bool is_x_ = false;
  bool is_hit_ = false;
  bool is_missed_ = false;
};

template <class T>
class RayRectangleFilter {
 public:
  [[gnu::always_inline]] RayRectangleFilter(const Aabb<2, T>& box, const Ray<2, T>& ray, T t_max)
      : min_(box.min), max_(box.max), origin_(ray.origin), direction_(ray.direction) {
    slabs_.cross((min_ - origin_).xy, (max_ - origin_).xy, direction_.xy, static_cast<double>(t_max), latest_t(t_max));
  }

  [[gnu::always_inline]] RayVerdict verdict() const { return slabs_.verdict(); }

  [[gnu::always_inline]] std::optional<RayHit<2, T>> hit() const {
    const bool is_x = slabs_.is_x();
    const double slope = is_x ? direction_.xy[0] : direction_.xy[1];
    const LanePair sides = direction_.xy > 0.0 ? min_.xy : max_.xy;
    const double start = is_x ? origin_.xy[0] : origin_.xy[1];
    const double side = is_x ? sides[0] : sides[1];
    const double t = (side - start) / slope;
    const double other = is_x ? origin_.xy[1] + direction_.xy[1] * t : origin_.xy[0] + direction_.xy[0] * t;
    const double normal = std::copysign(1.0, -slope);
    return RayHit<2, T>{static_cast<T>(t),
                        Vec<2, T>(static_cast<T>(is_x ? side : other), static_cast<T>(is_x ? other : side)) + T(0),
                        {static_cast<T>(is_x ? normal : 0), static_cast<T>(is_x ? 0 : normal)},
                        Status::converged,
                        tolerance::rounding * slabs_.size()};
  }

 private:
  Pair2d min_;
  Pair2d max_;
  Pair2d origin_;
  Pair2d direction_;
  RayTwoSlabs slabs_;
};

template <class T>
[[gnu::always_inline]] inline RayRectangleFilter<T> quick_cast(const Aabb<2, T>& box, const Ray<2, T>& ray, T t_max) {
  return {box, ray, t_max};
}

/// Coordinates are found with the inverse of the axes, as in ray_verdict_of: each row is perpendicular to the other
/// axis.
template <class T>
class RayOrientedRectangleFilter {
 public:
  [[gnu::always_inline]] RayOrientedRectangleFilter(const Obb<2, T>& box, const Ray<2, T>& ray, T t_max)
      : origin_(ray.origin), direction_(ray.direction) {
    const Pair2d first(box.axes[0]);
    const Pair2d second(box.axes[1]);
    const double determinant = first.xy[0] * second.xy[1] - first.xy[1] * second.xy[0];
    const double sign = std::copysign(1.0, determinant);
    const LanePair rows_x = LanePair{second.xy[1], -first.xy[1]} * sign;
    const LanePair rows_y = LanePair{-second.xy[0], first.xy[0]} * sign;
    const Pair2d from_origin = Pair2d(box.center) - origin_;
    const LanePair center = rows_x * from_origin.xy[0] + rows_y * from_origin.xy[1];
    const LanePair half = Pair2d(box.half_extents).xy * std::fabs(determinant);
    low_ = center - half;
    high_ = center + half;
    slope_ = rows_x * direction_.xy[0] + rows_y * direction_.xy[1];
    rows_x_ = rows_x;
    rows_y_ = rows_y;
    slabs_.cross(low_, high_, slope_, static_cast<double>(t_max), latest_t(t_max));
  }

  [[gnu::always_inline]] RayVerdict verdict() const { return slabs_.verdict(); }

  [[gnu::always_inline]] std::optional<RayHit<2, T>> hit() const {
    const bool is_x = slabs_.is_x();
    const double slope = is_x ? slope_[0] : slope_[1];
    const LanePair sides = slope_ > 0.0 ? low_ : high_;
    const double t = (is_x ? sides[0] : sides[1]) / slope;
    const LanePair row{is_x ? rows_x_[0] : rows_x_[1], is_x ? rows_y_[0] : rows_y_[1]};
    const LanePair squares = row * row;
    const Pair2d normal(row * std::copysign(1 / std::sqrt(squares[0] + squares[1]), -slope));
    return RayHit<2, T>{static_cast<T>(t), rounded_vec<T>(direction_ * t + origin_), rounded_vec<T>(normal),
                        Status::converged, 2 * tolerance::rounding * slabs_.size()};
  }

 private:
  Pair2d origin_;
  Pair2d direction_;
  LanePair rows_x_;  ///< The first numbers of both rows of the inverse, without its determinant, and the second ones.
  LanePair rows_y_;
  LanePair low_;
  LanePair high_;
  LanePair slope_;
  RayTwoSlabs slabs_;
};

template <class T>
[[gnu::always_inline]] inline RayOrientedRectangleFilter<T> quick_cast(const Obb<2, T>& box, const Ray<2, T>& ray,
                                                                       T t_max) {
  return {box, ray, t_max};
}

}  // namespace graze::detail

#endif
