// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <graze/math/motion.hpp>

namespace graze::test::motion_test {
namespace {

constexpr double pi = 3.14159265358979323846;

TEST(Motion, RestsByDefault) {
  const Pose<3, double> pose = pose_at(Motion<3>(), 0.5);
  EXPECT_EQ(pose.position, (Vec<3, double>{0, 0, 0}));
  for (Dim j = 0; j < 3; ++j) EXPECT_EQ(pose.rotation[j], unit_axis<3>(j));
}

TEST(Motion, TurnsAboutItsCenterWhichGoesStraight) {
  const Motion<2, double> motion{{4, 0}, pi, {1, 1}};
  const Pose<2, double> half = pose_at(motion, 0.5);  // the center at (3, 1), rotated by a quarter turn
  const Vec<2, double> moved = transformed<2, double>({2, 1}, half);
  EXPECT_NEAR(moved.x, 3, 1e-15);
  EXPECT_NEAR(moved.y, 2, 1e-15);
  const Motion<3, double> in_space{{0, 0, 2}, {0, 0, pi / 2}, {1, 0, 0}};
  const Vec<3, double> end = transformed<3, double>({2, 0, 5}, pose_at(in_space, 1));
  EXPECT_NEAR(end.x, 1, 1e-15);
  EXPECT_NEAR(end.y, 1, 1e-15);
  EXPECT_NEAR(end.z, 7, 1e-15);
}

void expect_near(const Pose<3, double>& found, const Pose<3, double>& expected, double off) {
  for (Dim i = 0; i < 3; ++i) {
    EXPECT_NEAR(found.position[i], expected.position[i], off);
    for (Dim j = 0; j < 3; ++j) EXPECT_NEAR(found.rotation[j][i], expected.rotation[j][i], off);
  }
}

/// The pose at the end of the motion between two poses, applied after the one at the start.
Pose<3, double> arrived(const Motion<3, double>& motion, const Pose<3, double>& start) {
  const Pose<3, double> way = pose_at(motion, 1);
  return {way.rotation * start.rotation, transformed<3, double>(start.position, way)};
}

TEST(Motion, BetweenTwoPosesEndsAtTheSecond) {
  const Pose<3, double> start{rotation_matrix(Vec<3, double>(1, 2, 3), 40), {5, -6, 7}};
  for (const double degrees : {0.0, 1e-7, 30.0, 90.0, 120.0, 179.0, 179.9999999, 180.0}) {
    for (const Vec<3, double>& axis : {Vec<3, double>(0, 0, 1), Vec<3, double>(-3, 1, 2), Vec<3, double>(0, -1, 0)}) {
      const Pose<3, double> end{rotation_matrix(axis, degrees) * start.rotation, {1, 2, 3}};
      const Motion<3, double> motion = motion_between(start, end);
      EXPECT_NEAR(std::sqrt(dot(motion.angular, motion.angular)), degrees * pi / 180, 1e-14) << degrees;
      EXPECT_EQ(motion.center, start.position);
      expect_near(arrived(motion, start), end, 1e-14);
    }
  }
}

TEST(Motion, BetweenTwoPosesOfThePlaneTurnsTheShorterWay) {
  for (const double degrees : {0.0, 30.0, -90.0, 170.0, -179.0}) {
    const Pose<2, double> start{rotation_matrix(25), {1, 2}};
    const Pose<2, double> end{rotation_matrix(25 + degrees), {3, 5}};
    const Motion<2, double> motion = motion_between(start, end);
    EXPECT_NEAR(motion.angular, degrees * pi / 180, 1e-15);
    EXPECT_EQ(motion.linear, (Vec<2, double>{2, 3}));
  }
}

TEST(Motion, IsFiniteIfEveryNumberIs) {
  EXPECT_TRUE(is_finite(Motion<2>()));
  EXPECT_FALSE(is_finite(Motion<2>{{0, 0}, std::numeric_limits<float>::infinity(), {0, 0}}));
  EXPECT_FALSE(is_finite(Motion<3>{{0, 0, 0}, {0, NAN, 0}, {0, 0, 0}}));
  EXPECT_FALSE(is_finite(Motion<3>{{0, 0, 0}, {0, 0, 0}, {0, 0, NAN}}));
}

}  // namespace
}  // namespace graze::test::motion_test
