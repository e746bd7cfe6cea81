// SPDX-License-Identifier: MIT
// The steps of time_of_impact.hpp from one separating plane to the next, up to the first contact: conservative
// advancement (Mirtich, "Impulse-based dynamic simulation of rigid body systems", 1996; Zhang, Lee, Kim, "Interactive
// continuous collision detection for non-convex polyhedra", 2006) in b's frame. Those advance by the distance divided
// by a bound on the speed, and slow down near contact. This one finds the time at which the current separating plane no
// longer separates the shapes, as Box2D does (Catto, "Continuous collision", 2013), but advances only as far as the
// plane provably separates them: see Trajectory. The results of a step are reused: GJK starts at the corners that were
// nearest before, and the plane's gap over time needs no poses, only two rotating directions.
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

/// A rotation at constant speed, with a precomputed axis.
template <Dim N>
class ConstantRotation;

template <>
class ConstantRotation<2> {
 public:
  explicit ConstantRotation(double whole) : angle_(whole) {}

  /// Cosine (x) and sine (y) of the rotation up to t.
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

/// A time, and cosine (x) and sine (y) of the rotations of a and b until then.
struct Moment {
  double t;
  Vec<2, double> by_a;
  Vec<2, double> by_b;
};

/// The motion of a relative to b, and a bound on the curvature of any point's path: the length of its second
/// derivative.
///
/// A plane fixed in b's frame separates a from b by some gap at two times, and by h(x) from each point x of a. In
/// between, dt apart, h(x) is below the chord between its heights at both times by at most bend dt^2 / 8; so the gap is
/// never below the parabola under the chord of the gaps.
template <Dim N>
struct Trajectory {
  Motion<N, double> a;
  Motion<N, double> b;
  double bend;
  double size;  ///< A bound on all lengths of the pair and its motion: rounding and the target are relative to it.
  ConstantRotation<N> turn_a = ConstantRotation<N>(a.angular);
  ConstantRotation<N> turn_b = ConstantRotation<N>(b.angular);

  Moment at(double t) const { return {t, turn_a.at(t), turn_b.at(t)}; }

  /// The pose of a at that time, relative to b.
  Pose<N, double> pose_of_a(const Moment& now) const {
    const Mat<N, double> of_a = turn_a.matrix(now.by_a);
    const Mat<N, double> back = transpose(turn_b.matrix(now.by_b));
    const Vec<N, double> way = (a.linear - b.linear) * now.t + (a.center - b.center);
    return {back * of_a, back * (way - of_a * a.center) + b.center};
  }

  /// The pose of b at that time, in world coordinates.
  Pose<N, double> pose_of_b(const Moment& now) const {
    const Mat<N, double> of_b = turn_b.matrix(now.by_b);
    return {of_b, b.center + b.linear * now.t - of_b * b.center};
  }
};

/// In a frame that rotates with b, with the angular velocities w, the velocities v, the centers c, and r the extent of
/// a from its own: a's rotation adds (|w_a| + |w_b|)^2 r, or nothing if both rotate alike, and its center adds 2 |w_b|
/// |v_a - v_b| (Coriolis) and |w_b|^2 |c_a - c_b| for the largest distance of the centers.
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

/// The largest distance of a point of a shape's core from a given point.
template <Convex S>
double reach_from(const Vec<dimension_of<S>, double>& center, const S& shape) {
  constexpr Dim N = dimension_of<S>;
  const auto box = bounds(shape);
  const Vec<N, double> reach =
      max(abs(wide<N, scalar_of<S>>(box.min) - center), abs(wide<N, scalar_of<S>>(box.max) - center));
  return std::sqrt(dot(reach, reach));
}

// ---- The gap between b at rest and a in a given pose

/// What separates two shapes at some time.
template <Dim N>
struct GapState {
  Vec<N, double> normal = Vec<N, double>(0.0);  ///< Unit vector, from a to b, in b's frame.
  double gap = 0;                               ///< Along the normal, minus the rounding error.
  double distance = 0;                          ///< An upper bound of the distance.
  double resolution = 0;
};

/// Two convex shapes, as cores and the sum of their radii. Caches the nearest corners of the last query.
template <Dim N, Scalar Number>
class ConvexPair {
 public:
  ConvexPair(const ConvexView<N>& a, const ConvexView<N>& b, double radius) : a_(a), b_(b), radius_(radius) {}

  const ConvexView<N>& a() const { return a_; }

  /// The height of the start of b along a normal, minus a's radius.
  double floor_along(const Vec<N, double>& normal) const { return dot(normal, b_.support(-normal)) - radius_; }

  GapState<N> gap_state_at(const Pose<N, double>& pose) {
    MovingDifference<N, Number> differences(a_, b_, pose);
    found_ = corners_.size == 0 ? gjk_on(differences, {})
                                : gjk_walk(differences, nearest_to_origin(differences.simplex_of(corners_)), {});
    corners_ = differences.corners_of(found_.simplex);
    GapState<N> state;
    state.resolution = found_.resolution + tolerance::rounding * radius_;
    state.distance = std::max(0.0, found_.upper - radius_);
    state.normal = unit_or(-found_.normal, Vec<N, double>(0.0));
    state.gap = found_.lower - radius_ - state.resolution;
    return state;
  }

