// SPDX-License-Identifier: MIT
// How a capsule touches a box in space: what penetration_of_simple finds for any two shapes, of capsules whose axis is
// clearly out of the box and nearest to it at one place: an end, or where it passes an edge or a corner. Include
// manifold.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/ball_touch.hpp>
#include <graze/query/clipped_patch.hpp>
#include <graze/query/oriented_box.hpp>
#include <graze/query/penetration_boxes.hpp>
#include <graze/query/round_touch.hpp>
#include <graze/query/touch_look.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/obb.hpp>

namespace graze::detail {

/// A segment as a box sees it along its axes, up to how far these are from orthonormal.
struct WayPastBox {
  Vec<3, double> start;
  Vec<3, double> way;
  Vec<3, double> half_extents;

  Vec<3, double> at(double t) const { return start + way * t; }

  /// Half of how the squared distance grows with t, which is more the larger t is.
  double slope(double t) const {
    double result = 0;
    for (Dim i = 0; i < 3; ++i) {
      const double x = start[i] + way[i] * t;
      result += way[i] * (x - std::min(std::max(x, -half_extents[i]), half_extents[i]));
    }
    return result;
  }

  /// Where it is nearest, from 0 to 1: the slope is a straight line between the places where the segment passes a side.
  double nearest() const {
    double low = 0;
    double high = 1;
    double slope_low = slope(low);
    if (slope_low >= 0) return 0;
    double slope_high = slope(high);
    if (slope_high <= 0) return 1;
    for (Dim i = 0; i < 3; ++i) {
      const double per_way = 1 / way[i];
      for (const double side : {-half_extents[i], half_extents[i]}) {
        const double t = (side - start[i]) * per_way;
        if (!(t > low && t < high)) continue;
        const double here = slope(t);
        (here < 0 ? low : high) = t;
        (here < 0 ? slope_low : slope_high) = here;
      }
    }
    return low - slope_low * (high - low) / (slope_high - slope_low);
  }
};

/// A capsule and a box, seen from the capsule's first end.
class CapsuleTouch {
 public:
  /// `turns` if the capsule is the first of both.
  CapsuleTouch(const Vec<3, double>& origin, const Vec<3, double>& way, double radius, const Obb<3, double>& box,
               bool turns)
      : origin_(origin),
        way_(way),
        radius_(radius),
        box_(box),
        size_(sum_abs(way) + sum_abs(box.center) + sum_abs(box.half_extents)),
        turns_(turns) {
    for (Dim i = 0; i < 3; ++i) {
      seen_.start[i] = -dot(box.center, box.axes[i]);
      seen_.way[i] = dot(way, box.axes[i]);
    }
    seen_.half_extents = box.half_extents;
  }

  TouchLook<3> run() const {
    const double t = seen_.nearest();
    if (t <= 0) return at_end(0);
    if (t >= 1) return at_end(1);
    return between_ends(t);
  }

 private:
  /// The axis' place there is the nearest if the way from it leads away from the box' nearest point: both are convex.
  TouchLook<3> at_end(std::uint32_t end) const {
    const Vec<3, double> place = way_ * (end == 0 ? 0.0 : 1.0);
    Obb<3, double> box = box_;
    box.center -= place;
    TouchLook<3> look = BallTouch<false>(origin_ + place, radius_, box, !turns_).run();
    Feature& of_capsule = turns_ ? look.feature_a : look.feature_b;
    of_capsule.index = end;
    if (!look.is_known || !look.meets) {
      look.is_known = false;  // what the end is apart from, the rest may meet
      return look;
    }
    const double away = dot(way_, look.found.normal) * (turns_ == (end == 0) ? -1.0 : 1.0);
    look.is_known = look.found.depth < radius_ && away >= -tolerance::rounding * sum_abs(way_);
    const Feature& of_box = turns_ ? look.feature_b : look.feature_a;
    look.is_single = of_box.kind != FeatureKind::face;  // on a face it may lie flat
    look.found.error = error();
    return look;
  }

