// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/patch/patch.hpp>

#include "catalogue.hpp"

namespace graze::detail::patch_test {
namespace {

using V2 = Vec<2, double>;
using V3 = Vec<3, double>;

const Aabb<3, double> box{{-1, -2, -3}, {1, 2, 3}};

/// The corner of the box with this number.
V3 numbered_corner(std::uint32_t number) {
  V3 corner;
  for (Dim i = 0; i < 3; ++i) corner[i] = (number >> static_cast<unsigned>(i) & 1U) != 0 ? box.max[i] : box.min[i];
  return corner;
}

/// The middle of the edge of the box with this number.
V3 numbered_edge(std::uint32_t number) {
  const auto axis = static_cast<Dim>(number / 4);
  V3 middle(0.0);
  const Dim next = (axis + 1) % 3;
  const Dim last = (axis + 2) % 3;
  middle[next] = (number & 1U) != 0 ? box.max[next] : box.min[next];
  middle[last] = (number & 2U) != 0 ? box.max[last] : box.min[last];
  return middle;
}

TEST(PatchOf, EverySideOfABoxHasItsNumbersRight) {
  std::set<std::uint32_t> faces;
  for (Dim axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      V3 direction(0.1);
      direction[axis] = sign;
      const Patch<3> patch = patch_of(box, direction);
      ASSERT_EQ(patch.size, 4U);
      EXPECT_EQ(patch.normal, unit_axis<3>(axis) * sign);
      EXPECT_EQ(patch.face, static_cast<std::uint32_t>(2 * axis + (sign > 0 ? 1 : 0)));
      faces.insert(patch.face);
      for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(patch.corners[i][axis], sign * (axis + 1));
        EXPECT_EQ(patch.corners[i], numbered_corner(patch.vertices[i]));
        EXPECT_EQ(0.5 * (patch.corners[i] + patch.corners[(i + 1) % 4]), numbered_edge(patch.edges[i]));
      }
    }
  }
  EXPECT_EQ(faces.size(), 6U);
}

TEST(PatchOf, ABoxThatIsTurnedIsTheSideThatLooksAlong) {
  const Obb<3, double> turned{{5, 0, 0}, {1, 2, 3}, rotation_matrix(V3(0, 0, 1), 30)};
  const Patch<3> patch = patch_of(turned, V3(1, 0.2, 0));
  EXPECT_EQ(patch.face, 1U);
  EXPECT_NEAR(length(patch.normal - turned.axes[0]), 0, 1e-15);
  EXPECT_NEAR(length(patch.corners[0] - (turned.center + turned.axes * V3(1, -2, -3))), 0, 1e-15);
}

TEST(PatchOf, ABoxOfThePlaneIsItsSide) {
  const Patch<2> patch = patch_of(Aabb<2, double>{{0, 0}, {4, 2}}, V2(0.1, 1));
  EXPECT_EQ(patch.face, 3U);
  EXPECT_EQ(patch.normal, V2(0, 1));
  EXPECT_EQ(patch.corners[0], V2(0, 2));
  EXPECT_EQ(patch.vertices[0], 2U);
  EXPECT_EQ(patch.corners[1], V2(4, 2));
  EXPECT_EQ(patch.vertices[1], 3U);
}

// Sides that face the direction equally must not alternate between frames.
TEST(PatchOf, OfSidesThatLookAlongAsMuchIsTheFirst) {
  for (const double noise : {-1e-9, 0.0, 1e-9}) EXPECT_EQ(patch_of(box, V3(1, 1 + noise, 0)).face, 1U);
}

