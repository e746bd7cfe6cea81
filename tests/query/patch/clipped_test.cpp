// SPDX-License-Identifier: MIT
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/patch/clipped.hpp>

#include "catalogue.hpp"

namespace graze::detail::clipped_patch_test {
namespace {

using V2 = Vec<2, double>;
using V3 = Vec<3, double>;

const V3 up(0, 0, 1);

/// The upper side of a flat box, and the lower side of one above.
Patch<3> upper(const V3& low, const V3& high) { return patch_of(Aabb<3, double>{low, high}, up); }
Patch<3> lower(const V3& low, const V3& high) { return patch_of(Aabb<3, double>{low, high}, -up); }

const Patch<3> table = upper({0, 0, -1}, {4, 4, 0});

Feature vertex(std::uint32_t index) { return {FeatureKind::vertex, index}; }
Feature edge(std::uint32_t index) { return {FeatureKind::edge, index}; }
Feature face(std::uint32_t index) { return {FeatureKind::face, index}; }

void expect_corner(const ClippedCorner<3>& corner, const V3& point, const Feature& reference, const Feature& incident) {
  EXPECT_EQ(corner.point, point);
  EXPECT_EQ(corner.reference, reference) << static_cast<int>(corner.reference.kind) << " " << corner.reference.index;
  EXPECT_EQ(corner.incident, incident) << static_cast<int>(corner.incident.kind) << " " << corner.incident.index;
}

TEST(ClippedPatch, ThatLiesOverTheOtherIsLeftWhole) {
  const auto whole = clipped(lower({1, 1, 0}, {2, 2, 1}), table, up, 0);
  ASSERT_EQ(whole.size(), 4U);
  expect_corner(whole[0], {1, 1, 0}, face(5), vertex(0));
  expect_corner(whole[2], {2, 2, 0}, face(5), vertex(3));
}

TEST(ClippedPatch, IsCutAcrossANormalOfAnyLengthAsByItsUnit) {
  const Patch<3> above = lower({1, 1, 0}, {2, 2, 1});
  for (const double place : {1.0, 1.25, 1.75, 2.0}) {
    ClippedPatch<3> cut(above, table);
    ClippedPatch<3> cut_across(above, table);
    cut.cut(V3(0.6, 0.8, 0), V3(place, 1.5, 0), 1, 1e-9);
    cut_across.cut_across(V3(3, 4, 0), V3(place, 1.5, 0), 1, 1e-9);
    ASSERT_EQ(cut_across.size(), cut.size());
    for (std::size_t i = 0; i < cut.size(); ++i) {
      EXPECT_NEAR(length(cut_across[i].point - cut[i].point), 0, 1e-15);
      EXPECT_EQ(cut_across[i].reference, cut[i].reference);
    }
  }
}

// Over a corner: one corner of the incident face, two crossings, and the reference face's own corner.
TEST(ClippedPatch, OverACornerNamesBothFeaturesOfEveryPoint) {
  const auto cut = clipped(lower({3, 3, 0}, {5, 5, 1}), table, up, 0);
  ASSERT_EQ(cut.size(), 4U);
  expect_corner(cut[0], {3, 3, 0}, face(5), vertex(0));
  expect_corner(cut[1], {4, 3, 0}, edge(7), edge(0));  // x = 4 above, y = 3 below
  expect_corner(cut[2], {4, 4, 0}, vertex(7), face(4));
  expect_corner(cut[3], {3, 4, 0}, edge(3), edge(4));
}

TEST(ClippedPatch, LargerThanTheOtherIsTheOther) {
  const auto cut = clipped(lower({-9, -9, 0}, {9, 9, 1}), table, up, 0);
  ASSERT_EQ(cut.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(cut[i].incident, face(4));
    EXPECT_EQ(cut[i].reference.kind, FeatureKind::vertex);
  }
}

TEST(ClippedPatch, BesideTheOtherIsNothing) {
  EXPECT_EQ(clipped(lower({5, 0, 0}, {6, 4, 1}), table, up, 0).size(), 0U);
}

TEST(ClippedPatch, UpToTheSlackIsNotCut) {
  EXPECT_EQ(clipped(lower({0, 0, 0}, {4 + 1e-12, 4, 1}), table, up, 1e-9)[1].incident, vertex(1));
}

TEST(ClippedPatch, CutAtTheFaceItselfNamesTheFace) {
  ClippedPatch<3> capsule(patch_of(Segment<3, double>{{1, 1, -1}, {1, 1, 3}}, up), table);
  capsule.cut(up, V3(0, 0, 0), table.size, 0);
  ASSERT_EQ(capsule.size(), 2U);
  expect_corner(capsule[0], {1, 1, -1}, face(5), vertex(0));
  expect_corner(capsule[1], {1, 1, 0}, face(5), edge(0));
}

TEST(ClippedPatch, OfAnEdgeIsCutAtBothEnds) {
  const auto capsule = clipped(patch_of(Segment<3, double>{{-9, 2, 0}, {9, 2, 0}}, up), table, up, 0);
  ASSERT_EQ(capsule.size(), 2U);
  expect_corner(capsule[0], {0, 2, 0}, edge(5), edge(0));
  expect_corner(capsule[1], {4, 2, 0}, edge(7), edge(0));
}

TEST(ClippedPatch, InThePlaneIsCutAtTheEndsOfTheEdge) {
  const Patch<2> floor_patch = patch_of(Aabb<2, double>{{0, -1}, {4, 0}}, V2(0, 1));
  const auto cut = clipped(patch_of(Aabb<2, double>{{3, 0}, {9, 1}}, V2(0, -1)), floor_patch, V2(0, 1), 0);
  ASSERT_EQ(cut.size(), 2U);
  EXPECT_EQ(cut[0].point, V2(3, 0));
  EXPECT_EQ(cut[0].reference, edge(3));
  EXPECT_EQ(cut[0].incident, vertex(0));
  EXPECT_EQ(cut[1].point, V2(4, 0));
  EXPECT_EQ(cut[1].reference, vertex(3));
  EXPECT_EQ(cut[1].incident, edge(2));
}

}  // namespace
}  // namespace graze::detail::clipped_patch_test
