// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/input_error.hpp>
#include <graze/io/tiled/json.hpp>

#include "io/tiled/same_content.hpp"

namespace graze::io::tiled_json_test {
namespace {

TiledMap read(std::string_view text) { return read_tiled_json_map({"m.tmj", text}); }

std::string error_of(std::string_view text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// The error of a map whose line 2 is one object with these fields.
std::string object_error(std::string_view fields) {
  return error_of("{\"type\": \"map\", \"layers\": [{\"type\": \"objectgroup\", \"objects\": [\n{" +
                  std::string(fields) + "}]}]}");
}

TEST(TiledJson, ReadsEveryFieldOfAnObject) {
  const TiledMap map =
      read(R"({"type": "map", "orientation": "isometric", "tilewidth": 64, "tileheight": 32, "layers": [
    {"type": "objectgroup", "name": "things", "offsetx": 3, "offsety": -4.5, "objects": [
      {"id": 7, "name": "box", "type": "crate", "gid": 2147483651, "x": 1.5, "y": -2, "width": 3, "height": 4e1,
       "rotation": -270, "template": "t/x.tj", "visible": false, "properties": [{"name": "a"}, {"name": "b"}]}]}]})");
  expect_every_field(map, "t/x.tj");
}

TEST(TiledJson, ReadsEveryOutline) {
  const TiledMap map = read(R"({"layers": [{"type": "objectgroup", "objects": [
    {"ellipse": false}, {"ellipse": true}, {"capsule": true}, {"point": true},
    {"polygon": [{"x": 0, "y": 0}, {"x": 8, "y": -2.5}, {"x": 1e1, "y": 4}]},
    {"polyline": [{"x": 0, "y": 0}, {"x": 8, "y": 0}]}, {"text": {"text": "Hello"}}]}]})");
  expect_every_outline(map);
}

TEST(TiledJson, KeepsGroupsAndCountsWhatItDoesNotRead) {
  const TiledMap map = read(R"({"type": "map", "properties": {"old": "style"}, "layers": [
    {"type": "tilelayer", "width": 1000000000, "height": 1000000000},
    {"type": "group", "name": "g", "parallaxx": 0.5, "layers": [{"type": "imagelayer"},
      {"type": "group", "name": "h", "layers": [{"type": "objectgroup", "name": "o", "objects": [{}]}]}]},
    {"type": "surprise"}]})");
  expect_groups(map, "1 custom property; 1 layer parallax; 1 image layer; 1 unknown layer; ");
}

using Gids = std::vector<std::uint32_t>;

TEST(TiledJson, ReadsTheCellsOfTileLayers) {
  const TiledMap map = read(R"({"type": "map", "layers": [
    {"type": "tilelayer", "width": 2, "height": 2, "x": 0, "y": 0, "data": [1, 0, 2147483650, 4294967295]},
    {"type": "tilelayer", "width": 2, "height": 1, "encoding": "base64", "compression": "", "data": "AQAAAAIAAIA="},
    {"type": "tilelayer", "chunks": [{"x": -16, "y": 32, "width": 1, "height": 2, "data": [5, 6]},
                                     {"x": 0, "y": 0, "width": 1, "height": 1, "data": [7]}]},
    {"type": "tilelayer", "width": 0, "height": 1, "data": []}]})");
  ASSERT_EQ(map.layers.size(), 4U);
  EXPECT_EQ(map.layers[0].cells.at(0).gids, (Gids{1, 0, 2147483650, 4294967295}));
  EXPECT_EQ(map.layers[0].cells.at(0).width, 2U);
  EXPECT_EQ(map.layers[1].cells.at(0).gids, (Gids{1, 2147483650}));
  expect_chunks(map.layers[2]);
}

TEST(TiledJson, RefusesCellsThatAreNone) {
  const auto error_with = [](const std::string& fields) {
    return error_of("{\"type\": \"map\", \"layers\": [{\"type\": \"tilelayer\", \"width\": 2, \"height\": 1,\n" +
                    fields + "}]}");
  };
  EXPECT_EQ(error_with("\"data\": [1, 2, 3]"),
            "m.tmj: line 2, column 9: there are 3 tiles here, but width times height is 2");
  EXPECT_EQ(error_with("\"data\": [1, 2.5]"),
            "m.tmj: line 2, column 13: \"data\" holds something else here; it must hold whole numbers from 0 to "
            "4294967295");
  EXPECT_NE(error_with("\"data\": [1, -2]").find("column 13"), std::string::npos);
  EXPECT_NE(error_with("\"data\": [1, 4294967296]").find("column 13"), std::string::npos);
  EXPECT_NE(error_with("\"data\": [1, \"2\"]").find("column 13"), std::string::npos);
  EXPECT_NE(error_with("\"data\": {}").find("it must be an array or a string"), std::string::npos);
  EXPECT_NE(error_with("\"encoding\": \"base64\", \"data\": \"AQAAAA==\"").find("has 4 bytes, but its cells need 8"),
            std::string::npos);
}

TEST(TiledJson, ReadsATilesetOfOneImage) {
  const TiledTileset tileset =
      read_tiled_json_tileset({"t.tsj", R"({"type": "tileset", "tilewidth": 32, "tileheight": 16,
    "tilecount": 8, "objectalignment": "center", "tileoffset": {"x": 0, "y": 3}, "image": "i.png",
    "tiles": [{"id": 5, "objectgroup": {"objects": [{}, {}]}}]})"});
  expect_tileset_of_one_image(tileset);
}

