// SPDX-License-Identifier: MIT
// distance(a, b) and closest_points(a, b) against the exact oracle: every pair of shape types, seven kinds of cases,
// four spaces. The distance is within the error that comes with it, which is no larger than documented; both points are
// in their shapes, and as far from each other as the distance says.
//
// GRAZE_TEST_SCALE multiplies the number of cases (default 1), GRAZE_TEST_SEED chooses others.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/proximity.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "exact.hpp"
#include "query/every_pair.hpp"
#include "query/pairs.hpp"
#include "query/placement.hpp"
#include "query/proximities.hpp"
#include "query/verdict_band.hpp"

namespace graze::test::distance_agreement_test {
namespace {

/// What a run has seen: the largest errors, each in units of what it is relative to.
struct Tally {
  std::size_t cases = 0;
  std::size_t apart = 0;
  double distance = 0;  ///< In epsilon of double of the documented size, of shapes that are apart.
  double claimed = 0;   ///< The same of the error that comes with the distance.
  double points = 0;    ///< In epsilon of T of the points' coordinates and the pair's size.
  std::string worst_distance;
  std::string worst_points;
  std::size_t failures = 0;
};

/// "A few epsilon" of sizes that are sums of lengths, and those of up to three coordinates: what distances are off by,
/// what they say that they may be, and points of closed forms and of GJK.
constexpr double most_error = 8;
constexpr double most_error_of_gjk = 64;
constexpr double most_claimed = 256;
constexpr double most_off = 8;
constexpr double most_off_by_gjk = 128;
constexpr double most_off_by_gjk_where_slivers_meet = 1e7;

/// A run that has failed this often says no more.
constexpr std::size_t most_failures = 5;

template <Dim N, class T>
class PairCheck {
 public:
  using Any = AnyShape<N, T>;

  PairCheck(const AnyPair<N, T>& pair, Tally& tally) : a_(pair.first), b_(pair.second), tally_(tally) {}

  void run() {
    found_ = closest_points_of<N, T>(a_, b_);
    expect(found_.relation == relation_of<N, T>(a_, b_), "the relation is another");
    expect(distance_of<N, T>(a_, b_) == found_.distance, "distance() is another");
    expect((found_.distance == T(0)) == (found_.relation != Relation::apart), "0 is for those that meet");
    ++tally_.cases;
    if (found_.relation == Relation::apart) ++tally_.apart;
    if (std::isinf(found_.distance)) return;
    expect(detail::exchanged(closest_points_of<N, T>(b_, a_)) == found_, "it is another in the other order");
    const ExactVerdict truth = exact_verdict<N, T>(a_, b_, Measure::distance);
    if (truth.is_nearly_parallel || (truth.gap > 0 && truth.gap < least_size)) return;
    check_distance(truth);
    check_points();
  }

 private:
  void expect(bool holds, const std::string& what) {
    if (holds) return;
    ++tally_.failures;
    ADD_FAILURE() << what << ": " << to_source<N, T>(a_) << ", " << to_source<N, T>(b_) << "; distance "
                  << found_.distance << " at " << to_source(found_.point_a) << ", " << to_source(found_.point_b)
                  << ", normal " << to_source(found_.normal) << ", error " << found_.error;
  }

  /// Keeps the largest error of a kind, and the case.
  void keep(double error, double& largest, std::string& worst) {
    if (!(error > largest)) return;
    largest = error;
    worst = to_source<N, T>(a_) + ", " + to_source<N, T>(b_);
  }

  /// The distance before it is rounded to T. What `relation` calls touching may be apart by its band.
  void check_distance(const ExactVerdict& truth) {
    const Proximity<N, double> wide = proximity_of<N, T>(a_, b_);
    const double error = std::fabs(wide.distance - std::max(0.0, truth.gap));
    expect(error <= wide.error, "the distance is off by " + literal(error) + ", from " + literal(truth.gap));
    const ExactVerdict sizes = exact_verdict<N, T>(a_, b_, Measure::depth);
    size_ = std::max(sizes.own_size, sizes.largest);
    const double size = documented_size(sizes.own_size, sizes.largest, a_.index(), b_.index()) * tolerance::epsilon;
    if (!(size > 0) || found_.relation != Relation::apart || wide.status == Status::best_bound) return;
    const double gap_of_gjk = tolerance::gjk_relative_gap * wide.distance;
    expect(error <= (is_closed() ? most_error : most_error_of_gjk) * size + gap_of_gjk,
           "the distance is off by too much");
    expect(wide.error <= most_claimed * size + gap_of_gjk, "too large an error is admitted");
    keep(error / size, tally_.distance, tally_.worst_distance);
    tally_.claimed = std::max(tally_.claimed, (wide.error - gap_of_gjk) / size);
  }

