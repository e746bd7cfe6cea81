// SPDX-License-Identifier: MIT
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <graze/io/json/document.hpp>
#include <graze/io/json_scene.hpp>

#include "io/scene_text.hpp"

namespace graze::io::json_scene_reader_test {
namespace {

using Scene2 = Scene<2, double>;

Scene2 read_2d(const std::string& text) { return std::get<Scene2>(parse_json_scene(text, "a.json").scene); }

const Object<2, double>& named(const Scene2& scene, const std::string& name) {
  return scene.object(scene.find(name).value());
}

std::string refusal(const std::string& text) {
  return error_of([&text] { parse_json_scene(text, "a.json"); });
}

const std::string dot = R"("type": "point", "position": [0, 0])";

TEST(JsonSceneReader, TheDocumentsFieldsAreRead) {
  const SceneFile flat = parse_json_scene(
      R"({"objects": [], "y_axis": "down", "dimension": 2, "schema": "graze.scene/1"})", "a folder/b.json");
  EXPECT_EQ(flat.source, "a folder/b.json");
  EXPECT_EQ(flat.format, "graze.scene/1");
  EXPECT_EQ(flat.y_axis, YAxis::down);
  EXPECT_TRUE(flat.omissions.empty());
  EXPECT_EQ(std::get<Scene2>(flat.scene).size(), 0U);
  const SceneFile space = parse_json_scene(scene_3d(R"({"type": "point", "position": [1, 2, 3]})"), "b.json");
  EXPECT_EQ(space.y_axis, YAxis::up);
  EXPECT_EQ((std::get<Scene<3, double>>(space.scene).size()), 1U);
}

TEST(JsonSceneReader, ADocumentThatHasBeenParsedGivesTheSameScene) {
  const std::string text = scene_2d("{" + dot + "}");
  const JsonDocument document(text, "b.json");
  const SceneFile file = read_json_scene(document);
  EXPECT_EQ(file.source, "b.json");
  EXPECT_TRUE(std::get<Scene2>(file.scene).find("#0").has_value());
}

TEST(JsonSceneReader, ObjectsWithoutANameAreCalledByTheirIndex) {
  const Scene2 scene = read_2d(scene_2d("{" + dot + R"(}, {"name": "#2", )" + dot + "}, {" + dot + "}"));
  EXPECT_EQ(scene.object(scene.ids()[0]).name, "#0");
  EXPECT_EQ(scene.object(scene.ids()[1]).name, "#2");
  EXPECT_EQ(scene.object(scene.ids()[2]).name, "#2-2");
}

TEST(JsonSceneReader, LayersAreNumberedAsTheyAppear) {
  const Scene2 scene = read_2d(scene_2d(R"({"name": "a", "layer": "walls", "mask": ["player"], )" + dot +
                                        R"(}, {"name": "b", "layer": "player", "user": 18446744073709551615, )" + dot +
                                        R"(}, {"name": "c", "mask": [], )" + dot + "}"));
  EXPECT_EQ(scene.layer_names(), (std::vector<std::string>{"walls", "player", "default"}));
  EXPECT_EQ(named(scene, "a").layer, 0);
  EXPECT_EQ(named(scene, "a").mask, 0b010U);
  EXPECT_EQ(named(scene, "a").user, 0U);
  EXPECT_EQ(named(scene, "b").layer, 1);
  EXPECT_EQ(named(scene, "b").mask, all_layers);
  EXPECT_EQ(named(scene, "b").user, 18446744073709551615U);
  EXPECT_EQ(named(scene, "c").layer, 2);
  EXPECT_EQ(named(scene, "c").mask, 0U);
}

TEST(JsonSceneReader, AListOfLayersFixesTheirNumbers) {
  const std::string head = R"({"schema": "graze.scene/1", "dimension": 2, "layers": ["walls", "player"], "objects": [)";
  const Scene2 scene =
      read_2d(head + R"({"name": "a", "layer": "player", )" + dot + R"(}, {"name": "b", )" + dot + "}]}");
  EXPECT_EQ(scene.layer_names(), (std::vector<std::string>{"walls", "player", "default"}));
  EXPECT_EQ(named(scene, "a").layer, 1);
  EXPECT_EQ(named(scene, "b").layer, 2);
  EXPECT_EQ(
      refusal(head + R"({"name": "a", "layer": "plaier", )" + dot + "}]}"),
      R"(a.json: line 1, column 111: object 0 "a": the layer "plaier" is not in "layers"; did you mean "player"?)");
  EXPECT_NE(refusal(head + R"({"mask": ["wals"], )" + dot + "}]}").find(R"(the layer "wals" is not in "layers"; did)"),
            std::string::npos);
}

TEST(JsonSceneReader, WithoutLayersAllIsOnTheFirstOne) {
  const Scene2 scene = read_2d(scene_2d("{" + dot + "}"));
  EXPECT_TRUE(scene.layer_names().empty());
  EXPECT_EQ(named(scene, "#0").layer, 0);
  EXPECT_EQ(named(scene, "#0").mask, all_layers);
}

std::string layer_list(std::size_t count) {
  std::string text = R"({"schema": "graze.scene/1", "dimension": 2, "objects": [], "layers": [)";
  for (std::size_t i = 0; i < count; ++i) text += (i == 0 ? "\"" : ", \"") + std::to_string(i) + '"';
  return text + "]}";
}

TEST(JsonSceneReader, ThereAreAtMost64Layers) {
  EXPECT_EQ(read_2d(layer_list(64)).layer_names().size(), 64U);
  EXPECT_NE(refusal(layer_list(65)).find(R"(the layer "64" is one too many; a scene has at most 64)"),
            std::string::npos);
}

TEST(JsonSceneReader, TwoObjectsOfOneNameAreBothNamed) {
  EXPECT_EQ(refusal("{\"schema\": \"graze.scene/1\", \"dimension\": 2, \"objects\": [\n{\"name\": \"ball\", " + dot +
                    "},\n{" + dot + "},\n{\"name\": \"ball\", " + dot + "}]}"),
            R"(a.json: line 4, column 10: object 2: the name "ball" is taken by object 0; names must be unique)");
}

TEST(JsonSceneReader, OtherSchemasAreRefusedWithTheReason) {
  const std::vector<std::pair<std::string, std::string>> table = {
      {R"({"schema": "graze.scene/2", "new": 1})",
       R"(a.json: line 1, column 12: "schema" is "graze.scene/2": written by a newer graze; this one reads "graze.scene/1")"},
      {R"({"schema": "graze.scene/99999999999999999999"})",
       R"(a.json: line 1, column 12: "schema" is "graze.scene/99999999999999999999": written by a newer graze; )"
       R"(this one reads "graze.scene/1")"},
      {R"({"schema": "graze.scene/0"})",
       R"(a.json: line 1, column 12: "schema" is "graze.scene/0", which is not a scene; a scene has "graze.scene/1")"},
      {R"({"schema": "graze.check/1"})",
       R"(a.json: line 1, column 12: "schema" is "graze.check/1", which is not a scene; a scene has "graze.scene/1")"},
      {R"({"schema": 1})", R"(a.json: line 1, column 12: "schema" must be a string, not a number)"},
      {R"({"dimension": 2})",
       R"(a.json: line 1, column 1: there is no "schema"; a graze scene has "schema": "graze.scene/1")"},
      {"[]", "a.json: line 1, column 1: a scene is a JSON object, not an array"},
  };
  for (const auto& [text, expected] : table) EXPECT_EQ(refusal(text), expected) << text;
}

TEST(JsonSceneReader, WrongDocumentFieldsAreNamed) {
  const std::string begin = R"({"schema": "graze.scene/1", )";
  const std::vector<std::pair<std::string, std::string>> table = {
      {R"("objects": []})", R"(column 1: there is no "dimension"; give 2 or 3)"},
      {R"("dimension": 4, "objects": []})", R"(column 42: "dimension" is 4; it must be 2 or 3)"},
      {R"("dimension": "2", "objects": []})", R"(column 42: "dimension" must be a number, not a string)"},
      {R"("dimension": 2})", R"(column 1: a scene needs the field "objects")"},
      {R"("dimension": 2, "objects": {}})", R"(column 56: "objects" must be an array, not an object)"},
      {R"("dimension": 2, "objects": [3]})", "column 57: object 0: must be an object, not a number"},
      {R"("dimension": 2, "objcts": []})", R"(column 45: unknown field "objcts"; did you mean "objects"?)"},
      {R"("dimension": 2, "y_axis": "left", "objects": []})",
       R"(column 55: "y_axis" is "left"; it must be "up" or "down")"},
      {R"("dimension": 3, "y_axis": "up", "objects": []})",
       R"(column 55: "y_axis" is for scenes of dimension 2 only; leave it out)"},
      {R"("dimension": 2, "layers": "a", "objects": []})", R"(column 55: "layers" must be an array, not a string)"},
      {R"("dimension": 2, "layers": [1], "objects": []})", R"(column 56: "layers"[0] must be a string, not a number)"},
      {R"("dimension": 2, "layers": ["a", "a"], "objects": []})", R"(column 61: "layers" names "a" twice)"},
      {R"("dimension": 2, "layers": [""], "objects": []})", R"(column 56: a layer in "layers" has an empty name)"},
  };
  for (const auto& [text, expected] : table) EXPECT_EQ(refusal(begin + text), "a.json: line 1, " + expected) << text;
}

TEST(JsonSceneReader, WrongObjectFieldsAreNamed) {
  const std::vector<std::pair<std::string, std::string>> table = {
      {R"("name": 5)", R"(103: object 0: "name" must be a string, not a number)"},
      {R"("name": null)", R"(103: object 0: "name" must be a string, not null)"},
      {R"("name": "")", R"(103: object 0: "name" is empty; give a name or leave the field out)"},
      {R"("layer": 5)", R"(104: object 0: "layer" must be a string, not a number)"},
      {R"("layer": "")", "104: object 0: a layer's name is empty; give a name or leave the field out"},
      {R"("mask": "a")", R"(103: object 0: "mask" must be an array, not a string)"},
      {R"("mask": [5])", R"(104: object 0: "mask"[0] must be a string, not a number)"},
      {R"("user": -5)", R"(103: object 0: "user" is -5; it must be a whole number from 0 to 18446744073709551615)"},
      {R"("usr": 5)", R"(95: object 0: unknown field "usr"; did you mean "user"?)"},
  };
  for (const auto& [text, expected] : table) {
    EXPECT_EQ(refusal(scene_2d("{" + dot + ", " + text + "}")), "a.json: line 1, column " + expected);
  }
}

TEST(JsonSceneReader, WhatIsFixedIsNoPairWithWhatIsFixed) {
  const Scene2 scene = read_2d(
      scene_2d("{" + dot + R"(, "fixed": true}, {)" + dot + R"(, "fixed": true}, {)" + dot + R"(, "fixed": false})"));
  EXPECT_EQ(scene.object(scene.ids()[0]).mobility, Mobility::fixed);
  EXPECT_EQ(scene.object(scene.ids()[2]).mobility, Mobility::moving);
  EXPECT_EQ(scene.pairs().size(), 2U);
  EXPECT_EQ(refusal(scene_2d("{" + dot + R"(, "fixed": 1})")),
            "a.json: line 1, column 104: object 0: \"fixed\" is a number; it must be true or false");
}

TEST(JsonSceneReader, ExceptedPairsAreReadByNameAndNumberAndWrittenAgain) {
  const auto with_pairs = [](const std::string& pairs) {
    return R"({"schema": "graze.scene/1", "dimension": 2, "excepted_pairs": )" + pairs +
           R"(, "objects": [{"name": "a", )" + dot + R"(}, {"name": "b", )" + dot + "}, {" + dot + "}]}";
  };
  const Scene2 scene = read_2d(with_pairs(R"([["b", "a"], [2, "b"]])"));
  const std::vector<ObjectId> ids = scene.ids();
  EXPECT_EQ(scene.excepted_pairs(), (std::vector<ObjectPair>{{ids[0], ids[1]}, {ids[1], ids[2]}}));
  EXPECT_EQ(scene.pairs(), (std::vector<ObjectPair>{{ids[0], ids[2]}}));
  EXPECT_EQ(read_2d(with_pairs(R"([["#2", "b"]])")).excepted_pairs().size(), 1U);
  Scene2 changed;
  for (int k = 0; k < 4; ++k) changed.add(Vec<2, double>(0, 0), {.name = k == 1 ? "one" : ""});
  changed.remove(changed.ids()[0]);
  const std::vector<ObjectId> left = changed.ids();
  changed.except(left[2], left[0]);
  changed.except(left[2], left[1]);
  std::ostringstream out;
  write_json_scene(out, {changed, "a.json", "test", YAxis::up, {}, {}});
  EXPECT_NE(out.str().find(R"("excepted_pairs": [["one", 2], [1, 2]],)"), std::string::npos) << out.str();
  const Scene2 again = read_2d(out.str());
  EXPECT_EQ(again.excepted_pairs().size(), 2U);
  EXPECT_TRUE(again.excepted(*again.find(1, 1), *again.find(3, 1)));
  EXPECT_TRUE(again.excepted(*again.find(2, 1), *again.find(3, 1)));
  const std::vector<std::pair<std::string, std::string>> table = {
      {R"({})", R"("excepted_pairs" must be an array, not an object)"},
      {R"([["a"]])", R"("excepted_pairs"[0] must name two different objects)"},
      {R"([["a", "b"], ["a", 0]])", R"("excepted_pairs"[1] must name two different objects)"},
      {R"([["a", "b", 2]])", R"("excepted_pairs"[0] must name two different objects)"},
      {R"([["a", "B"]])", R"(there is no object "B"; did you mean "b"?)"},
      {R"([["a", 3]])", R"(there is no object 3; the scene has 3)"},
      {R"([["a", 1.5]])", R"("excepted_pairs"[0])"},
  };
  for (const auto& [pairs, expected] : table) {
    EXPECT_NE(refusal(with_pairs(pairs)).find(expected), std::string::npos) << refusal(with_pairs(pairs));
  }
}

TEST(JsonSceneReader, TheDoorOfTheDocumentationTouchesNothing) {
  const std::string page = text_of(project_file("docs/scene_format.md"));
  const Scene2 scene = read_2d(code_block(page.substr(page.find("## Excepted pairs")), "json"));
  EXPECT_EQ(scene.excepted_pairs().size(), 2U);
  EXPECT_TRUE(scene.pairs().empty());
  Scene2 accepting = scene;
  for (const auto& [a, b] : scene.excepted_pairs()) accepting.accept(a, b);
  EXPECT_EQ(accepting.pairs().size(), 2U);
}

TEST(JsonSceneReader, VelocitiesComeBesideTheSceneAndAreWrittenAgain) {
  const std::string text = scene_2d("{" + dot + "}, {" + dot + R"(, "velocity": [1, -2.5]})");
  const SceneFile file = parse_json_scene(text, "a.json");
  ASSERT_EQ(file.velocities.size(), 1U);
  EXPECT_EQ(file.velocities[0].id, std::get<Scene2>(file.scene).ids()[1]);
  EXPECT_EQ(file.velocities[0].velocity, (Vec<3, double>(1, -2.5, 0)));
  std::ostringstream out;
  write_json_scene(out, file);
  EXPECT_NE(out.str().find(R"([0, 0], "velocity": [1, -2.5]})"), std::string::npos) << out.str();
  EXPECT_EQ(parse_json_scene(out.str(), "b.json").velocities.size(), 1U);
  EXPECT_NE(refusal(scene_2d("{" + dot + R"(, "velocity": [1]})")).find(R"("velocity" has 1 number)"),
            std::string::npos);
}

TEST(JsonSceneReader, ThePlaceOfAMistakeIsCountedInTheWholeFile) {
  EXPECT_EQ(refusal("{\"schema\": \"graze.scene/1\",\n\"dimension\": 2, \"objects\": [\n" + ("{" + dot + "},\n") +
                    R"({"name": "ball", "type": "sphere", "center": [1, 2], "raduis": 2}]})"),
            R"(a.json: line 4, column 54: object 1 "ball": unknown field "raduis"; did you mean "radius"?)");
}

TEST(JsonSceneReader, TheJsonSchemaHasTheSameFieldsAroundTheShapes) {
  const auto schema = nlohmann::json::parse(text_of(project_file("data/scene.schema.json")));
  std::vector<std::string> document_fields;
  for (const auto& entry : schema.at("properties").items()) document_fields.push_back(entry.key());
  EXPECT_EQ(document_fields, (std::vector<std::string>{"dimension", "excepted_pairs", "layers", "objects", "schema",
                                                       "vacant_ids", "y_axis"}));
  std::vector<std::string> object_fields;
  for (const auto& entry : schema.at("$defs").at("object_options").at("properties").items()) {
    object_fields.push_back(entry.key());
  }
  EXPECT_EQ(object_fields, (std::vector<std::string>{"fixed", "id", "layer", "mask", "name", "user", "velocity"}));
  EXPECT_EQ(schema.at("properties").at("schema").at("const"), json_scene_schema);
  EXPECT_EQ(schema.at("properties").at("layers").at("maxItems"), max_layers);
}

}  // namespace
}  // namespace graze::io::json_scene_reader_test
