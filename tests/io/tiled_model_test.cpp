// SPDX-License-Identifier: MIT
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/input_error.hpp>
#include <graze/io/tiled_model.hpp>

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

TEST(TiledModel, CountsOmissionsByKindInOrderOfAppearance) {
  std::vector<Omission> omissions;
  count_omission(omissions, "tile layer");
  count_omission(omissions, "text object", 2);
  count_omission(omissions, "tile layer", 3);
  count_omission(omissions, "nothing", 0);
  ASSERT_EQ(omissions.size(), 2U);
  EXPECT_EQ(omissions[0].what, "tile layer");
  EXPECT_EQ(omissions[0].count, 4U);
  EXPECT_EQ(omissions[1].count, 2U);
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
