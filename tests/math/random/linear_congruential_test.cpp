// SPDX-License-Identifier: MIT
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/random/linear_congruential.hpp>

namespace graze::detail::draws_test {
namespace {

TEST(Draws, StayBelowTheCount) {
  Draws draws;
  for (int k = 0; k < 100; ++k) {
    EXPECT_EQ(draws.below(1), 0U);
    EXPECT_LT(draws.below(3), 3U);
    EXPECT_LT(draws.below(std::size_t{1} << 32U), std::size_t{1} << 32U);
  }
}

TEST(Draws, ReachEveryPlaceAboutAsOften) {
  Draws draws;
  std::vector<int> times(10);
  for (int k = 0; k < 10'000; ++k) ++times[draws.below(times.size())];
  for (const int drawn : times) EXPECT_NEAR(drawn, 1000, 150);  // five standard deviations
}

TEST(Draws, DoNotFollowTheOneBefore) {
  Draws draws;
  std::vector<int> times(100);
  for (int k = 0; k < 100'000; ++k) {
    const std::size_t first = draws.below(10);
    ++times[first * 10 + draws.below(10)];
  }
  for (const int drawn : times) EXPECT_NEAR(drawn, 1000, 160);
}

TEST(Draws, OfTwoSeedsDoNotFollowEachOther) {
  Draws some(1);
  Draws others(2);
  std::vector<int> times(100);
  for (int k = 0; k < 100'000; ++k) ++times[some.below(10) * 10 + others.below(10)];
  for (const int drawn : times) EXPECT_NEAR(drawn, 1000, 160);
}

TEST(Draws, AreTheSameEachTime) {
  Draws some;
  Draws same;
  for (int k = 0; k < 100; ++k) EXPECT_EQ(some.below(1'000'000), same.below(1'000'000));
}

}  // namespace
}  // namespace graze::detail::draws_test
