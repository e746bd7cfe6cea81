// SPDX-License-Identifier: MIT
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/closest/nearest_on_hull.hpp>

#include "query/user_shapes.hpp"

namespace graze::detail::nearest_on_hull_test {
namespace {

using D3 = Vec<3, double>;

Polytope<3, double> cube(const D3& low, double side) {
  std::vector<D3> corners;
  for (const double x : {0.0, side}) {
    for (const double y : {0.0, side}) {
      for (const double z : {0.0, side}) corners.push_back(low + D3(x, y, z));
    }
  }
  return convex_hull<3, double>(corners);
}

TEST(NearestOnHull, FindsTheRightFaceOfASmallShapeFromFarAway) {
  // The squared distances to all points of the cube are the same up to rounding.
  for (const double side : {1.0, 1e-2, 1e-5}) {
    for (const double distance : {10.0, 1e3, 1e6, 1e9}) {
      const auto nearest = nearest_on_hull(cube(D3(0), side), D3(distance, side / 4, side / 8));
      EXPECT_EQ(nearest.point, D3(side, side / 4, side / 8)) << side << " from " << distance;
      EXPECT_NEAR(nearest.off.x, distance - side, 1e-15 * distance) << side << " from " << distance;
      EXPECT_EQ(max_abs(nearest.off), nearest.off.x);
    }
  }
}

TEST(NearestOnHull, FindsEdgesAndCornersToo) {
  const auto on_edge = nearest_on_hull(cube(D3(1, 2, 3), 1), D3(3, 4, 3.25));
  EXPECT_EQ(on_edge.point, D3(2, 3, 3.25));
  EXPECT_EQ(on_edge.off, D3(1, 1, 0));
  const auto on_corner = nearest_on_hull(cube(D3(0.1, 0.2, 0.3), 0.6), D3(1e7, 1e8, 1e9));
  EXPECT_EQ(on_corner.point, D3(0.1 + 0.6, 0.2 + 0.6, 0.3 + 0.6));
}

TEST(NearestOnHull, OfALongEdgeFromFarAwayIsItsFoot) {
  const auto edge = convex_hull<3, double>(std::vector{D3(0, 0, 0), D3(3e-3, 4e-3, 0)});
  const auto nearest = nearest_on_hull(edge, D3(1.5e-3, 2e-3, 1e6));
  EXPECT_EQ(nearest.point, D3(1.5e-3, 2e-3, 0));
}

TEST(NearestOnHull, OfAPointOrAPointOnTheShapeIsThat) {
  const auto point = convex_hull<3, double>(std::vector{D3(1, 2, 3)});
  EXPECT_EQ(nearest_on_hull(point, D3(1, 2, 5)).point, D3(1, 2, 3));
  EXPECT_EQ(nearest_on_hull(point, D3(1, 2, 3)).off, D3(0));
  EXPECT_EQ(nearest_on_hull(cube(D3(0), 1), D3(1, 0.5, 0.25)).point, D3(1, 0.5, 0.25));
}

TEST(NearestOnHull, ComesCloseOnACurvedSurface) {
  const user::Ellipsoid<double> sphere{{1, 2, 3}, {2, 2, 2}};
  const auto nearest = nearest_on_hull(sphere, D3(1 + 6, 2 + 6, 3 + 3));
  EXPECT_NEAR(max_abs(nearest.point - D3(1 + 4.0 / 3, 2 + 4.0 / 3, 3 + 2.0 / 3)), 0, 1e-6);
  EXPECT_NEAR(std::sqrt(dot(nearest.off, nearest.off)), 7, 1e-12);
}

}  // namespace
}  // namespace graze::detail::nearest_on_hull_test
