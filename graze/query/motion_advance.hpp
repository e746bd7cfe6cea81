// SPDX-License-Identifier: MIT
// How time_of_impact.hpp goes from one parting plane to the next, up to the first touch: conservative advancement
// (Mirtich, "Impulse-based dynamic simulation of rigid body systems", 1996; Zhang, Lee, Kim, "Interactive continuous
// collision detection for non-convex polyhedra", 2006) in b's frame. Where those go on by the distance over a bound on
// the speed, and slow down as they come near, this looks for the time at which the plane that now parts the shapes no
// longer does, as Box2D does (Catto, "Continuous collision", 2013), but goes only as far as it can be proved that the
// plane parts them all the way: see Course.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>

#include <graze/math/motion.hpp>
#include <graze/math/pose.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/gjk.hpp>
#include <graze/query/impact.hpp>
#include <graze/query/obstacle.hpp>
#include <graze/query/ray_sight.hpp>
#include <graze/query/status.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

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
    parting.normal = unit_or(-found.normal, Vec<N, double>(0.0));
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

}  // namespace graze::detail
