// SPDX-License-Identifier: MIT
#include <cstdint>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include <graze/broad/orthtree/code.hpp>
#include <graze/broad/orthtree/place.hpp>

namespace graze::detail::cell_code_test {
namespace {

/// A code names, level by level, the child that contains a point.
template <Dim N, class T>
void expect_the_way_down(std::uint32_t seed) {
  std::mt19937 random(seed);
  CellPosition<N> root;
  root.half = 8;
  for (Dim i = 0; i < N; ++i) root.center[i] = static_cast<double>(i) + 16;
  const CodeScale<N, T> scale(root);
  for (int round = 0; round < 200; ++round) {
    Vec<N, T> point;
    for (Dim i = 0; i < N; ++i) {
      point[i] = static_cast<T>(root.center[i]) - T(8) + static_cast<T>(random() % 1024) / T(64) + T(1) / T(128);
    }
    const std::uint32_t code = code_of(point, scale);
    CellPosition<N> place = root;
    for (int level = 1; level <= 10; ++level) {
      const std::uint32_t child = child_towards(place, wide<N, T>(point));
      const auto shift = static_cast<unsigned>(N * (code_levels<N> - level));
      ASSERT_EQ(code >> shift & ((1U << static_cast<unsigned>(N)) - 1U), child);
      place = child_place(place, child);
    }
  }
}

TEST(CellCode, NamesTheChildOfEveryLevel) {
  expect_the_way_down<2, float>(1);
  expect_the_way_down<3, float>(2);
  expect_the_way_down<2, double>(3);
  expect_the_way_down<3, double>(4);
}

TEST(CellCode, IsThatOfAnOutermostCellForPointsOutside) {
  CellPosition<2> root;
  root.half = 1;
  const CodeScale<2, float> scale(root);
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(code_of(Vec<2>(-1, -1), scale), 0U);
  EXPECT_EQ(code_of(Vec<2>(-5, -infinity), scale), 0U);
  EXPECT_EQ(code_of(Vec<2>(1, 1), scale), 0xFFFF'FFFFU);
  EXPECT_EQ(code_of(Vec<2>(7, infinity), scale), 0xFFFF'FFFFU);
  EXPECT_EQ(code_of(Vec<2>(7, -7), scale), 0x5555'5555U);
  EXPECT_EQ(code_of(Vec<2>(std::numeric_limits<float>::quiet_NaN(), 7), scale), 0xAAAA'AAAAU);
}

/// The same for a root whose cells are too small for the points' number type.
TEST(CellCode, IsTheSameForAllWhereTheRootIsAPoint) {
  for (const double half : {0.0, 1e-60}) {
    CellPosition<3> root;
    root.half = half;
    const CodeScale<3, float> scale(root);
    EXPECT_EQ(code_of(Vec<3>(0, 0, 0), scale), code_of(Vec<3>(1, -1, 2), scale));
  }
}

}  // namespace
}  // namespace graze::detail::cell_code_test
