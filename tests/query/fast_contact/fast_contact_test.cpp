// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <graze/query/fast_contact/fast_contact.hpp>
#include <graze/query/manifold.hpp>

namespace graze::detail::quick_touch_test {
namespace {

using Ball = Sphere<3, double>;
using Box = Obb<3, double>;

static_assert(has_quick_touch<Ball, Box> && has_quick_touch<Box, Ball>);
static_assert(has_quick_touch<Sphere<2, float>, Capsule<2, float>>);
static_assert(has_quick_touch<Sphere<2, float>, Obb<2, float>> && !has_quick_touch<Aabb<2, float>, Aabb<2, float>>);
static_assert(has_quick_touch<Triangle<3, double>, Ball> && !has_quick_touch<Sphere<2, double>, Triangle<2, double>>);

TEST(QuickTouch, TurnsWhatItSeesWithTheShapes) {
  const Ball ball{{0, 0, 1.5}, 1};
  const Box box{{0, 0, 0}, {3, 2, 1}};
  const TouchLook<3> one = quick_touch(ball, box);
  const TouchLook<3> other = quick_touch(box, ball);
  ASSERT_TRUE(one.is_known && one.meets && other.is_known && other.meets);
  EXPECT_EQ(one.found.normal, -other.found.normal);
  EXPECT_EQ(one.found.depth, other.found.depth);
  EXPECT_EQ(one.found.point_a, other.found.point_b);
  EXPECT_EQ(one.feature_b, other.feature_a);
  EXPECT_EQ(other.feature_a, (Feature{FeatureKind::face, 5}));
}

}  // namespace
}  // namespace graze::detail::quick_touch_test