  TouchLook<3> between_ends(double t) const {
    TouchLook<3> look;
    const Vec<3, double> place = seen_.at(t);
    // Of the places, by the axes: twice what the quick test of a ball allows for, and what is far above rounding.
    constexpr double least_skew = 1e-10;
    const double doubt = 2 * tolerance::box_filter * (skew_of_axes(box_.axes) + least_skew) * (size_ + radius_);
    const double along = t * max_abs(way_);
    bool is_clear = along > doubt && max_abs(way_) - along > doubt;
    std::array<bool, 3> is_beyond{};
    double squared = 0;
    double least_beyond = std::numeric_limits<double>::infinity();
    int count = 0;
    for (Dim i = 0; i < 3; ++i) {
      const double beyond = std::fabs(place[i]) - box_.half_extents[i];
      is_clear = is_clear && std::fabs(beyond) > doubt && box_.half_extents[i] > doubt;
      is_beyond[static_cast<std::size_t>(i)] = beyond > 0;
      if (!(beyond > 0)) continue;
      ++count;
      squared += beyond * beyond;
      least_beyond = std::min(least_beyond, beyond);
    }
    if (squared > (radius_ + doubt) * (radius_ + doubt)) {
      look.is_known = true;
      return look;
    }
    if (!is_clear || count < 2) return look;
    look = count == 2 ? past_edge(place, is_beyond) : past_corner(place);
    look.set_features(feature_of_box(place, is_beyond), {FeatureKind::edge, 0}, turns_);
    // On a face that the normal is hardly turned from it would be laid flat.
    constexpr double least_cosine = 16 * tolerance::aligned;
    look.is_single = least_beyond > least_cosine * std::sqrt(squared);
    return look;
  }

  /// The middle of the edge at the sides that a place is beyond, or a corner.
  Vec<3, double> middle_at(const Vec<3, double>& place, const std::array<bool, 3>& is_beyond) const {
    Vec<3, double> result = box_.center;
    for (Dim i = 0; i < 3; ++i) {
      const double side = is_beyond[static_cast<std::size_t>(i)] ? std::copysign(box_.half_extents[i], place[i]) : 0.0;
      result += box_.axes[i] * side;
    }
    return result;
  }

  /// As in segment_filter.hpp.
  TouchLook<3> past_edge(const Vec<3, double>& place, const std::array<bool, 3>& is_beyond) const {
    constexpr double least_sine_squared = 1.0 / 64;
    const Dim along = is_beyond[0] ? (is_beyond[1] ? 2 : 1) : 0;
    const Vec<3, double> middle = middle_at(place, is_beyond);
    const Vec<3, double>& edge = box_.axes[along];
    const double uu = dot(way_, way_);
    const double vv = dot(edge, edge);
    const double uv = dot(way_, edge);
    const double uw = dot(way_, middle);
    const double vw = dot(edge, middle);
    const double det = uu * vv - uv * uv;
    const double on_axis = (uw * vv - vw * uv) / det;
    const double on_edge = (uw * uv - vw * uu) / det;
    TouchLook<3> look = touch_at(middle + edge * on_edge, way_ * on_axis);
    look.is_known = look.is_known && det > least_sine_squared * (uu * vv) && on_axis > 0 && on_axis < 1 &&
                    std::fabs(on_edge) < box_.half_extents[along] &&
                    (!look.meets || are_lines_apart(radius_ - look.found.depth, size_));
    return look;
  }

  TouchLook<3> past_corner(const Vec<3, double>& place) const {
    const Vec<3, double> corner = middle_at(place, {true, true, true});
    const double on_axis = dot(way_, corner) / dot(way_, way_);
    TouchLook<3> look = touch_at(corner, way_ * on_axis);
    look.is_known = look.is_known && on_axis > 0 && on_axis < 1;
    return look;
  }

  TouchLook<3> touch_at(const Vec<3, double>& on_box, const Vec<3, double>& on_axis) const {
    return touch_of_cores<3>({{origin_, on_box}, {origin_, on_axis}, on_axis - on_box, size_}, 0, radius_, turns_);
  }

  double error() const { return 2 * tolerance::rounding * (size_ + radius_); }

  Vec<3, double> origin_;
  Vec<3, double> way_;
  double radius_;
  Obb<3, double> box_;
  double size_;
  bool turns_;
  WayPastBox seen_;
};

template <class T, class Box>
TouchLook<3> look_at_capsule(const Box& box, const Capsule<3, T>& capsule, bool turns) {
  const Vec<3, double> origin = wide<3, T>(capsule.a);
  return CapsuleTouch(origin, wide<3, T>(capsule.b) - origin, static_cast<double>(capsule.radius),
                      oriented_box_from(origin, box), turns)
      .run();
}

template <class T>
TouchLook<3> touch_look(const Aabb<3, T>& box, const Capsule<3, T>& capsule, bool turns) {
  return look_at_capsule(box, capsule, turns);
}
template <class T>
TouchLook<3> touch_look(const Obb<3, T>& box, const Capsule<3, T>& capsule, bool turns) {
  return look_at_capsule(box, capsule, turns);
}

}  // namespace graze::detail
