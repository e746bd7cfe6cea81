// SPDX-License-Identifier: MIT
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/input_error.hpp>
#include <graze/io/tiled/model.hpp>

namespace graze::io::tiled_model_test {
namespace {

const TiledText file{"level.tmx", "<map>\n <object/>\n</map>"};

template <class Action>
std::string error_of(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(TiledModel, NamesThePlaceOfAnError) {
  EXPECT_EQ(error_of([] { fail_at(file, 7, "bad"); }), "level.tmx: line 2, column 2: bad");
}

TEST(TiledModel, RefusesAnotherKindOfFileWithAWayOut) {
  EXPECT_EQ(
      error_of([] { fail_for_kind(file, 0, "tileset", "map"); }),
      "level.tmx: line 1, column 1: the file is a Tiled tileset, but a Tiled map is needed; give the map (.tmx or "
      ".tmj) that uses it");
  EXPECT_EQ(error_of([] { fail_for_kind(file, 0, "svg", "map"); }),
            "level.tmx: line 1, column 1: the file is of the kind \"svg\", but a Tiled map is needed; give a .tmx or "
            ".tmj file");
  EXPECT_EQ(error_of([] { fail_for_kind(file, 0, "map", "template"); }),
            "level.tmx: line 1, column 1: the file is a Tiled map, but a Tiled template is needed; check the reference "
            "to it");
}

TEST(TiledModel, KnowsTheNineAlignments) {
  EXPECT_EQ(tiled_alignment("topleft")->fraction, (Vec<2, double>(0, 0)));
  EXPECT_EQ(tiled_alignment("top")->fraction, (Vec<2, double>(0.5, 0)));
  EXPECT_EQ(tiled_alignment("topright")->fraction, (Vec<2, double>(1, 0)));
  EXPECT_EQ(tiled_alignment("left")->fraction, (Vec<2, double>(0, 0.5)));
  EXPECT_EQ(tiled_alignment("center")->fraction, (Vec<2, double>(0.5, 0.5)));
  EXPECT_EQ(tiled_alignment("right")->fraction, (Vec<2, double>(1, 0.5)));
  EXPECT_EQ(tiled_alignment("bottomleft")->fraction, (Vec<2, double>(0, 1)));
  EXPECT_EQ(tiled_alignment("bottom")->fraction, (Vec<2, double>(0.5, 1)));
  EXPECT_EQ(tiled_alignment("bottomright")->fraction, (Vec<2, double>(1, 1)));
  EXPECT_FALSE(tiled_alignment("unspecified"));
  EXPECT_FALSE(tiled_alignment(""));
}

TEST(TiledModel, LimitsHowManyCellsAMapHas) {
  TiledMap map;
  add_cells(map, 8192, 8191, {file, 7});
  add_cells(map, 8192, 1, {file, 7});
  EXPECT_EQ(map.cell_count, max_tiled_cells);
  EXPECT_EQ(error_of([&] {
              add_cells(map, 1, 1, {file, 7});
            }),
            "level.tmx: line 2, column 2: with this one of 1 x 1 the compressed tile layers of the map have 67108865 "
            "cells; the most "
            "is 67108864");
  TiledMap other;
  EXPECT_NE(error_of([&] {
              add_cells(other, 4294967295, 4294967295, {file, 7});
            }).find("18446744065119617025 cells"),
            std::string::npos);
}

TEST(TiledModel, RefusesAGridOnWhichNothingCanBePlaced) {
  const auto error_for = [](const char* orientation, double width, double height) {
    TiledGrid grid;
    grid.orientation = orientation;
    grid.tile_width = width;
    grid.tile_height = height;
    return error_of([&] { require_sound(grid, {file, 0}); });
  };
  EXPECT_EQ(error_for("orthogonal", 0, 0), "no error");
  EXPECT_EQ(error_for("isometric", 64, 32), "no error");
  EXPECT_EQ(error_for("isometric", 64, 0),
            "level.tmx: line 1, column 1: the map is isometric and has the tileheight 0; it must be above 0");
  EXPECT_EQ(error_for("hexagonal", -1, 8),
            "level.tmx: line 1, column 1: the map is hexagonal and has the tilewidth -1; it must be 0 or more");
}

TEST(TiledModel, RefusesNumbersThatAreNoWholeOnes) {
  for (const double good : {0.0, -3.0, 2147483647.0, -2147483647.0}) {
    EXPECT_EQ(error_of([&] { require_whole(good, "x", {file, 0}); }), "no error");
  }
  EXPECT_EQ(error_of([&] {
              require_whole(1.5, "x", {file, 0});
            }),
            "level.tmx: line 1, column 1: the x here is 1.5; it must be a whole number from -2147483647 to 2147483647");
  EXPECT_NE(error_of([&] { require_whole(3e9, "y", {file, 0}); }).find("the y here is 3"), std::string::npos);
}

TEST(TiledModel, DrawsOnAnOrthogonalGridUnlessItIsIsometric) {
  EXPECT_EQ(tiled_drawing_grid("isometric", 64, 32).orientation, "isometric");
  EXPECT_EQ(tiled_drawing_grid("isometric", 64, 32).tile_height, 32);
  EXPECT_EQ(tiled_drawing_grid("isometric", 64, 0).orientation, "orthogonal");
  EXPECT_EQ(tiled_drawing_grid("", 64, 32).orientation, "orthogonal");
}

TEST(TiledModel, DescribesAnObjectAsFarAsKnown) {
  TiledObject object;
  EXPECT_EQ(described(object), "the object");
  object.id = 12;
  EXPECT_EQ(described(object), "the object (id 12)");
  object.name = "coin";
  EXPECT_EQ(described(object), "object \"coin\" (id 12)");
}

TEST(TiledModel, RefusesWhatNoObjectCanMean) {
  TiledObject object;
  object.id = 3;
  object.height = -1.5;
  EXPECT_EQ(error_of([&] { require_sound(object, file); }),
            "level.tmx: line 1, column 1: the object (id 3) has the height -1.5; it must be 0 or more");
  object.height = 0;
  object.outline = TiledOutline::polygon;
  object.points = {{1, 2}};
  EXPECT_EQ(error_of([&] { require_sound(object, file); }),
            "level.tmx: line 1, column 1: the polygon of the object (id 3) has 1 point; it needs at least 2");
  object.points.emplace_back(3, 4);
  EXPECT_EQ(error_of([&] { require_sound(object, file); }), "no error");
}

TEST(TiledModel, RefusesWhatNoTilesetCanMean) {
  TiledTileset tileset;
  EXPECT_EQ(error_of([&] { require_sound(tileset, file); }), "no error");
  tileset.tiles[7].width = -1;
  EXPECT_EQ(error_of([&] { require_sound(tileset, file); }),
            "level.tmx: line 1, column 1: tile 7 is -1 x 0; both sizes must be 0 or more");
  tileset.tiles.clear();
  tileset.first_gid = 0;
  EXPECT_EQ(error_of([&] { require_sound(tileset, file); }),
            "level.tmx: line 1, column 1: the tileset has the firstgid 0; tiles are numbered from 1");
}

TEST(TiledModel, LimitsHowDeepGroupsAreNested) {
  EXPECT_EQ(error_of([] { require_group_depth(32, file, 0); }), "no error");
  EXPECT_EQ(error_of([] { require_group_depth(33, file, 0); }),
            "level.tmx: line 1, column 1: this group is nested deeper than 32 groups; flatten them");
}

}  // namespace
}  // namespace graze::io::tiled_model_test
