// SPDX-License-Identifier: MIT
#include <limits>

#include <gtest/gtest.h>

#include <graze/query/intersects.hpp>

#include "catalogue.hpp"
#include "query/user_shapes.hpp"

namespace graze::test::intersects_test {
namespace {

TEST(Intersects, CountsTouching) {
  const Sphere<2, float> disc{{0, 0}, 5};
  EXPECT_TRUE(intersects(disc, Vec<2, float>(3, 4)));
  EXPECT_FALSE(intersects(disc, Vec<2, float>(3, 4.001F)));
  EXPECT_TRUE(intersects(disc, Aabb<2, float>{{3, 4}, {6, 6}}));
  EXPECT_TRUE(intersects(Aabb<2, float>{{3, 3}, {6, 6}}, disc));
}

TEST(Intersects, TakesAnyShapeAndAnyPart) {
  const AnyShape<3, double> any = Sphere<3, double>{{0, 0, 0}, 1};
  const Aabb<3, double> box{{0.5, 0.5, 0.5}, {2, 2, 2}};
  EXPECT_TRUE(intersects(any, box));
  EXPECT_TRUE(intersects(box, any));
  EXPECT_TRUE(intersects(any, any));
  EXPECT_TRUE(intersects(compound_of<3, double>({any}), box));
  EXPECT_FALSE(intersects(compound_of<3, double>({}), box));
}

TEST(Intersects, TakesAUsersType) {
  const user::Ellipsoid<double> egg{{0, 0, 0}, {3, 1, 1}};
  EXPECT_TRUE(intersects(egg, Sphere<3, double>{{5, 0, 0}, 2.001}));
  EXPECT_FALSE(intersects(egg, Sphere<3, double>{{5, 0, 0}, 1.999}));
  EXPECT_TRUE(intersects(HalfSpace<3, double>{{0, 1, 0}, -0.999}, egg));
  EXPECT_FALSE(intersects(HalfSpace<3, double>{{0, 1, 0}, -1.001}, egg));
}

template <class A, class B>
concept CanBeAsked = requires(const A& a, const B& b) {
  intersects(a, b);
};

TEST(Intersects, DoesNotCompileAcrossDimensionsAndNumberTypes) {
  EXPECT_TRUE((CanBeAsked<Sphere<2, float>, Ray<2, float>>));
  EXPECT_FALSE((CanBeAsked<Sphere<2, float>, Sphere<3, float>>));
  EXPECT_FALSE((CanBeAsked<Sphere<2, float>, Sphere<2, double>>));
  EXPECT_FALSE((CanBeAsked<Sphere<2, float>, float>));
}

template <class A, class B>
void expect_not_apart_law() {
  check_property([] {
    const auto [a, b] = *any_pair<A, B>();
    RC_ASSERT(intersects(a, b) == (relation(a, b) != Relation::apart));
    RC_ASSERT(intersects(b, a) == intersects(a, b));
  });
}

TEST(Intersects, IsRelationOtherThanApart) {
  expect_not_apart_law<Sphere<2, float>, Obb<2, float>>();
  expect_not_apart_law<Triangle<3, double>, Capsule<3, double>>();
  expect_not_apart_law<Aabb<3, float>, Aabb<3, float>>();
  expect_not_apart_law<Ray<3, float>, Triangle<3, float>>();
  expect_not_apart_law<Ray<3, double>, Triangle<3, double>>();
}

/// For a ray, the closed form is tried first.
TEST(Intersects, TakesNothingThatIsNoNumberForMet) {
  const Triangle<3, double> triangle{{-1, -1, 0}, {2, -1, 0}, {-1, 2, 0}};
  const Ray<3, double> ray{{0, 0, 3}, {0.1, 0.1, -1}};
  ASSERT_TRUE(intersects(ray, triangle));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (Dim i = 0; i < 3; ++i) {
    for (Vec<3, double> Triangle<3, double>::*corner :
         {&Triangle<3, double>::a, &Triangle<3, double>::b, &Triangle<3, double>::c}) {
      Triangle<3, double> broken = triangle;
      (broken.*corner)[i] = nan;
      EXPECT_FALSE(detail::is_met(ray, broken)) << i;
    }
    for (Vec<3, double> Ray<3, double>::*part : {&Ray<3, double>::origin, &Ray<3, double>::direction}) {
      Ray<3, double> broken = ray;
      (broken.*part)[i] = nan;
      EXPECT_FALSE(detail::is_met(broken, triangle)) << i;
    }
  }
}

}  // namespace
}  // namespace graze::test::intersects_test
