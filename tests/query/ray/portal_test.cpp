// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/ray_cast.hpp>

#include "exact/ray_entry.hpp"

namespace graze::detail::ray_portal_test {
namespace {

using Point = Vec<3, double>;
using Hull = Polytope<3, double>;
constexpr double infinity = std::numeric_limits<double>::infinity();

template <class T>
std::optional<RayFinding<3>> portal_of(const Polytope<3, T>& polytope, const Path<3>& path) {
  return PortalSearch(CornersInFrame(polytope.vertices(), path.origin), path).finding();
}

template <class T>
std::optional<RayFinding<3>> portal_in_place(const Polytope<3, T>& polytope, const Path<3>& path) {
  return PortalSearch(CornersInPlace(polytope, path.origin), path).finding();
}

Hull pyramid() {
  return convex_hull<3, double>(std::vector<Point>{{4, -1, -1}, {4, 1, -1}, {4, -1, 1}, {4, 1, 1}, {3, 0, 0}});
}

TEST(RayPortal, EntersThroughTheFace) {
  const std::optional<RayFinding<3>> found = portal_of(pyramid(), {{0, 0.25, 0.125}, {2, 0, 0}, infinity});
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->verdict, RayVerdict::hits);
  EXPECT_NEAR(found->hit.t, 1.625, 1e-15);
  EXPECT_NEAR(found->hit.point.x, 3.25, 1e-15);
  EXPECT_EQ(found->hit.normal / found->hit.normal.y, Point(-1, 1, 0));
  EXPECT_LT(found->hit.error, 1e-13);
}

TEST(RayPortal, SaysWhatIsMissedByFar) {
  const auto misses = [](const Path<3>& path) {
    const std::optional<RayFinding<3>> found = portal_of(pyramid(), path);
    return found && found->verdict == RayVerdict::misses;
  };
  EXPECT_TRUE(misses({{0, 1.001, 0}, {1, 0, 0}, infinity}));
  EXPECT_TRUE(misses({{0, 0, 0}, {-1, 0, 0}, infinity}));
  EXPECT_TRUE(misses({{5, 0.25, 0}, {1, 0, 0}, infinity}));
  EXPECT_TRUE(misses({{0, 0.25, 0.125}, {1, 0, 0}, 3.24}));
  EXPECT_FALSE(misses({{0, 0.25, 0.125}, {1, 0, 0}, 3.26}));
}

/// At an edge, at a corner, at the end, from a point on the surface or inside.
TEST(RayPortal, LeavesOpenWhatIsNearlySo) {
  for (const double off : {-0x1p-48, -0x1p-50, 0.0, 0x1p-50, 0x1p-48}) {
    EXPECT_FALSE(portal_of(pyramid(), {{0, 1 + off, 0.5}, {1, 0, 0}, infinity}).has_value()) << off;
    EXPECT_FALSE(portal_of(pyramid(), {{0, 1 + off, 1 + off}, {1, 0, 0}, infinity}).has_value()) << off;
    EXPECT_FALSE(portal_of(pyramid(), {{0, 0.25, 0.25 + off}, {1, 0, 0}, infinity}).has_value()) << off;
    for (const Path<3>& path :
         {Path<3>{{0, 0.25, 0.125}, {1, 0, 0}, 3.25 + off}, Path<3>{{3.25 + off, 0.25, 0.125}, {1, 0, 0}, infinity}}) {
      const std::optional<RayFinding<3>> found = portal_of(pyramid(), path);
      ASSERT_TRUE(found.has_value()) << off;
      EXPECT_EQ(found->verdict, RayVerdict::unclear) << off;
      EXPECT_LE(found->hit.t, path.t_max);
      EXPECT_GE(found->hit.t, 0);
    }
  }
  EXPECT_FALSE(portal_of(pyramid(), {{3.75, 0.25, 0.125}, {1, 0, 0}, infinity}).has_value());
}

TEST(RayPortal, OfFlatPolytopesIsATriangleOrNone) {
  const Hull square = convex_hull<3, double>(std::vector<Point>{{1, 0, 0}, {1, 4, 0}, {1, 0, 4}, {1, 4, 4}});
  const std::optional<RayFinding<3>> crossed = portal_of(square, {{3, 1, 2}, {-2, 0, 0}, infinity});
  ASSERT_TRUE(crossed.has_value());
  EXPECT_EQ(crossed->verdict, RayVerdict::hits);
  EXPECT_EQ(crossed->hit.t, 1);
  EXPECT_GT(crossed->hit.normal.x, 0);
  EXPECT_FALSE(portal_of(square, {{1, -1, 2}, {0, 1, 0}, infinity}).has_value());
  const Hull segment = convex_hull<3, double>(std::vector<Point>{{1, 0, 0}, {1, 4, 0}});
  EXPECT_FALSE(portal_of(segment, {{0, 2, 0}, {1, 0, 0}, infinity}).has_value());
  EXPECT_FALSE(portal_of(segment, {{1, -2, 0}, {0, 1, 0}, infinity}).has_value());
  EXPECT_EQ(portal_of(segment, {{0, 2, 0.001}, {1, 0, 0}, infinity})->verdict, RayVerdict::misses);
  EXPECT_FALSE(portal_of(Hull(), {{-1, 0, 0}, {1, 0, 0}, infinity}).has_value());
  EXPECT_EQ(portal_of(Hull(), {{-1, 0, 1}, {1, 0, 0}, infinity})->verdict, RayVerdict::misses);
}

TEST(RayPortal, LeavesExtremesToOthers) {
  const Hull hull = pyramid();
  for (const double size : {1e-130, 1e-70, 1e70, 1e130}) {
    std::vector<Point> corners;
    for (const Point& corner : hull.vertices()) corners.push_back(corner * size);
    const Ray<3, double> ray{Point(0, 0.25, 0.125) * size, {2, 0, 0}};
    const Hull scaled = convex_hull<3, double>(corners);
    EXPECT_FALSE(portal_of(scaled, {ray.origin, ray.direction, infinity}).has_value()) << size;
    const auto hit = ray_cast(scaled, ray);
    ASSERT_TRUE(hit.has_value()) << size;
    EXPECT_NEAR(hit->t / size, 1.625, 1e-13) << size;
  }
}

class Random {
 public:
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  template <class T>
  Vec<3, T> vector(double size) {
    return Vec<3, T>(Point(number(-size, size), number(-size, size), number(-size, size)));
  }

