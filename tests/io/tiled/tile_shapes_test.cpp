// SPDX-License-Identifier: MIT
#include <variant>

#include <gtest/gtest.h>

#include <graze/io/tiled/tile_shapes.hpp>
#include <graze/query/bounds.hpp>

namespace graze::io::tiled_tile_shapes_test {
namespace {

using Point = Vec<2, double>;
using Box = Aabb<2, double>;

TiledProjection projection_of(const char* orientation, double width, double height) {
  TiledGrid grid;
  grid.orientation = orientation;
  grid.height = 3;
  grid.tile_width = width;
  grid.tile_height = height;
  return TiledProjection(grid);
}

/// A picture of 20 x 40 with a box of 4 x 8 at its top left.
struct Picture {
  TiledTileset tileset;
  TiledTile tile;

  Picture() {
    tile.width = 20;
    tile.height = 40;
    TiledObject box;
    box.width = 4;
    box.height = 8;
    tile.shapes.push_back(box);
  }

  Box box(std::uint32_t flips, const TiledProjection& projection = projection_of("orthogonal", 10, 10)) const {
    const TiledTileShapes shapes = tiled_tile_shapes({&tileset, &tile}, flips | 1U, projection);
    EXPECT_EQ(shapes.shapes.size(), 1U);
    return bounds(shapes.shapes.at(0));
  }
};

TEST(TiledTileShapes, StandOnTheCellsBottomLeftCorner) {
  EXPECT_EQ(Picture().box(0), (Box{{0, -40}, {4, -32}}));
  EXPECT_EQ(Picture().box(0x80000000U), (Box{{16, -40}, {20, -32}}));
  EXPECT_EQ(Picture().box(0x40000000U), (Box{{0, -8}, {4, 0}}));
  EXPECT_EQ(Picture().box(0x20000000U), (Box{{0, -20}, {8, -16}})) << "lies on its side, mirrored at the diagonal";
  EXPECT_EQ(Picture().box(0xA0000000U), (Box{{32, -20}, {40, -16}})) << "a quarter turn clockwise";
}

TEST(TiledTileShapes, FollowTheTilesetsDrawing) {
  Picture picture;
  picture.tileset.drawing_offset = {1, 2};
  EXPECT_EQ(picture.box(0), (Box{{1, -38}, {5, -30}}));
  picture.tileset.fills_grid = true;
  EXPECT_EQ(picture.box(0), (Box{{0.5, -9.5}, {2.5, -7.5}})) << "half as wide, a quarter as high";
  picture.tileset.keeps_aspect = true;
  EXPECT_EQ(picture.box(0), (Box{{2.75, -9.5}, {3.75, -7.5}})) << "in the middle";
}

TEST(TiledTileShapes, TurnBySixtyDegreesOnHexagonalMaps) {
  Picture picture;
  picture.tile.shapes[0].outline = TiledOutline::point;
  const TiledProjection hexagonal = projection_of("hexagonal", 20, 40);
  const auto point = [&](std::uint32_t flips) { return picture.box(flips, hexagonal).min - Point(10, -20); };
  EXPECT_NEAR(point(0).x, -10, 1e-14);
  EXPECT_NEAR(point(0x20000000U).x, -10 * 0.5 + 20 * 0.86602540378443865, 1e-13);
  EXPECT_NEAR(point(0x10000000U).x, -10 * -0.5 + 20 * 0.86602540378443865, 1e-13);
  EXPECT_NEAR(point(0x30000000U).x, 10, 1e-13) << "both: half a turn";
  EXPECT_NEAR(point(0x30000000U).y, 20, 1e-13);
}

TEST(TiledTileShapes, FillACellOnlyFromEdgeToEdge) {
  Picture picture;
  const auto fills = [&](double width, double height) {
    return tiled_tile_shapes({&picture.tileset, &picture.tile}, 1, projection_of("orthogonal", width, height))
        .fills_cell;
  };
  picture.tile.shapes[0].width = 20;
  picture.tile.shapes[0].height = 40;
  EXPECT_TRUE(fills(20, 40));
  EXPECT_FALSE(fills(20, 20)) << "reaches into the cell above";
  picture.tile.shapes[0].y = 0.5;
  EXPECT_FALSE(fills(20, 40));
}

TEST(TiledTileShapes, AreDrawnOnTheTilesetsIsometricGrid) {
  Picture picture;
  picture.tileset.grid = tiled_drawing_grid("isometric", 20, 10);
  picture.tile.shapes[0].width = 10;
  picture.tile.shapes[0].height = 10;
  EXPECT_EQ(picture.box(0), (Box{{0, -10}, {20, 0}})) << "one cell of that grid, at the picture's bottom";
  EXPECT_TRUE(tiled_tile_shapes({&picture.tileset, &picture.tile}, 1, projection_of("isometric", 20, 10)).fills_cell);
}

TEST(TiledTileShapes, CountWhatIsNotRead) {
  Picture picture;
  picture.tile.shapes[0].outline = TiledOutline::text;
  const TiledTileShapes text =
      tiled_tile_shapes({&picture.tileset, &picture.tile}, 1, projection_of("orthogonal", 1, 1));
  EXPECT_TRUE(text.shapes.empty());
  EXPECT_EQ(text.omissions.at(0).what, "text object");
  picture.tile.width.reset();
  EXPECT_EQ(
      tiled_tile_shapes({&picture.tileset, &picture.tile}, 1, projection_of("orthogonal", 1, 1)).omissions.at(0).what,
      "collision shape of a tile without size");
}

}  // namespace
}  // namespace graze::io::tiled_tile_shapes_test
