// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <graze/query/proximity.hpp>

namespace graze::detail::proximity_test {
namespace {

TEST(Proximity, IsInfinitelyFarFromNothingByDefault) {
  const Proximity<2> nothing;
  EXPECT_EQ(nothing.distance, std::numeric_limits<float>::infinity());
  EXPECT_TRUE(std::isnan(nothing.point_a.x) && std::isnan(nothing.point_b.y));
  EXPECT_EQ(nothing.normal, (Vec<2, float>(0, 0)));
  EXPECT_EQ(nothing.relation, Relation::apart);
}

TEST(Exchanged, SwapsThePointsAndNegatesTheNormalWithoutANegativeZero) {
  const Proximity<2, double> given{1, {2, 3}, {2, 4}, {0, 1}, Relation::apart, Status::best_bound, 0.5};
  const Proximity<2, double> other = exchanged(given);
  EXPECT_EQ(other, (Proximity<2, double>{1, {2, 4}, {2, 3}, {0, -1}, Relation::apart, Status::best_bound, 0.5}));
  EXPECT_FALSE(std::signbit(other.normal.x));
  EXPECT_EQ(exchanged(other), given);
}

TEST(RoundedDistance, IsZeroForShapesThatMeetAndForNoOthers) {
  constexpr float least = std::numeric_limits<float>::denorm_min();
  EXPECT_EQ(rounded_distance<float>(1e-60, Relation::apart), least);
  EXPECT_EQ(rounded_distance<float>(0, Relation::apart), least);
  EXPECT_EQ(rounded_distance<float>(0.1, Relation::apart), 0.1F);
  EXPECT_EQ(rounded_distance<float>(1e-60, Relation::touching), 0.0F);
  EXPECT_EQ(rounded_distance<double>(0, Relation::overlapping), 0.0);
}

TEST(Rounded, TakesEveryNumberToTheNearestOfItsType) {
  const Proximity<2, double> wide{0.1, {0.1, -0.0}, {0.3, 1}, {0.6, 0.8}, Relation::apart, Status::converged, 1e-17};
  const Proximity<2, float> narrow = rounded<float>(wide);
  EXPECT_EQ(narrow,
            (Proximity<2, float>{0.1F, {0.1F, 0}, {0.3F, 1}, {0.6F, 0.8F}, Relation::apart, Status::converged, 1e-17}));
  EXPECT_FALSE(std::signbit(narrow.point_a.y));
}

}  // namespace
}  // namespace graze::detail::proximity_test
