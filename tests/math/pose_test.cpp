// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/math/pose.hpp>

#include "../catalogue.hpp"

namespace graze::pose_test {
namespace {

template <Dim N>
double largest_difference(const Vec<N, double>& a, const Vec<N, double>& b) {
  return max_abs(Vec<N, double>(a - b));
}

TEST(Pose, DefaultsToTheIdentity) {
  EXPECT_EQ(transformed(Vec<2, float>(3, -4), Pose<2>{}), (Vec<2, float>(3, -4)));
  EXPECT_EQ(transformed(Vec<3, double>(0.1, 1e300, -7), Pose<3, double>{}), (Vec<3, double>(0.1, 1e300, -7)));
}

TEST(Pose, TurnsFirstAndMovesThen) {
  const Pose<2, double> pose{rotation_matrix(90), {10, 20}};
  EXPECT_EQ(transformed(Vec<2, double>(3, 4), pose), (Vec<2, double>(6, 23)));  // (3, 4) turns to (-4, 3)
  EXPECT_EQ((rotated<2, double>(Vec<2, double>(3, 4), pose)), (Vec<2, double>(-4, 3)));
}

TEST(Pose, RotatesEveryColumnOfAFrame) {
  const Pose<2, double> pose{rotation_matrix(90), {10, 20}};
  const Mat<2, double> frame = rotated<2, double>(Mat<2, double>({1, 2}, {3, 4}), pose);
  EXPECT_EQ(frame[0], (Vec<2, double>(-2, 1)));
  EXPECT_EQ(frame[1], (Vec<2, double>(-4, 3)));
}

TEST(Pose, RoundsAFloatImageOnce) {
  // 16777217 is no float; in float arithmetic 16777216 + 1 would stay 16777216, and the last 1 be lost again.
  const Pose<2, float> pose{Mat<2, float>({1, 0}, {1, 1}), {1, 0}};
  EXPECT_EQ(transformed(Vec<2, float>(16777216, 1), pose), (Vec<2, float>(16777218, 1)));
}

TEST(Pose, CosineAndSineAreExactAtQuarterTurns) {
  EXPECT_EQ(cosine_sine_of_degrees(0), (Vec<2, double>(1, 0)));
  for (const double full : {0.0, 360.0, -360.0, 3600000.0}) {
    EXPECT_EQ(cosine_sine_of_degrees(full + 90), (Vec<2, double>(0, 1))) << full;
    EXPECT_EQ(cosine_sine_of_degrees(full + 180), (Vec<2, double>(-1, 0))) << full;
    EXPECT_EQ(cosine_sine_of_degrees(full + 270), (Vec<2, double>(0, -1))) << full;
    EXPECT_EQ(cosine_sine_of_degrees(full - 90), (Vec<2, double>(0, -1))) << full;
  }
}

TEST(Pose, CosineAndSineAreRightBetweenQuarterTurns) {
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

TEST(Pose, SmallAnglesKeepTheirRelativePrecision) {
  const double radians_per_degree = std::acos(-1.0) / 180;
  EXPECT_DOUBLE_EQ(cosine_sine_of_degrees(1e-9).y, 1e-9 * radians_per_degree);
  EXPECT_NEAR(cosine_sine_of_degrees(90 + 1e-9).x, -1e-9 * radians_per_degree, 1e-25 + 90 * 0x1p-53);
}

TEST(Pose, CosineAndSineAreRightToTheLastBitButOne) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  for (int k = -10000; k <= 10000; ++k) {
    const double angle = k * (std::numbers::pi / 4) / 10000;
    const Vec<2, double> found = detail::cosine_sine_of_small(angle);
    EXPECT_NEAR(found.x, std::cos(angle), epsilon / 2) << angle;
    EXPECT_NEAR(found.y, std::sin(angle), epsilon * std::fabs(angle)) << angle;
  }
}

TEST(Pose, CosineAndSineAreTheSameOnEveryMachine) {
  const Vec<2, double> turn = cosine_sine_of_degrees(30.37);
  EXPECT_EQ(turn.x, 0x1.b9be1ad50b5c2p-1);
  EXPECT_EQ(turn.y, 0x1.02dba7a5a6ff5p-1);
}

TEST(Pose, RotationInThePlaneIsCounterClockwise) {
  EXPECT_EQ(rotation_matrix(90) * (Vec<2, double>(1, 0)), (Vec<2, double>(0, 1)));
  const Vec<2, double> image = rotation_matrix(30) * Vec<2, double>(2, 0);
  EXPECT_NEAR(image.x, std::sqrt(3.0), 4e-16);
  EXPECT_NEAR(image.y, 1, 4e-16);
}

TEST(Pose, RotationInSpaceIsRightHanded) {
  const Vec<3, double> x(1, 0, 0);
  const Vec<3, double> y(0, 1, 0);
  const Vec<3, double> z(0, 0, 1);
  EXPECT_EQ(rotation_matrix(z, 90) * x, y);
  EXPECT_EQ(rotation_matrix(x, 90) * y, z);
  EXPECT_EQ(rotation_matrix(y, 90) * z, x);
  EXPECT_EQ(rotation_matrix(-z, 90) * x, -y);
}

TEST(Pose, ATurnAboutTheDiagonalPermutesTheAxes) {
  for (const double length : {1.0, 1e-100, 1e100}) {
    const Mat<3, double> third = rotation_matrix(Vec<3, double>(length), 120);
    for (Dim i = 0; i < 3; ++i) {
      EXPECT_LE(largest_difference<3>(third * unit_axis<3>(i), unit_axis<3>((i + 1) % 3)), 5e-16) << length << i;
    }
  }
}

template <class S>
class PoseIn : public testing::Test {};
TYPED_TEST_SUITE(PoseIn, test::Spaces);

TYPED_TEST(PoseIn, KeepsDistances) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    const Pose<N, T> pose = *test::any<Pose<N, T>>();
    const auto [a, b] = *test::any_pair<Vec<N, T>, Vec<N, T>>();
    const Vec<N, double> before = wide<N, T>(b) - wide<N, T>(a);
    const Vec<N, double> after = wide<N, T>(transformed(b, pose)) - wide<N, T>(transformed(a, pose));
    const double size = static_cast<double>(max_abs(a) + max_abs(b) + max_abs(pose.position));
    const double band = 16 * static_cast<double>(std::numeric_limits<T>::epsilon()) * size;
    RC_ASSERT(std::fabs(std::sqrt(length_squared(before)) - std::sqrt(length_squared(after))) <= band);
  });
}

TYPED_TEST(PoseIn, ImageOfADifferenceIsTheDifferenceOfTheImages) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    const Pose<N, T> pose = *test::any<Pose<N, T>>();
    const Vec<N, T> a = *test::any<Vec<N, T>>();
    const Vec<N, double> turned = wide<N, T>(rotated<N, T>(a, pose));
    const Vec<N, double> moved = wide<N, T>(transformed(a, pose)) - wide<N, T>(pose.position);
    const double size = static_cast<double>(max_abs(a) + max_abs(pose.position));
    RC_ASSERT(largest_difference<N>(turned, moved) <=
              8 * static_cast<double>(std::numeric_limits<T>::epsilon()) * size);
  });
}

TYPED_TEST(PoseIn, CatalogueRotationsAreProper) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    const Pose<N, T> pose = *test::any_pose<N, T>();
    const Mat<N, double> rotation = wide_matrix<N, T>(pose.rotation);
    const double band = 8 * static_cast<double>(std::numeric_limits<T>::epsilon());
    RC_ASSERT(std::fabs(determinant(rotation) - 1) <= band);
    RC_ASSERT((orthonormal_error<N, T>(pose.rotation)) <= band);
  });
}

}  // namespace
}  // namespace graze::pose_test
