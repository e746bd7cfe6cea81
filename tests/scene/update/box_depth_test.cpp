// SPDX-License-Identifier: MIT
#include <limits>

#include <gtest/gtest.h>

#include <graze/scene/update/box_depth.hpp>

namespace graze::detail {
namespace {

TEST(BoxDepth, IsTheShortestWayOutOfEachOther) {
  const Aabb<2, double> box{{0, 0}, {4, 4}};
  EXPECT_EQ(box_depth(box, {{1, 3}, {9, 9}}), 1);      // along y
  EXPECT_EQ(box_depth(box, {{3.5, 1}, {9, 9}}), 0.5);  // along x
  EXPECT_EQ(box_depth(box, {{1, 1}, {2, 2}}), 2);      // out of the nearer side
  EXPECT_EQ(box_depth({{1, 1}, {2, 2}}, box), 2);
  EXPECT_EQ(box_depth(box, {{4, 1}, {5, 2}}), 0);   // they only touch
  EXPECT_EQ(box_depth(box, {{7, 6}, {8, 8}}), -3);  // apart along both, farther along x
}

TEST(BoxDepth, InSpaceLooksAlongAllAxes) {
  const Aabb<3, float> box{{0, 0, 0}, {4, 4, 4}};
  EXPECT_EQ(box_depth(box, {{1, 1, 3.75F}, {9, 9, 9}}), 0.25F);
  EXPECT_EQ(box_depth(box, {{1, 1, 6}, {9, 9, 9}}), -2);
}

TEST(BoxDepth, OfWhatContainsNothingIsLessThanZeroOrNaN) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const auto nothing = Aabb<2, float>::nothing();
  EXPECT_FALSE(box_depth(nothing, nothing) >= 0);
  EXPECT_FALSE(box_depth(nothing, {{0, 0}, {1, 1}}) >= 0);
  EXPECT_FALSE(box_depth({{-infinity, 0}, {infinity, 1}}, nothing) >= 0);
  EXPECT_FALSE(box_depth(nothing, {{-infinity, -infinity}, {infinity, infinity}}) >= 0);
}

}  // namespace
}  // namespace graze::detail