 private:
  std::mt19937 engine_{20261123};
};

/// Hulls of any shape, some of them nearly flat or far from zero; decided answers must agree with the exact oracle.
template <class T>
void expect_exact_entries() {
  Random random;
  std::array<std::size_t, 3> seen{};
  std::size_t open = 0;
  for (int i = 0; i < 1000; ++i) {
    const double flat = i % 4 == 0 ? std::ldexp(1.0, -(i % 24)) : 1;
    const Vec<3, T> far = random.vector<T>(i % 3 == 0 ? 1000 : 1);
    std::vector<Vec<3, T>> points(4 + static_cast<std::size_t>(i % 9));
    for (Vec<3, T>& point : points) {
      point = random.vector<T>(1);
      point.z *= static_cast<T>(flat);
      point += far;
    }
    const Polytope<3, T> hull = convex_hull<3, T>(points);
    Ray<3, T> ray{random.vector<T>(4) + far, {}};
    ray.direction = random.vector<T>(1) + far - ray.origin;
    const Path<3> path{wide<3, T>(ray.origin), wide<3, T>(ray.direction), infinity};
    const std::optional<RayFinding<3>> found = portal_of(hull, path);
    const std::optional<double> entry = test::exact_entry<3, T>(AnyShape<3, T>(hull), ray);
    if (!found) {
      ++open;
      continue;
    }
    ++seen[static_cast<std::size_t>(found->verdict)];
    if (found->verdict == RayVerdict::unclear) continue;
    ASSERT_EQ(found->verdict == RayVerdict::hits, entry.has_value()) << i;
    if (!entry) continue;
    const RawHit<3>& touch = found->hit;
    const double height = dot(touch.normal, path.direction * (touch.t - *entry)) / length(touch.normal);
    EXPECT_LE(std::fabs(height), touch.error) << i;
    EXPECT_LT(dot(touch.normal, path.direction), 0) << i;
  }
  EXPECT_GT(seen[static_cast<std::size_t>(RayVerdict::hits)], 150U);
  EXPECT_GT(seen[static_cast<std::size_t>(RayVerdict::misses)], 150U);
  EXPECT_LT(open, 200U);  // most of them begin inside
}

TEST(RayPortal, EntersWhereTheOracleDoesInFloat) { expect_exact_entries<float>(); }
TEST(RayPortal, EntersWhereTheOracleDoesInDouble) { expect_exact_entries<double>(); }

/// The first direction of the search is the part of the vector to the box's center perpendicular to the ray: here, only
/// rounding.
TEST(RayPortal, HitsThroughTheMiddleOfTheBox) {
  Random random;
  std::size_t hits = 0;
  for (int i = 0; i < 3000; ++i) {
    const Point middle = random.vector<double>(1);
    const Point half = random.vector<double>(1);
    std::vector<Point> corners;
    for (int corner = 0; corner < 8; ++corner) {
      const Point side((corner & 1) - 0.5, (corner & 2) - 1, (corner & 4) / 4 - 0.5);
      corners.push_back(middle + half * side);
    }
    const Point origin = random.vector<double>(1) + Point(5, 0, 0);
    const Ray<3, double> ray{origin, (middle - origin) * random.number(0.3, 3)};
    const Hull box = convex_hull<3, double>(corners);
    const std::optional<RayFinding<3>> found = portal_of(box, {ray.origin, ray.direction, infinity});
    if (!found) continue;
    ASSERT_EQ(found->verdict, RayVerdict::hits) << i;
    ++hits;
  }
  EXPECT_GT(hits, 1000U);
}

/// GJK is slower and does not use portals.
TEST(RayPortal, AgreesWithGjkOnRoundHullsOfAnyNumberOfCorners) {
  Random random;
  std::size_t settled = 0;
  constexpr int rays = 2000;
  for (int i = 0; i < rays; ++i) {
    std::vector<Vec<3>> points(static_cast<std::size_t>(4 + i % 150));
    for (Vec<3>& point : points) {
      const Point way = random.vector<double>(1);
      point = Vec<3>(way / length(way));
    }
    const Polytope<3> hull = convex_hull<3, float>(points);
    const Point origin = random.vector<double>(1) + Point(0, 0, 3);
    const Path<3> path{origin, random.vector<double>(1.2) - origin, 4};
    const bool is_small = hull.vertices().size() <= CornersInFrame::room;
    const std::optional<RayFinding<3>> found = is_small ? portal_of(hull, path) : portal_in_place(hull, path);
    if (!found) continue;
    ++settled;
    const RayFinding<3> expected = advance_to(hull, path);
    ASSERT_EQ(found->verdict, expected.verdict) << i;
    if (found->verdict == RayVerdict::hits) {
      const double way = length(path.direction) * std::fabs(found->hit.t - expected.hit.t);
      EXPECT_LT(way, 1e-9) << i;
      EXPECT_LE(length(found->hit.point - expected.hit.point), 1e-9) << i;
    }
  }
  EXPECT_GT(settled, std::size_t{rays * 99 / 100});
}

}  // namespace
}  // namespace graze::detail::ray_portal_test
