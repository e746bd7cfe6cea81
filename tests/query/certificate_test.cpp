// SPDX-License-Identifier: MIT
// The exam's certificates against the oracle that they replace: whatever they prove is true, for every pair of types,
// on all kinds of difficult cases and on their variations; and they leave little open.
//
// GRAZE_TEST_SCALE multiplies the number of cases (default 1), GRAZE_TEST_SEED selects others.
#include "exact/certificate.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/vec.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "exact.hpp"
#include "query/case_variations.hpp"
#include "query/every_pair.hpp"
#include "query/pairs.hpp"
#include "query/verdict_band.hpp"

namespace graze::test::certificate_test {
namespace {

struct Count {
  std::size_t cases = 0;
  std::size_t open = 0;
  std::size_t contradictions = 0;
};

/// Whether what is proved agrees with the truth; the oracle rounds a gap once.
bool is_so(const GapBounds& proved, const ExactVerdict& truth) {
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * std::fabs(truth.gap);
  const std::optional<Relation> relation = proved.relation();
  if (relation && *relation != truth.relation) return false;
  if (proved.is_overlapping && truth.relation != Relation::overlapping) return false;
  if (std::isinf(truth.gap)) return truth.relation == Relation::overlapping || proved.high == truth.gap;
  return proved.low <= truth.gap + rounding && proved.high >= truth.gap - rounding;
}

/// Whether the finding agrees with the oracle, and its gap is not below the true one.
bool is_the_oracles(const Finding& finding, Relation claim, const ExactVerdict& truth, std::size_t a, std::size_t b) {
  const Judgement judgement = judge(claim, truth, a, b);
  if (judgement == Judgement::outside_range) return finding.judgement != Judgement::right;
  if (judgement != finding.judgement) return false;
  return judgement != Judgement::within_band || finding.relative_gap >= relative_gap(truth, a, b) * (1 - 1e-9);
}

template <Dim N, class T>
void check(const AnyPair<N, T>& pair, Relation claim, Count& count) {
  const auto& [a, b] = pair;
  const GapBounds proved = gap_bounds<N, T>(a, b, claim);
  const std::optional<Finding> finding = graze::test::finding(claim, proved, a.index(), b.index());
  const ExactVerdict truth = exact_verdict<N, T>(a, b);
  ++count.cases;
  if (!finding && claim == relation_of<N, T>(a, b)) ++count.open;
  if (is_so(proved, truth) && (!finding || is_the_oracles(*finding, claim, truth, a.index(), b.index()))) return;
  ++count.contradictions;
  ADD_FAILURE() << "claimed " << name_of(claim) << ", proved " << literal(proved.low) << " to " << literal(proved.high)
                << ", is " << name_of(truth.relation) << " by " << literal(truth.gap) << ": " << to_source<N, T>(a)
                << ", " << to_source<N, T>(b);
}

template <Dim N, class T>
Count check_pair(std::size_t a, std::size_t b, std::size_t turns, std::uint64_t seed) {
  Count count;
  CaseMaker<N, T> maker(a, b, seed);
  CaseVariations<N, T> variations(seed);
  for (std::size_t turn = 0; turn < turns && count.contradictions < 5; ++turn) {
    for (const AnyPair<N, T>& pair : maker.make(static_cast<CaseKind>(turn % case_kind_count))) {
      const AnyPair<N, T> varied = variations.vary(pair);
      check<N, T>(pair, relation_of<N, T>(pair.first, pair.second), count);
      check<N, T>(varied, relation_of<N, T>(varied.first, varied.second), count);
      check<N, T>(varied, static_cast<Relation>(turn % 3), count);
    }
  }
  return count;
}

template <class SpaceType>
class Certificate : public ::testing::Test {};

TYPED_TEST_SUITE(Certificate, test::Spaces);

TYPED_TEST(Certificate, NeverContradictsTheOracleAndLeavesLittleOpen) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  // Fewer than nine would say little about how much is left open.
  const std::size_t turns = number_of_cases(14, 9);
  const std::uint64_t seed = seed_of_cases();
  Count all;
  for (std::size_t a = 0; a < shape_type_names.size(); ++a) {
    for (std::size_t b = a; b < shape_type_names.size(); ++b) {
      const Count count = check_pair<N, T>(a, b, turns, seed * 1000 + a * shape_type_names.size() + b);
      all.cases += count.cases;
      all.open += count.open;
      all.contradictions += count.contradictions;
    }
  }
  std::cout << "seed " << seed << ": " << all.cases << " cases, " << all.open << " left open\n";
  EXPECT_GT(all.cases, 2000U);
  EXPECT_LT(all.open * 100, all.cases);
}

TEST(CertificateOfTouching, IsExactOnWholeNumbers) {
  const AnyShape<3, double> box = Aabb<3, double>{{0, 0, 0}, {2, 2, 2}};
  const AnyShape<3, double> sphere = Sphere<3, double>{{5, 6, 1}, 5};
  const GapBounds proved = gap_bounds<3, double>(box, sphere, Relation::touching);
  EXPECT_EQ(proved.low, 0);
  EXPECT_EQ(proved.high, 0);
  EXPECT_EQ(proved.relation(), Relation::touching);
}

TEST(CertificateOfGaps, EnclosesADistanceThatIsNoDouble) {
  // From the corner (1, 1) to the point (2, 2): the square root of two.
  const AnyShape<2, float> box = Aabb<2, float>{{0, 0}, {1, 1}};
  const GapBounds proved = gap_bounds<2, float>(box, Vec<2, float>{2, 2}, Relation::touching);
  EXPECT_LE(proved.low, std::sqrt(2.0));
  EXPECT_GE(proved.high, std::sqrt(2.0));
  EXPECT_NEAR(proved.low, proved.high, 1e-12);
}

TEST(CertificateOfOverlap, NeedsAnInside) {
  // Two flat squares in one plane share points but no volume.
  const AnyShape<3, double> square = Aabb<3, double>{{0, 0, 0}, {2, 2, 0}};
  const AnyShape<3, double> other = Aabb<3, double>{{1, 1, 0}, {3, 3, 0}};
  const GapBounds proved = gap_bounds<3, double>(square, other, Relation::overlapping);
  EXPECT_FALSE(proved.is_overlapping);
  EXPECT_EQ((gap_bounds<3, double>(square, other, Relation::touching).relation()), Relation::touching);
}

}  // namespace
}  // namespace graze::test::certificate_test
