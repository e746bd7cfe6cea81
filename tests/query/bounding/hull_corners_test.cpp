// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/query/bounding/hull_corners.hpp>
#include <graze/shape/polytope.hpp>

#include "query/point_sets.hpp"

namespace graze::hull_corners_test {
namespace {

template <class T>
std::vector<Vec<2, T>> corners_of(const std::vector<Vec<2, T>>& points) {
  const Aabb<2, T> box = bounding_box(points);
  if (detail::largest_side(box) == 0) return {points.front()};
  return detail::hull_corners(std::span<const Vec<2, T>>(points), detail::local_frame(box));
}

/// The vertices of a convex polygon.
template <class T>
std::vector<Vec<2, T>> vertices_of(const std::vector<Vec<2, T>>& points) {
  const Polytope<2, T> hull = convex_hull<2, T>(points);
  return {hull.vertices().begin(), hull.vertices().end()};
}

TEST(HullCorners, OfASquareWithPointsInsideAndOnItsSidesAreFour) {
  const std::vector<Vec<2, float>> points{{1, 1}, {0, 0}, {2, 0}, {1, 0}, {2, 2}, {0, 2}, {0, 0}, {2, 1}, {1, 1.5F}};
  EXPECT_EQ(corners_of(points), (std::vector<Vec<2, float>>{{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
}

TEST(HullCorners, OfASegmentAreItsEnds) {
  EXPECT_EQ(corners_of<double>({{1, 1}, {3, 3}, {2, 2}, {0, 0}}), (std::vector<Vec<2, double>>{{0, 0}, {3, 3}}));
}

TEST(HullCorners, KeepACornerThatSticksOutByOneBit) {
  const double above = std::nextafter(1.0, 2.0);
  std::vector<Vec<2, double>> points{{0, 0}, {3, 0}, {3, 1}, {0, 1}, {1, above}, {2, 1}};
  EXPECT_EQ(corners_of(points), vertices_of(points));
  EXPECT_EQ(corners_of(points).size(), 5U);
}

template <class T>
class HullCornersIn : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(HullCornersIn, Scalars);

TYPED_TEST(HullCornersIn, AreThoseOfThePolygonAroundThePoints) {
  using T = TypeParam;
  test::check_property([] {
    const std::vector<Vec<2, T>> points = test::draw_points<2, T>(40);
    RC_ASSERT(corners_of(points) == vertices_of(points));
  });
}

TYPED_TEST(HullCornersIn, OfManyPointsAreThoseOfThePolygonAroundThem) {
  using T = TypeParam;
  std::mt19937 random(3);
  std::vector<Vec<2, T>> inside;
  std::vector<Vec<2, T>> circle;
  std::vector<Vec<2, T>> column;
  for (int i = 0; i < 5'000; ++i) {
    const Vec<2, double> point(static_cast<double>(random()) * 0x1p-31 - 1,
                               static_cast<double>(random()) * 0x1p-31 - 1);
    inside.push_back(Vec<2, T>(point));
    circle.push_back(Vec<2, T>(point / std::sqrt(dot(point, point)) + 100.0));
    column.push_back(Vec<2, T>(7, point.y));
  }
  for (const auto& points : {inside, circle, column}) EXPECT_EQ(corners_of(points), vertices_of(points));
}

}  // namespace
}  // namespace graze::hull_corners_test
