// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/broad/grid/place.hpp>

namespace graze::detail::grid_place_test {
namespace {

using Box = Aabb<2, double>;

TEST(GridPlace, ALevelIsTheNextPowerOfTwo) {
  EXPECT_EQ(grid_level_of(1), 0);
  EXPECT_EQ(grid_level_of(1.0000001), 1);
  EXPECT_EQ(grid_level_of(0.5), -1);
  EXPECT_EQ(grid_level_of(1000), 10);
  EXPECT_LT(grid_level_of(0), lowest_grid_level);
  for (const int level : {-1000, -1, 0, 7, 1000}) EXPECT_EQ(grid_size(level), std::ldexp(1.0, level));
}

TEST(GridPlace, TheLongestSideAndTheDistanceFromTheOriginDecideTheLevel) {
  EXPECT_EQ(own_grid_level(Box{{0, 0}, {1, 3}}), 2);
  EXPECT_EQ(own_grid_level(Box{{5, 5}, {5, 5}}), 3 - grid_digits);  // a point: 8 / 2^40
  EXPECT_EQ(own_grid_level(Box{{-0x1p50, 0}, {-0x1p50, 0}}), 50 - grid_digits);
  EXPECT_EQ(own_grid_level(Box{{0, 0}, {0, 0}}), lowest_grid_level);
}

TEST(GridPlace, TheCenterDecidesTheCell) {
  EXPECT_EQ(grid_place(Box{{0, 0}, {1, 1}}, 0), (GridPlace<2>{0, {0, 0}}));
  EXPECT_EQ(grid_place(Box{{-1, 3}, {0, 4}}, 0), (GridPlace<2>{0, {-1, 3}}));
  EXPECT_EQ(grid_place(Box{{-8, 7}, {-8, 9}}, 2), (GridPlace<2>{2, {-2, 2}}));  // on borders
}

TEST(GridPlace, WhatIsInfiniteOrHugeHasNone) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(has_grid_place(Box{{-0x1p999, 0}, {1, 0x1p999}}));
  EXPECT_FALSE(has_grid_place(Box{{0, 0}, {0, 0x1p1000}}));
  EXPECT_FALSE(has_grid_place(Box{{-infinity, 0}, {0, 0}}));
  EXPECT_EQ(own_grid_level(Box{{-0x1p999, 0}, {0x1p999, 0}}), highest_grid_level);
}

TEST(GridPlace, CellsAroundTheOriginAreNumberedAsChildrenAre) {
  EXPECT_EQ(place_at_origin<2>(3, 1), (GridPlace<2>{3, {-1, 0}}));
  for (std::uint32_t child = 0; child < 4; ++child) EXPECT_EQ(child_number(place_at_origin<2>(3, child)), child);
  EXPECT_EQ(level_at_origin(GridPlace<2>{3, {-1, 0}}), 3);
  EXPECT_EQ(level_at_origin(GridPlace<2>{3, {-2, 0}}), 4);
  EXPECT_EQ(level_at_origin(GridPlace<2>{3, {0, 8}}), 7);
}

RC_GTEST_PROP(GridPlace, ACellContainsTheCenterAndIsAChildOfItsParent, ()) {
  const auto coordinate = rc::gen::map(rc::gen::inRange(-4000, 4000), [](int k) { return k * 0.37; });
  const Box box = Box::from_corners({*coordinate, *coordinate}, {*coordinate, *coordinate});
  const int level = own_grid_level(box) + *rc::gen::inRange(0, 20);
  const GridPlace<2> place = grid_place(box, level);
  const double size = grid_size(level);
  for (Dim i = 0; i < 2; ++i) {
    const double center = box.min[i] * 0.5 + box.max[i] * 0.5;
    const auto number = static_cast<double>(place.numbers[static_cast<std::size_t>(i)]);
    RC_ASSERT(number * size <= center && center < (number + 1) * size);
    RC_ASSERT(box.max[i] - box.min[i] <= size);
  }
  RC_ASSERT(child_of(parent_of(place), child_number(place)) == place);
  const int top = level_at_origin(place);
  const GridPlace<2> root = place_above(place, top);
  RC_ASSERT(root == place_at_origin<2>(top, child_number(root)));
  RC_ASSERT(grid_place(box, level + 3) == place_above(place, level + 3));
}

}  // namespace
}  // namespace graze::detail::grid_place_test
