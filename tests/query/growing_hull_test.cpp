// SPDX-License-Identifier: MIT
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/growing_hull.hpp>

#include "catalogue.hpp"

namespace graze::test::growing_hull_test {
namespace {

using V2 = Vec<2, double>;
using V3 = Vec<3, double>;

TEST(Frame, GrowsByWhatIsBesideItsSpan) {
  detail::Frame<3> frame;
  EXPECT_TRUE(frame.add(V3(0, 2, 0), 0));
  EXPECT_FALSE(frame.add(V3(0, -5, 0), 0)) << "along the first";
  EXPECT_FALSE(frame.add(V3(0, 3, 0.125), 0.25)) << "too short beside the first";
  EXPECT_TRUE(frame.add(V3(0, 3, 0.5), 0.25));
  EXPECT_FALSE(frame.is_full());
  EXPECT_TRUE(frame.add(V3(1, 7, 8), 0));
  EXPECT_TRUE(frame.is_full());
  EXPECT_FALSE(frame.add(V3(9, 9, 9), 0));
}

TEST(Frame, KnowsADirectionAcrossItsSpan) {
  detail::Frame<3> frame;
  EXPECT_EQ(frame.across(), V3(1, 0, 0));
  frame.add(V3(3, 4, 0), 0);
  EXPECT_NEAR(dot(frame.across(), V3(3, 4, 0)), 0, 1e-15);
  EXPECT_NEAR(dot(frame.across(), frame.across()), 1, 1e-15);
  frame.add(V3(0, 0, 2), 0);
  EXPECT_NEAR(dot(frame.across(), V3(3, 4, 0)), 0, 1e-15);
  EXPECT_NEAR(frame.across().z, 0, 1e-15);
  detail::Frame<2> flat;
  flat.add(V2(3, 4), 0);
  EXPECT_NEAR(dot(flat.across(), V2(3, 4)), 0, 1e-15);
}

TEST(GrowingHull, OfThePlaneKnowsItsNearestFace) {
  const detail::GrowingHull<2> square({{-1, -2}, {3, -2}, {3, 2}, {-1, 2}, {0, 0}});
  const auto face = square.nearest_face();
  ASSERT_TRUE(face);
  EXPECT_EQ(face->height, 1);
  EXPECT_EQ(face->normal, V2(-1, 0));
}

TEST(GrowingHull, OfPointsOnALineHasNoFace) {
  EXPECT_FALSE(detail::GrowingHull<2>({{0, 0}, {1, 1}, {2, 2}}).nearest_face());
  EXPECT_FALSE(detail::GrowingHull<3>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}).nearest_face());
}

TEST(GrowingHull, GrowsByNewPointsOnly) {
  detail::GrowingHull<2> hull({{-1, -1}, {1, -1}, {0, 1}});
  const auto face = hull.nearest_face();
  EXPECT_FALSE(hull.insert(V2(1, -1), *face)) << "known";
  EXPECT_FALSE(hull.insert(V2(0, 0), *face)) << "inside";
  EXPECT_TRUE(hull.insert(V2(0, -3), *face));
  detail::GrowingHull<3> solid({{-1, -1, -1}, {3, -1, -1}, {-1, 3, -1}, {-1, -1, 3}});
  const auto floor = solid.nearest_face();
  EXPECT_FALSE(solid.insert(V3(3, -1, -1), *floor)) << "known";
  EXPECT_FALSE(solid.insert(V3(0, 0, 0), *floor)) << "inside";
  EXPECT_TRUE(solid.insert(V3(0, 0, -5), *floor));
}

TEST(GrowingHull, OfACubeHasTheCubesHeights) {
  std::vector<V3> corners;
  for (unsigned i = 0; i < 8; ++i) {
    corners.emplace_back((i & 1U) != 0 ? 2 : -3, (i & 2U) != 0 ? 2 : -3, (i & 4U) != 0 ? 2 : -1);
  }
  const auto face = detail::GrowingHull<3>(corners).nearest_face();
  ASSERT_TRUE(face);
  EXPECT_EQ(face->height, 1);
  EXPECT_EQ(face->normal, V3(0, 0, -1));
}

/// Every point that was put in is inside, up to rounding: no face has it above.
template <Dim N>
void expect_inside() {
  check_property([] {
    using V = Vec<N, double>;
    const auto ways = vector_of<N, double>(drawn<double>([](rc::Random& random) { return between(random, -1, 1); }));
    std::vector<V> points;
    for (int i = 0; i < 12; ++i) points.push_back(*ways + V(0.125));
    std::vector<V> start(points.begin(), points.begin() + N + 1);
    detail::GrowingHull<N> hull(start);
    const auto first = hull.nearest_face();
    RC_PRE(first.has_value());
    for (const V& point : points) hull.insert(point, *first);
    const auto face = hull.nearest_face();
    RC_ASSERT(face.has_value());
    for (const V& point : points) RC_ASSERT(dot(face->normal, point) <= face->height + 1e-14);
    RC_ASSERT(std::fabs(dot(face->normal, face->normal) - 1) <= 1e-14);
  });
}

TEST(GrowingHull, HoldsEveryPointPutIn) {
  expect_inside<2>();
  expect_inside<3>();
}

}  // namespace
}  // namespace graze::test::growing_hull_test
