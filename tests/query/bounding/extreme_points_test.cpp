// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/query/bounding/extreme_points.hpp>

#include "query/point_sets.hpp"

namespace graze::extreme_points_test {
namespace {

TEST(ExtremePoints, InThePlaneAreFarthestAlongTheAxesAndDiagonals) {
  const std::vector<Vec<2, float>> points{{0, 0}, {-5, 0}, {5, 1}, {0, -5}, {1, 5}, {-4, -4}, {4, 4}, {-4, 4}, {4, -4}};
  const auto indices = detail::extreme_points(std::span<const Vec<2, float>>(points));
  EXPECT_EQ(indices, (std::array<std::size_t, 8>{1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST(ExtremePoints, AreTheFirstOfEqualOnes) {
  const std::vector<Vec<3, double>> points{{1, 2, 3}, {1, 2, 3}};
  const auto indices = detail::extreme_points(std::span<const Vec<3, double>>(points));
  EXPECT_EQ(indices, (std::array<std::size_t, 14>{}));
}

TEST(ExtremePoints, TellPointsApartFarFromTheOrigin) {
  const double next = 1e15 + 0.125;
  const std::vector<Vec<2, double>> points{{1e15, 1e15}, {next, next}};
  const auto indices = detail::extreme_points(std::span<const Vec<2, double>>(points));
  EXPECT_EQ(indices, (std::array<std::size_t, 8>{0, 1, 0, 1, 0, 1, 0, 0}));
}

template <class S>
class ExtremePointsIn : public testing::Test {};
TYPED_TEST_SUITE(ExtremePointsIn, test::Spaces);

TYPED_TEST(ExtremePointsIn, ReachTheSidesOfTheBox) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    // Integers: their differences from the first are exact.
    const std::vector<Vec<N, T>> points = *test::some<Vec<N, T>>(20, test::source_of<N, T>(test::Kind::grid).point);
    const auto indices = detail::extreme_points(std::span<const Vec<N, T>>(points));
    for (Dim i = 0; i < N; ++i) {
      const auto k = static_cast<std::size_t>(i);
      for (const Vec<N, T>& point : points) {
        RC_ASSERT(points[indices[2 * k]][i] <= point[i]);
        RC_ASSERT(points[indices[2 * k + 1]][i] >= point[i]);
      }
    }
  });
}

}  // namespace
}  // namespace graze::extreme_points_test
