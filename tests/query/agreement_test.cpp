// SPDX-License-Identifier: MIT
// relation(a, b) against the exact oracle: every pair of shape types, eight kinds of cases, four spaces. A verdict may
// differ from the true one only if gap or depth are within the documented band, and `apart` and `overlapping` are
// guaranteed: only `touching` may replace another verdict.
//
// GRAZE_TEST_SCALE multiplies the number of cases (default 1), GRAZE_TEST_SEED selects others.
#include <algorithm>
#include <cstddef>
#include <iostream>
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include <graze/math/vec.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "query/every_pair.hpp"
#include "query/pairs.hpp"
#include "query/placement.hpp"
#include "query/verdict_band.hpp"

namespace graze::test::agreement_test {
namespace {

/// Statistics of a run.
struct Tally {
  std::size_t cases = 0;
  std::size_t hits = 0;
  std::size_t other_verdicts = 0;  ///< Within the band.
  double worst = 0;                ///< The largest gap or depth with verdict touching, in units of the band's size.
  std::string worst_case;
  std::size_t failures = 0;
};

/// After this many failures, a run prints no more.
constexpr std::size_t most_failures = 5;

template <Dim N, class T>
std::string describe(const AnyShape<N, T>& a, const AnyShape<N, T>& b) {
  return to_source<N, T>(a) + ", " + to_source<N, T>(b);
}

/// Checks one case, in both orders.
template <Dim N, class T>
void check(const AnyPair<N, T>& pair, Tally& tally) {
  const auto& [a, b] = pair;
  const Relation claim = relation_of<N, T>(a, b);
  if (relation_of<N, T>(b, a) != claim) {
    ++tally.failures;
    ADD_FAILURE() << name_of(claim) << ", but not in the other order: " << describe<N, T>(a, b);
  }
  const ExactVerdict truth = true_verdict<N, T>(a, b, claim);
  ++tally.cases;
  if (truth.relation != Relation::apart) ++tally.hits;
  const Judgement judgement = judge(claim, truth, a.index(), b.index());
  if (judgement == Judgement::right || judgement == Judgement::outside_range) return;
  const double error = relative_gap(truth, a.index(), b.index());
  ++tally.other_verdicts;
  if (judgement == Judgement::wrong) {
    ++tally.failures;
    ADD_FAILURE() << name_of(claim) << " is " << name_of(truth.relation) << " by " << truth.gap << ", " << error
                  << " of the size: " << describe<N, T>(a, b);
  }
  if (error > tally.worst) {
    tally.worst = error;
    tally.worst_case = describe<N, T>(a, b);
  }
}

template <class SpaceType>
class Agreement : public ::testing::Test {
 public:
  static void run(CaseKind kind) {
    constexpr Dim N = SpaceType::dimension;
    using T = typename SpaceType::scalar;
    Tally tally;
    for_each_case<N, T>(
        kind, number_of_cases(20, 8), [&tally](const AnyPair<N, T>& pair) { check<N, T>(pair, tally); },
        [&tally] { return tally.failures < most_failures; });
    std::cout << "seed " << seed_of_cases() << ": " << tally.cases << " cases, " << 100 * tally.hits / tally.cases
              << " % hits, " << tally.other_verdicts << " called touching within the band, at most " << tally.worst
              << " of the size\n";
    if (!tally.worst_case.empty()) std::cout << "the worst: " << tally.worst_case << "\n";
    EXPECT_GE(tally.hits * 5, tally.cases) << "too few hits to prove anything";
    EXPECT_LE(tally.hits * 5, tally.cases * 4) << "too many hits to prove anything";
  }
};

TYPED_TEST_SUITE(Agreement, test::Spaces);

TYPED_TEST(Agreement, OnUniformNumbers) { TestFixture::run(CaseKind::uniform); }
TYPED_TEST(Agreement, OnSmallWholeNumbers) { TestFixture::run(CaseKind::grid); }
TYPED_TEST(Agreement, OnNumbersOfAllSizes) { TestFixture::run(CaseKind::scales); }
TYPED_TEST(Agreement, FarFromTheOrigin) { TestFixture::run(CaseKind::far); }
TYPED_TEST(Agreement, OnShapesThatShareCorners) { TestFixture::run(CaseKind::shared_points); }
TYPED_TEST(Agreement, WhereTheVerdictChanges) { TestFixture::run(CaseKind::border); }
TYPED_TEST(Agreement, WhereTheVerdictOfNearlyParallelEdgesChanges) { TestFixture::run(CaseKind::nearly_parallel); }
TYPED_TEST(Agreement, OfFacesThatAreNearlyFlush) { TestFixture::run(CaseKind::flush_faces); }

}  // namespace
}  // namespace graze::test::agreement_test
