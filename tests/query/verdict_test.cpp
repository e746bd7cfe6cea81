// SPDX-License-Identifier: MIT
#include <limits>

#include <gtest/gtest.h>

#include <graze/query/verdict.hpp>

namespace graze::detail::verdict_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Relation, IsOrderedFromApartToOverlappingAndHasNames) {
  EXPECT_LT(Relation::apart, Relation::touching);
  EXPECT_LT(Relation::touching, Relation::overlapping);
  EXPECT_EQ(name_of(Relation::apart), "apart");
  EXPECT_EQ(name_of(Relation::touching), "touching");
  EXPECT_EQ(name_of(Relation::overlapping), "overlapping");
}

TEST(VerdictOnGap, IsTouchingWithinTheSlackOnBothSides) {
  EXPECT_EQ(verdict_on_gap(1, 0.5), Relation::apart);
  EXPECT_EQ(verdict_on_gap(0.5, 0.5), Relation::touching);
  EXPECT_EQ(verdict_on_gap(0, 0), Relation::touching);
  EXPECT_EQ(verdict_on_gap(-0.5, 0.5), Relation::touching);
  EXPECT_EQ(verdict_on_gap(-0.75, 0.5), Relation::overlapping);
  EXPECT_EQ(verdict_on_gap(infinity, 0.5), Relation::apart);
  EXPECT_EQ(verdict_on_gap(-infinity, 0.5), Relation::overlapping);
}

TEST(VerdictOnGap, OfNanIsApart) {
  EXPECT_EQ(verdict_on_gap(nan, 0.5), Relation::apart);
  EXPECT_EQ(verdict_on_gap(0, nan), Relation::apart);
}

TEST(VerdictOnDistance, ComparesTheSquareWithTheReach) {
  EXPECT_EQ(verdict_on_distance(25, 4, 0.5), Relation::apart);
  EXPECT_EQ(verdict_on_distance(25, 4.5, 0.5), Relation::touching);
  EXPECT_EQ(verdict_on_distance(25, 5.5, 0.5), Relation::touching);
  EXPECT_EQ(verdict_on_distance(25, 5.75, 0.5), Relation::overlapping);
  EXPECT_EQ(verdict_on_distance(25, 5, 0), Relation::touching);
}

TEST(VerdictOnDistance, OfCoresThatMeetWithoutReachIsTouching) {
  EXPECT_EQ(verdict_on_distance(0, 0, 0), Relation::touching);
  EXPECT_EQ(verdict_on_distance(0, 0.25, 0.5), Relation::touching);
  EXPECT_EQ(verdict_on_distance(0, 0.75, 0.5), Relation::overlapping);
}

TEST(VerdictOnDistance, OfNanIsApart) {
  EXPECT_EQ(verdict_on_distance(nan, 1, 0), Relation::apart);
  EXPECT_EQ(verdict_on_distance(1, nan, 0), Relation::apart);
  EXPECT_EQ(verdict_on_distance(1, 1, nan), Relation::apart);
}

}  // namespace
}  // namespace graze::detail::verdict_test