  /// The nearest point in b's frame: between the two surfaces, which nearly coincide. For the pose of the last call of
  /// `gap_state_at`.
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
  GjkResult<N> found_;              ///< Of the last query.
  CornersOfDifference<N> corners_;  ///< Of its simplex.
};

/// A convex shape and a plane: one normal separates them all the time, or none does.
template <Dim N>
class HalfSpacePair {
 public:
  /// The plane's unit normal, pointing into it, its height along that, and the rounding error of heights.
  HalfSpacePair(const ConvexView<N>& a, double radius, const Vec<N, double>& normal, double height, double slack)
      : a_(a), radius_(radius), normal_(normal), height_(height), slack_(slack) {}

  const ConvexView<N>& a() const { return a_; }

  double floor_along(const Vec<N, double>&) const { return height_ - radius_; }

  GapState<N> gap_state_at(const Pose<N, double>& pose) const {
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

/// The gap over time that a plane with a normal fixed in b's frame leaves between a pair. With n the normal in world
/// coordinates and d in a's frame, p the foremost point of a, v the velocities and c the centers, the points of a
/// extend to d . (p - c_a) + n . (c_a - c_b + (v_a - v_b) t), relative to b's center.
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

// ---- From one separating plane to the next

/// The minimum of a parabola from g at 0 to h at 1 with the second derivative 2 c: g + s (h - g - c) + c s^2.
inline double least_between(double g, double h, double c) {
  const double fall = g + c - h;
  if (!(fall > 0 && fall < 2 * c)) return std::min(g, h);
  return g - fall * fall / (4 * c);
}

/// The latest time found, up to 1, until which the separating plane keeps a gap of `goal`. `latest` is such that bend
/// dt^2 / 2 is half of what may be lost, so that a chord that ends at the goal is not undercut. If the plane does not
/// hold until then, the root of the remainder above the goal is bracketed, by the secant method (with one weighted end,
/// the Illinois algorithm: Dowell, Jarratt, "A modified regula falsi method", 1971) or every third time by bisection,
/// until little of it remains.
template <Dim N, class Pair>
Moment moment_parted(const Pair& pair, const Trajectory<N>& trajectory, const Moment& now, const GapState<N>& state,
                     double goal) {
  constexpr int step_limit = 96;
  const GapInTime<N, Pair> gap(pair, trajectory, state.normal);
  const double spare = state.gap - goal;
  Moment kept_moment = now;
  // What remains above the goal after a step, for a plane that holds until then if the result is not negative.
  const auto left_after = [&](double step) {
    const Moment then = trajectory.at(now.t + step);
    const double after = gap.at(then) - state.resolution;
    const double left = least_between(state.gap, after, trajectory.bend * step * step / 2) - goal;
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
    const double aim = std::max(left / 2, left - little / 2);  // so that the last step is one that holds
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

/// Before this time the spheres that the shapes rotate in do not touch; none if they never do. The spheres are larger
/// than necessary by twice the target, which covers all rounding, and by more than GJK's resolution: when they touch,
/// GJK still finds a normal.
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

/// Advances from t until the shapes are within the target, or the motion ends. Half of the target is kept as a reserve
/// for rounding.
template <Dim N, class Pair>
std::optional<CastHit<N>> advance_to_impact(Pair pair, const Trajectory<N>& trajectory, double t, double radius_b) {
  Moment now = trajectory.at(t);
  GapState<N> state;
  bool has_arrived = false;
  for (int step = 0; step < advance_step_limit; ++step) {
    state = pair.gap_state_at(trajectory.pose_of_a(now));
    const double target = std::max(tolerance::impact * trajectory.size, 8 * state.resolution);
    has_arrived = state.gap <= target;
    if (has_arrived) break;
    if (now.t >= 1) return std::nullopt;
    const Moment next = moment_parted(pair, trajectory, now, state, target / 2);
    if (!(next.t > now.t)) break;
    now = next;
  }
  const Pose<N, double> pose_of_a = trajectory.pose_of_a(now);
  if (!has_arrived) state = pair.gap_state_at(pose_of_a);  // at the limit, t has advanced since
  const bool is_near = state.distance <= 2 * tolerance::impact * trajectory.size + 16 * state.resolution;
  const Pose<N, double> back = trajectory.pose_of_b(now);
  const Vec<N, double> point = pair.point_at(pose_of_a, state.normal, radius_b);
  return CastHit<N>{now.t, back.rotation * point + back.position, back.rotation * state.normal,
                    has_arrived && is_near ? Status::converged : Status::best_bound, state.distance + state.resolution};
}

}  // namespace graze::detail
