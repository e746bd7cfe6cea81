// SPDX-License-Identifier: MIT
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/text/foreign_format.hpp>

#include "io/scene_text.hpp"

namespace graze::io::foreign_format_test {
namespace {

using namespace std::string_literals;

TEST(ForeignFormat, IsNamedWithTheWayOut) {
  const std::vector<std::pair<std::string, std::string>> table = {
      {R"({"type":"tileset","name":"a"})", "this is a Tiled tileset; give the map (.tmx or .tmj) that uses it"},
      {R"({ "columns":2, "tilecount" : 4})", "this is a Tiled tileset; give the map"},
      {R"({"object": {}, "type" : "template"})", "this is a Tiled template, a single object; give the map"},
      {R"({"maps": [], "type": "world"})", "this is a Tiled world; give one of the maps"},
      {"{\"schema\": \"graze.log/1\"}\n{\"call\": \"update\"}", "this is a query log; run it with graze replay"},
      {"{\n  \"schema\": \"graze.check/1\"", "this is a report of graze check; give the scene"},
      {R"({"a": "x", "b": "y", "relation": "touching"})", "this is a report of graze check"},
      {"a,b,relation\nx,y,touching\n", "this is a report of graze check"},
      {"A         B      RELATION\n", "this is a report of graze check"},
      {R"({"frame": 0, "seconds": 0.01, "touching": 1})", "this is a report of graze simulate"},
      {"\n[gd_scene format=3]\n", "this is a Godot scene; write its collision shapes as graze's JSON or CSV"},
      {"<?xml version=\"1.0\"?><!-- a --><robot name=\"r\">", "this is a robot in URDF; write its collision shapes"},
      {"<!DOCTYPE html><html>", "this is a web page"},
      {"<svg:svg xmlns:svg=\"a\">", "this is an SVG picture"},
      {"<tileset name=\"a\"/>", "this is a Tiled tileset; give the map"},
      {"<0\xff", "this is XML whose root is <0\xef\xbf\xbd>; the only XML"},
      {"<menu/>", "this is XML whose root is <menu>; the only XML that graze reads are Tiled maps"},
      {"(function(name,data){\n if(",
       "this is a map that Tiled exported as JavaScript; give the map itself (.tmx), or"},
      {"return {\n  version = \"1.10\",", "this is Lua, as Tiled exports its maps"},
      {"# .PCD v0.7\nVERSION 0.7\n", "this is a point cloud in PCD"},
      {"#usda 1.0\n", "this is a scene in USD"},
      {"POLYGON ((30 10, 40 40))", "this is geometry in WKT"},
      {"# made by me\nx,y,radius\n",
       "this is text that begins with a comment (#); remove it: no scene that graze reads"},
      {"// made by me\n{}", "this is text that begins with a comment (//); remove it"},
      {"[physics]\ngravity=9\n", "this is INI or TOML; write its collision shapes"},
      {"[a.b-2]\r\n", "this is INI or TOML"},
      {R"({"ogmoVersion": "3.3.0", "layers": []})", "this is an Ogmo level or project"},
      {R"({"automappingRulesFile": ""})", "this is a Tiled project; give one of its maps"},
      {"{\n\"classname\" \"worldspawn\"\n}", "this is a Quake map"},
      {"\x1f\x8b\x08", "this is compressed by gzip; unpack it first"},
      {"\xff\xfe{\0\"\0"s, "this is UTF-16; save it as UTF-8"},
      {"{\0\"\0s\0"s, "this is UTF-16; save it as UTF-8"},
      {"\0{\0\"\0s"s, "this is UTF-16; save it as UTF-8"},
      {"\xff\xfe\0\0{\0\0\0"s, "this is UTF-32; save it as UTF-8"}};
  for (const auto& [text, expected] : table) EXPECT_EQ(foreign_format(text).find(expected), 0U) << text;
}

TEST(ForeignFormat, IsNoneOfWhatMayBeAScene) {
  for (const std::string text : {R"({"schema": "graze.scene/1", "dimension": 2)", R"({"type": "map", "tilecount": 4)",
                                 R"({"height": 1, "layers": [{"type": "tilelayer"}], "tilesets": [{"tilecount": 4}])",
                                 "<?xml version=\"1.0\"?>\n<map version=\"1.10\">", "<", "{", "[1]", "[1e5]", "[true]",
                                 "[null]", "[[a]]", "[]", "", "id,min_x\n", "x,y,radius\n", "hello", "<!-- no end"}) {
    EXPECT_EQ(foreign_format(text), "") << text;
  }
}

TEST(ForeignFormat, IsNoneOfTheBundledScenes) {
  for (const std::string name : {"platform_level.tmx", "workshop.json", "crossing.json"}) {
    EXPECT_EQ(foreign_format(text_of(project_file("data/" + name))), "") << name;
  }
}

}  // namespace
}  // namespace graze::io::foreign_format_test
