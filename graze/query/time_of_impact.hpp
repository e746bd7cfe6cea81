// SPDX-License-Identifier: MIT
/// @file
/// time_of_impact(a, motion_a, b, motion_b): when and where two shapes that move and rotate first touch.
///
/// For any two shapes. If they meet at the start, as relation(a, b) decides, the impact is contact(a, b) at t = 0. If
/// neither rotates, it is that of shape_cast.hpp. For two convex shapes, and for a convex shape and a plane or
/// half-space, motion_advance.hpp finds the time. A ray is cut beyond the reach of the other shape; a compound counts
/// as its first part to touch. Of two unbounded shapes that rotate (rays, planes, half-spaces), the time is exact for
/// parallel planes and half-spaces with equal rotations. For all others the result is only the lower bound t = 0, with
/// `best_bound` and their distance as the error; planes that rotate against each other do meet at once, far away.
///
/// `error` is a length: at t, before rounding to T, the shapes are at most that far apart, and before t they do not
/// touch. It is 2^-36 of the pair's size and path, or a few epsilon of the largest coordinate if that is more (of T for
/// a user's shape that calculates in T). So shapes that come nearer than that without touching have an impact as well.
/// The status is `best_bound` if the step limit of 512 is reached (long shapes that rotate far and graze each other),
/// or GJK cannot resolve the distance: t is still a bound, and the error tells how far apart the shapes are there.
/// Coordinates may be any finite numbers; see range.hpp for sizes that differ by more than a factor of 2^900.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <optional>

#include <graze/math/motion.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/cast/motion_advance.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/compiled/instances.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/impact.hpp>
#include <graze/query/parts/visit.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/query/status.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/compound.hpp>
#include <graze/shape/fields/shape_order.hpp>
#include <graze/shape/fields/visit.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

