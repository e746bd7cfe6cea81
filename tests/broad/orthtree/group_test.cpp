// SPDX-License-Identifier: MIT
#include <cstdint>

#include <gtest/gtest.h>

#include <graze/broad/orthtree/group.hpp>

namespace graze::detail::cell_group_test {
namespace {

using Box = Aabb<3, double>;

void expect_empty(const Cell<3, double>& cell) {
  EXPECT_EQ(cell.bounds, Box::nothing());
  EXPECT_EQ(cell.entries.head, no_index);
  EXPECT_EQ(cell.entries.count, 0U);
  EXPECT_EQ(cell.first_child, no_index);
}

TEST(CellGroups, KeepWhatEachCellWasGiven) {
  CellGroups<3, double> cells;
  EXPECT_EQ(cells.size(), 8U);
  EXPECT_EQ(cells.add_group(), 8U);
  EXPECT_EQ(cells.add_group(), 16U);
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) expect_empty(cells[cell]);
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
    const double low = cell;
    cells.set(cell, {Box{{low, 2, 3}, {low + 1, 5, 6}}, {cell + 50, cell + 1}, cell % 2 == 0 ? no_index : 16});
  }
  cells.grow(9, Box{{0, 4, 2}, {0, 9, 5}});
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
    const double low = cell;
    const Box bounds = cell == 9 ? Box{{0, 2, 2}, {10, 9, 6}} : Box{{low, 2, 3}, {low + 1, 5, 6}};
    EXPECT_EQ(cells.bounds(cell), bounds);
    EXPECT_EQ(cells[cell].entries.head, cell + 50);
    EXPECT_EQ(cells.count(cell), cell + 1);
    EXPECT_EQ(cells.has_children(cell), cell % 2 == 1);
    EXPECT_EQ(cells.first_child(cell), cell % 2 == 0 ? no_index : 16);
  }
}

TEST(CellGroups, ForgetAndKeepTheirMemory) {
  CellGroups<3, double> cells;
  for (int k = 0; k < 100; ++k) cells.add_group();
  cells.set(3, {Box{{1, 2, 3}, {4, 5, 6}}, {1, 1}, 8});
  const std::size_t bytes = cells.bytes();
  cells.clear();
  EXPECT_EQ(cells.size(), 8U);
  EXPECT_EQ(cells.bytes(), bytes);
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) expect_empty(cells[cell]);
}

}  // namespace
}  // namespace graze::detail::cell_group_test
