// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include <graze/math/rotation.hpp>

namespace graze::test::rotation_test {
namespace {

TEST(Rotation, CosineAndSineOfRadiansAreRightToTwoEpsilon) {
  for (int i = -4000; i <= 4000; ++i) {
    const double angle = i * 0.0123456789;
    const Vec<2, double> found = cosine_sine(angle);
    EXPECT_NEAR(found.x, std::cos(angle), 5e-16) << angle;
    EXPECT_NEAR(found.y, std::sin(angle), 5e-16) << angle;
  }
  EXPECT_NEAR(cosine_sine(1e6).x, std::cos(1e6), 1e-15);
  EXPECT_NEAR(cosine_sine(-1e6).y, std::sin(-1e6), 1e-15);
  EXPECT_EQ(cosine_sine(0), (Vec<2, double>{1, 0}));
}

TEST(Rotation, CosineAndSineAreExactAtQuarterTurns) {
  EXPECT_EQ(cosine_sine_of_degrees(0), (Vec<2, double>(1, 0)));
  for (const double full : {0.0, 360.0, -360.0, 3600000.0}) {
    EXPECT_EQ(cosine_sine_of_degrees(full + 90), (Vec<2, double>(0, 1))) << full;
    EXPECT_EQ(cosine_sine_of_degrees(full + 180), (Vec<2, double>(-1, 0))) << full;
    EXPECT_EQ(cosine_sine_of_degrees(full + 270), (Vec<2, double>(0, -1))) << full;
    EXPECT_EQ(cosine_sine_of_degrees(full - 90), (Vec<2, double>(0, -1))) << full;
  }
}

TEST(Rotation, CosineAndSineAreRightBetweenQuarterTurns) {
  const double half_root_3 = std::sqrt(3.0) / 2;
  const double half_root_2 = std::sqrt(2.0) / 2;
  struct Row {
    double degrees, cosine, sine;
  };
  for (const Row& row : {Row{30, half_root_3, 0.5}, Row{45, half_root_2, half_root_2}, Row{60, 0.5, half_root_3},
                         Row{120, -0.5, half_root_3}, Row{135, -half_root_2, half_root_2}, Row{210, -half_root_3, -0.5},
                         Row{300, 0.5, -half_root_3}, Row{330, half_root_3, -0.5}, Row{-30, half_root_3, -0.5},
                         Row{-120, -0.5, -half_root_3}, Row{750, half_root_3, 0.5}}) {
    const Vec<2, double> turn = cosine_sine_of_degrees(row.degrees);
    EXPECT_NEAR(turn.x, row.cosine, 2e-16) << row.degrees;
    EXPECT_NEAR(turn.y, row.sine, 2e-16) << row.degrees;
  }
}

TEST(Rotation, SmallAnglesKeepTheirRelativePrecision) {
  const double radians_per_degree = std::acos(-1.0) / 180;
  EXPECT_DOUBLE_EQ(cosine_sine_of_degrees(1e-9).y, 1e-9 * radians_per_degree);
  EXPECT_NEAR(cosine_sine_of_degrees(90 + 1e-9).x, -1e-9 * radians_per_degree, 1e-25 + 90 * 0x1p-53);
}

TEST(Rotation, CosineAndSineAreRightToTheLastBitButOne) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  for (int k = -10000; k <= 10000; ++k) {
    const double angle = k * (std::numbers::pi / 4) / 10000;
    const Vec<2, double> found = detail::cosine_sine_of_small(angle);
    EXPECT_NEAR(found.x, std::cos(angle), epsilon / 2) << angle;
    EXPECT_NEAR(found.y, std::sin(angle), epsilon * std::fabs(angle)) << angle;
  }
}

TEST(Rotation, CosineAndSineAreTheSameOnEveryMachine) {
  const Vec<2, double> turn = cosine_sine_of_degrees(30.37);
  EXPECT_EQ(turn.x, 0x1.b9be1ad50b5c2p-1);
  EXPECT_EQ(turn.y, 0x1.02dba7a5a6ff5p-1);
}

TEST(Rotation, InThePlaneIsCounterClockwise) {
  EXPECT_EQ(rotation_matrix(90) * (Vec<2, double>(1, 0)), (Vec<2, double>(0, 1)));
  const Vec<2, double> image = rotation_matrix(30) * Vec<2, double>(2, 0);
  EXPECT_NEAR(image.x, std::sqrt(3.0), 4e-16);
  EXPECT_NEAR(image.y, 1, 4e-16);
}

TEST(Rotation, InSpaceIsRightHanded) {
  const Vec<3, double> x(1, 0, 0);
  const Vec<3, double> y(0, 1, 0);
  const Vec<3, double> z(0, 0, 1);
  EXPECT_EQ(rotation_matrix(z, 90) * x, y);
  EXPECT_EQ(rotation_matrix(x, 90) * y, z);
  EXPECT_EQ(rotation_matrix(y, 90) * z, x);
  EXPECT_EQ(rotation_matrix(-z, 90) * x, -y);
}

TEST(Rotation, ATurnAboutTheDiagonalPermutesTheAxes) {
  for (const double length : {1.0, 1e-100, 1e100}) {
    const Mat<3, double> third = rotation_matrix(Vec<3, double>(length), 120);
    for (Dim i = 0; i < 3; ++i) {
      EXPECT_LE(max_abs(Vec<3, double>(third * unit_axis<3>(i) - unit_axis<3>((i + 1) % 3))), 5e-16) << length << i;
    }
  }
}

TEST(Rotation, OfATurnInSpaceIsThatAboutItsAxis) {
  const Vec<3, double> turn(0.3, -1.2, 0.4);
  const Mat<3, double> found = rotation_of(turn);
  const Mat<3, double> expected = rotation_matrix(turn, std::sqrt(dot(turn, turn)) * 180 / std::numbers::pi);
  for (Dim j = 0; j < 3; ++j) EXPECT_LE(max_abs(Vec<3, double>(found[j] - expected[j])), 1e-15) << j;
  EXPECT_EQ(rotation_of(Vec<3, double>(0.0)), (Mat<3, double>(1.0)));
}

}  // namespace
}  // namespace graze::test::rotation_test
