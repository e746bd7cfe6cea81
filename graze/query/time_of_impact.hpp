// SPDX-License-Identifier: MIT
// time_of_impact(a, motion_a, b, motion_b): when two shapes that move and turn first touch, and where.
//
// For any two convex shapes, and for a convex shape and a plane or half-space. Shapes that meet at the start, as
// relation(a, b) says, have their contact(a, b) as the impact, at t = 0.
//
// Conservative advancement (Mirtich, "Impulse-based dynamic simulation of rigid body systems", 1996; Zhang, Lee, Kim,
// "Interactive continuous collision detection for non-convex polyhedra", 2006) in b's frame. Where those go on by the
// distance over a bound on the speed, and slow down as they come near, this looks for the time at which the plane that
// now parts the shapes no longer does, as Box2D does (Catto, "Continuous collision", 2013), but goes only as far as it
// can be proved that the plane parts them all the way: see Course below.
//
// `error` is a length: at t, before it is rounded to T, the shapes are no farther apart than that, and before t they
// are not in touch. It is 2^-36 of the pair's size and way, or a few epsilon of the largest coordinate if that is more
// (of T for a user's shape that calculates in T). So shapes that come nearer to each other than that without touching
// have an impact as well. If the steps end before (they are at most 512: long shapes that turn much and graze take
// them), or GJK cannot tell the distance, the status is `best_bound`: t is a bound all the same, and the error says how
// far apart they are there. Coordinates of magnitude 1e-140 to 1e140.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <type_traits>

#include <graze/math/motion.hpp>
#include <graze/math/pose.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/gjk.hpp>
#include <graze/query/impact.hpp>
#include <graze/query/obstacle.hpp>
#include <graze/query/ray_sight.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/status.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/shape.hpp>

namespace graze {

namespace detail {

inline constexpr int advance_step_limit = 512;

// ---- The relative motion

inline double size_of_turn(double angle) { return std::fabs(angle); }
inline double size_of_turn(const Vec<3, double>& turn) { return std::sqrt(dot(turn, turn)); }

/// How a moves as b sees it, and how much the way of any point of a bends: the length of its second derivative.
///
/// A plane at rest parts a from b by some gap at two times, and by h(x) from each point x of a. In between, dt apart,
/// h(x) is nowhere lower than the chord between its heights at both times by more than bend dt^2 / 8; so the gap is
/// nowhere lower than the parabola below the chord of the gaps.
template <Dim N>
struct Course {
  Motion<N, double> a;
  Motion<N, double> b;
  double bend;
  double size;  ///< A bound on all lengths of the pair and its way: what rounding and the target are relative to.

  /// Where a is at t, seen from b.
  Pose<N, double> at(double t) const {
    const Pose<N, double> of_a = pose_at(a, t);
    const Pose<N, double> of_b = pose_at(b, t);
    const Mat<N, double> back = transpose(of_b.rotation);
    return {back * of_a.rotation, back * (of_a.position - of_b.position)};
  }
};

/// In a frame that turns with b, with w the turns, v the ways, c the centers, and r how far a reaches from its own:
/// what a's turning adds is (|w_a| + |w_b|)^2 r, or nothing if both turn alike, and what its center adds 2 |w_b| |v_a -
/// v_b| (Coriolis) and |w_b|^2 |c_a - c_b|, as far apart as the centers get.
template <Dim N>
Course<N> course_of(const Motion<N, double>& a, const Motion<N, double>& b, double reach, double radius) {
  const Vec<N, double> way = a.linear - b.linear;
  const Vec<N, double> between = a.center - b.center;
  const double way_length = std::sqrt(dot(way, way));
  const double far = way_length + std::sqrt(dot(between, between));
  const double turn_b = size_of_turn(b.angular);
  const double turn = a.angular == b.angular ? 0 : size_of_turn(a.angular) + turn_b;
  const double bend = turn * turn * reach + 2 * turn_b * way_length + turn_b * turn_b * far;
  return {a, b, bend, far + reach + radius};
}

/// The farthest that a point of a shape's core can be from another.
template <Convex S>
double reach_from(const Vec<dimension_of<S>, double>& center, const S& shape) {
  constexpr Dim N = dimension_of<S>;
  const auto box = bounds(shape);
  const Vec<N, double> reach =
      max(abs(wide<N, scalar_of<S>>(box.min) - center), abs(wide<N, scalar_of<S>>(box.max) - center));
  return std::sqrt(dot(reach, reach));
}

// ---- The gap between b at rest and a somewhere else

/// A convex shape seen through a pose, its supports as right as `Number`.
template <Dim N, Scalar Number>
struct PosedView {
  ConvexView<N> view;
  Pose<N, double> pose;
};

template <Dim N, Scalar Number>
Vec<N, double> support(const PosedView<N, Number>& posed, const std::type_identity_t<Vec<N, double>>& direction) {
  return posed.pose.rotation * posed.view.support(transpose(posed.pose.rotation) * direction) + posed.pose.position;
}

template <Dim N>
inline constexpr double support_error<PosedView<N, float>> = tolerance::convex_in<float>;

/// What parts two shapes at some time.
template <Dim N>
struct Parting {
  Vec<N, double> normal = Vec<N, double>(0.0);  ///< Of length 1, from a to b, as b sees it.
  double gap = 0;                               ///< Along the normal, rounding taken off.
  double distance = 0;                          ///< No less than how far apart they are.
  double resolution = 0;
};

/// Two convex shapes, as cores and the sum of their radii.
template <Dim N, Scalar Number>
struct ConvexPair {
  ConvexView<N> a;
  ConvexView<N> b;
  double radius;

