// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/vec.hpp>

namespace graze::vec_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

static_assert(Scalar<float> && Scalar<double>);
static_assert(!Scalar<int> && !Scalar<long double> && !Scalar<const float>);
static_assert(std::is_same_v<decltype(wide<2, float>({})), Vec<2, double>>);
static_assert(std::is_same_v<Vec<3>, Vec<3, float>> && std::is_same_v<Mat<3>, Mat<3, float>>);
static_assert(sizeof(Vec<2, double>) == 16 && sizeof(Mat<3, float>) == 36 && sizeof(Mat<2, double>) == 32);

static_assert(PointRow<std::vector<Vec<2, float>>> && PointRow<std::array<Vec<3, double>, 2>>);
static_assert(PointRow<std::span<const Vec<3, float>>> && PointRow<std::span<Vec<3, float>, 4>> && PointRow<Vec<2>[3]>);
static_assert(PointRowIn<std::vector<Vec<2, float>>, 2> && PointRowIn<std::array<Vec<3, double>, 2>, 3>);
static_assert(!PointRowIn<std::vector<Vec<2, float>>, 3> && !PointRowIn<float, 2>);
static_assert(!PointRow<Vec<2>> && !PointRow<std::vector<float>> && !PointRow<int> && !PointRow<Vec<2>*>);

TEST(Vec, ARowOfPointsIsASpanOfThemWhateverHoldsIt) {
  const std::vector<Vec<2, float>> list{{1, 2}, {3, 4}};
  const std::array<Vec<2, float>, 2> array{list[0], list[1]};
  for (const std::span<const Vec<2, float>> points : {span_of(list), span_of(array), span_of(std::span(array))}) {
    ASSERT_EQ(points.size(), 2U);
    EXPECT_EQ(points[1], (Vec<2, float>(3, 4)));
  }
  EXPECT_EQ(span_of(list).data(), list.data()) << "not a copy";
}

TEST(Vec, WidensWithoutChangingTheValue) {
  const Vec<2, double> v = wide<2, float>({0.1F, -3});
  EXPECT_EQ(v, (Vec<2, double>(0.100000001490116119384765625, -3)));
}

TEST(Vec, MatricesAreStoredByColumns) {
  const Mat<2, float> matrix({1, 2}, {3, 4});
  EXPECT_EQ(matrix[0], (Vec<2, float>(1, 2)));
  EXPECT_EQ((matrix * Vec<2, float>(1, 0)), (Vec<2, float>(1, 2)));
  EXPECT_EQ((matrix * Vec<2, float>(0, 1)), (Vec<2, float>(3, 4)));
  const Mat<2, double> widened = wide_matrix<2, float>(matrix);
  EXPECT_EQ(widened[0], (Vec<2, double>(1, 2)));
  EXPECT_EQ(widened[1], (Vec<2, double>(3, 4)));
}

TEST(Vec, UnitAxesPointAlongTheirCoordinate) {
  EXPECT_EQ(unit_axis<2>(0), (Vec<2, double>(1, 0)));
  EXPECT_EQ(unit_axis<2>(1), (Vec<2, double>(0, 1)));
  EXPECT_EQ((unit_axis<3, float>(2)), (Vec<3, float>(0, 0, 1)));
}

TEST(Vec, PerpendicularTurnsCounterClockwise) {
  EXPECT_EQ(perpendicular(Vec<2, double>(1, 0)), (Vec<2, double>(0, 1)));
  EXPECT_EQ(perpendicular(Vec<2, double>(3, 4)), (Vec<2, double>(-4, 3)));
}

TEST(Vec, Cross2dIsPositiveToTheLeft) {
  EXPECT_EQ(cross_2d(Vec<2, double>(1, 0), Vec<2, double>(0, 1)), 1);
  EXPECT_EQ(cross_2d(Vec<2, double>(0, 1), Vec<2, double>(1, 0)), -1);
  EXPECT_EQ(cross_2d(Vec<2, double>(2, 3), Vec<2, double>(5, 7)), -1);
  EXPECT_EQ(cross_2d(Vec<2, double>(2, 3), Vec<2, double>(4, 6)), 0);
}

TEST(Vec, LengthSquaredSumsTheSquares) {
  EXPECT_EQ(length_squared(Vec<2, double>(3, -4)), 25);
  EXPECT_EQ(length_squared(Vec<3, float>(1, 2, 2)), 9);
}

TEST(Vec, MaxAbsIsTheLargestMagnitude) {
  EXPECT_EQ(max_abs(Vec<3, double>(1, -5, 3)), 5);
  EXPECT_EQ(max_abs(Vec<2, double>(0, -0.0)), 0);
  EXPECT_EQ(max_abs(Vec<2, double>(-infinity, 1)), infinity);
}

TEST(Vec, MaxAbsTakesNanForNothing) {
  EXPECT_EQ(max_abs(Vec<2, double>(nan, -2)), 2);
  EXPECT_EQ(max_abs(Vec<2, double>(-2, nan)), 2);
  EXPECT_EQ(max_abs(Vec<2, double>(nan, nan)), 0);
}

TEST(Vec, SumAbsAddsTheMagnitudes) {
  EXPECT_EQ(sum_abs(Vec<3, double>(1, -5, 3)), 9);
  EXPECT_TRUE(std::isnan(sum_abs(Vec<2, double>(nan, 1))));
}

TEST(Vec, IsFiniteNeedsEveryCoordinateFinite) {
  EXPECT_TRUE(is_finite(Vec<3, double>(0, -1e308, 5e-324)));
  for (Dim i = 0; i < 3; ++i) {
    for (const double bad : {nan, infinity, -infinity}) {
      Vec<3, double> v(1.0);
      v[i] = bad;
      EXPECT_FALSE(is_finite(v)) << i << " " << bad;
    }
  }
}

}  // namespace
}  // namespace graze::vec_test