TEST(PatchOfTriangle, InThePlaneOfAFlatOneIsAllOfIt) {
  // The third corner is the midpoint of the other two, and any of them is the farthest along the direction.
  const Triangle<2, double> flat{{-4, 0}, {4, 0}, {0, 0}};
  for (const V2 direction : {V2(0, 1), V2(0, -1), V2(1e-17, 1), V2(-1e-17, 1), V2(1, 0)}) {
    const Patch<2> patch = patch_of(flat, direction);
    ASSERT_EQ(patch.size, 2U);
    EXPECT_EQ(std::min(patch.corners[0].x, patch.corners[1].x), -4);
    EXPECT_EQ(std::max(patch.corners[0].x, patch.corners[1].x), 4);
    EXPECT_GE(dot(patch.normal, direction), 0);
  }
}

TEST(PatchOf, ATriangleLooksBothWays) {
  const Triangle<3, double> triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  EXPECT_EQ(patch_of(triangle, V3(1, 0, 0.1)).normal, V3(0, 0, 1));
  EXPECT_EQ(patch_of(triangle, V3(1, 0, -0.1)).normal, V3(0, 0, -1));
  EXPECT_EQ(patch_of(triangle, V3(0, 0, 1)).corners[1], V3(4, 0, 0));
  const Triangle<3, double> flat{{0, 0, 0}, {4, 0, 0}, {2, 0, 0}};
  EXPECT_EQ(patch_of(flat, V3(0, 0, 1)).normal, V3(0, 0, 0));
}

TEST(PatchOf, ATriangleOfThePlaneIsOneOfItsEdgesWhicheverWayRound) {
  for (const bool is_clockwise : {false, true}) {
    const V2 b = is_clockwise ? V2(0, 4) : V2(4, 0);
    const V2 c = is_clockwise ? V2(4, 0) : V2(0, 4);
    const Patch<2> patch = patch_of(Triangle<2, double>{{0, 0}, b, c}, V2(1, 0.8));
    EXPECT_EQ(patch.face, 1U);
    EXPECT_NEAR(length(patch.normal - V2(1, 1) * std::sqrt(0.5)), 0, 1e-15);
    EXPECT_EQ(patch.corners[0], b);
  }
}

// Along the needle itself no side faces that direction, and yet its end is the contact.
TEST(PatchOf, ANeedleEndOnIsASideWithItsEnd) {
  for (const double width : {0.0, 1e-9}) {
    const Triangle<2, double> needle{{0, 0}, {10, 0}, {9, width}};
    const Patch<2> patch = patch_of(needle, V2(1, 0));
    EXPECT_EQ(std::max(patch.corners[0].x, patch.corners[1].x), 10) << width;
    EXPECT_EQ(std::min(patch.corners[0].x, patch.corners[1].x), 0) << width;
  }
}

TEST(PatchOf, ASideWithoutLengthIsNoFace) {
  EXPECT_EQ(patch_of(Aabb<2, double>{{1, 1}, {1, 3}}, V2(0, 1)).normal, V2(0, 0));
  EXPECT_EQ(patch_of(Aabb<2, double>{{1, 1}, {1, 3}}, V2(1, 0)).normal, V2(1, 0));
  EXPECT_EQ(patch_of(Aabb<3, double>{{1, 1, 1}, {1, 3, 3}}, V3(0, 1, 0)).normal, V3(0, 0, 0));
  EXPECT_EQ(patch_of(Aabb<3, double>{{1, 1, 1}, {1, 3, 3}}, V3(1, 0, 0)).normal, V3(1, 0, 0));
}

TEST(PatchOf, PointsAndSegmentsAreThemselves) {
  EXPECT_EQ(patch_of(V3(1, 2, 3), V3(1, 0, 0)).size, 1U);
  const Patch<3> edge = patch_of(Segment<3, double>{{1, 2, 3}, {4, 5, 6}}, V3(1, 0, 0));
  EXPECT_EQ(edge.size, 2U);
  EXPECT_EQ(edge.normal, V3(0, 0, 0));
  EXPECT_EQ(patch_of(Segment<2, double>{{0, 0}, {2, 0}}, V2(1, -0.1)).normal, V2(0, -1));
}

}  // namespace
}  // namespace graze::detail::patch_test
