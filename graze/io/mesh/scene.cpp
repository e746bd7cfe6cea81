// SPDX-License-Identifier: MIT
#include <cstddef>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/mesh/scene.hpp>

namespace graze::io {
namespace {

/// Unique names for the parts. Names in the file come before made ones: of "a", "a" and "a-2", the second is "a-3".
std::vector<std::string> names_of(const std::vector<MeshPart>& parts) {
  std::unordered_set<std::string> taken;
  for (const MeshPart& part : parts) taken.insert(part.name);
  std::unordered_set<std::string> given;
  std::unordered_map<std::string, std::size_t> next;  // number to try, less 2
  std::vector<std::string> names;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool has_name = !parts[i].name.empty();
    const std::string name = has_name ? parts[i].name : fmt::format("#{}", i);
    std::string unique = name;
    const bool is_free = has_name ? given.insert(name).second : taken.insert(name).second;
    while (!is_free && !taken.insert(unique).second) unique = fmt::format("{}-{}", name, 2 + next[name]++);
    names.push_back(std::move(unique));
  }
  return names;
}

}  // namespace

SceneFile scene_of_meshes(MeshFile file) {
  std::vector<std::string> names = names_of(file.parts);
  Scene<3, double> scene;
  for (std::size_t i = 0; i < names.size(); ++i) {
    ObjectOptions options;
    options.name = std::move(names[i]);
    scene.add(file.parts[i].mesh, std::move(options));
  }
  SceneFile result{std::move(scene), file.source, file.format, YAxis::up, std::move(file.omissions)};
  result.warnings = std::move(file.warnings);
  return result;
}

}  // namespace graze::io
