// SPDX-License-Identifier: MIT
// distance(a, b) and closest_points(a, b) against the exact oracle: every pair of shape types, eight kinds of cases,
// four spaces. The distance is within the reported error, which is at most the documented one; both points are in their
// shapes, and as far from each other as the distance says.
//
// GRAZE_TEST_SCALE multiplies the number of cases (default 1), GRAZE_TEST_SEED selects others.
#include <algorithm>
#include <cstddef>
#include <iostream>
#include <string>

#include <gtest/gtest.h>

#include <graze/math/vec.hpp>
#include <graze/query/proximity.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "exact.hpp"
#include "query/distance_judgement.hpp"
#include "query/every_pair.hpp"
#include "query/pairs.hpp"
#include "query/proximities.hpp"
#include "query/verdict_band.hpp"

namespace graze::test::distance_agreement_test {
namespace {

/// Statistics of a run: the largest errors, in the units of DistanceErrors.
struct Tally {
  std::size_t cases = 0;
  std::size_t apart = 0;
  double distance = 0;
  double claimed = 0;
  double points = 0;
  std::string worst_distance;
  std::string worst_points;
  std::size_t failures = 0;
};

/// After this many failures, a run prints no more.
constexpr std::size_t most_failures = 5;

/// Records the largest error of a kind, and the case.
template <Dim N, class T>
void keep(double error, const AnyPair<N, T>& pair, double& largest, std::string& worst) {
  if (!(error > largest)) return;
  largest = error;
  worst = to_source<N, T>(pair.first) + ", " + to_source<N, T>(pair.second);
}

template <Dim N, class T>
void check_pair(CaseKind kind, const AnyPair<N, T>& pair, Tally& tally) {
  const auto& [a, b] = pair;
  const ExactVerdict truth = exact_verdict<N, T>(a, b);
  const DistanceErrors errors = distance_errors<N, T>(a, b, truth);
  const Proximity<N, T> found = closest_points_of<N, T>(a, b);
  ++tally.cases;
  if (found.relation == Relation::apart) ++tally.apart;
  keep<N, T>(errors.distance, pair, tally.distance, tally.worst_distance);
  keep<N, T>(errors.points, pair, tally.points, tally.worst_points);
  tally.claimed = std::max(tally.claimed, errors.claimed);
  const bool has_ended = found.status == Status::converged || kind != CaseKind::flush_faces;
  EXPECT_TRUE(has_ended) << "not converged: " << to_source<N, T>(a) << ", " << to_source<N, T>(b);
  if (errors.judgement != Judgement::wrong) return;
  ++tally.failures;
  ADD_FAILURE() << errors.fault << ": " << to_source<N, T>(a) << ", " << to_source<N, T>(b) << "; distance "
                << found.distance << " at " << to_source(found.point_a) << ", " << to_source(found.point_b)
                << ", normal " << to_source(found.normal) << ", error " << found.error << "; the gap is "
                << literal(truth.gap) << ", the errors " << errors.distance << " and " << errors.points
                << " (of the points)";
}

template <class SpaceType>
class DistanceAgreement : public ::testing::Test {
 public:
  static void run(CaseKind kind) {
    constexpr Dim N = SpaceType::dimension;
    using T = typename SpaceType::scalar;
    Tally tally;
    for_each_case<N, T>(
        kind, number_of_cases(6), [&](const AnyPair<N, T>& pair) { check_pair<N, T>(kind, pair, tally); },
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
TYPED_TEST(DistanceAgreement, OfFacesThatAreNearlyFlush) { TestFixture::run(CaseKind::flush_faces); }

}  // namespace
}  // namespace graze::test::distance_agreement_test