namespace detail {

// ---- Any two shapes that are apart, b the unbounded one if any

template <Dim N, class T>
Motion<N, double> wide_motion(const Motion<N, T>& motion) {
  return {wide<N, T>(motion.linear), Turn<N, double>(motion.angular), wide<N, T>(motion.center)};
}

/// Without rotation any center will do; in the middle of the shape the sphere around it is smallest.
template <Convex S>
Motion<dimension_of<S>, double> centered(Motion<dimension_of<S>, double> motion, const S& shape) {
  constexpr Dim N = dimension_of<S>;
  if (size_of_turn(motion.angular) > 0) return motion;
  const auto box = bounds(shape);
  motion.center = wide<N, scalar_of<S>>(box.min) * 0.5 + wide<N, scalar_of<S>>(box.max) * 0.5;
  return motion;
}

template <class S>
using MotionOf = Motion<dimension_of<S>, double>;

template <Convex A, Convex B>
std::optional<CastHit<dimension_of<A>>> cast_hit_of_moving(const A& a, const MotionOf<A>& motion_a, const B& b,
                                                           const MotionOf<A>& motion_b) {
  constexpr Dim N = dimension_of<A>;
  const auto& core_a = core(a);
  const auto& core_b = core(b);
  const double radius = core_radius(a) + core_radius(b);
  const ConvexPair<N, SupportNumber<A, B>> pair(ConvexView<N>(core_a), ConvexView<N>(core_b), radius);
  const Motion<N, double> about_a = centered(motion_a, core_a);
  const Motion<N, double> about_b = centered(motion_b, core_b);
  const double reach = reach_from(about_a.center, core_a);
  const Trajectory<N> trajectory = trajectory_of(about_a, about_b, reach, radius);
  const std::optional<double> start = time_of_spheres(trajectory, reach + reach_from(about_b.center, core_b) + radius);
  if (!start) return std::nullopt;
  return advance_to_impact(pair, trajectory, *start, core_radius(b));
}

template <Convex A, class B>
requires is_plane_or_half_space<B> std::optional<CastHit<dimension_of<A>>> cast_hit_of_moving(
    const A& a, const MotionOf<A>& motion_a, const B& b, const MotionOf<A>& motion_b) {
  constexpr Dim N = dimension_of<A>;
  const auto& core_a = core(a);
  const double radius = core_radius(a);
  const Proximity<N, double> gap = proximity(a, b);
  const double reach = reach_from(motion_a.center, core_a);
  const Trajectory<N> trajectory = trajectory_of(motion_a, motion_b, reach, radius);
  const double largest = trajectory.size + sum_abs(motion_a.center) + sum_abs(motion_b.center);
  const HalfSpacePair<N> pair(ConvexView<N>(core_a), radius, gap.normal, dot(gap.normal, gap.point_b),
                              gap.error + support_error<A> * largest);
  return advance_to_impact(pair, trajectory, 0, 0);
}

/// Whether a rotates within the smaller sphere, or is the first of two equal ones. That shape moves: a plane attached
/// to the larger one separates them longer, because less of what rotates past it reaches far.
template <Convex A, Convex B>
bool is_smaller(const A& a, const MotionOf<A>& motion_a, const B& b, const MotionOf<A>& motion_b) {
  const double reach_a = reach_from(centered(motion_a, core(a)).center, core(a));
  const double reach_b = reach_from(centered(motion_b, core(b)).center, core(b));
  return reach_a != reach_b ? reach_a < reach_b : is_in_order(a, b);
}

template <Dim N>
std::optional<CastHit<N>> with_normal_turned(std::optional<CastHit<N>> cast_hit) {
  if (cast_hit) cast_hit->normal = Vec<N, double>(0.0) - cast_hit->normal;
  return cast_hit;
}

// ---- Rays

/// The part of a ray that b can reach: b never comes farther from the ray's origin than its end, which is twice as far
/// as needed.
template <Dim N, class T, Convex B>
Segment<N, double> piece_of_ray(const Ray<N, T>& ray, const MotionOf<B>& motion, const B& b,
                                const MotionOf<B>& motion_b) {
  const Vec<N, double> origin = wide<N, T>(ray.origin);
  const Motion<N, double> about_b = centered(motion_b, core(b));
  const Vec<N, double> between = motion.center - about_b.center;
  const Vec<N, double> way = motion.linear - about_b.linear;
  const Vec<N, double> arm = origin - motion.center;
  const double reach = std::sqrt(dot(between, between)) + std::sqrt(dot(way, way)) + std::sqrt(dot(arm, arm)) +
                       reach_from(about_b.center, core(b)) + core_radius(b);
  return {origin, origin + unit_or(wide<N, T>(ray.direction), Vec<N, double>(0.0)) * (2 * reach)};
}

// ---- Two unbounded shapes

template <class S>
inline constexpr bool is_endless = is_ray<S> || is_plane_or_half_space<S>;

/// Two parallel planes or half-spaces with equal rotations: every point of a's surface is equally far from b.
template <class A, class B>
std::optional<CastHit<dimension_of<A>>> cast_hit_of_half_spaces(const Proximity<dimension_of<A>, double>& gap,
                                                                const MotionOf<A>& motion_a,
                                                                const MotionOf<A>& motion_b) {
  constexpr Dim N = dimension_of<A>;
  const double reach = reach_from(motion_a.center, gap.point_a);
  const Trajectory<N> trajectory = trajectory_of(motion_a, motion_b, reach, 0.0);
  const double largest = trajectory.size + sum_abs(motion_a.center) + sum_abs(motion_b.center);
  const HalfSpacePair<N> pair(ConvexView<N>(gap.point_a), 0, gap.normal, dot(gap.normal, gap.point_b),
                              gap.error + tolerance::rounding * largest);
  return advance_to_impact(pair, trajectory, 0, 0);
}

template <class A, class B>
std::optional<CastHit<dimension_of<A>>> cast_hit_of_endless(const A& a, const MotionOf<A>& motion_a, const B& b,
                                                            const MotionOf<A>& motion_b) {
  constexpr Dim N = dimension_of<A>;
  const Proximity<N, double> gap = proximity(a, b);
  if constexpr (is_plane_or_half_space<A> && is_plane_or_half_space<B>) {
    if (motion_a.angular == motion_b.angular) return cast_hit_of_half_spaces<A, B>(gap, motion_a, motion_b);
  }
  return CastHit<N>{0, gap.point_b, gap.normal, Status::best_bound, gap.distance + gap.error};
}

// ---- Two shapes without rotation

/// The shape cast along the motion of a relative to b. Rays in double, because the cast shape must represent the
/// motion's numbers.
template <class A, class B>
std::optional<CastHit<dimension_of<A>>> cast_hit_of_gliding(const A& a, const MotionOf<A>& motion_a, const B& b,
                                                            const MotionOf<A>& motion_b) {
  constexpr Dim N = dimension_of<A>;
  const Vec<N, double> way = motion_a.linear - motion_b.linear;
  if (max_abs(way) == 0) return std::nullopt;
  std::optional<CastHit<N>> found;
  if constexpr (is_ray<A> && is_ray<B>) {
    using T = scalar_of<A>;
    found = cast_hit(Ray<N, double>{wide<N, T>(a.origin), wide<N, T>(a.direction)}, way,
                     Ray<N, double>{wide<N, T>(b.origin), wide<N, T>(b.direction)});
  } else {
    found = cast_hit(a, way, b);
  }
  if (found) {
    found->point += motion_b.linear * found->t;
    found->error += tolerance::rounding * (sum_abs(motion_a.linear) + sum_abs(motion_b.linear));
  }
  return found;
}

/// Whether a shape cast suffices: neither rotates, and a point, which is cast in its own type, can represent the
/// motion.
template <class A, class B>
bool do_glide(const MotionOf<A>& motion_a, const MotionOf<A>& motion_b) {
  constexpr Dim N = dimension_of<A>;
  using T = scalar_of<A>;
  if (size_of_turn(motion_a.angular) > 0 || size_of_turn(motion_b.angular) > 0) return false;
  if constexpr (!is_point<A> && !is_point<B>) return true;
  const Vec<N, double> way = motion_a.linear - motion_b.linear;
  return wide<N, T>(Vec<N, T>(way)) == way;
}

// ---- Any two simple shapes

/// For two shapes in order.
template <class A, class B>
std::optional<CastHit<dimension_of<A>>> cast_hit_of_simple_motion(const A& a, const MotionOf<A>& motion_a, const B& b,
                                                                  const MotionOf<A>& motion_b) {
  if (do_glide<A, B>(motion_a, motion_b)) return cast_hit_of_gliding(a, motion_a, b, motion_b);
  if constexpr (is_endless<A> && is_endless<B>) {
    return cast_hit_of_endless(a, motion_a, b, motion_b);
  } else if constexpr (is_ray<A>) {
    return with_normal_turned(cast_hit_of_moving(b, motion_b, piece_of_ray(a, motion_a, b, motion_b), motion_a));
  } else if constexpr (is_ray<B>) {
    return cast_hit_of_moving(a, motion_a, piece_of_ray(b, motion_b, a, motion_a), motion_b);
  } else if constexpr (is_plane_or_half_space<B>) {
    return cast_hit_of_moving(a, motion_a, b, motion_b);
  } else {
    if constexpr (!is_plane_or_half_space<A>) {
      if (is_smaller(a, motion_a, b, motion_b)) return cast_hit_of_moving(a, motion_a, b, motion_b);
    }
    return with_normal_turned(cast_hit_of_moving(b, motion_b, a, motion_a));
  }
}

/// For two shapes in order. Shapes that start nearer to each other than GJK can resolve a direction touch at the start;
/// their normal is that of their distance.
template <class A, class B>
std::optional<CastHit<dimension_of<A>>> cast_hit_of_simple(const A& a, const MotionOf<A>& motion_a, const B& b,
                                                           const MotionOf<A>& motion_b) {
  if constexpr (can_leave_range<A>) {
    if (!are_usual(a, b, motion_a.linear, motion_a.center, motion_b.linear, motion_b.center)) {
      const auto rescaled = answer_in_range<std::optional<CastHit<dimension_of<A>>>>(
          [&](const auto& power, const auto& scaled_a, const auto& scaled_b, const auto& linear_a, const auto& center_a,
              const auto& linear_b, const auto& center_b) {
            const MotionOf<A> scaled_motion_a{linear_a, motion_a.angular, center_a};
            const MotionOf<A> scaled_motion_b{linear_b, motion_b.angular, center_b};
            return resized(cast_hit_of_simple(scaled_a, scaled_motion_a, scaled_b, scaled_motion_b), power.inverse());
          },
          a, b, motion_a.linear, motion_a.center, motion_b.linear, motion_b.center);
      if (rescaled) return *rescaled;
    }
  }
  std::optional<CastHit<dimension_of<A>>> found = cast_hit_of_simple_motion(a, motion_a, b, motion_b);
  if (found && !(max_abs(found->normal) > 0)) found->normal = proximity(a, b).normal;
  return found;
}

// ---- Any two shapes

/// For `visit_parts`: whether a part in motion may touch a box up to the first touch so far, by the spheres in which
/// both rotate. Boxes are grown as by touching_bounds.
template <Dim N, class T>
class MayTouchInMotion {
 public:
  MayTouchInMotion(const Motion<N, double>& motion, const Aabb<N, T>& other, const Motion<N, double>& motion_of_other)
      : motion_(motion), other_(other), motion_of_other_(motion_of_other) {}

