// SPDX-License-Identifier: MIT
// How time_of_impact.hpp goes from one parting plane to the next, up to the first touch: conservative advancement
// (Mirtich, "Impulse-based dynamic simulation of rigid body systems", 1996; Zhang, Lee, Kim, "Interactive continuous
// collision detection for non-convex polyhedra", 2006) in b's frame. Where those go on by the distance over a bound on
// the speed, and slow down as they come near, this looks for the time at which the plane that now parts the shapes no
// longer does, as Box2D does (Catto, "Continuous collision", 2013), but goes only as far as it can be proved that the
// plane parts them all the way: see Trajectory. What a step has found serves the next one: GJK begins at the corners
// between which the shapes were nearest before, and the plane's gap over time needs no poses, but two directions that
// turn.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include <graze/math/motion.hpp>
#include <graze/math/pose.hpp>
#include <graze/math/rotation.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/cast/minkowski_difference.hpp>
#include <graze/query/cast/moving_difference.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/convex/simplex.hpp>
#include <graze/query/gjk.hpp>
#include <graze/query/impact.hpp>
#include <graze/query/ray/verdict.hpp>
#include <graze/query/status.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

inline constexpr int advance_step_limit = 512;

// ---- The relative motion

inline double size_of_turn(double angle) { return std::fabs(angle); }
inline double size_of_turn(const Vec<3, double>& turn) { return std::sqrt(dot(turn, turn)); }

/// A turn at an even pace, its axis found once.
template <Dim N>
class ConstantRotation;

template <>
class ConstantRotation<2> {
 public:
  explicit ConstantRotation(double whole) : angle_(whole) {}

  /// Cosine (x) and sine (y) of the turn up to t.
  Vec<2, double> at(double t) const { return angle_ == 0 ? Vec<2, double>(1, 0) : cosine_sine(angle_ * t); }

  static Mat<2, double> matrix(const Vec<2, double>& by) { return {by, perpendicular(by)}; }
  static Vec<2, double> turned(const Vec<2, double>& v, const Vec<2, double>& by) { return matrix(by) * v; }

 private:
  double angle_;
};

template <>
class ConstantRotation<3> {
 public:
  explicit ConstantRotation(const Vec<3, double>& whole)
      : angle_(size_of_turn(whole)), axis_(angle_ == 0 ? unit_axis<3>(0) : whole / angle_) {}

  Vec<2, double> at(double t) const { return angle_ == 0 ? Vec<2, double>(1, 0) : cosine_sine(angle_ * t); }

  Mat<3, double> matrix(const Vec<2, double>& by) const { return rotation_about(axis_, by); }
  Vec<3, double> turned(const Vec<3, double>& v, const Vec<2, double>& by) const {
    return v * by.x + cross(axis_, v) * by.y + axis_ * (dot(axis_, v) * (1 - by.x));
  }

 private:
  double angle_;
  Vec<3, double> axis_;
};

/// A time, and cosine (x) and sine (y) of how far a and b have turned by then.
struct Moment {
  double t;
  Vec<2, double> by_a;
  Vec<2, double> by_b;
};

/// How a moves as b sees it, and how much the way of any point of a bends: the length of its second derivative.
///
/// A plane at rest parts a from b by some gap at two times, and by h(x) from each point x of a. In between, dt apart,
/// h(x) is nowhere lower than the chord between its heights at both times by more than bend dt^2 / 8; so the gap is
/// nowhere lower than the parabola below the chord of the gaps.
template <Dim N>
struct Trajectory {
  Motion<N, double> a;
  Motion<N, double> b;
  double bend;
  double size;  ///< A bound on all lengths of the pair and its way: what rounding and the target are relative to.
  ConstantRotation<N> turn_a = ConstantRotation<N>(a.angular);
  ConstantRotation<N> turn_b = ConstantRotation<N>(b.angular);

  Moment at(double t) const { return {t, turn_a.at(t), turn_b.at(t)}; }

