// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <graze/query/ray/verdict_2d.hpp>

namespace graze::detail::ray_sight_flat_test {
namespace {

using Point = Vec<3, double>;
constexpr double infinity = std::numeric_limits<double>::infinity();

template <Dim N>
Path<N> path(const Vec<N, double>& direction, double t_max) {
  return {Vec<N, double>(0.0), direction, t_max};
}

TEST(RaySightFlat, OfASegmentIsWhereTheLinesAreNearest) {
  const RayFinding<3> crossing =
      ray_verdict_of(Segment<3, double>{{4, -1, 0}, {4, 2, 0}}, path(Point(2, 0, 0), infinity));
  EXPECT_EQ(crossing.verdict, RayVerdict::unclear);
  EXPECT_EQ(crossing.hit.t, 2);
  const RayFinding<3> along = ray_verdict_of(Segment<3, double>{{6, 0, 0}, {3, 0, 0}}, path(Point(2, 0, 0), infinity));
  EXPECT_EQ(along.hit.t, 1.5);
  EXPECT_EQ(along.hit.normal, Point(0.0));
}

TEST(RaySightFlat, OfARayThatComesAgainstThePathIsWhereThePathStarts) {
  EXPECT_EQ(ray_verdict_of(Ray<3, double>{{6, 0, 0}, {-3, 0, 0}}, path(Point(2, 0, 0), infinity)).hit.t, 0);
  EXPECT_EQ(ray_verdict_of(Ray<3, double>{{6, 0, 0}, {3, 0, 0}}, path(Point(2, 0, 0), infinity)).hit.t, 3);
}

TEST(RaySightFlat, OfATriangleIsClearInsideOutsideAndInTime) {
  const Triangle<3, double> triangle{{4, -1, -1}, {4, 2, -1}, {4, -1, 2}};
  const auto verdict = [&](const Point& direction, double t_max) {
    return ray_verdict_of(triangle, path(direction, t_max)).verdict;
  };
  EXPECT_EQ(verdict({2, 0, 0}, infinity), RayVerdict::hits);
  EXPECT_EQ(verdict({-2, 0, 0}, infinity), RayVerdict::misses);
  EXPECT_EQ(verdict({2, 1, 1}, infinity), RayVerdict::misses);
  EXPECT_EQ(verdict({2, 0, 0}, 1.999), RayVerdict::misses);
  EXPECT_EQ(verdict({2, 0, 0}, 2.0), RayVerdict::unclear);
  EXPECT_EQ(verdict({4, -1, 0}, infinity), RayVerdict::unclear);   // an edge
  EXPECT_EQ(verdict({4, -1, -1}, infinity), RayVerdict::unclear);  // a corner
  EXPECT_EQ(verdict({4, 0.5, 0.5}, infinity), RayVerdict::unclear);
  EXPECT_EQ(ray_verdict_of(triangle, path(Point(2, 0, 0), infinity)).hit.t, 2);
  EXPECT_EQ(ray_verdict_of(triangle, path(Point(4, -1, -1), infinity)).hit.t, 1);
}

/// A miss is reported exactly if there is one, except at the two ends of a path, which only ray_verdict_of considers.
TEST(RaySightFlat, OfATriangleIsMissedJustWhereTheLinePassesIt) {
  const Triangle<3, double> triangle{{4, 0, 0}, {4, 3, 0}, {5, 0, 3}};
  int missed = 0;
  int met = 0;
  for (const double y : {-1.0, -0x1p-50, 0.0, 0x1p-30, 0.5, 1.0, 1.5, 4.0}) {
    for (const double z : {-1.0, -0x1p-30, 0.0, 0x1p-50, 0.5, 1.0, 1.5, 4.0}) {
      const Path<3> towards = path(Vec<3, double>(4, y, z), infinity);
      const bool misses = ray_verdict_of(triangle, towards).verdict == RayVerdict::misses;
      EXPECT_EQ(is_missed(triangle, towards), misses) << y << ' ' << z;
      ++(misses ? missed : met);
    }
  }
  EXPECT_GT(missed, 20);
  EXPECT_GT(met, 15);
}

TEST(RaySightFlat, OfATriangleInItsPlaneIsLeftOpen) {
  const Triangle<3, double> triangle{{4, -1, 0}, {4, 1, 0}, {6, 0, 0}};
  EXPECT_EQ(ray_verdict_of(triangle, path(Point(1, 0, 0), infinity)).verdict, RayVerdict::unclear);
  EXPECT_FALSE(ray_verdict_of(triangle, path(Point(1, 0, 0), infinity)).is_hit_known);
}

TEST(RaySightFlat, OfAPolygonClipsByItsEdges) {
  const std::array<Vec<2, double>, 4> corners{{{4, -1}, {5, -1}, {5, 1}, {3, 1}}};
  const auto verdict = [&](const Vec<2, double>& direction, double t_max) {
    return ray_verdict_of_polygon<double>(corners, 0, path(direction, t_max));
  };
  const RayFinding<2> hit = verdict({2, 0}, infinity);
  EXPECT_EQ(hit.verdict, RayVerdict::hits);
  EXPECT_EQ(hit.hit.t, 1.75);
  EXPECT_EQ(verdict({2, 1}, infinity).verdict, RayVerdict::misses);
  EXPECT_EQ(verdict({2, 0}, 1.75).verdict, RayVerdict::unclear);
  EXPECT_EQ(verdict({3, 1}, infinity).verdict, RayVerdict::unclear);  // the upper left corner
  EXPECT_EQ(verdict({-1, 0}, infinity).verdict, RayVerdict::misses);
}

/// The lower side has an angle of 1e-8 to the path and is crossed just after the left one, where the path is only 1e-12
/// below it: closer than the margin of verdicts, which moves that crossing by 7e-4.
TEST(RaySightFlat, OfAPolygonIsWhereTheLastSideIsCrossedHoweverNearlyParallel) {
  const std::array<Vec<2, double>, 4> corners{{{2, 1e-12}, {4, -1.9999e-8}, {4, 1}, {2, 1}}};
  const RayFinding<2> hit = ray_verdict_of_polygon<double>(corners, 0, path(Vec<2, double>(1, 0), infinity));
  EXPECT_EQ(hit.verdict, RayVerdict::hits);
  EXPECT_NEAR(hit.hit.t, 2.0001, 1e-6);
  EXPECT_LT(hit.hit.normal.y, 0);
}

TEST(RaySightFlat, OfATriangleWhosePlaneIsCrossedBesideAnEdgeIsLeftOpen) {
  const Triangle<3, double> triangle{{-4, -4, 1}, {4, 1, 1}, {-4, 1, 1}};
  const RayFinding<3> on_edge = ray_verdict_of(triangle, path(Point(0, 1, 1), infinity));
  EXPECT_EQ(on_edge.verdict, RayVerdict::unclear);
  EXPECT_TRUE(on_edge.is_hit_known);
  EXPECT_EQ(on_edge.hit.t, 1);
  const RayFinding<3> beside = ray_verdict_of(triangle, path(Point(0, 1 + 0x1p-42, 1), infinity));
  EXPECT_EQ(beside.verdict, RayVerdict::unclear);
  EXPECT_FALSE(beside.is_hit_known);
}

/// The sides at its corner are nearly parallel to the path, which passes it by a rounding error: its crossings with
/// their lines are thousands of times farther from the corner than the error says.
TEST(RaySightFlat, OfAPolygonWhoseCornerIsBarelyPassedIsLeftOpen) {
  const Vec<2, double> start(43.69407653808594, 1.1748249471118409e-06);
  const Triangle<2, double> needle{{0, 0}, {-219, 0}, {44, -12722}};
  const Vec<2, double> way = (needle.c - start) * 2.0;
  const RayFinding<2> passing = ray_verdict_of(relative_to(start, needle), path(way, 1));
  EXPECT_EQ(passing.verdict, RayVerdict::unclear);
  EXPECT_FALSE(passing.is_hit_known);
}

TEST(RaySightFlat, OfAPolygonWithoutAreaIsAsWrongAsWhatDecidesIt) {
  const std::array<Vec<2, double>, 2> flat{{{5, -1}, {5, 1}}};
  const RayFinding<2> near = ray_verdict_of_polygon<double>(flat, 0, path(Vec<2, double>(2, 0), infinity));
  const RayFinding<2> far = ray_verdict_of_polygon<double>(flat, 1e6, path(Vec<2, double>(2, 0), infinity));
  EXPECT_EQ(near.hit.t, 2.5);
  EXPECT_EQ(far.hit.t, 2.5);
  EXPECT_LT(near.hit.error, 1e-13);
  EXPECT_GE(far.hit.error, tolerance::convex * 1e6);
}

TEST(RaySightFlat, OfPlanesAndHalfSpacesIsUnclearNearTheEndOnly) {
  const Plane<3, float> plane{{2, 0, 0}, 6};
  const HalfSpace<3, float> solid{{-2, 0, 0}, -6};
  const auto beside = [](double t_max) { return Path<3>{{1, 5, 5}, {1, 0, 0}, t_max}; };
  for (const double t_max : {2.001, infinity}) {
    EXPECT_EQ(ray_verdict_of_boundary(plane, beside(t_max)).verdict, RayVerdict::hits);
    EXPECT_EQ(ray_verdict_of_boundary(solid, beside(t_max)).verdict, RayVerdict::hits);
    EXPECT_EQ(ray_verdict_of_boundary(solid, beside(t_max)).hit.t, 2);
  }
  EXPECT_EQ(ray_verdict_of_boundary(plane, beside(2)).verdict, RayVerdict::unclear);
  EXPECT_EQ(ray_verdict_of_boundary(solid, beside(2)).verdict, RayVerdict::unclear);
  EXPECT_EQ(ray_verdict_of_boundary(plane, beside(1.999)).verdict, RayVerdict::misses);
  EXPECT_EQ(ray_verdict_of_boundary(solid, beside(1.999)).verdict, RayVerdict::misses);
}

}  // namespace
}  // namespace graze::detail::ray_sight_flat_test
