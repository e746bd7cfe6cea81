// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/convex_parts.hpp>
#include <graze/query/union_outline.hpp>
#include <graze/shape/polytope.hpp>

namespace graze::union_outline_test {
namespace {

using Point = Vec<2, double>;
using Polygon = std::vector<Point>;
using Polygons = std::vector<Polygon>;

Polygon box(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

double twice_area(const Polygon& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) sum += cross_2d(polygon[i], polygon[(i + 1) % polygon.size()]);
  return sum;
}

double area(const Polygons& loops) {
  double sum = 0;
  for (const Polygon& loop : loops) sum += twice_area(loop) / 2;
  return sum;
}

/// The loop rotated to start at its least corner.
Polygon from_least(Polygon loop) {
  const auto less = [](const Point& a, const Point& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end(), less), loop.end());
  return loop;
}

/// The winding number of the loops around a point that is on none of them (Sunday 2001).
int winding(const Polygons& loops, const Point& point) {
  int count = 0;
  for (const Polygon& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Point& a = loop[i];
      const Point& b = loop[(i + 1) % loop.size()];
      const double side = cross_2d(b - a, point - a);
      if (a.y <= point.y && b.y > point.y && side > 0) ++count;
      if (a.y > point.y && b.y <= point.y && side < 0) --count;
    }
  }
  return count;
}

bool holds(const Polygon& convex, const Point& point) {
  for (std::size_t i = 0; i < convex.size(); ++i) {
    const Point& a = convex[i];
    if (cross_2d(convex[(i + 1) % convex.size()] - a, point - a) < 0) return false;
  }
  return true;
}

TEST(UnionOutline, is_the_polygon_that_was_cut_into_parts) {
  const Polygon comb = {{0, 0}, {9, 0}, {9, 4}, {7, 1}, {6, 5}, {4, 1}, {3, 6}, {1, 1}, {0, 4}};
  const auto parts = convex_parts<double>(comb);
  ASSERT_TRUE(parts);
  ASSERT_GT(parts->size(), 1U);
  const Polygons loops = union_outline(*parts);
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_EQ(from_least(loops[0]), comb);
}

TEST(UnionOutline, leaves_out_edges_that_meet_others_in_part) {
  const Polygons loops = union_outline(Polygons{box(0, 0, 4, 2), box(1, 2, 1, 1), box(2, 2, 1, 3)});
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_EQ(from_least(loops[0]),
            (Polygon{{0, 0}, {4, 0}, {4, 2}, {3, 2}, {3, 5}, {2, 5}, {2, 3}, {1, 3}, {1, 2}, {0, 2}}));
}

TEST(UnionOutline, runs_round_a_hole_the_other_way) {
  const Polygons frame = {box(0, 0, 5, 1), box(0, 1, 1, 3), box(4, 1, 1, 3), box(0, 4, 5, 1)};
  const Polygons loops = union_outline(frame);
  ASSERT_EQ(loops.size(), 2U);
  EXPECT_EQ(area(loops), 25 - 9);
  EXPECT_EQ(winding(loops, {2.5, 2.5}), 0);
  EXPECT_EQ(winding(loops, {0.5, 2.5}), 1);
}

TEST(UnionOutline, joins_what_overlaps_and_keeps_apart_what_does_not) {
  EXPECT_EQ(area(union_outline(Polygons{box(0, 0, 4, 4), box(2, 2, 4, 4)})), 28);
  EXPECT_EQ(area(union_outline(Polygons{box(0, 0, 4, 4), box(0, 0, 4, 4)})), 16);
  EXPECT_EQ(area(union_outline(Polygons{box(0, 0, 4, 4), box(1, 1, 1, 1)})), 16);
  EXPECT_EQ(union_outline(Polygons{box(0, 0, 1, 1), box(2, 0, 1, 1)}).size(), 2U);
  EXPECT_EQ(area(union_outline(Polygons{box(0, 0, 1, 1), box(1, 1, 1, 1)})), 2);  // a shared corner
}

TEST(UnionOutline, takes_polygons_of_either_sense_and_leaves_out_what_has_no_area) {
  Polygon clockwise = box(0, 0, 2, 2);
  std::reverse(clockwise.begin(), clockwise.end());
  EXPECT_EQ(area(union_outline(Polygons{clockwise, box(2, 0, 2, 2)})), 8);
  EXPECT_TRUE(union_outline(Polygons{}).empty());
  EXPECT_TRUE(union_outline(Polygons{{{1, 1}}, {{0, 0}, {3, 3}}, {}}).empty());
}

TEST(UnionOutline, closes_gaps_of_rounding_far_from_the_origin) {
  const Polygon comb = {{0, 0}, {9, 0}, {9, 4}, {7, 1}, {6, 5}, {4, 1}, {3, 6}, {1, 1}, {0, 4}};
  const auto cut = convex_parts<double>(comb);
  ASSERT_TRUE(cut);
  for (const double degrees : {0.0, 7.0, 31.0, 90.0, 201.5}) {
    for (const double far : {0.0, 1.0, 1e4, 1e9}) {
      const Pose<2, double> pose{rotation_matrix(degrees), Point(far, -0.3 * far)};
      Polygons parts;
      for (const Polygon& part : *cut) {
        Polygon moved;
        for (const Point& corner : part) moved.push_back(transformed(corner, pose));
        const Polytope<2, double> hull = convex_hull<2, double>(moved);
        parts.emplace_back(hull.vertices().begin(), hull.vertices().end());
      }
      const Polygons loops = union_outline(parts);
      EXPECT_EQ(loops.size(), 1U) << degrees << " at " << far;
      EXPECT_EQ(loops.front().size(), comb.size()) << degrees << " at " << far;
    }
  }
}

/// Convex polygons with few distinct coordinates: many edges coincide, in part or completely.
Polygons random_polygons(double scale) {
  Polygons polygons;
  const int count = *rc::gen::inRange(1, 9);
  for (int i = 0; i < count; ++i) {
    std::vector<Point> points;
    for (int k = 0; k < 5; ++k) points.push_back(Point(*rc::gen::inRange(0, 6), *rc::gen::inRange(0, 6)) * scale);
    const Polytope<2, double> hull = convex_hull<2, double>(points);
    if (hull.vertices().size() > 2) polygons.emplace_back(hull.vertices().begin(), hull.vertices().end());
  }
  return polygons;
}

RC_GTEST_PROP(UnionOutline, runs_once_round_the_points_of_the_union_and_round_no_others, ()) {
  const double scale = *rc::gen::element(1.0, 0.1, 1e-7, 3e8);
  const Polygons polygons = random_polygons(scale);
  const Polygons loops = union_outline(polygons);
  // Off the lines through any two points of the lattice, by far more than the tolerance.
  for (double x = -0.4867; x < 6; x += 0.473) {
    for (double y = -0.4713; y < 6; y += 0.491) {
      const Point point = Point(x, y) * scale;
      const bool inside =
          std::any_of(polygons.begin(), polygons.end(), [&](const Polygon& one) { return holds(one, point); });
      RC_ASSERT(winding(loops, point) == (inside ? 1 : 0));
    }
  }
}

}  // namespace
}  // namespace graze::union_outline_test
