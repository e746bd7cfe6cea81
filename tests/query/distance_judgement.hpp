// SPDX-License-Identifier: MIT
// Finds errors of closest_points(a, b) and distance(a, b): compares the distance with the oracle's and the reported
// error, and the points with their shapes and each other, according to the contract of closest_points.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/proximity.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>

#include "exact.hpp"
#include "exact/verdict.hpp"
#include "query/pairs.hpp"
#include "query/proximities.hpp"
#include "query/verdict_band.hpp"

namespace graze::test {

/// The errors of one answer.
struct DistanceErrors {
  Judgement judgement = Judgement::right;  ///< Never `within_band`.
  std::string_view fault;                  ///< The first fault; empty if there is none.
  double distance = 0;                     ///< In epsilon of double of the documented size, for shapes that are apart.
  double claimed = 0;                      ///< The same for the error reported with the distance.
  double points = 0;  ///< In epsilon of T of the points' coordinates and the pair's size, and the reported error.
};

/// "A few epsilon" of sizes that are sums of lengths, and of up to three coordinates: the limits of errors of
/// distances, of reported errors, and of points of closed forms and of GJK.
inline constexpr double most_error = 8;
inline constexpr double most_error_of_gjk = 64;
inline constexpr double most_claimed = 256;
inline constexpr double most_off = 8;
inline constexpr double most_off_by_gjk = 128;
inline constexpr double most_off_by_gjk_where_slivers_meet = 1e7;

template <Dim N, class T>
class DistanceJudge {
 public:
  using Any = AnyShape<N, T>;

  /// `truth` with gap and sizes.
  DistanceJudge(const Any& a, const Any& b, const ExactVerdict& truth)
      : a_(a),
        b_(b),
        truth_(truth),
        found_(closest_points_of<N, T>(a, b)),
        is_closed_(is_relative_to_own_size(a.index(), b.index())) {}

  DistanceErrors run() {
    expect(found_.relation == relation_of<N, T>(a_, b_), "another relation");
    expect(distance_of<N, T>(a_, b_) == found_.distance, "distance() differs");
    expect((found_.distance == T(0)) == (found_.relation != Relation::apart), "the distance of separate shapes is 0");
    expect(std::isinf(found_.distance) == (truth_.gap == infinity), "an empty shape must be infinitely far away");
    if (std::isinf(found_.distance)) return errors_;
    expect(detail::exchanged(closest_points_of<N, T>(b_, a_)) == found_, "another answer in the other order");
    if (truth_.is_nearly_parallel || (truth_.gap > 0 && truth_.gap < least_size)) {
      if (errors_.fault.empty()) errors_.judgement = Judgement::outside_range;
      return errors_;
    }
    judge_distance();
    judge_points();
    return errors_;
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  void expect(bool holds, std::string_view fault) {
    if (holds || !errors_.fault.empty()) return;
    errors_.judgement = Judgement::wrong;
    errors_.fault = fault;
  }

  /// The distance before it is rounded to T. Shapes that `relation` calls touching may be apart by its band.
  void judge_distance() {
    const Proximity<N, double> wide = proximity_of<N, T>(a_, b_);
    const double error = std::fabs(wide.distance - std::max(0.0, truth_.gap));
    expect(error <= wide.error, "the distance is off by more than its error");
    const double size = documented_size(truth_.own_size, truth_.largest, a_.index(), b_.index()) * tolerance::epsilon;
    if (!(size > 0) || found_.relation != Relation::apart || wide.status == Status::best_bound) return;
    const double gap_of_gjk = tolerance::gjk_relative_gap * wide.distance;
    expect(error <= (is_closed_ ? most_error : most_error_of_gjk) * size + gap_of_gjk,
           "the distance is off by too much");
    expect(wide.error <= most_claimed * (size + size_of_cut()) + gap_of_gjk, "the reported error is too large");
    errors_.distance = error / size;
    errors_.claimed = std::max(0.0, (wide.error - gap_of_gjk) / size);
  }

  /// A ray is truncated at the bounds of the other shape, which are rounded to T and may be much larger than the pair.
  double size_of_cut() const {
    if (a_.index() != ray_type && b_.index() != ray_type) return 0;
    return tolerance::epsilon * static_cast<double>(std::numeric_limits<T>::epsilon()) * truth_.largest;
  }

  /// Both points are in their shapes, and differ by distance times normal.
  void judge_points() {
    const Vec<N, double> a = wide<N, T>(found_.point_a);
    const Vec<N, double> b = wide<N, T>(found_.point_b);
    const auto epsilon = static_cast<double>(std::numeric_limits<T>::epsilon());
    const double size = epsilon * std::max({max_abs(a), max_abs(b), truth_.own_size, truth_.largest}) + found_.error +
                        static_cast<double>(std::numeric_limits<T>::denorm_min());
    const Vec<N, double> normal = wide<N, T>(found_.normal);
    const Vec<N, double> rest = (b - a) - normal * static_cast<double>(found_.distance);
    const double worst = std::max({off(found_.point_a, a_), off(found_.point_b, b_), max_abs(rest)}) / size;
    const bool is_apart = found_.relation == Relation::apart;
    const double most_off_by_others = is_apart ? most_off_by_gjk : most_off_by_gjk_where_slivers_meet;
    expect(worst <= (is_closed_ ? most_off : most_off_by_others), "the points are off");
    errors_.points = worst;
    const double squared = dot(normal, normal);
    const bool is_unit = std::fabs(squared - 1) <= 4 * epsilon;
    const bool may_be_zero = !is_apart || static_cast<double>(found_.distance) <= found_.error;
    expect(is_unit || (squared == 0 && may_be_zero), "the normal is not a unit vector");
  }

  /// How far a point is from a shape, exactly.
  static double off(const Vec<N, T>& point, const Any& shape) {
    return std::max(0.0, exact_verdict<N, T>(Any(point), shape, Measure::distance).gap);
  }

  const Any& a_;
  const Any& b_;
  const ExactVerdict& truth_;
  Proximity<N, T> found_;
  bool is_closed_;
  DistanceErrors errors_;
};

/// `truth` with gap and sizes.
template <Dim N, class T>
DistanceErrors distance_errors(const AnyShape<N, T>& a, const AnyShape<N, T>& b, const ExactVerdict& truth) {
  return DistanceJudge<N, T>(a, b, truth).run();
}

}  // namespace graze::test
