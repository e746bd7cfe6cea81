// SPDX-License-Identifier: MIT
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <graze/io/json_scene.hpp>
#include <graze/io/scene_file.hpp>

#include "io/mesh_text.hpp"
#include "io/scene_text.hpp"
#include "io/tiled_folder.hpp"

namespace graze::io::json_mesh_files_test {
namespace {

const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 1 0\no left\nf 1 2 3\no right\nf 2 4 1\n";

/// The meshes of a scene with these objects, beside which are the files.
std::vector<Mesh<3, double>> meshes(const std::string& objects) {
  const TiledFolder folder;
  folder.write("parts/a.obj", obj);
  folder.write("broken.off", "OFF\n1 0\n0 0");
  const SceneFile file = parse_scene(scene_3d(objects), "scene.json", folder.path());
  const auto& scene = std::get<Scene<3, double>>(file.scene);
  std::vector<Mesh<3, double>> result;
  for (const ObjectId id : scene.ids()) result.push_back(std::get<Mesh<3, double>>(scene.object(id).shape));
  return result;
}

std::string refusal(const std::string& object) {
  return error_of([&object] { meshes(object); });
}

TEST(JsonMeshFiles, AllPartsOrThoseOfANameAreRead) {
  const auto all = meshes(R"({"type": "mesh", "file": "parts/a.obj", "name": "a"})");
  EXPECT_EQ(all.at(0).faces().size(), 2U);
  EXPECT_EQ(all.at(0).vertices().size(), 6U);
  EXPECT_EQ(all.at(0).kind(), MeshKind::surface);
  const auto right = meshes(R"({"type": "mesh", "file": "parts/../parts/a.obj", "part": "right", "layer": "b"})");
  EXPECT_EQ(points_of(right.at(0)), (MeshPoints{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

TEST(JsonMeshFiles, EqualReferencesShareTrianglesAndSolidsAreWelded) {
  const std::string object = R"({"type": "mesh", "file": "parts/a.obj")";
  const std::string other_path = R"({"type": "mesh", "file": "./parts/a.obj"})";
  const auto read = meshes(object + "}, " + other_path + ", " + object + R"(, "kind": "solid"})");
  EXPECT_EQ(detail::placed(read.at(0)).data(), detail::placed(read.at(1)).data());
  EXPECT_EQ(read.at(2).kind(), MeshKind::solid);
  EXPECT_EQ(read.at(2).vertices().size(), 3U);
}

TEST(JsonMeshFiles, WhatIsNotReadOfAFileIsReportedOnce) {
  const TiledFolder folder;
  folder.write("a.obj", obj + "l 1 2\n");
  const std::string object = R"({"type": "mesh", "file": "a.obj", "part": ")";
  const SceneFile file =
      parse_scene(scene_3d(object + R"(left"}, )" + object + R"(right"})"), "scene.json", folder.path());
  ASSERT_EQ(file.omissions.size(), 1U);
  EXPECT_EQ(file.omissions[0].what, "line");
  EXPECT_EQ(file.omissions[0].loss, Loss::shape);
}

TEST(JsonMeshFiles, FaultsAreRefusedWithTheirPlace) {
  const std::vector<std::pair<std::string, std::string>> table = {
      {R"("file": "none.obj")",
       "object 0: \"file\" is \"none.obj\", which cannot be read: there is no such file; it is relative to the scene"},
      {R"("file": 7)", "object 0: \"file\" must be a string, not a number"},
      {R"("file": "parts/a.obj", "part": "rihgt")",
       "object 0: \"part\" is \"rihgt\", but the file has no part of that name; did you mean \"right\"?"},
      {R"("file": "parts/a.obj", "vertices": [])", "object 0: unknown field \"vertices\""},
      {R"("file": "parts/a.obj", "kind": "hollow")", "object 0: \"kind\" is \"hollow\"; a mesh is a \"surface\" or a"},
      {R"("file": "broken.off")", "object 0: \"file\" cannot be used: "},
      {R"("file": "broken.off")", "broken.off: line 3, column 4: z is missing; a number must follow here"}};
  for (const auto& [fields, expected] : table) {
    const std::string message = refusal(R"({"type": "mesh", )" + fields + "}");
    EXPECT_EQ(message.find("scene.json: line 1, column "), 0U) << message;
    EXPECT_NE(message.find(expected), std::string::npos) << message;
  }
}

TEST(JsonMeshFiles, ScenesWithoutAFolderHaveNone) {
  const std::string object = R"({"type": "mesh", "file": "a.obj"})";
  EXPECT_NE(error_of([&] {
              parse_json_scene(scene_3d(object), "scene");
            }).find("this scene was not read from a file that it could be relative to"),
            std::string::npos);
  EXPECT_NE(error_of([&] {
              parse_json_scene(scene_2d(object), "scene");
            }).find("names a mesh file, which is 3D; in a 2D scene, a mesh has \"vertices\" and \"faces\""),
            std::string::npos);
  EXPECT_NE(error_of([] {
              parse_json_scene(scene_3d(R"({"type": "mesh"})"), "scene");
            }).find("a mesh needs \"vertices\" and \"faces\", or the \"file\" that has them"),
            std::string::npos);
}

TEST(JsonMeshFiles, TheJsonSchemaHasTheSameFields) {
  const auto schema = nlohmann::json::parse(text_of(project_file("data/scene.schema.json")));
  std::vector<std::string> fields;
  for (const auto& entry : schema.at("$defs").at("mesh_file").at("properties").items()) fields.push_back(entry.key());
  EXPECT_EQ(fields, (std::vector<std::string>{"file", "kind", "part", "type"}));
}

}  // namespace
}  // namespace graze::io::json_mesh_files_test
