// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include <graze/query/cores/penetration.hpp>

namespace graze::detail::penetration_test {
namespace {

using V2 = Vec<2, double>;

const Penetration<2> given{V2(0, 1), 2, V2(3, 5), V2(3, 3), Status::best_bound, 0.5};

TEST(Penetration, ExchangedSwapsThePointsAndNegatesTheNormalWithoutANegativeZero) {
  const Penetration<2> other = exchanged(given);
  EXPECT_EQ(other.point_a, V2(3, 3));
  EXPECT_EQ(other.point_b, V2(3, 5));
  EXPECT_EQ(other.normal, V2(0, -1));
  EXPECT_FALSE(std::signbit(other.normal.x));
  EXPECT_EQ(other.depth, 2);
  EXPECT_EQ(other.status, Status::best_bound);
  EXPECT_EQ(other.error, 0.5);
}

TEST(Penetration, MovedByAnOriginMovesThePointsAlone) {
  const Penetration<2> moved = moved_by(given, V2(10, 20));
  EXPECT_EQ(moved.point_a, V2(13, 25));
  EXPECT_EQ(moved.point_b, V2(13, 23));
  EXPECT_EQ(moved.normal, given.normal);
  EXPECT_EQ(moved.depth, 2);
}

}  // namespace
}  // namespace graze::detail::penetration_test
