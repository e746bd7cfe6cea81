// SPDX-License-Identifier: MIT
// Tests the steps from one separating plane to the next; time_of_impact_laws_test.cpp tests where they lead.
#include <cmath>

#include <gtest/gtest.h>

#include <graze/math/motion.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/query/cast/motion_advance.hpp>
#include <graze/query/convex/wide_support.hpp>
#include <graze/query/transformed.hpp>
#include <graze/shape/obb.hpp>

namespace graze::test::motion_advance_test {
namespace {

TEST(MotionAdvance, TheLeastBetweenTwoGapsIsThatOfTheParabola) {
  EXPECT_EQ(detail::least_between(1, 2, 0), 1);
  EXPECT_EQ(detail::least_between(2, 1, 0), 1);
  EXPECT_EQ(detail::least_between(1, 1, 2), 0.5);  // 1 - 2 s + 2 s^2 at s = 1/2
  EXPECT_EQ(detail::least_between(4, 0, 1), 0);    // 4 - 5 s + s^2 decreases over the whole interval
}

using Point = Vec<3, double>;
using Box = Obb<3, double>;
using Pair = detail::ConvexPair<3, double>;

/// Two boxes that move past each other, both rotating.
const Box a{{0, 0, 0}, {1, 0.5, 0.25}, rotation_matrix(Point(1, 2, 3), 40)};
const Box b{{6, 1, 0}, {0.5, 2, 1}, rotation_matrix(Point(3, -1, 0), 70)};
const Motion<3, double> motion_a{{8, 0, 1}, {0.5, -0.25, 1}, {0.5, 0, 0}};
const Motion<3, double> motion_b{{-1, 0.5, 0}, {0, 2, 0.25}, {6, 2, 0}};

TEST(MotionAdvance, ACourseIsTheMotionOfAAsBSeesIt) {
  const auto trajectory = detail::trajectory_of(motion_a, motion_b, 2.0, 0.0);
  for (const double t : {0.0, 0.3, 0.99}) {
    const Point seen = transformed(Point(1, 2, 3), trajectory.pose_of_a(trajectory.at(t)));
    const Point in_world = transformed(seen, pose_at(motion_b, t));
    EXPECT_LT(max_abs(in_world - transformed(Point(1, 2, 3), pose_at(motion_a, t))), 1e-14) << t;
    const Pose<3, double> of_b = trajectory.pose_of_b(trajectory.at(t));
    EXPECT_LT(max_abs(transformed(Point(1, 2, 3), of_b) - transformed(Point(1, 2, 3), pose_at(motion_b, t))), 1e-14);
  }
  const Motion<2, double> swing{{1, 2}, 2.5, {3, 4}};
  const Motion<2, double> other{{0, 1}, -1, {-2, 5}};
  const auto flat = detail::trajectory_of(swing, other, 2.0, 0.0);
  const Vec<2, double> flat_seen = transformed(Vec<2, double>(7, 8), flat.pose_of_a(flat.at(0.5)));
  const Vec<2, double> expected = transformed(Vec<2, double>(7, 8), pose_at(swing, 0.5));
  EXPECT_LT(max_abs(transformed(flat_seen, pose_at(other, 0.5)) - expected), 1e-14);
}

TEST(MotionAdvance, TheGapInTimeIsThatOfTheShapesWhereTheyAre) {
  const Pair pair(detail::ConvexView<3>(a), detail::ConvexView<3>(b), 0.125);
  const auto trajectory = detail::trajectory_of(motion_a, motion_b, 2.0, 0.125);
  const Point normal = Point(2, 1, -2) / 3.0;
  const detail::GapInTime<3, Pair> gap(pair, trajectory, normal);
  for (const double t : {0.0, 0.25, 0.8}) {
    const Box there = transformed(a, trajectory.pose_of_a(trajectory.at(t)));
    const double expected = dot(normal, support(b, -normal)) - dot(normal, support(there, normal)) - 0.125;
    EXPECT_NEAR(gap.at(trajectory.at(t)), expected, 1e-14) << t;
  }
}

TEST(MotionAdvance, APlaneIsKeptUntilLittleOfItsGapIsLeftAndNoLonger) {
  Pair pair(detail::ConvexView<3>(a), detail::ConvexView<3>(b), 0);
  const auto trajectory = detail::trajectory_of(motion_a, motion_b, detail::reach_from(motion_a.center, a), 0.0);
  const double goal = tolerance::impact * trajectory.size / 2;
  const auto start = trajectory.at(0);
  const auto parting = pair.gap_state_at(trajectory.pose_of_a(start));
  ASSERT_GT(parting.gap, 1);
  const auto kept = detail::moment_parted(pair, trajectory, start, parting, goal);
  ASSERT_GT(kept.t, 0);
  const detail::GapInTime<3, Pair> gap(pair, trajectory, parting.normal);
  constexpr int samples = 1000;
  for (int i = 0; i <= samples; ++i) EXPECT_GE(gap.at(trajectory.at(kept.t * i / samples)), goal) << i;
  // At most half of the gap may be lost to the curvature of the path.
  const double lost = trajectory.bend * kept.t * kept.t / 2;
  EXPECT_LE(lost, parting.gap / 2);
}

}  // namespace
}  // namespace graze::test::motion_advance_test
