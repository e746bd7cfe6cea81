// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/pairs/cell_grid.hpp>

namespace graze::detail::cell_grid_test {
namespace {

using Box = Aabb<3, float>;

TEST(CellGrid, HasAtLeastTheCellsThatWereWantedAndLessThanTwiceAsMany) {
  const Box bounds{{0, 0, 0}, {3, 5, 9}};
  for (std::size_t wanted = 1; wanted <= 2000; ++wanted) {
    const std::uint32_t count = grid_over(bounds, wanted).count();
    EXPECT_GE(count, wanted);
    EXPECT_LT(count, 2 * wanted);
  }
}

TEST(CellGrid, CellsAreNearToCubes) {
  const auto grid = grid_over(Box{{0, 0, 0}, {8, 4, 1}}, 256);
  EXPECT_EQ(grid.cells[0], 16U);
  EXPECT_EQ(grid.cells[1], 8U);
  EXPECT_EQ(grid.cells[2], 2U);
}

TEST(CellGrid, APointIsOneCellAndAFlatAxisIsNotCut) {
  EXPECT_EQ(grid_over(Box{{2, 2, 2}, {2, 2, 2}}, 100).count(), 1U);
  const auto line = grid_over(Box{{0, 1, 1}, {10, 1, 1}}, 100);
  EXPECT_EQ(line.cells[0], 128U);
  EXPECT_EQ(line.cells[1], 1U);
  EXPECT_EQ(line.cells[2], 1U);
}

TEST(CellGrid, BoundsThatOverflowOrUnderflowAreStillAGrid) {
  constexpr float huge = std::numeric_limits<float>::max();
  constexpr float tiny = std::numeric_limits<float>::denorm_min();
  const auto wide = grid_over(Box{{-huge, 0, 0}, {huge, 1, 1}}, 64);
  EXPECT_LT(cell_of(Vec<3>(huge, 1, 1), wide), wide.count());
  const auto narrow = grid_over(Box{{0, 0, 0}, {tiny, tiny, tiny}}, 64);
  EXPECT_LT(cell_of(Vec<3>(tiny, tiny, tiny), narrow), narrow.count());
}

TEST(CellGrid, TheNearestCellIsThatOfThePointWithinTheBoundsThatIsNearest) {
  constexpr float huge = std::numeric_limits<float>::max();
  const Box bounds{{-1, 0, 2}, {7, 4, 3}};
  const auto grid = grid_over(bounds, 100);
  for (const float x : {-huge, -3.0F, -1.0F, 0.7F, 6.9F, 7.0F, 1e6F, huge}) {
    for (const float y : {-huge, -0.5F, 0.0F, 2.2F, 4.0F, 9.0F}) {
      for (const float z : {-1e9F, 2.0F, 2.6F, 3.0F, huge}) {
        const Vec<3> within(std::min(std::max(x, -1.0F), 7.0F), std::min(std::max(y, 0.0F), 4.0F),
                            std::min(std::max(z, 2.0F), 3.0F));
        EXPECT_EQ(nearest_cell_of(Vec<3>(x, y, z), grid), cell_of(within, grid)) << x << ", " << y << ", " << z;
      }
    }
  }
  const auto point = grid_over(Box{{2, 2, 2}, {2, 2, 2}}, 100);
  EXPECT_EQ(nearest_cell_of(Vec<3>(-huge, huge, 1), point), 0U);
}

TEST(CellGrid, TheSnakeVisitsEveryCellAndEachNextOneIsANeighbour) {
  const auto grid = grid_over(Box{{0, 0, 0}, {4, 4, 2}}, 32);
  ASSERT_EQ(grid.cells[0], 4U);
  ASSERT_EQ(grid.cells[1], 4U);
  ASSERT_EQ(grid.cells[2], 2U);
  std::vector<Vec<3>> center(grid.count(), Vec<3>(-1));
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y < 4; ++y) {
      for (int z = 0; z < 2; ++z) {
        const Vec<3> point(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F, static_cast<float>(z) + 0.5F);
        const std::uint16_t cell = cell_of(point, grid);
        ASSERT_LT(cell, grid.count());
        EXPECT_EQ(center[cell].x, -1) << "two positions have cell " << cell;
        center[cell] = point;
      }
    }
  }
  for (std::size_t c = 1; c < center.size(); ++c) {
    const Vec<3> step = center[c] - center[c - 1];
    EXPECT_EQ(std::abs(step.x) + std::abs(step.y) + std::abs(step.z), 1.0F) << "from cell " << c - 1;
  }
}

TEST(CellGrid, RowsCanBeCutFinerWhereverTheyRun) {
  const Box block{{0, 0, 0}, {4, 4, 4}};
  const auto fine = with_finer_rows(grid_over(block, 64), block, 8);
  EXPECT_EQ(fine.cells[0], 32U);
  EXPECT_EQ(fine.cells_per_unit[0], 8.0F);
  EXPECT_EQ(fine.cells[1], 4U);
  const Box line{{1, 0, 2}, {1, 16, 2}};
  EXPECT_EQ(with_finer_rows(grid_over(line, 16), line, 8).cells[1], 128U);
  const Box point{{1, 1, 1}, {1, 1, 1}};
  EXPECT_EQ(with_finer_rows(grid_over(point, 16), point, 8).count(), 1U);
  constexpr float tiny = 1e-37F;  // where the finer cells can no longer be counted
  const Box speck{{0, 0, 0}, {tiny, tiny, tiny}};
  const auto cells = with_finer_rows(grid_over(speck, 32), speck, 8);
  EXPECT_LT(cell_of(speck.max, cells), cells.count());
}

TEST(CellGrid, TheFarCornerLiesInACell) {
  const Box bounds{{0.1F, -7, 3}, {0.7F, 11, 3.5F}};
  const auto grid = grid_over(bounds, 500);
  EXPECT_LT(cell_of(bounds.max, grid), grid.count());
  EXPECT_EQ(cell_of(bounds.min, grid), 0U);
}

}  // namespace
}  // namespace graze::detail::cell_grid_test