  /// Ends the motion at t.
  void end_at(double t) { end_ = t; }

  /// When the spheres touch first; NaN if they do not.
  double key(const Aabb<N, T>& box) const {
    if (!is_bounded(other_) || !is_bounded(box) || !are_usual(other_, box)) return 0;
    const Motion<N, double> about_a = centered(motion_, box);
    const Motion<N, double> about_b = centered(motion_of_other_, other_);
    const double reach_a = reach_from(about_a.center, box);
    const Trajectory<N> trajectory = trajectory_of(about_a, about_b, reach_a, 0.0);
    const std::optional<double> start = time_of_spheres(trajectory, reach_a + reach_from(about_b.center, other_));
    return start.value_or(std::numeric_limits<double>::quiet_NaN());
  }
  bool admits(double key) const { return key <= end_; }

  bool operator()(const Aabb<N, T>& box) const { return admits(key(box)); }
  bool operator()(const Part<N, T>& part) const { return (*this)(touching_bounds(part.box)); }

 private:
  Motion<N, double> motion_;
  Aabb<N, T> other_;
  Motion<N, double> motion_of_other_;
  double end_ = 1;
};

/// The first part to touch the shape, of several the first in order. `find(part)` tests one that may touch before the
/// others.
template <Dim N, class T, template <Dim, class> class Whole, class S, class Find>
std::optional<CastHit<N>> cast_hit_of_moving_parts(const Whole<N, T>& whole, const Motion<N, double>& motion,
                                                   const S& shape, const Motion<N, double>& motion_of_shape,
                                                   const Find& find) {
  std::optional<CastHit<N>> best;
  FirstPart first;
  const Aabb<N, T> box = touching_bounds(shape);
  MayTouchInMotion<N, T> may_touch(motion, box, motion_of_shape);
  const auto visit = [&](const auto& part, std::size_t index) {
    const std::optional<CastHit<N>> found = find(part.shape);
    if (!found || !first.is_replaced_by(found->t, index)) return true;
    best = found;
    may_touch.end_at(found->t);
    return true;
  };
  visit_parts(whole, may_touch, ByKey(), PartVisitor<Whole<N, T>>(visit));
  return best;
}

/// For shapes that are apart.
template <class A, class B>
std::optional<CastHit<dimension_of<A>>> cast_hit_in_motion(const A& a, const MotionOf<A>& motion_a, const B& b,
                                                           const MotionOf<A>& motion_b) {
  if constexpr (is_any_shape<A>) {
    return detail::visit([&](const auto& held) { return cast_hit_in_motion(held, motion_a, b, motion_b); }, a);
  } else if constexpr (is_any_shape<B>) {
    return detail::visit([&](const auto& held) { return cast_hit_in_motion(a, motion_a, held, motion_b); }, b);
  } else if constexpr (HasParts<A>) {
    if constexpr (HasParts<B>) {
      if (!is_in_order(a, b)) return with_normal_turned(cast_hit_in_motion(b, motion_b, a, motion_a));
    }
    return cast_hit_of_moving_parts(a, motion_a, b, motion_b,
                                    [&](const auto& part) { return cast_hit_in_motion(part, motion_a, b, motion_b); });
  } else if constexpr (HasParts<B>) {
    return cast_hit_of_moving_parts(b, motion_b, a, motion_a,
                                    [&](const auto& part) { return cast_hit_in_motion(a, motion_a, part, motion_b); });
  } else if constexpr (are_exchanged<A, B>) {
    return with_normal_turned(cast_hit_in_motion(b, motion_b, a, motion_a));
  } else {
    if constexpr (are_in_either_order<A, B>) {
      if (!is_in_order(a, b)) return with_normal_turned(cast_hit_of_simple(b, motion_b, a, motion_a));
    }
    return cast_hit_of_simple(a, motion_a, b, motion_b);
  }
}

}  // namespace detail

