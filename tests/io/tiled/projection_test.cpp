// SPDX-License-Identifier: MIT
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/tiled/projection.hpp>

namespace graze::io::tiled_projection_test {
namespace {

using Point = Vec<2, double>;

TiledGrid grid_of(const std::string& orientation, double width, double height, double side = 0) {
  TiledGrid grid;
  grid.orientation = orientation;
  grid.height = 5;
  grid.tile_width = width;
  grid.tile_height = height;
  grid.hex_side = side;
  return grid;
}

TEST(TiledProjection, LeavesPixelsWhereTheyAreUnlessTheMapIsIsometricOrOblique) {
  for (const char* orientation : {"orthogonal", "staggered", "hexagonal"}) {
    const TiledProjection projection(grid_of(orientation, 16, 8, 4));
    EXPECT_TRUE(projection.is_identity());
    EXPECT_EQ(projection.place({3, -7}), Point(3, -7));
  }
}

TEST(TiledProjection, TurnsIsometricPixelsIntoDiamonds) {
  const TiledProjection projection(grid_of("isometric", 64, 32));
  EXPECT_FALSE(projection.is_identity());
  EXPECT_EQ(projection.place({0, 0}), Point(160, 0)) << "half the map's height in cells to the right";
  EXPECT_EQ(projection.place({32, 0}), Point(192, 16));
  EXPECT_EQ(projection.place({0, 32}), Point(128, 16));
  EXPECT_EQ(projection.corner_of_cell(0, 0), Point(128, 32));
  EXPECT_EQ(projection.corner_of_cell(2, 1), Point(160, 80));
  EXPECT_EQ(TiledProjection(grid_of("isometric", 33, 16)).place({0, 0}), Point(82, 0)) << "whole pixels";
}

TEST(TiledProjection, LeansObliquePixels) {
  TiledGrid grid = grid_of("oblique", 16, 8);
  grid.skew_x = 4;
  grid.skew_y = -2;
  const TiledProjection projection(grid);
  EXPECT_EQ(projection.place({16, 0}), Point(16, -2));
  EXPECT_EQ(projection.place({0, 8}), Point(4, 8));
  EXPECT_EQ(projection.corner_of_cell(1, 0), Point(20, 6));
}

struct Cell {
  std::int64_t x, y;
  Point corner;
};

/// Bottom left corners according to Tiled's renderers, for cells of 16 x 12.
void expect_corners(TiledGrid grid, const std::vector<Cell>& cells) {
  const TiledProjection projection(grid);
  for (const Cell& cell : cells) {
    EXPECT_EQ(projection.corner_of_cell(cell.x, cell.y), cell.corner)
        << grid.orientation << " " << grid.staggers_x << grid.shifts_even << ": " << cell.x << ", " << cell.y;
  }
}

TEST(TiledProjection, ShiftsEverySecondRowOrColumn) {
  TiledGrid grid = grid_of("staggered", 16, 12);
  expect_corners(grid, {{0, 0, {0, 12}}, {1, 0, {16, 12}}, {0, 1, {8, 18}}, {0, 2, {0, 24}}, {0, -1, {8, 6}}});
  grid.shifts_even = true;
  expect_corners(grid, {{0, 0, {8, 12}}, {0, 1, {0, 18}}, {0, -1, {0, 6}}});
  grid.staggers_x = true;
  expect_corners(grid, {{0, 0, {0, 18}}, {1, 0, {8, 12}}, {-1, 0, {-8, 12}}, {0, 1, {0, 30}}});
  grid.shifts_even = false;
  expect_corners(grid, {{0, 0, {0, 12}}, {1, 0, {8, 18}}});
}

TEST(TiledProjection, KeepsTheSidesOfHexagonsApart) {
  TiledGrid grid = grid_of("hexagonal", 16, 12, 4);
  expect_corners(grid, {{0, 0, {0, 12}}, {1, 0, {16, 12}}, {0, 1, {8, 20}}, {0, 2, {0, 28}}});
  grid.staggers_x = true;
  expect_corners(grid, {{0, 0, {0, 12}}, {1, 0, {10, 18}}, {2, 0, {20, 12}}, {0, 1, {0, 24}}});
  EXPECT_TRUE(TiledProjection(grid).is_hexagonal());
  EXPECT_FALSE(TiledProjection(grid).has_rows());
}

TEST(TiledProjection, RoundsOddSizesAndSlantsOfStaggeredCellsDownAsTiledDoes) {
  TiledGrid grid = grid_of("hexagonal", 15, 11, 7);
  expect_corners(grid, {{0, 0, {0, 10}}, {1, 0, {14, 10}}, {0, 1, {7, 18}}, {0, 2, {0, 26}}});
  grid.staggers_x = true;
  expect_corners(grid, {{0, 0, {0, 10}}, {1, 0, {10, 15}}, {2, 0, {20, 10}}, {0, 1, {0, 20}}});
  grid = grid_of("hexagonal", 16, 12, 7);
  expect_corners(grid, {{0, 0, {0, 12}}, {0, 1, {8, 21}}, {0, 2, {0, 30}}});
  expect_corners(grid_of("staggered", 15, 11, 7), {{1, 1, {21, 15}}});
}

}  // namespace
}  // namespace graze::io::tiled_projection_test
