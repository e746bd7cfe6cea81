// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/math/tolerance.hpp>
#include <graze/query/bounding/box.hpp>

#include "query/point_sets.hpp"

namespace graze::bounding_box_test {
namespace {

TEST(BoundingBox, ReachesFromTheLeastToTheLargestCoordinates) {
  EXPECT_EQ((bounding_box<2, float>({{1, 5}, {-2, 7}, {0, 6}})), (Aabb<2>{{-2, 5}, {1, 7}}));
  EXPECT_EQ((bounding_box<3, double>({{3, 4, 5}})), (Aabb<3, double>{{3, 4, 5}, {3, 4, 5}}));
}

TEST(BoundingBox, HoldsTheLargestNumbers) {
  const float huge = std::numeric_limits<float>::max();
  EXPECT_EQ((bounding_box<2, float>({{-huge, huge}, {huge, -huge}})), (Aabb<2>{{-huge, -huge}, {huge, huge}}));
}

template <class S>
class BoundingBoxIn : public testing::Test {};
TYPED_TEST_SUITE(BoundingBoxIn, test::Spaces);

TYPED_TEST(BoundingBoxIn, ContainsEveryPointAndTouchesOneOnEverySide) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    const std::vector<Vec<N, T>> points = test::draw_points<N, T>(12);
    const Aabb<N, T> box = bounding_box(points);
    RC_ASSERT(test::contains_all(box, points));
    for (Dim i = 0; i < N; ++i) {
      const auto touches = [&points, i](T side) {
        return std::any_of(points.begin(), points.end(), [&](const Vec<N, T>& point) { return point[i] == side; });
      };
      RC_ASSERT(touches(box.min[i]));
      RC_ASSERT(touches(box.max[i]));
    }
  });
}

TYPED_TEST(BoundingBoxIn, GivesALocalFrameInWhichThePointsAreAboutAsLargeAsOne) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    const std::vector<Vec<N, T>> points = test::draw_points<N, T>(12);
    const Aabb<N, T> box = bounding_box(points);
    if (detail::largest_side(box) == 0) return;
    const detail::LocalFrame<N> frame = detail::local_frame(box);
    RC_ASSERT(std::exp2(std::ilogb(frame.scale)) == frame.scale);
    double largest = 0;
    for (const Vec<N, T>& point : points) {
      largest = std::max(largest, max_abs(frame.local(point)));
      const double error = max_abs<N, double>(frame.world(frame.local(point)) - wide<N, T>(point));
      RC_ASSERT(error <= 2 * tolerance::epsilon * (max_abs(wide<N, T>(point)) + detail::largest_side(box)));
    }
    RC_ASSERT(largest >= 0.5 - tolerance::rounding);
    RC_ASSERT(largest <= 1 + tolerance::rounding * max_abs(frame.origin) * frame.scale);
  });
}

TEST(BoundingBox, GivesTheSmallestSetsALocalFrameToo) {
  const Aabb<2, double> box{{0, 0}, {std::numeric_limits<double>::denorm_min() * 4, 0}};
  const detail::LocalFrame<2> frame = detail::local_frame(box);
  EXPECT_EQ(frame.scale, 0x1p1000);
  EXPECT_EQ(frame.local(box.max), (Vec<2, double>(0x1p-73, 0)));
}

}  // namespace
}  // namespace graze::bounding_box_test
