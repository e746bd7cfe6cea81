// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/tolerance.hpp>
#include <graze/query/closest/convex.hpp>
#include <graze/shape/polytope.hpp>

#include "query/user_shapes.hpp"

namespace graze::detail::closest_convex_test {
namespace {

using V3 = Vec<3, double>;

Polytope<3, double> octahedron(const V3& center) {
  std::vector<V3> corners;
  for (Dim i = 0; i < 3; ++i) {
    corners.push_back(center + unit_axis<3>(i));
    corners.push_back(center - unit_axis<3>(i));
  }
  return convex_hull<3, double>(corners);
}

Simplex<3> simplex_of(const std::vector<V3>& points) {
  Simplex<3> simplex;
  for (const V3& point : points) simplex.push(point);
  return simplex;
}

void expect_shares(const std::vector<V3>& points, const V3& point, const std::array<double, 3>& expected) {
  const std::array<double, 3> shares = SharesInSimplex<3>(simplex_of(points)).of(point);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(shares[i], expected[i], 1e-15);
}

TEST(SharesInSimplex, AreThoseOfThePoint) {
  expect_shares({{1, 2, 3}}, {1, 2, 3}, {0, 0, 0});
  expect_shares({{1, 0, 0}, {5, 0, 0}}, {2, 0, 0}, {0.25, 0, 0});
  expect_shares({{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}, {1, 2, 1}, {0.25, 0.5, 0});
  expect_shares({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, -4}}, {1, 1, -1}, {0.25, 0.25, 0.25});
}

TEST(SharesInSimplex, AreOfTheSimplexForPointsBesideIt) {
  expect_shares({{1, 0, 0}, {5, 0, 0}}, {9, 0, 0}, {1, 0, 0});
  expect_shares({{1, 0, 0}, {5, 0, 0}}, {0, 0, 0}, {0, 0, 0});
  expect_shares({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {1, 1, 0}, {0.5, 0.5, 0});
}

TEST(SharesInSimplex, OfAFlatSimplexAreFinite) {
  expect_shares({{1, 0, 0}, {1, 0, 0}}, {1, 0, 0}, {0, 0, 0});
  expect_shares({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {1, 1, 1}, {0, 0.5, 0});
}

// Points of triangles that are 1e-9 to 1e-17 of their length wide, in every order of the corners.
TEST(SharesInSimplex, OfAThinTriangleLeaveNothingOfThePoint) {
  for (int digits = 9; digits <= 17; ++digits) {
    std::vector<V3> corners{{-1, -2, 0.5}, {3, 1, 1}, {1.7, 0.1, 0.9}};
    corners[2] = corners[0] * 0.3 + corners[1] * 0.7 + V3(1, -2, 3) * std::pow(10, -digits);
    std::sort(corners.begin(), corners.end(), [](const V3& p, const V3& q) { return p.x < q.x; });
    do {
      for (const V3& weights : {V3(0.2, 0.3, 0.5), V3(0, 0.25, 0.75), V3(1, 0, 0), V3(0.0, 1e-9, 1 - 1e-9)}) {
        const V3 point = corners[0] * weights[0] + corners[1] * weights[1] + corners[2] * weights[2];
        const std::array<double, 3> shares = SharesInSimplex<3>(simplex_of(corners)).of(point);
        const V3 found = corners[0] + (corners[1] - corners[0]) * shares[0] + (corners[2] - corners[0]) * shares[1];
        EXPECT_LE(length(found - point), 8 * tolerance::epsilon) << digits;
        EXPECT_LE(shares[0] + shares[1], 1 + tolerance::epsilon);
      }
    } while (std::next_permutation(corners.begin(), corners.end(), [](const V3& p, const V3& q) { return p.x < q.x; }));
  }
}

// A tetrahedron a million times longer than thick, and a point in it.
TEST(SharesInSimplex, OfASliverLeaveNothingOfThePoint) {
  const std::vector<V3> corners{{0, 0, 0}, {1e6, 1, 0}, {1e6, -1, 0.5}, {1e6, 0.25, -1}};
  const V3 point = 0.1 * corners[1] + 0.2 * corners[2] + 0.3 * corners[3];
  const std::array<double, 3> shares = SharesInSimplex<3>(simplex_of(corners)).of(point);
  V3 rest = point;
  for (std::size_t i = 0; i < 3; ++i) rest -= corners[i + 1] * shares[i];
  EXPECT_LE(length(rest), 2e-10);  // an epsilon of the length
}

TEST(ClosestOfConvex, FindsFacesEdgesAndCorners) {
  const auto corners = closest_of_convex(octahedron({0, 0, 0}), octahedron({5, 0, 0}));
  EXPECT_EQ(corners.closest.on_a, V3(1, 0, 0));
  EXPECT_EQ(corners.closest.on_b, V3(4, 0, 0));
  EXPECT_EQ(corners.status, Status::converged);
  EXPECT_LE(corners.error, 1e-13);
  const auto face = closest_of_convex(V3(2, 2, 2), octahedron({0, 0, 0}));
  EXPECT_NEAR(length(face.closest.on_b - V3(1 / 3.0)), 0, 1e-15);
  EXPECT_NEAR(length(face.closest.between + V3(5 / 3.0)), 0, 2e-15);
  const auto edge = closest_of_convex(octahedron({0, 0, 0}), V3(3, 3, 0));
  EXPECT_NEAR(length(edge.closest.on_a - V3(0.5, 0.5, 0)), 0, 1e-15);
}

TEST(ClosestOfConvex, FindsACommonPointOfShapesThatMeet) {
  const auto found = closest_of_convex(octahedron({0, 0, 0}), octahedron({0.5, 0.25, 0.125}));
  EXPECT_LE(found.closest.squared, 1e-30);
  EXPECT_NEAR(length(found.closest.on_a - found.closest.on_b), 0, 1e-15);
  EXPECT_LE(std::fabs(found.closest.on_a.x) + std::fabs(found.closest.on_a.y) + std::fabs(found.closest.on_a.z),
            1 + 1e-15);
}

TEST(ClosestOfConvex, FindsPointsOfCurvedShapes) {
  const user::Ellipsoid<double> egg{{0, 0, 0}, {3, 2, 1}};
  const user::Cylinder<double> can{{9, 0, 0}, 2, 1};
  const auto found = closest_of_convex(egg, can);
  EXPECT_NEAR(std::sqrt(found.closest.squared), 4, found.error);
  EXPECT_NEAR(found.closest.on_a.x, 3, 1e-6);
  EXPECT_NEAR(found.closest.on_b.x, 7, 1e-6);
}

// An object without farthest points has no distance; but the call returns, with a status.
TEST(ClosestOfConvex, EndsForWhatIsNoShape) {
  const auto found = closest_of_convex(user::Chaos{}, octahedron({5, 0, 0}));
  EXPECT_TRUE(std::isfinite(found.closest.squared));
  EXPECT_TRUE(found.status == Status::best_bound || found.error >= 0);
}

}  // namespace
}  // namespace graze::detail::closest_convex_test
