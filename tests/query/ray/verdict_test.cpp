// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <graze/query/ray/verdict.hpp>

namespace graze::detail::ray_sight_test {
namespace {

using Point = Vec<3, double>;
constexpr double infinity = std::numeric_limits<double>::infinity();

template <Dim N>
Path<N> path(const Vec<N, double>& direction, double t_max) {
  return {Vec<N, double>(0.0), direction, t_max};
}

TEST(RaySight, OfABallIsClearBeyondRoundingAndUnclearWithin) {
  const Point along(2, 0, 0);
  const auto sight = [&along](double height, double t_max) {
    return sight_of(Sphere<3, double>{{10, height, 0}, 1}, path(along, t_max)).sight;
  };
  EXPECT_EQ(sight(0.999, infinity), Sight::hits);
  EXPECT_EQ(sight(1.001, infinity), Sight::misses);
  EXPECT_EQ(sight(1, infinity), Sight::unclear);
  EXPECT_EQ(sight(1 + 1e-15, infinity), Sight::unclear);
  EXPECT_EQ(sight(0, 4.5), Sight::unclear);
  EXPECT_EQ(sight(0, 4.51), Sight::hits);
  EXPECT_EQ(sight(0, 4.49), Sight::misses);
}

TEST(RaySight, OfABallBehindTheOriginMisses) {
  const Point along(1, 0, 0);
  EXPECT_EQ(sight_of(Sphere<3, double>{{-3, 0, 0}, 1}, path(along, infinity)).sight, Sight::misses);
  EXPECT_EQ(sight_of(Sphere<3, double>{{-1, 0, 0}, 1}, path(along, infinity)).sight, Sight::unclear);
  const Sighting<3> inside = sight_of(Sphere<3, double>{{-0.5, 0, 0}, 1}, path(along, infinity));
  EXPECT_EQ(inside.sight, Sight::hits);
  EXPECT_EQ(inside.touch.t, 0);
  EXPECT_EQ(inside.touch.normal, Point(0.0));
}

TEST(RaySight, OfABallKnowsWhereAGrazingRayTouches) {
  const Sighting<3> grazing = sight_of(Sphere<3, double>{{10, 1, 0}, 1}, path(Point(2, 0, 0), infinity));
  EXPECT_EQ(grazing.touch.t, 5);
  EXPECT_EQ(grazing.touch.point, Point(10, 0, 0));
  EXPECT_EQ(grazing.touch.normal, Point(0, -1, 0));
}

TEST(RaySight, OfACapsuleMeetsTheTubeOrAnEnd) {
  const Capsule<3, double> capsule{{10, -2, 0}, {10, 2, 0}, 1};
  const Sighting<3> tube = sight_of(capsule, path(Point(1, 0, 0), infinity));
  EXPECT_EQ(tube.sight, Sight::hits);
  EXPECT_EQ(tube.touch.t, 9);
  EXPECT_EQ(tube.touch.normal, Point(-1, 0, 0));
  // Through (10, 2.6, 0) parallel to x, seen from (0, 2.6, 0): 0.6 over the upper end's center, 0.8 before it.
  const Capsule<3, double> lower{{10, -4.6, 0}, {10, -0.6, 0}, 1};
  const Sighting<3> end = sight_of(lower, path(Point(1, 0, 0), infinity));
  EXPECT_EQ(end.sight, Sight::hits);
  EXPECT_DOUBLE_EQ(end.touch.t, 9.2);
  EXPECT_NEAR(end.touch.normal.y, 0.6, 1e-15);
  EXPECT_EQ(sight_of(capsule, path(Point(1, 0, 0), 8.9)).sight, Sight::misses);
  EXPECT_EQ(sight_of(capsule, path(Point(1, 0.4, 0), infinity)).sight, Sight::misses);
}

TEST(RaySight, OfACapsuleLeavesNearlyParallelRaysOpen) {
  const Sighting<3> along = sight_of(Capsule<3, double>{{2, 0, 0}, {5, 0, 0}, 1}, path(Point(1, 0, 0), infinity));
  EXPECT_EQ(along.sight, Sight::unclear);
  EXPECT_FALSE(along.is_touch_known);
}

}  // namespace
}  // namespace graze::detail::ray_sight_test
