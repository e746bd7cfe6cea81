// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <graze/query/fast_contact/fast_contact.hpp>
#include <graze/query/manifold.hpp>

namespace graze::detail::quick_touch_test {
namespace {

using Ball = Sphere<3, double>;
using Box = Obb<3, double>;

static_assert(has_fast_contact<Ball, Box> && has_fast_contact<Box, Ball>);
static_assert(has_fast_contact<Sphere<2, float>, Capsule<2, float>>);
static_assert(has_fast_contact<Sphere<2, float>, Obb<2, float>> && !has_fast_contact<Aabb<2, float>, Aabb<2, float>>);
static_assert(has_fast_contact<Triangle<3, double>, Ball> && !has_fast_contact<Sphere<2, double>, Triangle<2, double>>);

TEST(QuickTouch, TurnsWhatItSeesWithTheShapes) {
  const Ball sphere{{0, 0, 1.5}, 1};
  const Box box{{0, 0, 0}, {3, 2, 1}};
  const FastContact<3> one = fast_contact(sphere, box);
  const FastContact<3> other = fast_contact(box, sphere);
  ASSERT_TRUE(one.is_known && one.meets && other.is_known && other.meets);
  EXPECT_EQ(one.found.normal, -other.found.normal);
  EXPECT_EQ(one.found.depth, other.found.depth);
  EXPECT_EQ(one.found.point_a, other.found.point_b);
  EXPECT_EQ(one.feature_b, other.feature_a);
  EXPECT_EQ(other.feature_a, (Feature{FeatureKind::face, 5}));
}

}  // namespace
}  // namespace graze::detail::quick_touch_test
