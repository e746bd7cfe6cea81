// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/vec.hpp>
#include <graze/shape/hull/edges.hpp>
#include <graze/shape/hull/frame.hpp>
#include <graze/shape/hull/undecided_points.hpp>

namespace graze::detail {
namespace {

// Points on the edges and sides of a cube are at most corners of its triangles.
TEST(HullEdges, AreThoseBetweenPlanesAndCornersWhereThreeOfThemMeet) {
  std::vector<Vec<3, double>> points;
  for (int i = 0; i < 27; ++i) points.emplace_back(i % 3, i / 3 % 3, i / 9);
  const HullFrame<double> frame(points);
  const Quickhull<double> hull = hull_of(frame);
  const std::vector<bool> are_bent = bent_edges(hull);
  const std::vector<bool> is_vertex = are_vertices(hull, are_bent);
  EXPECT_EQ(std::count(is_vertex.begin(), is_vertex.end(), true), 8);
  for (std::size_t i = 0; i < is_vertex.size(); ++i) {
    const Vec<3, double>& corner = points[hull.corners()[i].index];
    EXPECT_EQ(is_vertex[i], corner.x != 1 && corner.y != 1 && corner.z != 1);
  }
}

TEST(HullEdges, OfACubeAreTwelve) {
  std::vector<Vec<3, double>> points;
  for (int i = 0; i < 8; ++i) points.emplace_back(i & 1, i >> 1 & 1, i >> 2);
  const HullFrame<double> frame(points);
  const std::vector<bool> are_bent = bent_edges(hull_of(frame));
  EXPECT_EQ(std::count(are_bent.begin(), are_bent.end(), true), 2 * 12);
}

}  // namespace
}  // namespace graze::detail
