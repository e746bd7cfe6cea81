// SPDX-License-Identifier: MIT
#include <sstream>
#include <string>
#include <utility>
#include <variant>

#include <gtest/gtest.h>

#include <graze/io/json_scene.hpp>
#include <graze/io/output_error.hpp>
#include <graze/query/bounds.hpp>

namespace graze::io::json_scene_writer_test {
namespace {

using Scene2 = Scene<2, double>;
using V2 = Vec<2, double>;

SceneFile file_of(AnyScene scene, YAxis y_axis = YAxis::up) { return {std::move(scene), "a.json", "test", y_axis, {}}; }

std::string written(const SceneFile& file) {
  std::ostringstream out;
  write_json_scene(out, file);
  return out.str();
}

TEST(JsonSceneWriter, AnEmptySceneIsAFewLines) {
  EXPECT_EQ(written(file_of(Scene<3, double>{})),
            "{\n  \"schema\": \"graze.scene/1\",\n  \"dimension\": 3,\n  \"objects\": []\n}\n");
}

TEST(JsonSceneWriter, EveryObjectTakesOneLineAndDefaultsAreLeftOut) {
  Scene2 scene;
  scene.add(V2(1, 2));
  scene.add(Sphere<2, double>{{0, 0.5}, 1}, {.name = "ball \"a\"\\\n", .user = 7});
  EXPECT_EQ(written(file_of(std::move(scene), YAxis::down)), R"({
  "schema": "graze.scene/1",
  "dimension": 2,
  "y_axis": "down",
  "objects": [
    {"type": "point", "position": [1, 2]},
    {"name": "ball \"a\"\\\u000a", "type": "sphere", "center": [0, 0.5], "radius": 1, "user": 7}
  ]
}
)");
}

TEST(JsonSceneWriter, ANameMayHoldAZero) {
  const std::string name("a\0b", 3);
  Scene2 scene;
  scene.add(V2(1, 2), {.name = name});
  const std::string text = written(file_of(std::move(scene)));
  EXPECT_NE(text.find(R"({"name": "a\u0000b", )"), std::string::npos) << text;
  EXPECT_TRUE(std::get<Scene2>(parse_json_scene(text, "a.json").scene).find(name));
}

TEST(JsonSceneWriter, LayersAndMasksAreWrittenByName) {
  Scene2 scene;
  const Layer walls = scene.layer("walls");
  const Layer player = scene.layer("player");
  scene.add(V2(1, 2), {.name = "a", .layer = player, .mask = only_layer(walls)});
  scene.add(V2(3, 4), {.name = "b", .layer = walls, .mask = 0});
  EXPECT_EQ(written(file_of(std::move(scene))), R"({
  "schema": "graze.scene/1",
  "dimension": 2,
  "layers": ["walls", "player"],
  "objects": [
    {"name": "a", "type": "point", "position": [1, 2], "layer": "player", "mask": ["walls"]},
    {"name": "b", "type": "point", "position": [3, 4], "layer": "walls", "mask": []}
  ]
}
)");
}

TEST(JsonSceneWriter, LayersThatAProgramUsesByNumberGetNames) {
  Scene2 scene;
  scene.layer("layer 1");
  scene.add(V2(1, 2), {.name = "a", .layer = 2, .mask = only_layer(1)});
  EXPECT_EQ(written(file_of(std::move(scene))), R"({
  "schema": "graze.scene/1",
  "dimension": 2,
  "layers": ["layer 1", "layer 1'", "layer 2"],
  "objects": [
    {"name": "a", "type": "point", "position": [1, 2], "layer": "layer 2", "mask": ["layer 1'"]}
  ]
}
)");
}

TEST(JsonSceneWriter, RemovedObjectsAreNotWritten) {
  Scene2 scene;
  const ObjectId first = scene.add(V2(1, 2), {.name = "a"});
  scene.add(V2(3, 4), {.name = "b"});
  scene.remove(first);
  const std::string text = written(file_of(std::move(scene)));
  EXPECT_EQ(text.find("\"a\""), std::string::npos);
  EXPECT_NE(text.find("[\n    {\"id\": [1, 1], \"name\": \"b\""), std::string::npos);
}

TEST(JsonSceneWriter, WhatTheFormatCannotHoldIsRefusedByName) {
  Scene2 no_text;
  no_text.add(V2(1, 2), {.name = "a\xFF"});
  EXPECT_THROW(written(file_of(std::move(no_text))), OutputError);
  AnyShape<2, double> deep = V2(0, 0);
  for (int i = 0; i < 33; ++i) deep = compound_of<2, double>({deep});
  Scene2 too_deep;
  too_deep.add(deep, {.name = "onion"});
  try {
    written(file_of(std::move(too_deep)));
    ADD_FAILURE() << "no OutputError was thrown";
  } catch (const OutputError& error) {
    EXPECT_STREQ(error.what(),
                 "object \"onion\": compounds are nested deeper than 32, the most that the scene format allows");
  }
}

}  // namespace
}  // namespace graze::io::json_scene_writer_test
