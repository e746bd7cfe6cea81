// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

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

TEST(Rotation, ALargeAngleIsRightToItsOwnLastBit) {
  for (const double angle : {1.0000001e6, -3e7, 1e10, -7.3e15, 1e100, std::numeric_limits<double>::max()}) {
    const Vec<2, double> found = cosine_sine(angle);
    const double step = 1e-15 + std::fabs(angle) * 0x1p-53;
    EXPECT_NEAR(dot(found, found), 1, 1e-15) << angle;
    if (step < 1) {
      EXPECT_NEAR(found.x, std::cos(angle), step) << angle;
      EXPECT_NEAR(found.y, std::sin(angle), step) << angle;
    }
  }
}

double largest_difference(const Mat<3, double>& a, const Mat<3, double>& b) {
  double largest = 0;
  for (Dim j = 0; j < 3; ++j) largest = std::max(largest, max_abs(Vec<3, double>(a[j] - b[j])));
  return largest;
}

TEST(Rotation, FromAnAxisAndAnAngleIsThatByDegrees) {
  const double huge = std::numeric_limits<double>::max();
  const double tiny = std::numeric_limits<double>::denorm_min();
  for (const Vec<3, double>& axis :
       {Vec<3, double>(0, 0, 1), Vec<3, double>(1, -2, 3), Vec<3, double>(1e-200, 3e-200, 0),
        Vec<3, double>(huge, huge, -huge), Vec<3, double>(0, tiny, tiny)}) {
    for (int degrees = -720; degrees <= 720; degrees += 15) {
      const Mat<3, double> found = rotation_from_axis_angle(axis, degrees * std::numbers::pi / 180);
      EXPECT_LE(largest_difference(found, rotation_matrix(axis, degrees)), 4e-15) << degrees;
      EXPECT_LE(largest_difference(transpose(found) * found, Mat<3, double>(1.0)), 2e-15) << degrees;
    }
  }
  EXPECT_EQ(rotation_from_angle(0.75), rotation_of(0.75));
}

struct Quat {  // in the order of some other library
  float w, x, y, z;
};

TEST(Rotation, FromAQuaternionIsThatAboutItsAxis) {
  const Vec<3, double> axis = Vec<3, double>(1, -2, 2) / 3.0;
  for (int degrees = -720; degrees <= 720; degrees += 15) {
    const Vec<2, double> half = cosine_sine_of_degrees(degrees * 0.5);
    for (const double length : {1.0, -1.0, 3.5, 1e-300, -1e300, 0x1p-1060}) {
      const Vec<4, double> quaternion = Vec<4, double>(axis * half.y, half.x) * length;
      const Mat<3, double> found = rotation_from_quaternion(quaternion);
      // Subnormal numbers have few bits, so such a quaternion has no more.
      const double bound = std::fabs(length) < 1e-310 ? 1e-3 : 2e-15;
      EXPECT_LE(largest_difference(found, rotation_matrix(axis, degrees)), bound) << degrees << ' ' << length;
      EXPECT_LE(largest_difference(transpose(found) * found, Mat<3, double>(1.0)), 2e-15) << degrees << ' ' << length;
    }
  }
  EXPECT_EQ(rotation_from_quaternion(Quat{2, 0, 0, 0}), (Mat<3, double>(1.0)));
  EXPECT_EQ(rotation_from_quaternion(Quat{1, 0, 0, 1}), rotation_matrix(Vec<3, double>(0, 0, 1), 90));
  static_assert(Quaternion<Quat> && Quaternion<Vec<4, float>> && !Quaternion<Vec<3, float>>);
}

template <class Ask>
std::string error_of(Ask ask) {
  try {
    ask();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

TEST(Rotation, RefusesWhatHasNoDirectionByName) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  struct Row {
    std::string expected, found;
  };
  const auto about = [](const Vec<3, double>& axis, double angle) {
    return error_of([&] { (void)rotation_from_axis_angle(axis, angle); });
  };
  const auto quaternion = [](const Vec<4, double>& q) { return error_of([&] { (void)rotation_from_quaternion(q); }); };
  for (const Row& row :
       {Row{"none", about({0, 1e-320, 0}, 1)},
        Row{"rotation_from_axis_angle: the axis is zero and has no direction", about({0, -0.0, 0}, 1)},
        Row{"rotation_from_axis_angle: the axis has a coordinate that is not finite", about({0, infinity, 0}, 1)},
        Row{"rotation_from_axis_angle: the axis has a coordinate that is not finite", about({nan, 1, 0}, 1)},
        Row{"rotation_from_axis_angle: the angle is not finite", about({0, 1, 0}, -infinity)},
        Row{"rotation_from_angle: the angle is not finite", error_of([&] { (void)rotation_from_angle(nan); })},
        Row{"none", quaternion({0, 0, 0, 1e-320})},
        Row{"rotation_from_quaternion: the quaternion is zero", quaternion({0, 0, 0, -0.0})},
        Row{"rotation_from_quaternion: the quaternion has a number that is not finite", quaternion({0, nan, 0, 1})},
        Row{"rotation_from_quaternion: the quaternion has a number that is not finite",
            quaternion({0, 0, 0, infinity})}}) {
    EXPECT_EQ(row.found, row.expected);
  }
}

}  // namespace
}  // namespace graze::test::rotation_test