  PosedView<N, Number> at(const Pose<N, double>& pose) const { return {a, pose}; }
  PosedView<N, Number> at_rest() const { return {b, Pose<N, double>()}; }

  double gap_along(const Vec<N, double>& normal, const Pose<N, double>& pose) const {
    return dot(normal, b.support(-normal)) - dot(normal, support(at(pose), normal)) - radius;
  }

  Parting<N> parting_at(const Pose<N, double>& pose) const {
    const GjkResult<N> found = gjk(at(pose), at_rest());
    Parting<N> parting;
    parting.resolution = found.resolution + tolerance::rounding * radius;
    parting.distance = std::max(0.0, found.upper - radius);
    parting.normal = unit_or(-found.separation, Vec<N, double>(0.0));
    if (max_abs(parting.normal) > 0) parting.gap = gap_along(parting.normal, pose) - parting.resolution;
    return parting;
  }

  /// Where they are nearest, as b sees it: between the two surfaces, which are as good as one.
  Vec<N, double> point_at(const Pose<N, double>& pose, const Vec<N, double>& normal, double radius_b) const {
    return closest_of_convex(at(pose), at_rest()).closest.on_b - normal * radius_b;
  }
};

/// A convex shape before a plane: one normal parts them all the time, or nothing does.
template <Dim N, Scalar Number>
struct LevelPair {
  ConvexView<N> a;
  double radius;
  Vec<N, double> normal;  ///< Of length 1, into the plane.
  double height;          ///< Of the plane along it.
  double slack;           ///< What rounding makes of heights.

  double gap_along(const Vec<N, double>&, const Pose<N, double>& pose) const {
    return height - dot(normal, foremost(pose)) - radius;
  }

  Parting<N> parting_at(const Pose<N, double>& pose) const {
    const double gap = gap_along(normal, pose);
    return {normal, gap - slack, std::max(0.0, gap), slack};
  }

  Vec<N, double> point_at(const Pose<N, double>& pose, const Vec<N, double>&, double) const {
    return foremost(pose) + normal * radius;
  }

