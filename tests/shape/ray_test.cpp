// SPDX-License-Identifier: MIT
#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <graze/shape/ray.hpp>

#include "../catalogue/nasty.hpp"

namespace graze::ray_test {
namespace {

template <class S>
class RayIn : public testing::Test {};
TYPED_TEST_SUITE(RayIn, test::Spaces);

TYPED_TEST(RayIn, NamesTheDefectOfEveryNumber) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  EXPECT_EQ(test::expect_defects(
                Ray<N, T>{}, test::finite("has an origin that is not finite"),
                test::direction_along(0, "has a direction that is not finite", "has a direction of length zero")),
            2 * N * 11);
}

TEST(Ray, DefaultsToTheOriginAlongX) {
  EXPECT_EQ((Ray<2>{}.origin), (Vec<2, float>(0, 0)));
  EXPECT_EQ((Ray<3, double>{}.direction), (Vec<3, double>(1, 0, 0)));
}

TEST(Ray, MayHaveADirectionOfAnyLength) {
  EXPECT_TRUE(is_valid(Ray<2, double>{{0, 0}, {0, std::numeric_limits<double>::denorm_min()}}));
  EXPECT_TRUE(is_valid(Ray<2, double>{{0, 0}, {1e308, -1e308}}));
}

TEST(Ray, BetweenTwoPointsReachesTheSecondAtOne) {
  const Ray<3, float> ray = ray_between(Vec<3, float>(1, 2, 3), Vec<3, float>(4, 2, 1));
  EXPECT_EQ(ray.origin, (Vec<3, float>(1, 2, 3)));
  EXPECT_EQ(ray.direction, (Vec<3, float>(3, 0, -2)));
}

TEST(Ray, BetweenEqualPointsIsRefusedWithTheReason) {
  try {
    ray_between(Vec<2, double>(1, 2), Vec<2, double>(1, 2));
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()), "ray_between: the two points are equal, so the ray has no direction");
  }
}

TEST(Ray, BetweenNeighbouringNumbersHasADirection) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(ray_between(Vec<2, double>(0, 0), Vec<2, double>(tiny, 0)).direction, (Vec<2, double>(tiny, 0)));
}

TEST(Ray, TurnsItsDirectionAndMovesItsOrigin) {
  const Pose<2, float> pose{Mat<2, float>(rotation_matrix(90)), {10, 0}};
  const Ray<2, float> moved = transformed(Ray<2, float>{{1, 0}, {0, 2}}, pose);
  EXPECT_EQ(moved.origin, (Vec<2, float>(10, 1)));
  EXPECT_EQ(moved.direction, (Vec<2, float>(-2, 0)));
}

}  // namespace
}  // namespace graze::ray_test
