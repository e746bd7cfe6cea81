// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <set>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/io/mesh/polygon.hpp>

namespace graze::io::polygon_test {
namespace {

using Points = std::vector<Vec<3, double>>;
using Faces = std::vector<std::array<std::uint32_t, 3>>;

Faces cut(const Points& points) {
  std::vector<std::uint32_t> corners(points.size());
  std::iota(corners.begin(), corners.end(), 0U);
  Faces faces;
  append_triangles(faces, points, corners);
  return faces;
}

Vec<3, double> area_of(const Points& points, const std::array<std::uint32_t, 3>& face) {
  return cross(points[face[1]] - points[face[0]], points[face[2]] - points[face[0]]);
}

/// Twice the area of the polygon, by the shoelace formula on each axis.
Vec<3, double> area_of(const Points& points) {
  Vec<3, double> area(0);
  for (std::size_t i = 0; i < points.size(); ++i) area += cross(points[i], points[(i + 1) % points.size()]);
  return area;
}

double length(const Vec<3, double>& v) { return std::sqrt(dot(v, v)); }

/// The triangles fill the polygon exactly once: all have its direction, and their areas add up to its own.
void expect_filled(const Points& points) {
  const Faces faces = cut(points);
  ASSERT_EQ(faces.size(), points.size() - 2);
  const Vec<3, double> whole = area_of(points);
  double sum = 0;
  std::set<std::uint32_t> used;
  for (const auto& face : faces) {
    const Vec<3, double> area = area_of(points, face);
    EXPECT_GT(dot(area, whole), 0);
    sum += length(area);
    used.insert(face.begin(), face.end());
  }
  EXPECT_NEAR(sum, length(whole), 1e-9 * length(whole));
  EXPECT_EQ(used.size(), points.size());
}

TEST(Polygon, AConvexOneIsAFanFromItsFirstCorner) {
  EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), (Faces{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(cut({{0, 0, 5}, {0, 1, 5}, {1, 1, 5}}), (Faces{{0, 1, 2}}));
  EXPECT_TRUE(cut({{0, 0, 5}, {0, 1, 5}}).empty());
  EXPECT_TRUE(cut({}).empty());
}

TEST(Polygon, AConcaveOneIsFilledOnceFromAnySideAndFirstCorner) {
  Points arrow = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {3, 1, 0}, {1, 1, 0}, {0, 4, 0}};
  for (int turn = 0; turn < 3; ++turn) {
    for (std::size_t i = 0; i < arrow.size(); ++i) {
      expect_filled(arrow);
      expect_filled({arrow.rbegin(), arrow.rend()});
      std::rotate(arrow.begin(), arrow.begin() + 1, arrow.end());
    }
    for (Vec<3, double>& point : arrow) point = {point.z + 7, point.x, point.y};
  }
}

TEST(Polygon, CornersOnStraightEdgesAreKept) {
  expect_filled({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 1, 0}});
  expect_filled({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 4, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}});
}

TEST(Polygon, OneThatCrossesItselfOrHasNoAreaIsAFan) {
  EXPECT_EQ(cut({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}), (Faces{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}), (Faces{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(cut(Points(5, {1, 2, 3})).size(), 3U);
  EXPECT_EQ(cut({{1e308, 0, 0}, {-1e308, 0, 0}, {0, 1e308, 0}, {0, 0, 1e-300}}).size(), 2U);
}

RC_GTEST_PROP(Polygon, StarsAreFilled, ()) {
  const auto count = *rc::gen::inRange<std::size_t>(3, 40);
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(count);
    const double radius = *rc::gen::inRange(1, 20);
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.25 * radius * std::cos(angle));
  }
  expect_filled(points);
}

}  // namespace
}  // namespace graze::io::polygon_test
