// SPDX-License-Identifier: MIT
// The minimum translation of a segment out of a box, by hand.
#include <gtest/gtest.h>

#include <graze/math/vec.hpp>
#include <graze/query/manifold.hpp>

namespace graze::detail::way_out_test {
namespace {

using V3 = Vec<3, double>;

constexpr double doubt = 1e-8;
constexpr double noise = 1e-14;

using one_pair::MinimumTranslation;

/// Out of a box of 3 x 2 x 1 around the origin.
MinimumTranslation minimum_translation(const V3& start, const V3& end) {
  return {one_pair::WayPastBox{start, end - start, V3(3, 2, 1)}, doubt, noise, true};
}

V3 outward_of_face(const MinimumTranslation& way) { return unit_axis<3>(way.face) * (way.is_far ? 1.0 : -1.0); }

void expect_face(const V3& start, const V3& end, const V3& outward) {
  const MinimumTranslation way = minimum_translation(start, end);
  ASSERT_TRUE(way.is_known && way.is_face);
  EXPECT_EQ(outward_of_face(way), outward);
}

TEST(MinimumTranslation, IsAcrossTheFaceThatTheLowestPlaceIsNearestTo) {
  expect_face({0, 0, 0.5}, {1, 1, 0.7}, {0, 0, 1});
  expect_face({0, 0, -0.5}, {1, 1, -0.7}, {0, 0, -1});
  expect_face({2.9, 0, 0.5}, {9, 1, 0.5}, {1, 0, 0});
  expect_face({0, -1.9, 0.1}, {1, -9, 0.2}, {0, -1, 0});
}

TEST(MinimumTranslation, IsAcrossAnEdgeThatTheSegmentCuts) {
  // Past the edge along x at +y and +z, and along y at -x and +z.
  MinimumTranslation way = minimum_translation({0, 1.8, 9.8}, {0, 9.8, 1.8});
  EXPECT_FALSE(way.is_known) << "out of the box";
  way = minimum_translation({0.1, -1.2, 4}, {0.2, 4, -1.2});
  ASSERT_TRUE(way.is_known && !way.is_face);
  EXPECT_EQ(way.edge, 0);
  EXPECT_GT(way.outward.y, 0);
  EXPECT_GT(way.outward.z, 0);
  EXPECT_TRUE(way.is_oblique);
  way = minimum_translation({-6, 0.5, -2.1}, {-0.5, 0, 3.3});
  ASSERT_TRUE(way.is_known && !way.is_face);
  EXPECT_EQ(way.edge, 1);
  EXPECT_LT(way.outward.x, 0);
  EXPECT_GT(way.outward.z, 0);
}

TEST(MinimumTranslation, IsTheFaceThatALevelSegmentIsUnder) {
  const MinimumTranslation way = minimum_translation({-9, -1, 0.5}, {9, 1, 0.5});
  ASSERT_TRUE(way.is_known && way.is_face && way.is_level);
  EXPECT_EQ(outward_of_face(way), V3(0, 0, 1));
  const MinimumTranslation along_edges = minimum_translation({-9, 1, 0.5}, {9, 1, 0.5});
  EXPECT_TRUE(along_edges.is_known && along_edges.is_face && along_edges.is_level);
  EXPECT_FALSE(minimum_translation({-9, -1, 0.5}, {9, 1, 0.5 + 1e-9}).is_known) << "too close to level to decide";
}

TEST(MinimumTranslation, IsNotKnownWhereTwoAreAsGood) {
  EXPECT_FALSE(minimum_translation({0, 0, 0}, {1, 0, 0}).is_known) << "in the middle of two faces";
  EXPECT_FALSE(minimum_translation({2.5, 0, 0.5}, {2.6, 0, 0.6}).is_known) << "equally far from two adjacent faces";
  EXPECT_FALSE(minimum_translation({0, -9, 0}, {0, 9, 1e-9}).is_known) << "through the middle";
}

}  // namespace
}  // namespace graze::detail::way_out_test
