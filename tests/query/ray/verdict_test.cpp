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
  const auto verdict = [&along](double height, double t_max) {
    return ray_verdict_of(Sphere<3, double>{{10, height, 0}, 1}, path(along, t_max)).verdict;
  };
  EXPECT_EQ(verdict(0.999, infinity), RayVerdict::hits);
  EXPECT_EQ(verdict(1.001, infinity), RayVerdict::misses);
  EXPECT_EQ(verdict(1, infinity), RayVerdict::unclear);
  EXPECT_EQ(verdict(1 + 1e-15, infinity), RayVerdict::unclear);
  EXPECT_EQ(verdict(0, 4.5), RayVerdict::unclear);
  EXPECT_EQ(verdict(0, 4.51), RayVerdict::hits);
  EXPECT_EQ(verdict(0, 4.49), RayVerdict::misses);
}

TEST(RaySight, OfABallBehindTheOriginMisses) {
  const Point along(1, 0, 0);
  EXPECT_EQ(ray_verdict_of(Sphere<3, double>{{-3, 0, 0}, 1}, path(along, infinity)).verdict, RayVerdict::misses);
  EXPECT_EQ(ray_verdict_of(Sphere<3, double>{{-1, 0, 0}, 1}, path(along, infinity)).verdict, RayVerdict::unclear);
  const RayFinding<3> inside = ray_verdict_of(Sphere<3, double>{{-0.5, 0, 0}, 1}, path(along, infinity));
  EXPECT_EQ(inside.verdict, RayVerdict::hits);
  EXPECT_EQ(inside.hit.t, 0);
  EXPECT_EQ(inside.hit.normal, Point(0.0));
}

TEST(RaySight, OfABallKnowsWhereAGrazingRayTouches) {
  const RayFinding<3> grazing = ray_verdict_of(Sphere<3, double>{{10, 1, 0}, 1}, path(Point(2, 0, 0), infinity));
  EXPECT_EQ(grazing.hit.t, 5);
  EXPECT_EQ(grazing.hit.point, Point(10, 0, 0));
  EXPECT_EQ(grazing.hit.normal, Point(0, -1, 0));
}

TEST(RaySight, OfACapsuleMeetsTheTubeOrAnEnd) {
  const Capsule<3, double> capsule{{10, -2, 0}, {10, 2, 0}, 1};
  const RayFinding<3> tube = ray_verdict_of(capsule, path(Point(1, 0, 0), infinity));
  EXPECT_EQ(tube.verdict, RayVerdict::hits);
  EXPECT_EQ(tube.hit.t, 9);
  EXPECT_EQ(tube.hit.normal, Point(-1, 0, 0));
  // Through (10, 2.6, 0) parallel to x, seen from (0, 2.6, 0): 0.6 above the upper end's center, 0.8 before it.
  const Capsule<3, double> lower{{10, -4.6, 0}, {10, -0.6, 0}, 1};
  const RayFinding<3> end = ray_verdict_of(lower, path(Point(1, 0, 0), infinity));
  EXPECT_EQ(end.verdict, RayVerdict::hits);
  EXPECT_DOUBLE_EQ(end.hit.t, 9.2);
  EXPECT_NEAR(end.hit.normal.y, 0.6, 1e-15);
  EXPECT_EQ(ray_verdict_of(capsule, path(Point(1, 0, 0), 8.9)).verdict, RayVerdict::misses);
  EXPECT_EQ(ray_verdict_of(capsule, path(Point(1, 0.4, 0), infinity)).verdict, RayVerdict::misses);
}

TEST(RaySight, OfACapsuleLeavesNearlyParallelRaysOpen) {
  const RayFinding<3> along =
      ray_verdict_of(Capsule<3, double>{{2, 0, 0}, {5, 0, 0}, 1}, path(Point(1, 0, 0), infinity));
  EXPECT_EQ(along.verdict, RayVerdict::unclear);
  EXPECT_FALSE(along.is_hit_known);
}

}  // namespace
}  // namespace graze::detail::ray_sight_test
