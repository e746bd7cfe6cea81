// SPDX-License-Identifier: MIT
// The farthest corner is the one that a plain search finds, by vectors of any width.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <graze/shape/hull/corner_rows.hpp>

namespace graze::detail::corner_rows_test {
namespace {

template <Dim N, class T>
std::uint32_t plain_farthest(const std::vector<Vec<N, T>>& corners, const Vec<N, double>& direction) {
  std::uint32_t best = 0;
  for (std::uint32_t i = 1; i < corners.size(); ++i) {
    if (dot(wide<N, T>(corners[i]), direction) > dot(wide<N, T>(corners[best]), direction)) best = i;
  }
  return best;
}

template <Dim N, class T>
void expect_as_plain(const std::vector<Vec<N, T>>& corners, const Vec<N, double>& direction) {
  const CornerRows<N, T> rows{std::span<const Vec<N, T>>(corners)};
  const std::uint32_t expected = plain_farthest<N, T>(corners, direction);
  ASSERT_EQ(rows.farthest(direction), expected) << corners.size();
  ASSERT_EQ(rows.farthest_by_two(direction), expected) << corners.size();
#ifdef GRAZE_HAS_WIDER_LANES
  if (__builtin_cpu_supports("avx2")) {
    ASSERT_EQ(rows.farthest_by_four(direction), expected) << corners.size();
  }
  if (__builtin_cpu_supports("avx512f")) {
    ASSERT_EQ(rows.farthest_by_eight(direction), expected) << corners.size();
  }
#endif
}

/// Coordinates on a coarse lattice are often equal, and so are heights.
template <Dim N, class T>
void search_random_corners(double step) {
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> number(-100, 100);
  const auto point = [&] {
    Vec<N, double> result(0.0);
    for (Dim k = 0; k < N; ++k) result[k] = step > 0 ? std::floor(number(engine) / step) * step : number(engine);
    return result;
  };
  for (std::size_t count = 1; count <= 200; ++count) {
    std::vector<Vec<N, T>> corners;
    while (corners.size() < count) corners.push_back(Vec<N, T>(point()));
    for (int repeat = 0; repeat < 4; ++repeat) expect_as_plain<N, T>(corners, point());
    expect_as_plain<N, T>(corners, Vec<N, double>(0.0));
    expect_as_plain<N, T>(corners, unit_axis<N>(0));
    expect_as_plain<N, T>(corners, unit_axis<N>(N - 1) * -1e300);
  }
}

TEST(CornerRows, FindTheFarthestCorner) {
  search_random_corners<3, double>(0);
  search_random_corners<3, float>(0);
  search_random_corners<2, double>(0);
  search_random_corners<2, float>(0);
}

TEST(CornerRows, FindTheFirstOfSeveral) {
  search_random_corners<3, double>(40);
  search_random_corners<3, float>(40);
  search_random_corners<2, double>(20);
  search_random_corners<2, float>(20);
}

TEST(CornerRows, FindSomeCornerAlongNonsense) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::size_t count : {1U, 5U, 64U, 65U, 200U}) {
    const std::vector<Vec<3, double>> corners(count, Vec<3, double>(1.0));
    const CornerRows<3, double> rows{std::span<const Vec<3, double>>(corners)};
    EXPECT_LT(rows.farthest(Vec<3, double>(nan)), count);
    EXPECT_LT(rows.farthest(Vec<3, double>(std::numeric_limits<double>::infinity(), 0, 0)), count);
  }
}

TEST(CornerRows, KnowTheirMiddleAndTheirLargestCoordinate) {
  const std::vector<Vec<3, float>> corners{{1, 2, 3}, {-7, 0, 1}, {0, 1, -1}};
  const CornerRows<3, float> rows{std::span<const Vec<3, float>>(corners)};
  EXPECT_EQ(rows.middle(), (Vec<3, double>(-2, 1, 1)));
  EXPECT_EQ(rows.largest(), 7);
}

}  // namespace
}  // namespace graze::detail::corner_rows_test