TEST(TiledJson, ReadsATilesetOfManyImagesNewAndOld) {
  for (const char* tiles : {R"([{"id": 3, "image": "a.png", "imagewidth": 64, "imageheight": 96},
                                {"id": 9, "image": "b.png", "imagewidth": 64, "imageheight": 96, "width": 10, "height": 20}])",
                            R"({"3": {"image": "a.png", "imagewidth": 64, "imageheight": 96},
                                "9": {"image": "b.png", "imagewidth": 64, "imageheight": 96, "width": 10, "height": 20}})"}) {
    const std::string text = R"({"tilewidth": 64, "tiles": )" + std::string(tiles) + "}";
    const TiledTileset tileset = read_tiled_json_tileset({"t.json", text});
    expect_tileset_of_many_images(tileset);
  }
  EXPECT_THROW(read_tiled_json_tileset({"t.json", R"({"tilewidth": 1, "tiles": {"x": {}}})"}), InputError);
}

TEST(TiledJson, ReadsATemplate) {
  const TiledTemplate read = read_tiled_json_template({"t.tj", R"({"type": "template",
    "tileset": {"firstgid": 4, "source": "a.tsx"}, "object": {"gid": 5, "width": 7}})"});
  expect_template(read);
  EXPECT_THROW(read_tiled_json_template({"t.tj", R"({"type": "template"})"}), InputError);
}

TEST(TiledJson, NamesThePlaceOfBrokenJson) {
  EXPECT_EQ(error_of("{\"type\": \"map\",\n \"layers\": [").rfind("m.tmj: line 2, column", 0), 0U);
  EXPECT_EQ(error_of("").rfind("m.tmj: line 1, column 1: ", 0), 0U);
  EXPECT_EQ(object_error("\"x\": 1e999").rfind("m.tmj: line 2, column 7: ", 0), 0U);
  EXPECT_EQ(object_error("\"x\": NaN").rfind("m.tmj: line 2, column 7: ", 0), 0U);
}

TEST(TiledJson, RefusesAnotherKindOfFile) {
  EXPECT_NE(error_of(R"({"type": "tileset"})").find("is a Tiled tileset, but a Tiled map is needed"),
            std::string::npos);
  EXPECT_NE(error_of(R"({"tilewidth": 3})").find("is a Tiled tileset"), std::string::npos);
  EXPECT_NE(error_of(R"({"type": "world"})").find("of the kind \"world\""), std::string::npos);
  EXPECT_NE(error_of("[1, 2]").find("the file holds an array, but a Tiled map is an object"), std::string::npos);
}

TEST(TiledJson, RefusesFieldsOfTheWrongKind) {
  EXPECT_EQ(object_error(R"("x": "5")"), "m.tmj: line 2, column 7: \"x\" is a string; it must be a number");
  EXPECT_EQ(object_error(R"("name": 5)"), "m.tmj: line 2, column 10: \"name\" is a number; it must be a string");
  EXPECT_EQ(object_error(R"("gid": -1)"),
            "m.tmj: line 2, column 9: \"gid\" must be a whole number from 0 to 4294967295");
  EXPECT_EQ(object_error(R"("gid": 4294967296)"),
            "m.tmj: line 2, column 9: \"gid\" must be a whole number from 0 to 4294967295");
  EXPECT_EQ(object_error(R"("id": 1.5)"),
            "m.tmj: line 2, column 8: \"id\" must be a whole number from 0 to 4294967295");
  EXPECT_EQ(error_of(R"({"type": "map", "layers": {}})"),
            "m.tmj: line 1, column 27: \"layers\" is an object; it must be an array");
  EXPECT_EQ(error_of(R"({"type": "map", "layers": [5]})"),
            "m.tmj: line 1, column 28: \"layers\" holds a number here; it must hold objects");
}

TEST(TiledJson, RefusesPointsThatAreNone) {
  EXPECT_EQ(object_error(R"("polygon": [{"x": 1}, {"x": 2, "y": 2}])"),
            "m.tmj: line 2, column 14: this point of the polygon needs both an x and a y");
  EXPECT_NE(object_error(R"("polygon": "0,0 1,1")").find("must be an array"), std::string::npos);
  EXPECT_NE(object_error(R"("polyline": [])").find("has 0 points; it needs at least 2"), std::string::npos);
}

TEST(TiledJson, RefusesNegativeSizes) {
  EXPECT_EQ(object_error(R"("name": "pit", "width": -3)"),
            "m.tmj: line 2, column 1: object \"pit\" has the width -3; it must be 0 or more");
}

TEST(TiledJson, RefusesDeepNesting) {
  std::string groups = R"({"type": "map", "layers": [)";
  for (int i = 0; i < 33; ++i) groups += R"({"type": "group", "layers": [)";
  for (int i = 0; i < 33; ++i) groups += "]}";
  EXPECT_NE(error_of(groups + "]}").find("nested deeper than 32 groups"), std::string::npos);
  EXPECT_NE(error_of(std::string(200'000, '[')).find("nested deeper"), std::string::npos);
}

}  // namespace
}  // namespace graze::io::tiled_json_test