  bool is_closed() const { return is_relative_to_own_size(a_.index(), b_.index()); }

  /// How far a point is from a shape, exactly.
  static double off(const Vec<N, T>& point, const Any& shape) {
    return std::max(0.0, exact_verdict<N, T>(Any(point), shape, Measure::distance).gap);
  }

  /// Both points are in their shapes, and apart by distance times normal.
  void check_points() {
    const Vec<N, double> a = wide<N, T>(found_.point_a);
    const Vec<N, double> b = wide<N, T>(found_.point_b);
    const auto epsilon = static_cast<double>(std::numeric_limits<T>::epsilon());
    const double size = epsilon * std::max({max_abs(a), max_abs(b), size_}) + found_.error +
                        static_cast<double>(std::numeric_limits<T>::denorm_min());
    const Vec<N, double> normal = wide<N, T>(found_.normal);
    const Vec<N, double> rest = (b - a) - normal * static_cast<double>(found_.distance);
    const double worst = std::max({off(found_.point_a, a_), off(found_.point_b, b_), max_abs(rest)}) / size;
    const bool is_apart = found_.relation == Relation::apart;
    const double most_off_by_others = is_apart ? most_off_by_gjk : most_off_by_gjk_where_slivers_meet;
    expect(worst <= (is_closed() ? most_off : most_off_by_others),
           "the points are off by " + literal(worst) + " epsilon");
    keep(worst, tally_.points, tally_.worst_points);
    const double squared = dot(normal, normal);
    const bool is_unit = std::fabs(squared - 1) <= 4 * epsilon;
    const bool may_be_zero = !is_apart || static_cast<double>(found_.distance) <= found_.error;
    expect(is_unit || (squared == 0 && may_be_zero), "the normal is not of length 1");
  }

  const Any& a_;
  const Any& b_;
  Tally& tally_;
  Proximity<N, T> found_;
  double size_ = 0;
};

template <class SpaceType>
class DistanceAgreement : public ::testing::Test {
 public:
  static void run(CaseKind kind) {
    constexpr Dim N = SpaceType::dimension;
    using T = typename SpaceType::scalar;
    Tally tally;
    for_each_case<N, T>(
        kind, number_of_cases(6), [&tally](const AnyPair<N, T>& pair) { PairCheck<N, T>(pair, tally).run(); },
        [&tally] { return tally.failures < most_failures; });
    std::cout << "seed " << seed_of_cases() << ": " << tally.cases << " cases, " << tally.apart
              << " apart; distances are off by " << tally.distance << " epsilon at most and say so up to "
              << tally.claimed << ", points by " << tally.points << "\n"
              << "the worst distance: " << tally.worst_distance << "\nthe worst points: " << tally.worst_points << "\n";
    EXPECT_GE(tally.apart * 8, tally.cases) << "too few are apart to prove anything";
  }
};

TYPED_TEST_SUITE(DistanceAgreement, Spaces);

TYPED_TEST(DistanceAgreement, OnUniformNumbers) { TestFixture::run(CaseKind::uniform); }
TYPED_TEST(DistanceAgreement, OnSmallWholeNumbers) { TestFixture::run(CaseKind::grid); }
TYPED_TEST(DistanceAgreement, OnNumbersOfAllSizes) { TestFixture::run(CaseKind::scales); }
TYPED_TEST(DistanceAgreement, FarFromTheOrigin) { TestFixture::run(CaseKind::far); }
TYPED_TEST(DistanceAgreement, OnShapesThatShareCorners) { TestFixture::run(CaseKind::shared_points); }
TYPED_TEST(DistanceAgreement, WhereTheVerdictChanges) { TestFixture::run(CaseKind::border); }
TYPED_TEST(DistanceAgreement, OfNearlyParallelEdges) { TestFixture::run(CaseKind::nearly_parallel); }

}  // namespace
}  // namespace graze::test::distance_agreement_test
