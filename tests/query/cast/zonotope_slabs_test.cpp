// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include <graze/query/cast/zonotope_slabs.hpp>
#include <graze/query/cores/closest.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/segment.hpp>

namespace graze::test::zonotope_slabs_test {
namespace {

using Point = Vec<3, double>;

const Obb<3, double> box{{1, 2, 3}, {1, 0.5, 0}, {{0.6, 0.8, 0}, {-0.8, 0.6, 0}, {0, 0, 1}}};
const Segment<3, double> segment{{5, -2, 0}, {7, 2, 1}};

TEST(RoundedZonotope, IsTheSetOfDifferences) {
  const auto solid = detail::difference_of(detail::zonotope(box), detail::zonotope(segment), 0.25);
  EXPECT_EQ(solid.radius, 0.25);
  for (const Point& direction : {Point(1, 0, 0), Point(0, -1, 0), Point(1, 2, -3), Point(-5, 1, 0.25)}) {
    const double highest = detail::span_along(direction, segment).high - detail::span_along(direction, box).low;
    EXPECT_NEAR(dot(direction, solid.center) + detail::reach_along(solid, direction), highest, 1e-14);
  }
}

TEST(RoundedZonotope, HasASizeThatNoPointIsBeyond) {
  const auto solid = detail::difference_of(detail::zonotope(box), detail::zonotope(segment), 0.25);
  for (const Point& corner : detail::corner_points(box)) {
    for (const Point& end : {segment.start, segment.end}) {
      EXPECT_LE(sum_abs(end - corner) + 0.25, detail::size_of(solid));
    }
  }
}

/// The times of a point that moves towards a cube from -1 to 1 around a center, with or without rounded edges.
detail::AxisTimes<3> times_at_cube(const Point& center, const Point& motion, double radius) {
  const Aabb<3, double> cube{center - 1.0, center + 1.0};
  const auto solid = detail::difference_of(detail::zonotope(Point(0.0)), detail::zonotope(cube), radius);
  detail::AxisTimes<3> times(solid.center, motion, radius, detail::size_of(solid));
  detail::add_axes(solid, motion, times);
  return times;
}

TEST(AxisTimes, AreEnteredWhereTheLastPlaneIsCrossed) {
  const auto times = times_at_cube({5, 0.5, 1}, {8, 0, 1}, 0);
  EXPECT_TRUE(times.are_entered());
  EXPECT_FALSE(times.are_missed());
  EXPECT_DOUBLE_EQ(times.enter(), 0.5);
  EXPECT_GT(times.normal().x, 0);
  EXPECT_EQ(times.normal().y, 0);
  EXPECT_EQ(times.normal().z, 0);
  EXPECT_DOUBLE_EQ(times_at_cube({5, 0.5, 1}, {8, 0, 1}, 0.4).enter(), 0.45);
}

TEST(AxisTimes, AreMissedBesideShortOfAndBehind) {
  EXPECT_TRUE(times_at_cube({5, 1.001, 0}, {8, 0, 0}, 0).are_missed());
  EXPECT_FALSE(times_at_cube({5, 1.001, 0}, {8, 0, 0}, 0.01).are_missed());
  EXPECT_TRUE(times_at_cube({5, 0, 0}, {3.999, 0, 0}, 0).are_missed());
  EXPECT_TRUE(times_at_cube({-5, 0, 0}, {8, 0, 0}, 0).are_missed());
  EXPECT_TRUE(times_at_cube({5, 5, 0}, {10, 5, 0}, 0).are_missed());
}

TEST(AxisTimes, AreNeitherWhereThePointGrazes) {
  for (const double off : {-1e-13, 0.0, 1e-13}) {
    const auto beside = times_at_cube({5, 1 + off, 0}, {8, 0, 0}, 0);
    EXPECT_FALSE(beside.are_missed() || beside.are_entered()) << off;
    const auto at_end = times_at_cube({5, 0, 0}, {4 + off, 0, 0}, 0);
    EXPECT_FALSE(at_end.are_missed() || at_end.are_entered()) << off;
  }
}

TEST(AddAxes, SeesWhatOnlyTheProductOfTwoEdgesParts) {
  // Two crossed needles pass each other at a distance of 1/2: their boxes along the axes of either overlap.
  const double root = std::sqrt(0.5);
  const Segment<3, double> up{{-root, 0, -root}, {root, 0, root}};
  const Segment<3, double> across{{3, -1, 0}, {3, 1, 0}};
  const Obb<3, double> flat{{3, 0.5, 0}, {1, 0, 1}, {{root, root, 0}, {-root, root, 0}, {0, 0, 1}}};
  const auto are_missed = [](const auto& a, const auto& b, const Point& motion) {
    const auto solid = detail::difference_of(detail::zonotope(a), detail::zonotope(b), 0);
    detail::AxisTimes<3> times(solid.center, motion, 0, detail::size_of(solid));
    detail::add_axes(solid, motion, times);
    return times.are_missed();
  };
  EXPECT_TRUE(are_missed(up, across, {2, 0, 0}));
  EXPECT_FALSE(are_missed(up, across, {6, 0, 0}));
  EXPECT_TRUE(are_missed(up, flat, {0, 4, 0}));
  EXPECT_FALSE(are_missed(up, flat, {6, 0, 0}));
}

TEST(AddAxes, KnowsAParallelogramThatIsASegment) {
  const Segment<3, double> one{{0, 0, 0}, {2, 0, 0}};
  const Segment<3, double> other{{5, 1, 0}, {9, 1, 0}};
  const auto solid = detail::difference_of(detail::zonotope(one), detail::zonotope(other), 0.5);
  const Point motion(12, 1, 0);
  detail::AxisTimes<3> times(solid.center, motion, solid.radius, detail::size_of(solid));
  detail::add_axes(solid, motion, times);
  EXPECT_FALSE(times.are_missed());
  EXPECT_DOUBLE_EQ(times.enter(), 0.5) << "the lines are 1/2 apart then, long after the ends have passed each other";
  EXPECT_EQ(times.normal(), Point(0, 1, 0));
}

}  // namespace
}  // namespace graze::test::zonotope_slabs_test