 private:
  Vec<N, double> foremost(const Pose<N, double>& pose) const { return support(PosedView<N, Number>{a, pose}, normal); }
};

// ---- From one parting plane to the next

/// The least of a parabola from g at 0 to h at 1 whose second derivative is 2 c: g + s (h - g - c) + c s^2.
inline double least_between(double g, double h, double c) {
  const double fall = g + c - h;
  if (!(fall > 0 && fall < 2 * c)) return std::min(g, h);
  return g - fall * fall / (4 * c);
}

/// The latest time found, up to 1, until which the plane of a parting keeps a gap of `goal`. With `latest` such that
/// bend dt^2 / 2 is half of what may be lost, so that a chord that ends at the goal is not undercut; and, where that
/// does not hold, halved until it does. From there, bisection towards the time at which the gap comes to the goal.
template <Dim N, class Pair>
double time_parted(const Pair& pair, const Course<N>& course, double t, const Parting<N>& parting, double goal) {
  constexpr int halvings = 64;
  constexpr int bisections = 24;
  const double spare = parting.gap - goal;
  const auto keeps = [&](double step) {
    const double gap = pair.gap_along(parting.normal, course.at(t + step)) - parting.resolution;
    return least_between(parting.gap, gap, course.bend * step * step / 2) >= goal;
  };
  double latest = 1 - t;
  if (course.bend * latest * latest > spare) latest = std::min(latest, std::sqrt(spare / course.bend));
  if (keeps(latest)) return t + latest;
  double kept = 0;
  for (int i = 0; i < halvings && kept == 0; ++i) {
    const double half = latest / 2;
    (keeps(half) ? kept : latest) = half;
  }
  for (int i = 0; i < bisections && kept > 0; ++i) {
    const double middle = kept + (latest - kept) / 2;
    (keeps(middle) ? kept : latest) = middle;
  }
  return t + kept;
}

/// Before this time the balls that the shapes turn in do not touch; none if they never do. The balls are larger than
/// they need be by the target, which hides all rounding.
template <Dim N>
std::optional<double> time_of_balls(const Course<N>& course, double reach) {
  const double radius = reach + 2 * tolerance::impact * (course.size + reach);
  const Vec<N, double> between = course.b.center - course.a.center;
  const Vec<N, double> way = course.a.linear - course.b.linear;
  if (dot(between, between) <= radius * radius) return 0;
  if (!(dot(way, way) > 0)) return std::nullopt;
  const BallPassage<N> passage(way, between, radius * radius);
  if (!(passage.depth >= 0 && passage.exit() >= 0 && passage.enter() <= 1)) return std::nullopt;
  return std::max(0.0, passage.enter());
}

/// Goes on from t until the shapes are as near as the target, or the motion ends. Half of the target is kept, so that
/// rounding cannot spend it.
template <Dim N, class Pair>
std::optional<Strike<N>> advance_to_impact(const Pair& pair, const Course<N>& course, double t, double radius_b) {
  Parting<N> parting;
  bool has_arrived = false;
  for (int step = 0; step < advance_step_limit; ++step) {
    parting = pair.parting_at(course.at(t));
    const double target = std::max(tolerance::impact * course.size, 8 * parting.resolution);
    has_arrived = parting.gap <= target;
    if (has_arrived) break;
    if (t >= 1) return std::nullopt;
    const double next = time_parted(pair, course, t, parting, target / 2);
    if (!(next > t)) break;
    t = next;
  }
  if (!has_arrived) parting = pair.parting_at(course.at(t));  // at the limit t has gone on since
  const bool is_near = parting.distance <= 2 * tolerance::impact * course.size + 16 * parting.resolution;
  const Pose<N, double> back = pose_at(course.b, t);
  const Vec<N, double> point = pair.point_at(course.at(t), parting.normal, radius_b);
  return Strike<N>{t, back.rotation * point + back.position, back.rotation * parting.normal,
                   has_arrived && is_near ? Status::converged : Status::best_bound,
                   parting.distance + parting.resolution};
}

// ---- Any two shapes that are apart, b the unbounded one if any

template <Dim N, class T>
Motion<N, double> wide_motion(const Motion<N, T>& motion) {
  return {wide<N, T>(motion.linear), Turn<N, double>(motion.angular), wide<N, T>(motion.center)};
}

/// What does not turn has its center anywhere: in the middle the ball around it is smallest.
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
std::optional<Strike<dimension_of<A>>> strike_of_moving(const A& a, const MotionOf<A>& motion_a, const B& b,
                                                        const MotionOf<A>& motion_b) {
  constexpr Dim N = dimension_of<A>;
  const auto& core_a = core(a);
  const auto& core_b = core(b);
  const double radius = core_radius(a) + core_radius(b);
  const ConvexPair<N, SupportNumber<A, B>> pair{ConvexView<N>(core_a), ConvexView<N>(core_b), radius};
  const Motion<N, double> about_a = centered(motion_a, core_a);
  const Motion<N, double> about_b = centered(motion_b, core_b);
  const double reach = reach_from(about_a.center, core_a);
  const Course<N> course = course_of(about_a, about_b, reach, radius);
  const std::optional<double> start = time_of_balls(course, reach + reach_from(about_b.center, core_b) + radius);
  if (!start) return std::nullopt;
  return advance_to_impact(pair, course, *start, core_radius(b));
}

template <Convex A, class B>
requires is_level<B> std::optional<Strike<dimension_of<A>>> strike_of_moving(const A& a, const MotionOf<A>& motion_a,
                                                                             const B& b, const MotionOf<A>& motion_b) {
  constexpr Dim N = dimension_of<A>;
  const auto& core_a = core(a);
  const double radius = core_radius(a);
  const Proximity<N, double> gap = proximity(a, b);
  const double reach = reach_from(motion_a.center, core_a);
  const Course<N> course = course_of(motion_a, motion_b, reach, radius);
  const double largest = course.size + sum_abs(motion_a.center) + sum_abs(motion_b.center);
  const LevelPair<N, SupportNumber<A, A>> pair{ConvexView<N>(core_a), radius, gap.normal, dot(gap.normal, gap.point_b),
                                               gap.error + support_error<A> * largest};
  return advance_to_impact(pair, course, 0, 0);
}

/// Whether a turns in the smaller ball, or as the first of two that are equal. It is to be the one that moves: a plane
/// that rests on the larger one parts them longer, since less of what turns past it reaches far.
template <Convex A, Convex B>
bool is_smaller(const A& a, const MotionOf<A>& motion_a, const B& b, const MotionOf<A>& motion_b) {
  const double reach_a = reach_from(centered(motion_a, core(a)).center, core(a));
  const double reach_b = reach_from(centered(motion_b, core(b)).center, core(b));
  return reach_a != reach_b ? reach_a < reach_b : is_in_order(a, b);
}

/// The same whichever of the two is named first.
template <class A, class B>
std::optional<Strike<dimension_of<A>>> strike_in_motion(const A& a, const MotionOf<A>& motion_a, const B& b,
                                                        const MotionOf<A>& motion_b) {
  if constexpr (is_level<B>) {
    return strike_of_moving(a, motion_a, b, motion_b);
  } else {
    if constexpr (!is_level<A>) {
      if (is_smaller(a, motion_a, b, motion_b)) return strike_of_moving(a, motion_a, b, motion_b);
    }
    auto strike = strike_of_moving(b, motion_b, a, motion_a);
    if (strike) strike->normal = Vec<dimension_of<A>, double>(0.0) - strike->normal;
    return strike;
  }
}

template <class S>
inline constexpr bool moves_against_convex = Convex<S> || is_level<S>;

}  // namespace detail

template <Shape S>
using MotionIn = Motion<dimension_of<S>, scalar_of<S>>;

/// The first touch, from t = 0 to t = 1, of two valid shapes (asserted) of one space that move; none if there is none.
/// The shapes are given as they are at t = 0; one of them is convex, the other convex, a plane or a half-space.
/// Touching counts, also at the start and at the end. t is never after the first touch; see above for how much before.
/// Swapping the shapes negates the normal and changes nothing else. For a motion without turning, `shape_cast` is
/// quicker, more exact and for all shapes. Motions whose numbers are not finite touch nothing.
template <Shape A, SameSpace<A> B>
requires((Convex<A> && detail::moves_against_convex<B>) || (Convex<B> && detail::moves_against_convex<A>))  //
    std::optional<Impact<dimension_of<A>, scalar_of<A>>> time_of_impact(const A& a, const MotionIn<A>& motion_a,
                                                                        const B& b, const MotionIn<A>& motion_b) {
  using T = scalar_of<A>;
  assert(detail::is_valid_if_known(a) && detail::is_valid_if_known(b));
  if (!is_finite(motion_a) || !is_finite(motion_b)) return std::nullopt;
  if (const auto contact = detail::penetration(a, b)) {
    return detail::rounded_impact<T>(detail::strike_at_start(*contact));
  }
  const auto strike = detail::strike_in_motion(a, detail::wide_motion(motion_a), b, detail::wide_motion(motion_b));
  if (!strike) return std::nullopt;
  return detail::rounded_impact<T>(*strike);
}

}  // namespace graze
