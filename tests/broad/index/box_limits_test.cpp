// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include <graze/broad/index/box_limits.hpp>

#include "spaces.hpp"

namespace graze::detail::box_limits_test {
namespace {

template <class Traits>
class BoxLimitsTest : public testing::Test {};

TYPED_TEST_SUITE(BoxLimitsTest, test::Spaces);

/// Few distinct coordinates, so that boxes touch, with the extremes of all numbers and both zeros.
TYPED_TEST(BoxLimitsTest, SaysWhatBoxesOverlapSays) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  constexpr T infinity = std::numeric_limits<T>::infinity();
  const T numbers[] = {-infinity, std::numeric_limits<T>::lowest(),     -1,   -0.0F,
                       0,         std::numeric_limits<T>::denorm_min(), T(1), std::numeric_limits<T>::max(),
                       infinity};
  std::mt19937 random(20261121);
  const auto any_box = [&] {
    Aabb<N, T> box;
    for (Dim i = 0; i < N; ++i) {
      const auto a = random() % std::size(numbers);
      const auto b = random() % std::size(numbers);
      box.min[i] = numbers[std::min(a, b)];
      box.max[i] = numbers[std::max(a, b)];
    }
    return box;
  };
  int met = 0;
  for (int round = 0; round < 20'000; ++round) {
    const Aabb<N, T> a = any_box();
    const Aabb<N, T> b = any_box();
    const bool expected = boxes_overlap(a, b);
    ASSERT_EQ((BoxLimits<N, T>(a).meets(b)), expected) << round;
    met += expected ? 1 : 0;
  }
  EXPECT_GT(met, 4'000);
  EXPECT_LT(met, 18'000);
}

/// Each side of a box can decide alone.
TYPED_TEST(BoxLimitsTest, EveryCoordinateCountsAndNoNumberMeetsNothing) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const Aabb<N, T> unit{Vec<N, T>(T(0)), Vec<N, T>(T(1))};
  const BoxLimits<N, T> limits(unit);
  EXPECT_TRUE(limits.meets(unit));
  EXPECT_FALSE(limits.meets(Aabb<N, T>::nothing()));
  for (Dim i = 0; i < N; ++i) {
    for (const T shift : {T(-1), T(1)}) {
      Aabb<N, T> moved = unit;
      moved.min[i] += shift;
      moved.max[i] += shift;
      EXPECT_TRUE(limits.meets(moved));
      moved.min[i] = std::nextafter(moved.min[i], 4 * shift);
      moved.max[i] = std::nextafter(moved.max[i], 4 * shift);
      EXPECT_FALSE(limits.meets(moved));
    }
    Aabb<N, T> broken = unit;
    broken.min[i] = std::numeric_limits<T>::quiet_NaN();
    EXPECT_FALSE((BoxLimits<N, T>(broken).meets(unit)));
    EXPECT_FALSE(limits.meets(broken));
  }
}

}  // namespace
}  // namespace graze::detail::box_limits_test