  /// Where a is then, seen from b.
  Pose<N, double> pose_of_a(const Moment& now) const {
    const Mat<N, double> of_a = turn_a.matrix(now.by_a);
    const Mat<N, double> back = transpose(turn_b.matrix(now.by_b));
    const Vec<N, double> way = (a.linear - b.linear) * now.t + (a.center - b.center);
    return {back * of_a, back * (way - of_a * a.center) + b.center};
  }

  /// Where b is then, seen from the world.
  Pose<N, double> pose_of_b(const Moment& now) const {
    const Mat<N, double> of_b = turn_b.matrix(now.by_b);
    return {of_b, b.center + b.linear * now.t - of_b * b.center};
  }
};

/// In a frame that turns with b, with w the turns, v the ways, c the centers, and r how far a reaches from its own:
/// what a's turning adds is (|w_a| + |w_b|)^2 r, or nothing if both turn alike, and what its center adds 2 |w_b| |v_a -
/// v_b| (Coriolis) and |w_b|^2 |c_a - c_b|, as far apart as the centers get.
template <Dim N>
Trajectory<N> trajectory_of(const Motion<N, double>& a, const Motion<N, double>& b, double reach, double radius) {
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

/// What parts two shapes at some time.
template <Dim N>
struct Parting {
  Vec<N, double> normal = Vec<N, double>(0.0);  ///< Of length 1, from a to b, as b sees it.
  double gap = 0;                               ///< Along the normal, rounding taken off.
  double distance = 0;                          ///< No less than how far apart they are.
  double resolution = 0;
};

/// Two convex shapes, as cores and the sum of their radii. Remembers between which corners they were nearest when it
/// was last asked.
template <Dim N, Scalar Number>
class ConvexPair {
 public:
  ConvexPair(const ConvexView<N>& a, const ConvexView<N>& b, double radius) : a_(a), b_(b), radius_(radius) {}

  const ConvexView<N>& a() const { return a_; }

  /// How high above zero, along a normal, the shape b begins, a's radius taken off as well.
  double floor_along(const Vec<N, double>& normal) const { return dot(normal, b_.support(-normal)) - radius_; }

  Parting<N> parting_at(const Pose<N, double>& pose) {
    MovingDifference<N, Number> differences(a_, b_, pose);
    found_ = corners_.size == 0 ? gjk_on(differences, {})
                                : gjk_walk(differences, nearest_to_origin(differences.simplex_of(corners_)), {});
    corners_ = differences.corners_of(found_.simplex);
    Parting<N> parting;
    parting.resolution = found_.resolution + tolerance::rounding * radius_;
    parting.distance = std::max(0.0, found_.upper - radius_);
    parting.normal = unit_or(-found_.normal, Vec<N, double>(0.0));
    parting.gap = found_.lower - radius_ - parting.resolution;
    return parting;
  }

  /// Where they are nearest, as b sees it: between the two surfaces, which are as good as one. Of the pose that
  /// `parting_at` was asked about last.
  Vec<N, double> point_at(const Pose<N, double>& pose, const Vec<N, double>& normal, double radius_b) const {
    MovingDifference<N, Number> differences(a_, b_, pose);
    GjkResult<N> known = found_;
    known.simplex = differences.simplex_of(corners_);
    return closest_from(differences, known).closest.on_b - normal * radius_b;
  }

 private:
  ConvexView<N> a_;
  ConvexView<N> b_;
  double radius_;
  GjkResult<N> found_;              ///< When last asked.
  CornersOfDifference<N> corners_;  ///< Of its simplex.
};

/// A convex shape before a plane: one normal parts them all the time, or nothing does.
template <Dim N>
class HalfSpacePair {
 public:
  /// The plane's normal of length 1, into it, and its height along that; what rounding makes of heights.
  HalfSpacePair(const ConvexView<N>& a, double radius, const Vec<N, double>& normal, double height, double slack)
      : a_(a), radius_(radius), normal_(normal), height_(height), slack_(slack) {}

  const ConvexView<N>& a() const { return a_; }

  double floor_along(const Vec<N, double>&) const { return height_ - radius_; }

  Parting<N> parting_at(const Pose<N, double>& pose) const {
    const double gap = height_ - radius_ - dot(normal_, foremost(pose));
    return {normal_, gap - slack_, std::max(0.0, gap), slack_};
  }

  Vec<N, double> point_at(const Pose<N, double>& pose, const Vec<N, double>&, double) const {
    return foremost(pose) + normal_ * radius_;
  }

 private:
  Vec<N, double> foremost(const Pose<N, double>& pose) const {
    return pose.rotation * a_.support(transpose(pose.rotation) * normal_) + pose.position;
  }

  ConvexView<N> a_;
  double radius_;
  Vec<N, double> normal_;
  double height_;
  double slack_;
};

/// The gap that a plane across a normal, at rest as b sees it, leaves between a pair in time. With n the normal as the
/// world sees it and d as a does, p the foremost point of a, v the ways and c the centers, the points of a reach up to
/// d . (p - c_a) + n . (c_a - c_b + (v_a - v_b) t), counted from b's center.
template <Dim N, class Pair>
class GapInTime {
 public:
  GapInTime(const Pair& pair, const Trajectory<N>& trajectory, const Vec<N, double>& normal)
      : pair_(pair),
        trajectory_(trajectory),
        normal_(normal),
        floor_(pair.floor_along(normal) - dot(normal, trajectory.b.center)),
        between_(trajectory.a.center - trajectory.b.center),
        way_(trajectory.a.linear - trajectory.b.linear) {}

  double at(const Moment& now) const {
    const Vec<N, double> seen = trajectory_.turn_b.turned(normal_, now.by_b);
    const Vec<N, double> direction = trajectory_.turn_a.turned(seen, Vec<2, double>(now.by_a.x, -now.by_a.y));
    const Vec<N, double> foremost = pair_.a().support(direction);
    return floor_ - dot(direction, foremost - trajectory_.a.center) - dot(seen, between_ + way_ * now.t);
  }

 private:
  const Pair& pair_;
  const Trajectory<N>& trajectory_;
  Vec<N, double> normal_;
  double floor_;
  Vec<N, double> between_;
  Vec<N, double> way_;
};

// ---- From one parting plane to the next

/// The least of a parabola from g at 0 to h at 1 whose second derivative is 2 c: g + s (h - g - c) + c s^2.
inline double least_between(double g, double h, double c) {
  const double fall = g + c - h;
  if (!(fall > 0 && fall < 2 * c)) return std::min(g, h);
  return g - fall * fall / (4 * c);
}

/// The latest time found, up to 1, until which the plane of a parting keeps a gap of `goal`. With `latest` such that
/// bend dt^2 / 2 is half of what may be lost, so that a chord that ends at the goal is not undercut. Where that does
/// not hold, the root of what is left above the goal is closed in on, by the secant (with one end weighed down that
/// stays, the Illinois algorithm: Dowell, Jarratt, "A modified regula falsi method", 1971) or each third time by
/// halves, until little of it is left.
template <Dim N, class Pair>
Moment moment_parted(const Pair& pair, const Trajectory<N>& trajectory, const Moment& now, const Parting<N>& parting,
                     double goal) {
  constexpr int step_limit = 96;
  const GapInTime<N, Pair> gap(pair, trajectory, parting.normal);
  const double spare = parting.gap - goal;
  Moment kept_moment = now;
  // What is left above the goal after a step, of a plane that is kept until then if that is not negative.
  const auto left_after = [&](double step) {
    const Moment then = trajectory.at(now.t + step);
    const double after = gap.at(then) - parting.resolution;
    const double left = least_between(parting.gap, after, trajectory.bend * step * step / 2) - goal;
    if (left >= 0) kept_moment = then;
    return left;
  };
  double latest = 1 - now.t;
  if (trajectory.bend * latest * latest > spare) latest = std::min(latest, std::sqrt(spare / trajectory.bend));
  double over = left_after(latest);
  if (over >= 0) return kept_moment;
  const double little = std::max(goal / 2, spare * tolerance::impact_plane);
  double kept = 0;
  double left = spare;
  bool was_kept = false;
  for (int i = 1; i <= step_limit && !(was_kept && left <= little); ++i) {
    const double aim = std::max(left / 2, left - little / 2);  // so that the last step is one that is kept
    const double share = i % 3 == 0 ? 0.5 : std::min(1 - 0x1p-10, aim / (left - over));
    const double step = kept + (latest - kept) * share;
    if (!(kept < step && step < latest)) break;
    const double found = left_after(step);
    const bool is_kept = found >= 0;
    if (i > 1 && is_kept == was_kept) (is_kept ? over : left) *= 0.5;
    (is_kept ? kept : latest) = step;
    (is_kept ? left : over) = found;
    was_kept = is_kept;
  }
  return kept_moment;
}

/// Before this time the spheres that the shapes turn in do not touch; none if they never do. The spheres are larger
/// than they need be by twice the target, which hides all rounding, and by more than GJK cannot resolve: at their touch
/// it still tells a normal.
template <Dim N>
std::optional<double> time_of_spheres(const Trajectory<N>& trajectory, double reach) {
  const double largest = reach + sum_abs(trajectory.a.center) + sum_abs(trajectory.b.center);
  const double radius =
      reach + 2 * tolerance::impact * (trajectory.size + reach) + 16 * tolerance::convex * (trajectory.size + largest);
  const Vec<N, double> between = trajectory.b.center - trajectory.a.center;
  const Vec<N, double> way = trajectory.a.linear - trajectory.b.linear;
  if (dot(between, between) <= radius * radius) return 0;
  if (!(dot(way, way) > 0)) return std::nullopt;
  const SpherePassage<N> passage(way, between, radius * radius);
  if (!(passage.depth >= 0 && passage.exit() >= 0 && passage.enter() <= 1)) return std::nullopt;
  return std::max(0.0, passage.enter());
}

/// Goes on from t until the shapes are as near as the target, or the motion ends. Half of the target is kept, so that
/// rounding cannot spend it.
template <Dim N, class Pair>
std::optional<CastHit<N>> advance_to_impact(Pair pair, const Trajectory<N>& trajectory, double t, double radius_b) {
  Moment now = trajectory.at(t);
  Parting<N> parting;
  bool has_arrived = false;
  for (int step = 0; step < advance_step_limit; ++step) {
    parting = pair.parting_at(trajectory.pose_of_a(now));
    const double target = std::max(tolerance::impact * trajectory.size, 8 * parting.resolution);
    has_arrived = parting.gap <= target;
    if (has_arrived) break;
    if (now.t >= 1) return std::nullopt;
    const Moment next = moment_parted(pair, trajectory, now, parting, target / 2);
    if (!(next.t > now.t)) break;
    now = next;
  }
  const Pose<N, double> pose_of_a = trajectory.pose_of_a(now);
  if (!has_arrived) parting = pair.parting_at(pose_of_a);  // at the limit t has gone on since
  const bool is_near = parting.distance <= 2 * tolerance::impact * trajectory.size + 16 * parting.resolution;
  const Pose<N, double> back = trajectory.pose_of_b(now);
  const Vec<N, double> point = pair.point_at(pose_of_a, parting.normal, radius_b);
  return CastHit<N>{now.t, back.rotation * point + back.position, back.rotation * parting.normal,
                    has_arrived && is_near ? Status::converged : Status::best_bound,
                    parting.distance + parting.resolution};
}

}  // namespace graze::detail
