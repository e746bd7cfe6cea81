// SPDX-License-Identifier: MIT
#include <limits>

#include <gtest/gtest.h>

#include <graze/query/convex/wide_support.hpp>
#include <graze/shape/any_shape.hpp>

#include "query/user_shapes.hpp"

namespace graze::detail::wide_support_test {
namespace {

using V3 = Vec<3, double>;

TEST(WideSupport, OfOurShapesIsTheirOwn) {
  EXPECT_EQ(wide_support(Aabb<3, float>{{-1, -2, -3}, {1, 2, 3}}, V3(1, -1, 1)), V3(1, -2, 3));
  EXPECT_EQ(wide_support(Segment<3, double>{{0, 0, 0}, {1, 2, 3}}, V3(0, 0, 1)), V3(1, 2, 3));
}

TEST(WideSupport, OfAUsersFloatShapeTakesDirectionsOfAnyLength) {
  const user::Ellipsoid<float> egg{{1, 0, 0}, {2, 3, 4}};
  for (const double length : {1.0, 1e-200, 1e200}) {
    EXPECT_EQ(wide_support(egg, V3(length, 0, 0)), V3(3, 0, 0)) << length;
    EXPECT_EQ(wide_support(egg, V3(0, -length, 0)), V3(1, -3, 0)) << length;
  }
}

TEST(SupportError, IsThatOfTheNumbersTheShapeCalculatesIn) {
  EXPECT_EQ((support_error<Sphere<3, float>>), 32 * std::numeric_limits<double>::epsilon());
  EXPECT_EQ((support_error<user::Ellipsoid<double>>), 32 * std::numeric_limits<double>::epsilon());
  EXPECT_EQ((support_error<user::Ellipsoid<float>>), 32.0 * static_cast<double>(std::numeric_limits<float>::epsilon()));
}

TEST(Core, OfARoundShapeIsWhatItIsBuiltAround) {
  const Capsule<2, float> capsule{{1, 2}, {3, 4}, 0.5F};
  EXPECT_EQ(core(capsule).start, (Vec<2, float>(1, 2)));
  EXPECT_EQ(core(capsule).end, (Vec<2, float>(3, 4)));
  EXPECT_EQ(core_radius(capsule), 0.5);
  EXPECT_EQ((core(Sphere<2, float>{{1, 2}, 3})), (Vec<2, float>(1, 2)));
  EXPECT_EQ((core_radius(Sphere<2, float>{{1, 2}, 3})), 3);
  const Aabb<2, float> box{{0, 0}, {1, 1}};
  EXPECT_EQ(&core(box), &box);
  EXPECT_EQ(core_radius(box), 0);
}

TEST(Difference, IsSpannedByBothSupports) {
  const Aabb<3, double> box{{-1, -1, -1}, {1, 1, 1}};
  const Vec<3, double> point(10, 0, 0);
  Difference<Aabb<3, double>, Vec<3, double>> difference(box, point);
  EXPECT_EQ(difference.resolution(), 0);
  EXPECT_EQ(difference.support(V3(1, 1, 1)), V3(-9, 1, 1));
  EXPECT_EQ(difference.support(V3(-1, -1, -1)), V3(-11, -1, -1));
  EXPECT_EQ(difference.resolution(), 320 * std::numeric_limits<double>::epsilon());
}

}  // namespace
}  // namespace graze::detail::wide_support_test
