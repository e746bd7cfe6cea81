// SPDX-License-Identifier: MIT
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/mesh/scene.hpp>

#include "io/mesh_text.hpp"

namespace graze::io::mesh_scene_test {
namespace {

std::vector<std::string> names_in(const std::vector<std::string>& given) {
  MeshFile file{{}, "a.obj", "obj"};
  for (const std::string& name : given) file.parts.push_back({name, cube_mesh()});
  const SceneFile scene_file = scene_of_meshes(std::move(file));
  const auto& scene = std::get<Scene<3, double>>(scene_file.scene);
  std::vector<std::string> names;
  for (const ObjectId id : scene.ids()) names.push_back(scene.object(id).name);
  return names;
}

TEST(MeshScene, NamesBecomeUnique) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(names_in({"a", "b"}), (Names{"a", "b"}));
  EXPECT_EQ(names_in({"a", "a", "a"}), (Names{"a", "a-2", "a-3"}));
  EXPECT_EQ(names_in({"a", "a", "a-2"}), (Names{"a", "a-3", "a-2"}));
  EXPECT_EQ(names_in({"", ""}), (Names{"#0", "#1"}));
  EXPECT_EQ(names_in({"#1", "", "x", ""}), (Names{"#1", "#1-2", "x", "#3"}));
}

TEST(MeshScene, CarriesEverythingOver) {
  MeshFile file{{{"a", cube_mesh()}}, "a.obj", "obj"};
  file.omissions = {{"line", 2}};
  file.warnings = {"doubtful"};
  const SceneFile scene_file = scene_of_meshes(file);
  EXPECT_EQ(scene_file.source, "a.obj");
  EXPECT_EQ(scene_file.format, "obj");
  EXPECT_EQ(scene_file.omissions.at(0).what, "line");
  EXPECT_EQ(scene_file.warnings, file.warnings);
  const auto& scene = std::get<Scene<3, double>>(scene_file.scene);
  const auto& mesh = std::get<Mesh<3, double>>(scene.object(scene.ids().at(0)).shape);
  EXPECT_EQ(detail::placed(mesh).data(), detail::placed(file.parts[0].mesh).data());
}

TEST(MeshScene, PartsWithoutFacesAreObjectsThatTouchNothing) {
  const SceneFile scene_file = scene_of_meshes({{{"a", {}}, {"b", cube_mesh()}, {"c", cube_mesh()}}, "a.obj", "obj"});
  EXPECT_EQ((std::get<Scene<3, double>>(scene_file.scene).pairs().size()), 1U);
}

}  // namespace
}  // namespace graze::io::mesh_scene_test
