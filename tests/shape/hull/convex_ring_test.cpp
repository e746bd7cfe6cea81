// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/shape/hull/convex_ring.hpp>
#include <graze/shape/polytope.hpp>

#include "catalogue.hpp"

namespace graze::detail::convex_ring_test {
namespace {

using Points = std::vector<Vec<2, double>>;

bool is_ring(const Points& points) { return is_convex_ring<double>(points); }

TEST(ConvexRing, RunsCounterClockwiseFromAnyCorner) {
  EXPECT_TRUE(is_ring({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_TRUE(is_ring({{1, 1}, {0, 1}, {0, 0}, {1, 0}}));
  EXPECT_FALSE(is_ring({{0, 1}, {1, 1}, {1, 0}, {0, 0}}));
}

TEST(ConvexRing, HasNoCornerOnALineOrBehindIt) {
  EXPECT_FALSE(is_ring({{0, 0}, {2, 0}, {2, 1}, {2, 2}, {0, 2}}));
  EXPECT_FALSE(is_ring({{0, 0}, {2, 0}, {std::nextafter(2.0, 0.0), 1}, {2, 2}, {0, 2}}));
  EXPECT_TRUE(is_ring({{0, 0}, {2, 0}, {std::nextafter(2.0, 3.0), 1}, {2, 2}, {0, 2}}));
  EXPECT_FALSE(is_ring({{0, 0}, {1, 0}, {1, 0}, {0, 1}}));
  EXPECT_FALSE(is_ring({{0, 0}, {1, 1}, {2, 2}}));
}

TEST(ConvexRing, GoesAroundOnce) {
  EXPECT_FALSE(is_ring({{0, 0}, {1, 0}, {0, 1}, {0, 0}, {1, 0}, {0, 1}}));
  // A five-pointed star turns left at each tip.
  Points star;
  for (int i = 0; i < 5; ++i) star.push_back(cosine_sine_of_degrees(144.0 * i));
  EXPECT_FALSE(is_ring(star));
}

TEST(ConvexRing, OfOneOrTwoPointsAreTheEndsOfWhatIsFlat) {
  EXPECT_TRUE(is_ring({{1, 2}}));
  EXPECT_TRUE(is_ring({{1, 2}, {0, 0}}));
  EXPECT_FALSE(is_ring({{1, 2}, {1, 2}}));
}

TEST(ConvexRing, IsWhatTheHullOfItsPointsIs) {
  test::check_property([] {
    Points points = *test::some<Vec<2, double>>(8, test::draw_source<2, double>().point);
    if (*rc::gen::arbitrary<bool>()) {
      const Polytope<2, double> hull = convex_hull(points);
      points.assign(hull.vertices().begin(), hull.vertices().end());
      std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2), points.end());
    }
    const Polytope<2, double> hull = convex_hull(points);
    Points corners(hull.vertices().begin(), hull.vertices().end());
    std::rotate(corners.begin(), std::find(corners.begin(), corners.end(), points.front()), corners.end());
    RC_ASSERT(is_ring(points) == (corners == points));
  });
}

}  // namespace
}  // namespace graze::detail::convex_ring_test
