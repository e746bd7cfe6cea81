// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/query/bounding/flush_rectangle.hpp>
#include <graze/query/bounding/hull_corners.hpp>

#include "query/point_sets.hpp"

namespace graze::flush_rectangle_test {
namespace {

double area(double width, double height) { return width * height; }

Vec<2, double> best(const std::vector<Vec<2, double>>& corners) {
  return detail::best_flush_direction(std::span<const Vec<2, double>>(corners), 1, area);
}

TEST(FlushRectangle, OfARectangleLiesAlongItsSides) {
  EXPECT_EQ(best({{0, 0}, {3, 0}, {3, 1}, {0, 1}}), (Vec<2, double>(1, 0)));
  const Vec<2, double> along = best({{0, 0}, {3, 4}, {-1, 7}, {-4, 3}});
  EXPECT_NEAR(along.x, 0.6, 1e-15);
  EXPECT_NEAR(along.y, 0.8, 1e-15);
}

TEST(FlushRectangle, OfASegmentLiesAlongIt) { EXPECT_EQ(best({{5, 5}, {5, 9}}), (Vec<2, double>(0, 1))); }

TEST(FlushRectangle, OfAPointIsAnything) { EXPECT_EQ(best({{5, 5}}), (Vec<2, double>(1, 0))); }

TEST(FlushRectangle, MinimisesWhatItIsAskedTo) {
  // Triangle (0,0), (8,0), (0,6): along the legs 8 x 6, along the hypotenuse 10 x 4.8, both of area 48.
  const std::vector<Vec<2, double>> triangle{{0, 0}, {8, 0}, {0, 6}};
  const auto direction = [&triangle](auto measure) {
    return detail::best_flush_direction(std::span<const Vec<2, double>>(triangle), 1, measure);
  };
  EXPECT_EQ(direction([](double width, double height) { return width + height; }), (Vec<2, double>(1, 0)));
  const Vec<2, double> thin = direction([](double, double height) { return height; });
  EXPECT_NEAR(thin.x, -0.8, 1e-15);
  EXPECT_NEAR(thin.y, 0.6, 1e-15);
}

TEST(FlushRectangle, KnowsTheDirectionOfTheShortestEdge) {
  // A unit square with one corner cut off by an edge of about one step: the directions of all edges are right.
  const double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(detail::edge_direction(Vec<2, double>(0, 0), Vec<2, double>(2 * tiny, tiny)), (Vec<2, double>(1, 0.5)));
  EXPECT_EQ(detail::edge_direction(Vec<2, double>(1, 1), Vec<2, double>(1, 1 - 0x1p-53)), (Vec<2, double>(0, -1)));
}

/// The least area over all edges, each measured by all corners.
double least_area(const std::vector<Vec<2, double>>& corners) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec<2, double> edge = corners[(i + 1) % corners.size()] - corners[i];
    const auto extent_along = [&corners](const Vec<2, double>& direction) {
      double low = dot(corners[0], direction);
      double high = low;
      for (const Vec<2, double>& corner : corners) {
        low = std::min(low, dot(corner, direction));
        high = std::max(high, dot(corner, direction));
      }
      return high - low;
    };
    least = std::min(least, extent_along(edge) * extent_along(perpendicular(edge)) / dot(edge, edge));
  }
  return least;
}

RC_GTEST_PROP(FlushRectangle, HasTheLeastAreaOfAllEdges, ()) {
  const rc::Gen<Vec<2, double>> point = test::source_of<2, double>(test::Kind::uniform).point;
  const std::vector<Vec<2, double>> corners = detail::sorted_chain(*test::some<Vec<2, double>>(40, point));
  if (corners.size() < 3) return;
  double least = std::numeric_limits<double>::infinity();
  const auto measure = [&](double width, double height) {
    least = std::min(least, width * height);
    return width * height;
  };
  detail::best_flush_direction(std::span<const Vec<2, double>>(corners), 1, measure);
  RC_ASSERT(std::fabs(least - least_area(corners)) <= 1e-12 * least_area(corners));
}

}  // namespace
}  // namespace graze::flush_rectangle_test
