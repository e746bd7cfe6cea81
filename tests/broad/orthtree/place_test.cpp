// SPDX-License-Identifier: MIT
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/orthtree/place.hpp>

namespace graze::detail::cell_place_test {
namespace {

constexpr CellPosition<2> unit{{0, 0}, 1, 5, 9};

TEST(CellPosition, TakesInBoxesUpToItsOwnSizeWhoseCenterItContains) {
  EXPECT_TRUE(takes(unit, Aabb<2>{{0, 0}, {2, 2}}));    // the center is a corner of the cell
  EXPECT_TRUE(takes(unit, Aabb<2>{{-2, -2}, {2, 2}}));  // twice the cell
  EXPECT_FALSE(takes(unit, Aabb<2>{{-2, -2}, {2.5F, 2}}));
  EXPECT_FALSE(takes(unit, Aabb<2>{{1.5F, 0}, {2, 0}}));  // fits, but its center is elsewhere
  EXPECT_TRUE(fits(unit, Aabb<2>{{1.5F, 0}, {2, 0}}));
  EXPECT_FALSE(takes(unit, Aabb<2>::everything()));
  EXPECT_FALSE(takes(unit, Aabb<2>{{0, 0}, {1, std::numeric_limits<float>::infinity()}}));
}

TEST(CellPosition, ItsChildrenAreItsQuarters) {
  for (std::uint32_t k = 0; k < 4; ++k) {
    const CellPosition<2> child = child_place(unit, k);
    EXPECT_EQ(child.center, (Vec<2, double>((k & 1U) != 0 ? 0.5 : -0.5, (k & 2U) != 0 ? 0.5 : -0.5)));
    EXPECT_EQ(child.half, 0.5);
    EXPECT_EQ(child.level, 6);
    EXPECT_EQ(child_towards(unit, child.center), k);
  }
  EXPECT_EQ(child_towards(unit, Vec<2, double>(0, -3)), 1U);  // borders belong to the upper side
}

TEST(CellPosition, DoublesTowardsAPoint) {
  const CellPosition<2> doubled = doubled_place(unit, Vec<2, double>(7, -3));
  EXPECT_EQ(doubled.center, (Vec<2, double>(1, -1)));
  EXPECT_EQ(doubled.half, 2);
  EXPECT_EQ(doubled.level, 4);
  EXPECT_EQ(child_place(doubled, 2).center, unit.center);
}

TEST(CellPosition, ARootIsAsGoodAsAnotherThatIsNotMuchSmallerInIt) {
  EXPECT_TRUE(is_as_good(unit, unit));
  EXPECT_TRUE(is_as_good(unit, CellPosition<2>{{0.25, 0}, 0.75, 0, 0}));
  EXPECT_FALSE(is_as_good(unit, CellPosition<2>{{0.25, 0}, 0.8, 0, 0}));  // sticks out
  EXPECT_FALSE(is_as_good(unit, CellPosition<2>{{0, 0}, 0.5, 0, 0}));     // half the size would suffice
}

TEST(RootPlace, IsAroundAllBoxesUnlessAFewAreTooFarOff) {
  std::vector<Aabb<2>> boxes;
  for (int k = 0; k < 64; ++k) {
    const int row = k / 8;
    const Vec<2> low(static_cast<float>(k % 8), static_cast<float>(row));
    boxes.push_back({low, low + 1.0F});
  }
  const CellPosition<2> whole = place_of_root(boxes, {.capacity = 4, .max_depth = 8});
  EXPECT_EQ(whole.center, (Vec<2, double>(4)));
  EXPECT_EQ(whole.half, 4);
  boxes.push_back({{1e6F, 0}, {1e6F, 0}});
  const CellPosition<2> middle = place_of_root(boxes, {.capacity = 4, .max_depth = 8});
  EXPECT_LT(middle.half, 10);
  EXPECT_TRUE(takes(middle, boxes[0]));
  EXPECT_FALSE(takes(middle, boxes.back()));
  EXPECT_EQ(place_of_root(boxes, {.capacity = 4, .max_depth = 32}).half, 5e5);
}

TEST(RootPlace, OfBoxesWithOneCenterIsTheLargest) {
  const std::vector<Aabb<2>> boxes = {{{1, 1}, {3, 3}}, {{2, 2}, {2, 2}}, {{0, 1}, {4, 3}}};
  EXPECT_EQ(place_of_root(boxes, {}).half, 2);
  EXPECT_EQ(place_of_root(std::vector<Aabb<2>>{{{2, 2}, {2, 2}}}, {}).half, 0);
}

TEST(RootPlace, DoesNotOverflow) {
  constexpr double huge = std::numeric_limits<double>::max();
  const std::vector<Aabb<2, double>> boxes = {{{-huge, -1}, {-huge, 0}}, {{huge, 0}, {huge, 1}}};
  EXPECT_EQ(place_of_root(boxes, {}).half, huge);
}

}  // namespace
}  // namespace graze::detail::cell_place_test
