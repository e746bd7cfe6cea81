// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_set>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/tiled/tile_layer.hpp>

namespace graze::io::tiled_tile_layer_test {
namespace {

using Point = Vec<2, double>;
using Box = Aabb<2, double>;

/// A tileset of 8 x 8 tiles: 1 is full, 2 has a box on its left, 3 has nothing; a missing tileset from 10 on.
struct Fixture {
  TiledText file{"m.tmx", "<map/>"};
  TiledTileset tileset;
  TiledTileset missing;
  std::vector<TiledTilesetUse> tilesets;
  TiledProjection projection;
  std::unordered_set<std::string> taken;
  Scene<2, double> scene;
  std::vector<Omission> omissions;
  TiledTileLayers layers{tilesets, projection, taken};

  Fixture() : projection(grid()) {
    tileset.tile_width = tileset.tile_height = 8;
    tileset.tile_count = 3;
    TiledObject box;
    box.width = box.height = 8;
    tileset.tiles[0].shapes = {box};
    box.width = 2;
    tileset.tiles[1].shapes = {box};
    tilesets = {{1, &tileset, ""}, {10, &missing, "it is gone"}};
  }

  static TiledGrid grid() {
    TiledGrid grid;
    grid.tile_width = grid.tile_height = 8;
    return grid;
  }

  void add(const std::string& name, std::uint32_t width, std::vector<std::uint32_t> gids) {
    add(name, width, std::move(gids), layers);
  }

  void add(const std::string& name, std::uint32_t width, std::vector<std::uint32_t> gids, std::size_t most_objects) {
    TiledTileLayers those(tilesets, projection, taken, most_objects);
    add(name, width, std::move(gids), those);
  }

  void add(const std::string& name, std::uint32_t width, std::vector<std::uint32_t> gids, TiledTileLayers& to) {
    TiledLayer layer;
    layer.cells.push_back({0, 0, width, std::move(gids)});
    to.add({layer, name, {100.0, 0.0}, {file, 0}}, scene, omissions);
  }

  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const ObjectId id : scene.ids()) result.push_back(scene.object(id).name);
    return result;
  }
};

TEST(TiledTileLayers, AddShapesOfTilesFirstAndThenRectanglesOfCells) {
  Fixture map;
  map.add("a", 3, {1, 2, 1, 1, 1, 1});
  EXPECT_EQ(map.names(), (std::vector<std::string>{"a[1,0]", "a[0,0]", "a[2,0]", "a[0..2,1]"}));
  EXPECT_EQ(map.scene.object(*map.scene.find("a[1,0]")).box, (Box{{108, 0}, {110, 8}}));
  EXPECT_EQ(map.scene.object(*map.scene.find("a[0..2,1]")).box, (Box{{100, 8}, {124, 16}}));
}

TEST(TiledTileLayers, GiveNoNameTwice) {
  Fixture map;
  map.taken = {"a[0,0]", "a[0,0]+"};
  map.add("a", 1, {2});
  map.add("a", 1, {2});
  EXPECT_EQ(map.names(), (std::vector<std::string>{"a[0,0]++", "a[0,0]+++"}));
}

TEST(TiledTileLayers, JoinSmallObjectsBlockByBlockWhereTheyAreTooMany) {
  std::vector<std::uint32_t> gids(2 * 20, 0);
  gids[0] = gids[2] = gids[17] = gids[18] = gids[19] = 1;
  gids[5] = 2;
  std::fill(gids.begin() + 20, gids.begin() + 37, 1U);
  Fixture few;
  few.add("a", 20, gids, 5);
  EXPECT_EQ(few.names(), (std::vector<std::string>{"a[5,0]", "a[0,0]", "a[2,0]", "a[17..19,0]", "a[0..16,1]"}));
  Fixture many;
  many.add("a", 20, gids, 4);
  EXPECT_EQ(many.names(), (std::vector<std::string>{"a[0..16,1]", "a[0..5,0]", "a[17..19,0]"}))
      << "rectangles wider than a block stay alone, also where they begin in one";
  const auto& joined = std::get<Compound<2, double>>(many.scene.object(*many.scene.find("a[0..5,0]")).shape);
  ASSERT_EQ(joined.parts.size(), 3U);
  EXPECT_EQ(joined.parts[0].box, (Box{{140, 0}, {142, 8}}));
  EXPECT_EQ(joined.parts[2].box, (Box{{116, 0}, {124, 8}}));
  EXPECT_EQ(many.scene.object(many.scene.ids()[1]).mobility, Mobility::fixed);
}

TEST(TiledTileLayers, CountTheObjectsOfAllLayers) {
  Fixture map;
  TiledTileLayers layers(map.tilesets, map.projection, map.taken, 3);
  for (const char* name : {"a", "b", "c"}) map.add(name, 3, {1, 0, 1}, layers);
  EXPECT_EQ(map.names(), (std::vector<std::string>{"a[0,0]", "a[2,0]", "b[0..2,0]", "c[0..2,0]"}));
}

TEST(TiledTileLayers, CountWhatHasNoShapeInOrderOfAppearance) {
  Fixture map;
  map.add("a", 4, {10, 3, 4, 0, 0x80000003U, 3, 12, 0});
  map.add("b", 1, {3});
  ASSERT_EQ(map.omissions.size(), 3U);
  EXPECT_EQ(map.omissions[0].what, "tile of a missing tileset");
  EXPECT_EQ(map.omissions[0].count, 2U);
  EXPECT_EQ(map.omissions[1].what, "tile without collision shape");
  EXPECT_EQ(map.omissions[1].count, 4U);
  EXPECT_EQ(map.omissions[2].what, "tile that no tileset holds");
  EXPECT_TRUE(map.scene.layer_names().empty()) << "a layer without objects is none of the scene's";
}

}  // namespace
}  // namespace graze::io::tiled_tile_layer_test
