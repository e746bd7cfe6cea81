// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <string_view>
#include <variant>

#include <gtest/gtest.h>

#include <graze/io/scene_file.hpp>

#include "scene_text.hpp"
#include "tiled_folder.hpp"

namespace graze::io::scene_file_test {
namespace {

SceneFile parse(const std::string& text) { return parse_scene(text, "a file", "."); }

std::string refusal(const std::string& text) {
  return error_of([&text] { parse(text); });
}

std::string refusal_of_file(const std::filesystem::path& path) {
  return error_of([&path] { read_scene(path); });
}

const std::string csv = "id,min_x,min_y,max_x,max_y\na,0,0,1,1\n";
const std::string tmx = R"(<?xml version="1.0"?><map version="1.10" orientation="orthogonal" width="1" height="1" )"
                        R"(tilewidth="16" tileheight="16"><objectgroup id="1" name="o"></objectgroup></map>)";
const std::string tmj = R"({"type": "map", "version": "1.10", "orientation": "orthogonal", "width": 1, "height": 1, )"
                        R"("tilewidth": 16, "tileheight": 16, "layers": [], "tilesets": []})";

TEST(SceneFile, FormatsAreToldApartByContent) {
  for (const std::string before : {"", "\xEF\xBB\xBF", " \r\n\t", "\xEF\xBB\xBF\n"}) {
    EXPECT_EQ(parse(before + scene_2d("")).format, "graze.scene/1");
    EXPECT_EQ(parse(before + csv).format, "csv");
  }
  EXPECT_EQ(parse(tmx).format, "tiled");
  EXPECT_EQ(parse(tmj).format, "tiled");
}

TEST(SceneFile, MeshFilesAreScenesOfTheirParts) {
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\no a\nf 1 2 3\no b\nf 1 2 3\n";
  const SceneFile file = parse(obj);
  EXPECT_EQ(file.format, "obj");
  const auto& scene = std::get<Scene<3, double>>(file.scene);
  ASSERT_EQ(scene.size(), 2U);
  EXPECT_EQ(scene.pairs().size(), 1U);
  EXPECT_TRUE(scene.find("b"));
  EXPECT_EQ(parse("OFF\n0 0 0\n").format, "off");
  EXPECT_EQ(parse("solid a\nendsolid a\n").format, "stl");
  EXPECT_EQ(parse(R"({"asset": {"version": "2.0"}})").format, "gltf");
}

TEST(SceneFile, ClosedMeshesBecomeSolidsIfThatIsWanted) {
  const std::string off = "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  const auto kind_of = [](const SceneFile& file) {
    const auto& scene = std::get<Scene<3, double>>(file.scene);
    return std::get<Mesh<3, double>>(scene.object(scene.ids().front()).shape).kind();
  };
  EXPECT_EQ(kind_of(parse(off)), MeshKind::surface);
  EXPECT_EQ(kind_of(parse_scene(off, "a file", ".", {MeshKind::solid})), MeshKind::solid);
}

TEST(SceneFile, WhatIsNoSceneIsRefusedWithTheListOfFormats) {
  EXPECT_EQ(
      refusal("hello\nworld, x"),
      "a file: not a scene; graze reads its own JSON (begins with {), CSV (begins with a line like "
      "id,min_x,min_y,max_x,max_y or x,y,radius), maps of Tiled, .tmx or .tmj (begin with < or {), and meshes in STL, "
      "OBJ, PLY, OFF and glTF 2.0 (.gltf, .glb)");
  EXPECT_EQ(refusal("\x01\x02\r\n").find("a file: not a scene; graze reads"), 0U);
  EXPECT_EQ(refusal("[gd_scene format=3]\n").find("a file: this is a Godot scene; "), 0U);
  EXPECT_EQ(refusal(std::string("\xFF\xFE{\0", 4)), "a file: this is UTF-16; save it as UTF-8");
  EXPECT_EQ(refusal("[1]"), "a file: line 1, column 1: a scene is a JSON object, not an array");
  EXPECT_EQ(refusal(R"({"type": "other"})").find("a file: line 1, column 1: there is no \"schema\""), 0U);
}

TEST(SceneFile, EmptyTextIsRefused) {
  for (const std::string text : {"", " \n\t\r\n", "\xEF\xBB\xBF"}) {
    EXPECT_EQ(refusal(text), "a file: this is empty; a scene needs at least its header");
  }
}

TEST(SceneFile, FilesWithSpacesAndUmlautsAreRead) {
  const TiledFolder folder;
  folder.write(
      "gr\xC3\xB6\xC3\x9F"
      "e 1.txt",
      csv);
  const std::filesystem::path path = folder.path() /
                                     "gr\xC3\xB6\xC3\x9F"
                                     "e 1.txt";
  const SceneFile file = read_scene(path);
  EXPECT_EQ(file.source, path.string());
  EXPECT_EQ((std::get<Scene<2, double>>(file.scene).size()), 1U);
}

TEST(SceneFile, FilesThatCannotBeReadAreNamedWithTheReason) {
  const TiledFolder folder;
  const std::filesystem::path missing = folder.path() / "none.json";
  EXPECT_EQ(refusal_of_file(missing), missing.string() + ": there is no such file");
  EXPECT_EQ(refusal_of_file(folder.path()), folder.path().string() + ": this is a folder; give the scene file in it");
  folder.write("empty.json", "");
  EXPECT_EQ(refusal_of_file(folder.path() / "empty.json"),
            (folder.path() / "empty.json").string() + ": this is empty; a scene needs at least its header");
  EXPECT_EQ(refusal_of_file(folder.path() / std::string(5000, 'x')).find(folder.path().string()), 0U);
  std::filesystem::create_symlink("round.json", folder.path() / "round.json");
  EXPECT_NE(refusal_of_file(folder.path() / "round.json").find(": cannot be read: "), std::string::npos);
}

TEST(SceneFile, AProtectedFileIsNamedWithTheReason) {
  const TiledFolder folder;
  folder.write("a.csv", csv);
  const std::filesystem::path path = folder.path() / "a.csv";
  std::filesystem::permissions(path, std::filesystem::perms::none);
  if (std::ifstream(path)) GTEST_SKIP() << "this user may read protected files";
  EXPECT_EQ(refusal_of_file(path), path.string() + ": cannot be opened: Permission denied");
}

TEST(SceneFile, TheWorkshopHoldsEveryTypeOfShapeButMeshesAndSomeDozensOfPairs) {
  const SceneFile file = read_scene(project_file("data/workshop.json"));
  const auto& scene = std::get<Scene<3, double>>(file.scene);
  std::set<std::string_view> types;
  for (const ObjectId id : scene.ids()) types.insert(type_name<3, double>(scene.object(id).shape));
  types.insert("mesh");
  EXPECT_EQ(types.size(), shape_type_names.size());
  EXPECT_EQ(scene.size(), 345U);
  EXPECT_EQ(scene.pairs().size(), 62U);
}

}  // namespace
}  // namespace graze::io::scene_file_test
