// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <graze/query/ray/verdict_box.hpp>

namespace graze::detail::ray_sight_box_test {
namespace {

using Point = Vec<3, double>;
using Box = Aabb<3, double>;
constexpr double infinity = std::numeric_limits<double>::infinity();

template <Dim N>
Path<N> path(const Vec<N, double>& direction, double t_max) {
  return {Vec<N, double>(0.0), direction, t_max};
}

TEST(RaySightBox, IsClearBeyondRoundingAndUnclearWithin) {
  const auto verdict = [](double height, double t_max) {
    return ray_verdict_of(Box{{4, height - 1, -1}, {6, height + 1, 1}}, path(Point(2, 0, 0), t_max)).verdict;
  };
  EXPECT_EQ(verdict(0.999, infinity), RayVerdict::hits);
  EXPECT_EQ(verdict(1.001, infinity), RayVerdict::misses);
  EXPECT_EQ(verdict(1, infinity), RayVerdict::unclear);
  EXPECT_EQ(verdict(0, 2), RayVerdict::unclear);
  EXPECT_EQ(verdict(0, 2.001), RayVerdict::hits);
  EXPECT_EQ(verdict(0, 1.999), RayVerdict::misses);
}

/// Rays to a lattice of points around the box and on it, some of them closer to an edge than rounding.
TEST(RaySightBox, IsMissedJustWhereSightSaysSo) {
  const Box box{{4, -1, -1}, {6, 1, 1}};
  int missed = 0;
  int met = 0;
  for (const double t_max : {0.5, 1.0, 1.5, infinity}) {
    for (const double x : {-5.0, 0.0, 4.0, 5.0}) {
      for (const double y : {-1.25, -1.0, -1.0 - 0x1p-50, 0.0, 0.5, 1.0, 1.0 + 0x1p-35, 2.0}) {
        for (const double z : {-3.0, -1.0, -0.0, 1.0 - 0x1p-52, std::numeric_limits<double>::quiet_NaN()}) {
          const Path<3> towards = path(Point(x, y, z), t_max);
          const bool misses = ray_verdict_of(box, towards).verdict == RayVerdict::misses;
          EXPECT_EQ(is_missed(box, towards), misses) << x << ' ' << y << ' ' << z << ' ' << t_max;
          ++(misses ? missed : met);
        }
      }
    }
  }
  EXPECT_GT(missed, 100);
  EXPECT_GT(met, 100);
}

TEST(RaySightBox, OfAFlatBoxIsClearWhereItIsCrossed) {
  const RayFinding<3> crossed = ray_verdict_of(Box{{4, -1, -1}, {4, 1, 1}}, path(Point(2, 0.25, 0), infinity));
  EXPECT_EQ(crossed.verdict, RayVerdict::hits);
  EXPECT_EQ(crossed.hit.t, 2);
  EXPECT_EQ(crossed.hit.point, Point(4, 0.5, 0));
}

/// A path that passes the side x = 4 slightly below the box and enters through its bottom, towards which it rises
/// slowly.
TEST(RaySightBox, EntersNextToAnEdgeThroughTheSideThatItComesToLast) {
  for (const double slope : {0x1p-1, 0x1p-5, 0x1p-9, 0x1p-13}) {
    for (const double below : {0x1p-30, 0x1p-38, 0x1p-40, 0x1p-42, 0x1p-44, 0x1p-48}) {
      const double bottom = 2 * slope + below;
      const Box box{{4, bottom, -1}, {6, bottom + 2, 1}};
      const Obb<3, double> turned{box.center(), box.half_extents(), Mat<3, double>(1.0)};
      const Path<3> rising = path(Point(2, slope, 0), infinity);
      for (const RayFinding<3>& found : {ray_verdict_of(box, rising), ray_verdict_of(turned, rising)}) {
        const double height = slope * found.hit.t - bottom;
        EXPECT_NE(found.verdict, RayVerdict::misses) << slope << ", " << below;
        EXPECT_LE(std::fabs(height), found.hit.error) << slope << ", " << below;
        EXPECT_LE(found.hit.error, 3e-14 * (found.verdict == RayVerdict::unclear ? 2 : 1));
      }
    }
  }
}

TEST(RaySightBox, RunsAlongASideWithEitherZero) {
  for (const double zero : {0.0, -0.0}) {
    const RayFinding<3> along = ray_verdict_of(Box{{4, 0, -1}, {6, 1, 1}}, path(Point(2, zero, zero), infinity));
    EXPECT_EQ(along.verdict, RayVerdict::unclear);
    EXPECT_EQ(along.hit.t, 2);
    EXPECT_EQ(along.hit.normal, Point(-1, 0, 0));
  }
}

// The point was once put on the side perpendicular to x as well, however far away that is.
TEST(RaySightBox, PutsAPointOnTheSideOfANormalAlongAnAxisAlone) {
  const Box box{{0, 0, 0}, {100, 1, 1}};
  RawHit<3> touch;
  touch.point = {30, -1e-12, 0.5};
  for (const Point& normal : {Point(0, -1, 0), Point(3e-29, -1, 0), Point(0, -1, -1e-300)}) {
    touch.normal = normal;
    put_on_surface(touch, box);
    EXPECT_EQ(touch.point, Point(30, 0, 0.5)) << normal.x << ", " << normal.z;
  }
}

TEST(RaySightBox, WorksInThePlane) {
  const RayFinding<2> hit = ray_verdict_of(Aabb<2, double>{{-1, 3}, {1, 5}}, path(Vec<2, double>(0.1, 2), infinity));
  EXPECT_EQ(hit.verdict, RayVerdict::hits);
  EXPECT_EQ(hit.hit.t, 1.5);
  EXPECT_EQ(hit.hit.normal, (Vec<2, double>(0, -1)));
}

TEST(RaySightBox, TakesAxesAsTheyAreStored) {
  // The first axis is tilted: the box is all (u + v / 1024, v, w), and its side u = -1 is hit where x = -1 + y / 1024.
  Mat<3, double> axes(1.0);
  axes[1] = Point(0x1p-10, 1, 0);
  const Obb<3, double> box{{4, 0, 0}, {1, 2, 1}, axes};
  const RayFinding<3> hit = ray_verdict_of(box, path(Point(1, 0.25, 0), infinity));
  EXPECT_EQ(hit.verdict, RayVerdict::hits);
  EXPECT_NEAR(hit.hit.t, 3 / (1 - 0.25 * 0x1p-10), 1e-15);
  EXPECT_NEAR(hit.hit.normal.y / hit.hit.normal.x, -0x1p-10, 1e-18);
}

TEST(RaySightBox, TakesAxesThatAreMirrored) {
  Mat<3, double> axes(1.0);
  axes[0] = Point(-1, 0, 0);
  const RayFinding<3> hit =
      ray_verdict_of(Obb<3, double>{{4, 0, 0}, {1, 2, 1}, axes}, path(Point(1, 0.25, 0), infinity));
  EXPECT_EQ(hit.verdict, RayVerdict::hits);
  EXPECT_EQ(hit.hit.t, 3);
  EXPECT_EQ(hit.hit.point, Point(3, 0.75, 0));
  EXPECT_EQ(hit.hit.normal, Point(-1, 0, 0));
}

TEST(RaySightBox, NanIsNeverHit) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(ray_verdict_of(Box{{nan, -1, -1}, {6, 1, 1}}, path(Point(1, 0, 0), infinity)).verdict, RayVerdict::hits);
  EXPECT_NE(ray_verdict_of(Box{{4, -1, -1}, {6, nan, 1}}, path(Point(1, 0, 0), infinity)).verdict, RayVerdict::hits);
  EXPECT_NE(ray_verdict_of(Box{{4, -1, -1}, {6, 1, nan}}, path(Point(1, 0, 0), infinity)).verdict, RayVerdict::hits);
}

}  // namespace
}  // namespace graze::detail::ray_sight_box_test
