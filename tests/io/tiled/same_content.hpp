// SPDX-License-Identifier: MIT
// The content of test files that exist in XML and in JSON, which both readers must return.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/tiled/model.hpp>

namespace graze::io {

/// A layer "things" with one object that has all fields.
inline void expect_every_field(const TiledMap& map, const std::string& template_source) {
  EXPECT_EQ(map.grid.orientation, "isometric");
  ASSERT_EQ(map.layers.size(), 1U);
  EXPECT_EQ(map.layers[0].name, "things");
  EXPECT_EQ(map.layers[0].shift, (Vec<2, double>(3, -4.5)));
  ASSERT_EQ(map.layers[0].objects.size(), 1U);
  const TiledObject& object = map.layers[0].objects[0];
  EXPECT_EQ(object.id, 7U);
  EXPECT_EQ(object.name, "box");
  EXPECT_TRUE(object.has_class);
  EXPECT_EQ(object.gid, 2147483651U);
  EXPECT_EQ(object.x, 1.5);
  EXPECT_EQ(object.y, -2.0);
  EXPECT_EQ(object.width, 3.0);
  EXPECT_EQ(object.height, 40.0);
  EXPECT_EQ(object.rotation, -270.0);
  EXPECT_EQ(object.template_source, template_source);
  EXPECT_EQ(object.properties, 2U);
  EXPECT_FALSE(object.outline);
  EXPECT_TRUE(map.omissions.empty());
}

/// A layer with one object for each kind of outline.
inline void expect_every_outline(const TiledMap& map) {
  using Points = std::vector<Vec<2, double>>;
  const std::vector<TiledObject>& objects = map.layers.at(0).objects;
  ASSERT_EQ(objects.size(), 7U);
  EXPECT_FALSE(objects[0].outline);
  EXPECT_EQ(objects[1].outline, TiledOutline::ellipse);
  EXPECT_EQ(objects[2].outline, TiledOutline::capsule);
  EXPECT_EQ(objects[3].outline, TiledOutline::point);
  EXPECT_EQ(objects[4].outline, TiledOutline::polygon);
  EXPECT_EQ(objects[4].points, (Points{{0, 0}, {8, -2.5}, {10, 4}}));
  EXPECT_EQ(objects[5].outline, TiledOutline::polyline);
  EXPECT_EQ(objects[5].points, (Points{{0, 0}, {8, 0}}));
  EXPECT_EQ(objects[6].outline, TiledOutline::text);
}

/// A tile layer without data, a nested group, and what is not read.
inline void expect_groups(const TiledMap& map, const std::string& omissions) {
  ASSERT_EQ(map.layers.size(), 2U);
  EXPECT_TRUE(map.layers[0].cells.empty());
  EXPECT_EQ(map.layers[1].name, "g");
  ASSERT_EQ(map.layers[1].layers.size(), 1U);
  EXPECT_EQ(map.layers[1].layers[0].layers.at(0).name, "o");
  std::string counted;
  for (const Omission& each : map.omissions) counted += std::to_string(each.count) + " " + each.what + "; ";
  EXPECT_EQ(counted, omissions);
}

/// A layer of two chunks.
inline void expect_chunks(const TiledLayer& layer) {
  ASSERT_EQ(layer.cells.size(), 2U);
  EXPECT_EQ(layer.cells[0].x, -16);
  EXPECT_EQ(layer.cells[0].y, 32);
  EXPECT_EQ(layer.cells[0].gids, (std::vector<std::uint32_t>{5, 6}));
  EXPECT_EQ(layer.cells[1].gids, std::vector<std::uint32_t>{7});
}

inline void expect_tileset_of_one_image(const TiledTileset& tileset) {
  EXPECT_EQ(tileset.first_gid, 1U);
  EXPECT_EQ(tileset.tile_width, 32.0);
  EXPECT_EQ(tileset.tile_height, 16.0);
  EXPECT_EQ(tileset.tile_count, 8U);
  EXPECT_EQ(tileset.alignment->fraction, (Vec<2, double>(0.5, 0.5)));
  EXPECT_EQ(tileset.drawing_offset, (Vec<2, double>(0, 3)));
  EXPECT_FALSE(tileset.is_collection);
  EXPECT_EQ(tileset.tiles.at(5).shapes.size(), 2U);
  EXPECT_FALSE(tileset.tiles.at(5).width);
}

/// Tile 3 shows its whole image, tile 9 a part of it.
inline void expect_tileset_of_many_images(const TiledTileset& tileset) {
  EXPECT_TRUE(tileset.is_collection);
  EXPECT_FALSE(tileset.alignment);
  EXPECT_EQ(tileset.tiles.at(3).width, 64.0);
  EXPECT_EQ(tileset.tiles.at(3).height, 96.0);
  EXPECT_EQ(tileset.tiles.at(9).width, 10.0) << "the part of the image that the tile shows";
  EXPECT_EQ(tileset.tiles.at(9).height, 20.0);
}

inline void expect_template(const TiledTemplate& read) {
  ASSERT_TRUE(read.tileset);
  EXPECT_EQ(read.tileset->first_gid, 4U);
  EXPECT_EQ(read.tileset->source, "a.tsx");
  EXPECT_EQ(read.object.gid, 5U);
  EXPECT_EQ(read.object.width, 7.0);
}

}  // namespace graze::io
