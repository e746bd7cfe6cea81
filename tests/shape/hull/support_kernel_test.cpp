// SPDX-License-Identifier: MIT
// The index of the highest of eight or sixteen is the one that a plain search finds, and the lane of the highest is
// that of one which is as high up to its error, by vectors of any width.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include <graze/shape/hull/support_kernel.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail::eight_heights_test {
namespace {

using Sixteen = std::array<double, 16>;

/// Eight heights, or combined with eight later ones.
template <std::size_t lanes>
[[gnu::always_inline]] inline std::uint32_t highest_of(const Sixteen& heights, bool all) {
  static constexpr Sixteen places = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  PlacedHeights<8, lanes> first;
  PlacedHeights<8, lanes> later;
  std::memcpy(&first.height, heights.data(), sizeof(first.height));
  std::memcpy(&later.height, heights.data() + 8, sizeof(later.height));
  std::memcpy(&first.place, places.data(), sizeof(first.place));
  std::memcpy(&later.place, places.data() + 8, sizeof(later.place));
  if (all) first.meet_later(later);
  return first.highest();
}

std::uint32_t by_two(const Sixteen& heights, bool all) { return highest_of<2>(heights, all); }
#ifdef GRAZE_HAS_WIDER_LANES
[[gnu::target("avx2")]] std::uint32_t by_four(const Sixteen& heights, bool all) { return highest_of<4>(heights, all); }
[[gnu::target("avx512f")]] std::uint32_t by_eight(const Sixteen& heights, bool all) {
  return highest_of<8>(heights, all);
}
#endif

TEST(EightHeights, KnowTheFirstOfTheHighest) {
  std::mt19937 engine(3);
  for (int i = 0; i < 20'000; ++i) {
    const int most = i % 3 == 0 ? 1 : i % 3 == 1 ? 4 : 1000;  // so few that many are equal
    Sixteen heights;
    for (double& height : heights) height = std::uniform_int_distribution<int>(-most, most)(engine);
    for (const bool all : {false, true}) {
      const auto right = static_cast<std::uint32_t>(
          std::max_element(heights.begin(), heights.begin() + (all ? 16 : 8)) - heights.begin());
      ASSERT_EQ(by_two(heights, all), right);
#ifdef GRAZE_HAS_WIDER_LANES
      if (__builtin_cpu_supports("avx2")) {
        ASSERT_EQ(by_four(heights, all), right);
      }
      if (__builtin_cpu_supports("avx512f")) {
        ASSERT_EQ(by_eight(heights, all), right);
      }
#endif
    }
  }
}

template <std::size_t lanes>
[[gnu::always_inline]] inline std::uint32_t lane_of(const std::array<double, 8>& heights) {
  PlacedHeights<8, lanes> all;
  std::memcpy(&all.height, heights.data(), sizeof(all.height));
  return lane_of_highest<lanes>(all.height);
}

std::uint32_t lane_by_two(const std::array<double, 8>& heights) { return lane_of<2>(heights); }
#ifdef GRAZE_HAS_WIDER_LANES
[[gnu::target("avx2")]] std::uint32_t lane_by_four(const std::array<double, 8>& heights) { return lane_of<4>(heights); }
[[gnu::target("avx512f")]] std::uint32_t lane_by_eight(const std::array<double, 8>& heights) {
  return lane_of<8>(heights);
}
#endif

/// Of any magnitude and sign, some of them equal, some higher than others by a few rounding errors.
std::array<double, 8> draw_close_heights(std::mt19937& engine) {
  const double size = std::ldexp(1.0, std::uniform_int_distribution<int>(-1074, 1000)(engine));
  const double middle = std::uniform_real_distribution<double>(-2, 2)(engine);
  const auto drawn = [&] { return std::uniform_int_distribution<int>(0, 40)(engine); };
  std::array<double, 8> heights;
  for (double& height : heights) height = size * middle * (1 + drawn() * std::numeric_limits<double>::epsilon());
  heights[static_cast<std::size_t>(drawn() % 8)] = 0;
  return heights;
}

TEST(EightHeights, KnowALaneThatIsAsHighAsAny) {
  std::mt19937 engine(5);
  for (int i = 0; i < 50'000; ++i) {
    const std::array<double, 8> heights = draw_close_heights(engine);
    const std::uint32_t lane = lane_by_two(heights);
    ASSERT_LT(lane, 8U);
    for (const double height : heights) {
      const double larger = std::max(std::fabs(height), std::fabs(heights[lane]));
      // Below the smallest normal number there are no bits but the last ones.
      ASSERT_LE(height - heights[lane], lane_of_highest_error * std::max(larger, std::numeric_limits<double>::min()));
    }
#ifdef GRAZE_HAS_WIDER_LANES
    if (__builtin_cpu_supports("avx2")) {
      ASSERT_EQ(lane_by_four(heights), lane);
    }
    if (__builtin_cpu_supports("avx512f")) {
      ASSERT_EQ(lane_by_eight(heights), lane);
    }
#endif
  }
}

TEST(EightHeights, KnowSomeLaneOfWhatIsNoNumber) {
  std::array<double, 8> heights{1, 2, 3, 4, 5, 6, 7, 8};
  for (double& height : heights) {
    height = std::numeric_limits<double>::quiet_NaN();
    EXPECT_LT(lane_by_two(heights), 8U);
  }
  heights = {1, 2, std::numeric_limits<double>::infinity(), 4, 5, 6, 7, 8};
  EXPECT_LT(lane_by_two(heights), 8U);
}

}  // namespace
}  // namespace graze::detail::eight_heights_test

#endif
