// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/input_error.hpp>
#include <graze/io/tiled/fields.hpp>

namespace graze::io::tiled_fields_test {
namespace {

/// Fields as in XML and JSON: numbers and texts by name.
struct Node {
  TiledText file{"m.tmx", "<map/>"};
  std::map<std::string, double, std::less<>> numbers = {};
  std::map<std::string, std::string, std::less<>> texts = {};

  std::size_t offset() const { return 3; }
  TiledPlace place() const { return {file, offset()}; }
};

template <class Map>
std::optional<typename Map::mapped_type> find_in(const Map& map, std::string_view name) {
  const auto found = map.find(name);
  if (found == map.end()) return std::nullopt;
  return found->second;
}

std::optional<double> number_of(const Node& node, std::string_view name) { return find_in(node.numbers, name); }
std::optional<std::string> text_of(const Node& node, std::string_view name) { return find_in(node.texts, name); }
std::optional<std::uint32_t> index_of(const Node& node, std::string_view name) {
  const std::optional<double> number = number_of(node, name);
  if (!number) return std::nullopt;
  return static_cast<std::uint32_t>(*number);
}

TEST(TiledFields, ReadObjectsAndLeaveOutWhatIsNotSaid) {
  const TiledObject coin = tiled_object_of(Node{.numbers = {{"id", 7}, {"x", -2.5}, {"gid", 3}, {"rotation", 90}},
                                                .texts = {{"name", "coin"}, {"class", "gold"}}});
  EXPECT_EQ(coin.offset, 3U);
  EXPECT_EQ(coin.name, "coin");
  EXPECT_EQ(coin.id, 7U);
  EXPECT_EQ(coin.x, -2.5);
  EXPECT_EQ(coin.y, std::nullopt);
  EXPECT_EQ(coin.gid, 3U);
  EXPECT_EQ(coin.rotation, 90);
  EXPECT_TRUE(coin.has_class);
  EXPECT_TRUE(tiled_object_of(Node{.texts = {{"type", "gold"}}}).has_class) << "as Tiled 1.8 and older call it";
  EXPECT_FALSE(tiled_object_of(Node{.texts = {{"type", ""}}}).has_class);
}

TEST(TiledFields, ReadTilesets) {
  const TiledTileset usual = tiled_tileset_of(Node{});
  EXPECT_EQ(usual.first_gid, 1U);
  EXPECT_FALSE(usual.alignment || usual.fills_grid || usual.keeps_aspect);
  const TiledTileset other = tiled_tileset_of(
      Node{.numbers = {{"firstgid", 5}, {"tilewidth", 8}, {"tilecount", 4}},
           .texts = {{"tilerendersize", "grid"}, {"fillmode", "preserve-aspect-fit"}, {"objectalignment", "top"}}});
  EXPECT_EQ(other.first_gid, 5U);
  EXPECT_EQ(other.tile_width, 8);
  EXPECT_EQ(other.tile_count, 4U);
  EXPECT_TRUE(other.alignment && other.fills_grid && other.keeps_aspect);
}

TEST(TiledFields, ReadLayersAndCountTheirParallax) {
  std::vector<Omission> omissions;
  const TiledLayer layer =
      tiled_layer_of(Node{.numbers = {{"offsetx", 4}, {"offsety", -1}}, .texts = {{"name", "sky"}}}, omissions);
  EXPECT_EQ(layer.name, "sky");
  EXPECT_EQ(layer.shift, (Vec<2, double>(4, -1)));
  EXPECT_TRUE(omissions.empty());
  tiled_layer_of(Node{.numbers = {{"parallaxy", 0.5}}}, omissions);
  ASSERT_EQ(omissions.size(), 1U);
  EXPECT_EQ(omissions[0].what, "layer parallax");
}

TEST(TiledFields, ReadGridsThatCanBePlaced) {
  Node map{.numbers = {{"tilewidth", 8}, {"tileheight", 4}}, .texts = {{"staggeraxis", "x"}, {"staggerindex", "even"}}};
  const TiledGrid grid = tiled_grid_of(map);
  EXPECT_EQ(grid.orientation, "orthogonal");
  EXPECT_EQ(grid.tile_height, 4);
  EXPECT_TRUE(grid.staggers_x && grid.shifts_even);
  map.numbers["tilewidth"] = -8;
  EXPECT_THROW(tiled_grid_of(map), InputError);
}

TEST(TiledFields, ReadCellsThatBeginAnywhere) {
  const TiledCells cells = tiled_cells_of(Node{.numbers = {{"x", -16}, {"width", 16}}});
  EXPECT_EQ(cells.x, -16);
  EXPECT_EQ(cells.y, 0);
  EXPECT_EQ(cells.width, 16U);
  EXPECT_THROW(tiled_cells_of(Node{.numbers = {{"y", 0.5}}}), InputError);
}

}  // namespace
}  // namespace graze::io::tiled_fields_test
