// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <graze/query/contact.hpp>
#include <graze/query/contact/unbounded.hpp>

#include "catalogue.hpp"

namespace graze::detail::penetration_unbounded_test {
namespace {

using V2 = Vec<2, double>;
using V3 = Vec<3, double>;

constexpr double infinity = std::numeric_limits<double>::infinity();

template <Dim N>
void expect_penetration(const Penetration<N>& found, const Vec<N, double>& normal, double depth,
                        const Vec<N, double>& on_a) {
  EXPECT_NEAR(length(found.normal - normal), 0, 1e-15);
  EXPECT_NEAR(found.depth, depth, 1e-14);
  EXPECT_NEAR(length(found.point_a - on_a), 0, 1e-14);
  EXPECT_NEAR(length(found.point_b - (on_a - normal * depth)), 0, 1e-14);
}

const Plane<3, double> floor_plane{{0, 0, 2}, 4};    // z = 2
const HalfSpace<3, double> ground{{0, 0, 2}, 4};     // z <= 2
const HalfSpace<3, double> ceiling{{0, 0, -1}, -1};  // z >= 1
const HalfSpace<3, double> wall{{1, 0, 0}, 0};       // x <= 0

TEST(PenetrationInLevel, IsUpToThePlaneFromTheLowestPoint) {
  const Sphere<3, double> sphere{{1, 2, 4}, 3};
  expect_penetration<3>(penetration_in_half_space(ground, sphere), {0, 0, 1}, 1, {1, 2, 2});
  expect_penetration<3>(penetration_in_half_space(ground, Sphere<3, double>{{1, 2, -4}, 3}), {0, 0, 1}, 9, {1, 2, 2});
  const Capsule<3, double> pill{{5, 5, 7}, {1, 2, 4}, 3};
  expect_penetration<3>(penetration_in_half_space(ground, pill), {0, 0, 1}, 1, {1, 2, 2});
}

TEST(PenetrationInLevel, OfAPlaneIsToTheNearerSide) {
  expect_penetration<3>(penetration_in_half_space(floor_plane, Sphere<3, double>{{1, 2, 4}, 3}), {0, 0, 1}, 1,
                        {1, 2, 2});
  expect_penetration<3>(penetration_in_half_space(floor_plane, Sphere<3, double>{{1, 2, 1}, 3}), {0, 0, -1}, 2,
                        {1, 2, 2});
  expect_penetration<3>(penetration_in_half_space(floor_plane, V3(1, 2, 2)), {0, 0, 1}, 0, {1, 2, 2});
}

TEST(PenetrationOfRay, EndsAtItsOrigin) {
  const Ray<3, double> falling{{1, 2, 5}, {1, 0, -1}};
  const Ray<3, double> climbing{{1, 2, -1}, {1, 0, 1}};
  expect_penetration<3>(penetration_of_ray(falling, floor_plane), {0, 0, 1}, 3, {1, 2, 5});
  expect_penetration<3>(penetration_of_ray(climbing, floor_plane), {0, 0, -1}, 3, {1, 2, -1});
  expect_penetration<3>(penetration_of_ray(climbing, ground), {0, 0, -1}, 3, {1, 2, -1});
  expect_penetration<3>(penetration_of_ray(Ray<3, double>{{0, 0, 1}, {1, 0, 0}}, ground), {0, 0, -1}, 1, {0, 0, 1});
  // Off the plane by a distance that `relation` calls touching.
  expect_penetration<3>(penetration_of_ray(Ray<3, double>{{0, 0, 2 + 1e-15}, {1, 0, 0}}, floor_plane), {0, 0, -1}, 0,
                        {0, 0, 2});
}

TEST(PenetrationOfRay, OfOneThatRunsOnIntoAHalfSpaceIsInfinite) {
  const Penetration<3> found = penetration_of_ray(Ray<3, double>{{1, 2, 5}, {1, 0, -1}}, ground);
  EXPECT_EQ(found.depth, infinity);
  EXPECT_EQ(found.normal, V3(0, 0, 0));
  EXPECT_EQ(found.point_a, V3(4, 2, 2));
}

TEST(PenetrationOfLevels, IsBetweenThoseThatFaceEachOther) {
  expect_penetration<3>(penetration_of_half_spaces(ground, ceiling), {0, 0, 1}, 1, {0, 0, 2});
  expect_penetration<3>(penetration_of_half_spaces(Plane<3, double>{{0, 0, 1}, 0}, ground), {0, 0, -1}, 2, {0, 0, 0});
  expect_penetration<3>(penetration_of_half_spaces(floor_plane, ceiling), {0, 0, 1}, 1, {0, 0, 2});
  expect_penetration<3>(penetration_of_half_spaces(floor_plane, floor_plane), {0, 0, 1}, 0, {0, 0, 2});
}

TEST(PenetrationOfLevels, OfThoseThatCrossOrFaceTheSameWayIsInfinite) {
  for (const Penetration<3>& found :
       {penetration_of_half_spaces(ground, wall), penetration_of_half_spaces(ground, ground),
        penetration_of_half_spaces(Plane<3, double>{{1, 0, 0}, 3}, ground)}) {
    EXPECT_EQ(found.depth, infinity);
    EXPECT_EQ(found.normal, V3(0, 0, 0));
    EXPECT_EQ(found.point_a, found.point_b);
  }
}

TEST(PenetrationOfRays, InThePlaneIsToTheNearerOrigin) {
  const Ray<2, double> right{{0, 0}, {1, 0}};
  const Ray<2, double> up{{3, -1}, {0, 1}};
  expect_penetration<2>(penetration_of_rays(right, up), {0, 1}, 1, {3, 0});
  const Ray<2, double> far_up{{3, -5}, {0, 1}};
  expect_penetration<2>(penetration_of_rays(right, far_up), {-1, 0}, 3, {0, 0});
}

TEST(PenetrationOfRays, InSpaceOrOnOneLineIsNone) {
  const Ray<3, double> right{{0, 0, 0}, {1, 0, 0}};
  const Penetration<3> crossing = penetration_of_rays(right, Ray<3, double>{{3, -1, 0}, {0, 1, 0}});
  expect_penetration<3>(crossing, {0, 0, 1}, 0, {3, 0, 0});
  const Penetration<3> on_line = penetration_of_rays(right, Ray<3, double>{{3, 0, 0}, {-1, 0, 0}});
  EXPECT_EQ(on_line.depth, 0);
  EXPECT_EQ(on_line.normal.x, 0);
}

}  // namespace
}  // namespace graze::detail::penetration_unbounded_test
