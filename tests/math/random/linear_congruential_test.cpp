// SPDX-License-Identifier: MIT
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/random/linear_congruential.hpp>

namespace graze::detail::draws_test {
namespace {

TEST(LinearCongruential, StayBelowTheCount) {
  LinearCongruential random;
  for (int k = 0; k < 100; ++k) {
    EXPECT_EQ(random.below(1), 0U);
    EXPECT_LT(random.below(3), 3U);
    EXPECT_LT(random.below(std::size_t{1} << 32U), std::size_t{1} << 32U);
  }
}

TEST(LinearCongruential, ReachEveryPlaceAboutAsOften) {
  LinearCongruential random;
  std::vector<int> times(10);
  for (int k = 0; k < 10'000; ++k) ++times[random.below(times.size())];
  for (const int drawn : times) EXPECT_NEAR(drawn, 1000, 150);  // five standard deviations
}

TEST(LinearCongruential, DoNotFollowTheOneBefore) {
  LinearCongruential random;
  std::vector<int> times(100);
  for (int k = 0; k < 100'000; ++k) {
    const std::size_t first = random.below(10);
    ++times[first * 10 + random.below(10)];
  }
  for (const int drawn : times) EXPECT_NEAR(drawn, 1000, 160);
}

TEST(LinearCongruential, OfTwoSeedsDoNotFollowEachOther) {
  LinearCongruential some(1);
  LinearCongruential others(2);
  std::vector<int> times(100);
  for (int k = 0; k < 100'000; ++k) ++times[some.below(10) * 10 + others.below(10)];
  for (const int drawn : times) EXPECT_NEAR(drawn, 1000, 160);
}

TEST(LinearCongruential, AreTheSameEachTime) {
  LinearCongruential some;
  LinearCongruential same;
  for (int k = 0; k < 100; ++k) EXPECT_EQ(some.below(1'000'000), same.below(1'000'000));
}

}  // namespace
}  // namespace graze::detail::draws_test
