// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

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
  EXPECT_EQ(transformed(Vec<2, double>(3, 4), pose), (Vec<2, double>(6, 23)));  // (3, 4) is rotated to (-4, 3)
  EXPECT_EQ((rotated<2, double>(Vec<2, double>(3, 4), pose)), (Vec<2, double>(-4, 3)));
}

TEST(Pose, IsMadeFromAnAngleAnAxisOrAQuaternion) {
  const Pose<2> flat = Pose<2>::from_angle({10, 20}, 0.5);
  EXPECT_EQ(flat.rotation, (Mat<2, float>(rotation_from_angle(0.5))));
  EXPECT_EQ(flat.position, (Vec<2, float>(10, 20)));
  const Vec<3, double> axis(1, 2, -2);
  const Pose<3, double> turned = Pose<3, double>::from_axis_angle({1, 2, 3}, axis, 0.5);
  EXPECT_EQ(turned.rotation, rotation_from_axis_angle(axis, 0.5));
  EXPECT_EQ(turned.position, (Vec<3, double>(1, 2, 3)));
  const Vec<4, float> quaternion(1, 2, 3, 4);
  const Pose<3> float_pose = Pose<3>::from_quaternion({1, 2, 3}, quaternion);
  EXPECT_EQ(float_pose.rotation, (Mat<3, float>(rotation_from_quaternion(quaternion))));
  EXPECT_EQ(float_pose.position, (Vec<3, float>(1, 2, 3)));
}

TEST(Pose, RotatesEveryColumnOfAFrame) {
  const Pose<2, double> pose{rotation_matrix(90), {10, 20}};
  const Mat<2, double> frame = rotated<2, double>(Mat<2, double>({1, 2}, {3, 4}), pose);
  EXPECT_EQ(frame[0], (Vec<2, double>(-2, 1)));
  EXPECT_EQ(frame[1], (Vec<2, double>(-4, 3)));
}

TEST(Pose, RoundsAFloatImageOnce) {
  // 16777217 is not a float; in float arithmetic 16777216 + 1 would stay 16777216, and the last 1 would be lost again.
  const Pose<2, float> pose{Mat<2, float>({1, 0}, {1, 1}), {1, 0}};
  EXPECT_EQ(transformed(Vec<2, float>(16777216, 1), pose), (Vec<2, float>(16777218, 1)));
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
