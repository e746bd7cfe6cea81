// SPDX-License-Identifier: MIT
#include <cmath>
#include <type_traits>

#include <gtest/gtest.h>

#include <graze/shape/sphere.hpp>

#include "../catalogue/nasty.hpp"

namespace graze::sphere_test {
namespace {

static_assert(std::is_same_v<Circle<double>, Sphere<2, double>> && std::is_same_v<Circle<>, Sphere<2>>);

template <class S>
class SphereIn : public testing::Test {};
TYPED_TEST_SUITE(SphereIn, test::Spaces);

TYPED_TEST(SphereIn, NamesTheDefectOfEveryNumber) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  EXPECT_EQ(test::expect_defects(Sphere<N, T>{}, test::finite("has a center that is not finite"),
                                 test::finite_size("has a radius that is not finite", "has a negative radius")),
            (N + 1) * 11);
}

TYPED_TEST(SphereIn, OfRadiusZeroIsValidAndItsOwnSupport) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const Sphere<N, T> point{Vec<N, T>(T(-3)), 0};
  EXPECT_TRUE(is_valid(point));
  EXPECT_EQ(support(point, Vec<N, double>(0.3)), (Vec<N, double>(-3)));
}

TEST(Sphere, DefaultsToTheUnitSphereAtTheOrigin) {
  EXPECT_EQ((Sphere<3>{}.center), (Vec<3, float>(0, 0, 0)));
  EXPECT_EQ((Sphere<3>{}.radius), 1.0F);
}

TEST(Sphere, HasItsSupportAtTheRadiusWhateverTheLengthOfTheDirection) {
  const Sphere<2, float> circle{{1, 2}, 5};
  EXPECT_EQ(support(circle, {1, 0}), (Vec<2, double>(6, 2)));
  EXPECT_EQ(support(circle, {-0.25, 0}), (Vec<2, double>(-4, 2)));
  EXPECT_EQ(support(circle, {3, 4}), (Vec<2, double>(4, 6)));
  EXPECT_EQ(support(circle, {0x3p-300, 0x4p-300}), (Vec<2, double>(4, 6)));
  EXPECT_EQ(support(circle, {0x3p300, -0x4p300}), (Vec<2, double>(4, -2)));
}

TEST(Sphere, MovesWithItsCenterAndKeepsItsRadius) {
  const Pose<3, double> pose{rotation_matrix(Vec<3, double>(0, 0, 1), 90), {0, 0, 7}};
  const Sphere<3, double> moved = transformed(Sphere<3, double>{{1, 0, 0}, 0.1}, pose);
  EXPECT_EQ(moved.center, (Vec<3, double>(0, 1, 7)));
  EXPECT_EQ(moved.radius, 0.1);
}

}  // namespace
}  // namespace graze::sphere_test
