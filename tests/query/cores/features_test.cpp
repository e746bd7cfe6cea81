// SPDX-License-Identifier: MIT
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/cores/features.hpp>

#include "catalogue.hpp"

namespace graze::detail::core_features_test {
namespace {

using V3 = Vec<3, double>;
using Edge = Segment<3, double>;

const Obb<3, double> turned{{1, 2, 3}, {1, 2, 3}, Mat<3, double>(0, 1, 0, -1, 0, 0, 0, 0, 1)};
const Triangle<3, double> triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

void expect_foot(const ClosestOnCore<3>& closest, const V3& point, const V3& off) {
  EXPECT_EQ(closest.point, point);
  EXPECT_EQ(closest.off, off);
}

TEST(FootOn, CoresIsAsComputedByHand) {
  expect_foot(closest_on(V3(1, 2, 3), V3(4, 4, 4)), {1, 2, 3}, {3, 2, 1});
  expect_foot(closest_on(Aabb<3, double>{}, V3(3, 0.5, -2)), {1, 0.5, -1}, {2, 0, -1});
  expect_foot(closest_on(Aabb<3, double>{}, V3(0, 0.5, 0)), {0, 0.5, 0}, {0, 0, 0});
  expect_foot(closest_on(turned, V3(9, 3, 7)), {3, 3, 6}, {6, 0, 1});  // x runs along y, y against x
  expect_foot(closest_on(triangle, V3(1, 1, 5)), {1, 1, 0}, {0, 0, 5});
  expect_foot(closest_on(triangle, V3(4, 4, 1)), {2, 2, 0}, {2, 2, 1});
  expect_foot(closest_on(triangle, V3(-1, -2, 3)), {0, 0, 0}, {-1, -2, 3});
}

TEST(FootOn, ATriangleOfThePlaneIsThePointItselfInside) {
  using V2 = Vec<2, double>;
  const Triangle<2, double> clockwise{{0, 0}, {0, 4}, {4, 0}};
  EXPECT_EQ(closest_on(clockwise, V2(1, 1)).point, V2(1, 1));
  EXPECT_EQ(closest_on(clockwise, V2(1, 1)).off, V2(0, 0));
  EXPECT_EQ(closest_on(clockwise, V2(3, 3)).point, V2(2, 2));
  const Triangle<2, double> flat{{0, 0}, {4, 0}, {2, 0}};
  EXPECT_EQ(closest_on(flat, V2(3, 2)).point, V2(3, 0));
  EXPECT_EQ(closest_on(Triangle<2, double>{{1, 1}, {1, 1}, {1, 1}}, V2(3, 2)).off, V2(2, 1));
}

// A projection outside of a needle is easily taken for one inside, and the distance to the needle is long.
TEST(FootOn, ANeedleIsOneOfItsPoints) {
  for (const double half_width : {1e-3, 1e-8, 1e-12, 1e-16, 0.0}) {
    const Triangle<3, double> needle{{0, 0, 0}, {1, half_width, 0}, {1, -half_width, 0}};
    EXPECT_NEAR(length(closest_on(needle, V3(-0.3, 0, 0.4)).off), 0.5, 1e-15);
    EXPECT_NEAR(length(closest_on(needle, V3(0.7, 0, 0.4)).off), 0.4, 1e-15);
    EXPECT_NEAR(length(closest_on(needle, V3(0.7, 0, 0.4)).point - V3(0.7, 0, 0)), 0, half_width + 1e-15);
  }
}

TEST(CornerPoints, AreThoseOfTheShape) {
  EXPECT_EQ(corner_points(V3(1, 2, 3)).at(0), V3(1, 2, 3));
  EXPECT_EQ(corner_points(Edge{{1, 2, 3}, {4, 5, 6}}).at(1), V3(4, 5, 6));
  EXPECT_EQ(corner_points(triangle).at(2), V3(0, 4, 0));
  const auto upright = corner_points(Aabb<3, double>{{1, 2, 3}, {4, 5, 6}});
  EXPECT_EQ(upright.at(0), V3(1, 2, 3));
  EXPECT_EQ(upright.at(5), V3(4, 2, 6));
  EXPECT_EQ(corner_points(turned).at(1), V3(3, 3, 0));
}

TEST(SizeAroundZero, IsTheLargestSumOfCoordinates) {
  EXPECT_EQ(size_around_zero(V3(1, -2, 3)), 6);
  EXPECT_EQ(size_around_zero(triangle), 4);
  EXPECT_EQ(size_around_zero(turned), 3 + 3 + 6);
}

template <class Core>
std::vector<Edge> edges_of_core(const Core& core) {
  std::vector<Edge> edges;
  visit_edges(core, [&](const Edge& edge) { edges.push_back(edge); });
  return edges;
}

TEST(VisitEdges, VisitsEveryEdgeOnce) {
  EXPECT_EQ(edges_of_core(Edge{}).size(), 1U);
  EXPECT_EQ(edges_of_core(triangle).size(), 3U);
  const std::vector<Edge> edges = edges_of_core(Aabb<3, double>{{0, 0, 0}, {1, 2, 3}});
  ASSERT_EQ(edges.size(), 12U);
  double sum = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    sum += length(edges[i].end - edges[i].start);
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(edges[i].start + edges[i].end, edges[j].start + edges[j].end);
  }
  EXPECT_EQ(sum, 4 * (1 + 2 + 3));
}

TEST(VisitForemostEdges, LeavesOutWhatLiesBehind) {
  const BoxFrame<3> box = frame_of(Aabb<3, double>{});
  const auto count = [&](const V3& direction) {
    int edges = 0;
    visit_foremost_edges(box, 0, direction, [&](const Edge& edge) {
      ++edges;
      EXPECT_EQ(edge.start.z, 1);
    });
    return edges;
  };
  EXPECT_EQ(count(V3(0, 1, 1)), 1);
  EXPECT_EQ(count(V3(0, -1e-3, 1)), 1);
  EXPECT_EQ(count(V3(0, 1e-15, 1)), 2);  // rounding cannot tell
  int sides = 0;
  visit_foremost_edges(triangle, 0, V3(0, -1, 1), [&](const Edge&) { ++sides; });
  EXPECT_EQ(sides, 1);
  visit_foremost_edges(triangle, 0, V3(0, 1, 1), [&](const Edge&) { ++sides; });
  EXPECT_EQ(sides, 1);
}

}  // namespace
}  // namespace graze::detail::core_features_test
