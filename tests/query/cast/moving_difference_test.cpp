// SPDX-License-Identifier: MIT
// The differences of moving shapes are those of the shapes at their positions, and cached ones are found again.
#include <algorithm>
#include <cstddef>

#include <gtest/gtest.h>

#include <graze/math/motion.hpp>
#include <graze/query/cast/minkowski_difference.hpp>
#include <graze/query/cast/moving_difference.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/convex/simplex.hpp>
#include <graze/query/convex/wide_support.hpp>
#include <graze/query/transformed.hpp>
#include <graze/shape/obb.hpp>

namespace graze::test::moving_difference_test {
namespace {

using Point = Vec<3, double>;
using Box = Obb<3, double>;
using View = detail::ConvexView<3>;

const Box a{{3, 1, 0}, {1, 2, 0.5}, rotation_matrix(Point(1, 2, 3), 40)};
const Box b{{-1, 0, 1}, {0.5, 0.25, 2}, rotation_matrix(Point(3, -1, 0), 70)};
const Motion<3, double> motion{{-2, 1, 0.5}, {0.3, 0.2, -0.7}, {3, 1, 0}};

TEST(MovingDifference, SupportPointsAreThoseOfTheShapesWhereTheyAre) {
  const View view_a(a);
  const View view_b(b);
  const Pose<3, double> pose = pose_at(motion, 0.75);
  const Box there = transformed(a, pose);
  detail::MovingDifference<3, double> moving(view_a, view_b, pose);
  detail::Difference<Box, Box> placed(there, b);
  for (const Point& direction : {Point(1, 2, 3), Point(-1, 0.5, 2), Point(0.1, -3, 1)}) {
    const Point difference = moving.support(direction);
    EXPECT_LT(max_abs(difference - placed.support(direction)), 1e-14);
    EXPECT_LT(max_abs(moving.witness(difference).on_a - support(there, direction)), 1e-14);
  }
  EXPECT_GT(moving.resolution(), 0);
  EXPECT_LT(moving.resolution(), 1e-12);
}

TEST(MovingDifference, CornersThatWereKnownAreFoundWhereTheyHaveMovedTo) {
  const View view_a(a);
  const View view_b(b);
  const Pose<3, double> before = pose_at(motion, 0.5);
  detail::MovingDifference<3, double> early(view_a, view_b, before);
  detail::Simplex<3> simplex;
  for (const Point& direction : {Point(1, 2, 3), Point(-1, 0.5, 2)}) simplex.push(early.support(direction));
  const auto corners = early.corners_of(simplex);
  ASSERT_EQ(corners.size, 2U);

  const Pose<3, double> after = pose_at(motion, 0.6);
  detail::MovingDifference<3, double> late(view_a, view_b, after);
  const detail::Simplex<3> moved = late.simplex_of(corners);
  ASSERT_EQ(moved.size, 2U);
  for (std::size_t i = 0; i < moved.size; ++i) {
    const auto& corner = corners.corners[i];
    EXPECT_EQ(moved.points[i], transformed(corner.on_a, after) - corner.on_b);
    EXPECT_EQ(simplex.points[i], transformed(corner.on_a, before) - corner.on_b);
    EXPECT_EQ(late.witness(moved.points[i]).on_a, transformed(corner.on_a, after));
  }
}

}  // namespace
}  // namespace graze::test::moving_difference_test
