// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/patch/manifold_points.hpp>

#include "catalogue.hpp"

namespace graze::detail::manifold_points_test {
namespace {

using V3 = Vec<3, double>;

const V3 up(0, 0, 1);

Patch<3> table() { return patch_of(Aabb<3, double>{{0, 0, -1}, {4, 4, 0}}, up); }
Patch<3> capsule(const V3& start, const V3& end) { return patch_of(Segment<3, double>{start, end}, -up); }

TEST(PairsOver, LayPointsOfTheIncidentFaceOnTheReferenceFace) {
  const Patch<3> below = table();
  const Patch<3> above = capsule({1, 1, 0.25}, {9, 1, 0.5});
  const FacingPatches<3> facing{below, above, 0, 1};
  const SurfacePairs<3> pairs = pairs_over(facing, up, 0);
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs[0].point_a, V3(1, 1, 0));
  EXPECT_EQ(pairs[0].point_b, V3(1, 1, -0.75));
  EXPECT_EQ(pairs[0].depth, 0.75);
  EXPECT_EQ(pairs[1].point_a, V3(4, 1, 0));
  EXPECT_NEAR(pairs[1].depth, 1 - (0.25 + 0.25 * 3 / 8), 1e-15);
}

TEST(PairsOver, LeaveOutWhatIsAboveTheSurface) {
  const Patch<3> below = table();
  const Patch<3> above = capsule({1, 1, -1}, {3, 1, 1});
  const FacingPatches<3> facing{below, above, 0, 0};
  const SurfacePairs<3> pairs = pairs_over(facing, up, 0);
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs[0].depth, 1);
  EXPECT_EQ(pairs[1].depth, 0);
  EXPECT_EQ(pairs[1].point_b, V3(2, 1, 0));
}

TEST(PairsBetweenEdges, AreTheEndsOfWhatTheyShare) {
  const Patch<3> below = capsule({0, 0, 0}, {4, 0, 0});
  const Patch<3> above = capsule({6, 0, 1}, {1, 0, 1});
  const FacingPatches<3> facing{below, above, 1, 0.5};
  const SurfacePairs<3> pairs = pairs_between_edges(facing, up, 0);
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs[0].point_a, V3(4, 0, 1));
  EXPECT_EQ(pairs[0].point_b, V3(4, 0, 0.5));
  EXPECT_EQ(pairs[0].depth, 0.5);
  EXPECT_EQ(pairs[1].point_a, V3(1, 0, 1));
}

TEST(PairsBetweenEdges, AreNoneOfEdgesThatAreNotParallel) {
  const Patch<3> below = capsule({0, 0, 0}, {4, 0, 0});
  const Patch<3> above = capsule({2, -1, 1}, {2, 1, 1});
  const FacingPatches<3> facing{below, above, 1, 0.5};
  EXPECT_EQ(pairs_between_edges(facing, up, 0).size(), 0U);
}

TEST(FeatureAt, IsTheLeastOneThatThePointIsOn) {
  const Patch<3> patch = table();
  EXPECT_EQ(feature_at(patch, V3(4, 0, 0), 1e-9), (Feature{FeatureKind::vertex, 5}));
  EXPECT_EQ(feature_at(patch, V3(4, 1, 0), 1e-9), (Feature{FeatureKind::edge, 7}));
  EXPECT_EQ(feature_at(patch, V3(3, 1, 0), 1e-9), (Feature{FeatureKind::face, 5}));
  EXPECT_EQ(feature_at(capsule({0, 0, 0}, {4, 0, 0}), V3(2, 0, 0), 1e-9), (Feature{FeatureKind::edge, 0}));
}

SurfacePairs<3> pairs_at(const std::vector<V3>& points) {
  SurfacePairs<3> pairs;
  for (const V3& point : points) {
    pairs.push_back({V3(point.x, point.y, 0), V3(point.x, point.y, 0), point.z, {}, {}});
  }
  return pairs;
}

TEST(SpanningChoice, TakesTheDeepestTheFarthestAndTheWidestOnEitherSide) {
  const auto pairs = pairs_at({{0, 0, 0}, {2, 0, 0.5}, {4, 0, 0}, {5, 1.5, 0}, {4, 4, 0}, {0, 4, 0}});
  EXPECT_EQ(SpanningChoice(pairs, up).run(), (std::array<std::size_t, 4>{1, 4, 5, 3}));
}

TEST(SpanningChoice, TakesTheFirstOfPointsThatAreAsGoodButForNoise) {
  for (const double noise : {-1e-8, 0.0, 1e-8}) {
    std::vector<V3> octagon;
    for (int i = 0; i < 8; ++i) {
      const Vec<2, double> turn = cosine_sine_of_degrees(45 * i);
      octagon.emplace_back(turn.x * (1 + noise * i), turn.y, 0.1 + noise * i);
    }
    const auto pairs = pairs_at(octagon);
    EXPECT_EQ(SpanningChoice(pairs, up).run(), (std::array<std::size_t, 4>{0, 4, 6, 2}));
  }
}

}  // namespace
}  // namespace graze::detail::manifold_points_test