/// A motion with the dimension and number type of a shape.
template <Shape S>
using MotionIn = Motion<dimension_of<S>, scalar_of<S>>;

/// The first touch, from t = 0 to t = 1, of two valid shapes (asserted) of the same dimension and number type that
/// move; none if they do not touch. Pass the shapes as they are at t = 0. Touching counts, also at the start and at the
/// end. t is never after the first touch and earlier by at most the error; see the top of this file. Swapping the
/// shapes negates the normal and changes nothing else. A compound is the union of its parts. Motions with numbers that
/// are not finite touch nothing. Without rotation it costs as much as `shape_cast`.
template <Shape A, SameSpace<A> B>
std::optional<Impact<dimension_of<A>, scalar_of<A>>> time_of_impact(const A& a, const MotionIn<A>& motion_a, const B& b,
                                                                    const MotionIn<A>& motion_b) {
  using T = scalar_of<A>;
  assert(detail::is_valid_if_known(a) && detail::is_valid_if_known(b));
  if (!is_finite(motion_a) || !is_finite(motion_b)) return std::nullopt;
  if (const auto contact = detail::penetration(a, b)) {
    return detail::rounded_impact<T>(detail::cast_hit_at_start(*contact));
  }
  const auto cast_hit = detail::cast_hit_in_motion(a, detail::wide_motion(motion_a), b, detail::wide_motion(motion_b));
  if (!cast_hit) return std::nullopt;
  return detail::rounded_impact<T>(*cast_hit);
}

GRAZE_DECLARE_INSTANCES(GRAZE_TIME_OF_IMPACT_INSTANCES)

}  // namespace graze
