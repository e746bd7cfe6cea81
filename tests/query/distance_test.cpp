// SPDX-License-Identifier: MIT
#include <limits>
#include <type_traits>

#include <gtest/gtest.h>

#include <graze/query/distance.hpp>

#include "query/proximities.hpp"
#include "query/user_shapes.hpp"

namespace graze::test::distance_test {
namespace {

using V2 = Vec<2, float>;
using V3 = Vec<3, double>;

TEST(Distance, IsAsComputedByHand) {
  EXPECT_EQ(distance(Circle<float>{{0, 0}, 1}, Circle<float>{{3, 4}, 1}), 3.0F);
  EXPECT_EQ(distance(Rect<float>{{0, 0}, {1, 1}}, Rect<float>{{4, 5}, {6, 6}}), 5.0F);
  EXPECT_EQ(distance(Sphere<3, double>{{0, 0, 0}, 1}, Capsule<3, double>{{4, -9, 0}, {4, 9, 0}, 1}), 2.0);
  EXPECT_EQ(distance(Ray<2, float>{{0, 0}, {1, 0}}, V2(-3, 4)), 5.0F);
  EXPECT_EQ(distance(Plane<3, double>{{0, 0, 4}, 8}, V3(1, 2, 5)), 3.0);
  EXPECT_EQ(distance(Triangle<3, double>{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, Segment<3, double>{{1, 1, 3}, {1, 1, 9}}),
            3.0);
}

TEST(Distance, OfShapesThatTouchOrOverlapIsZero) {
  EXPECT_EQ(distance(Circle<float>{{0, 0}, 1}, Circle<float>{{2, 0}, 1}), 0.0F);
  EXPECT_EQ(distance(Circle<float>{{0, 0}, 1}, Circle<float>{{1, 0}, 1}), 0.0F);
  EXPECT_EQ(distance(Rect<float>{{0, 0}, {1, 1}}, V2(1, 1)), 0.0F);
}

// Less than half of the smallest float, which rounds to zero; but the shapes do not touch.
TEST(Distance, OfShapesThatDoNotTouchIsNotZero) {
  const auto least = std::numeric_limits<float>::denorm_min();
  EXPECT_EQ(distance(V2(0, 0), Plane<2, float>{{4, 0}, least}), least);
}

TEST(Distance, IsInTheNumberTypeOfTheShapes) {
  static_assert(std::is_same_v<decltype(distance(Circle<float>{}, V2{})), float>);
  static_assert(std::is_same_v<decltype(distance(Sphere<3, double>{}, V3{})), double>);
}

// glm::distance takes any two of one type, and is found by argument-dependent lookup for types made from vectors.
TEST(Distance, OfPointsIsOurs) {
  EXPECT_EQ(distance(V2(0, 0), V2(3, 4)), 5.0F);
  EXPECT_EQ(distance(V2(0, 0), V2(1e-30F, 0)), 1e-30F);  // GLM's version squares it in float
}

TEST(Distance, OfAnyShapesIsThatOfWhatTheyHold) {
  const AnyShape<3, double> sphere = Sphere<3, double>{{0, 0, 0}, 1};
  const AnyShape<3, double> point = V3(0, 0, 4);
  EXPECT_EQ((distance_of<3, double>(sphere, point)), 3.0);
  EXPECT_EQ((distance_of<3, double>(point, sphere)), 3.0);
}

TEST(Distance, OfACompoundIsThatOfItsNearestPart) {
  using Any = AnyShape<2, float>;
  const Any dumbbell = compound_of<2, float>({Circle<float>{{-5, 0}, 1}, Circle<float>{{5, 0}, 1}});
  EXPECT_EQ((distance_of<2, float>(dumbbell, V2(0, 0))), 4.0F);
  EXPECT_EQ((distance_of<2, float>(dumbbell, V2(9, 0))), 3.0F);
  EXPECT_EQ((distance_of<2, float>(dumbbell, dumbbell)), 0.0F);
  EXPECT_EQ((distance_of<2, float>(dumbbell, Compound<2, float>{})), std::numeric_limits<float>::infinity());
}

TEST(Distance, TakesAUsersShape) {
  EXPECT_NEAR(distance(user::Cylinder<double>{{0, 0, 0}, 1, 2}, V3(5, 0, 0)), 4.0, 1e-12);
  EXPECT_NEAR(distance(user::Cone<float>{{0, 0, 0}, 1, 2}, user::Cone<float>{{0, 0, 5}, 1, 2}), 3.0F, 1e-5F);
}

}  // namespace
}  // namespace graze::test::distance_test
