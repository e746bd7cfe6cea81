// SPDX-License-Identifier: MIT
// Asks graze about the meshes of files, clean or broken, in float and double: rays at faces, edges and vertices, from
// outside and from vertices; distances; winding numbers; which faces of a moved copy, or of the mesh itself, touch. The
// judge is CGAL's kernel with exact predicates and constructions. Exit status 1 if an answer is wrong.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <graze/io/input_error.hpp>
#include <graze/io/mesh_file.hpp>

#include "exam.hpp"

namespace graze::mesh_exam {
namespace {

class Table {
 public:
  Table() {
    fmt::print("{:24} {:6} {:>7} {:>6} {:>6} {:>6} {:>7} {:>6} {:>8} {:>8} {:>9} {:>9} {:>6}\n", "mesh", "number",
               "faces", "rays", "hits", "points", "winding", "inside", "pairs", "own", "t error", "distance", "faults");
  }

  void add(std::string_view name, std::string_view number, std::size_t faces, const Tally& tally) {
    fmt::print("{:24} {:6} {:7} {:6} {:6} {:6} {:7} {:6} {:8} {:8} {:9.2} {:9.2} {:6}\n", name.substr(0, 24), number,
               faces, tally.rays, tally.hits, tally.distances, tally.winding_numbers, tally.inside, tally.pairs,
               tally.own_pairs, tally.hit_error, tally.distance_error, tally.faults.size());
    for (std::size_t i = 0; i < tally.faults.size() && i < 5; ++i) fmt::print("  {}\n", tally.faults[i]);
    std::fflush(stdout);
    faults += tally.faults.size();
  }

  std::size_t faults = 0;
};

/// The path, or of a folder, all files of meshes below it, by the ends of their names.
std::vector<std::string> files_at(const std::filesystem::path& path) {
  if (!std::filesystem::is_directory(path)) return {path.string()};
  constexpr std::array<std::string_view, 6> formats = {".off", ".ply", ".stl", ".obj", ".glb", ".gltf"};
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path)) {
    const std::string end = entry.path().extension().string();
    if (std::find(formats.begin(), formats.end(), end) != formats.end()) files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// All parts of a file as one mesh.
void examine_file(const std::string& path, const Settings& settings, Table& table) {
  const io::MeshFile file = io::read_meshes(path);
  std::vector<Point> vertices;
  std::vector<Face> faces;
  for (const io::MeshPart& part : file.parts) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), part.mesh.vertices().begin(), part.mesh.vertices().end());
    for (const Face& face : part.mesh.faces()) faces.push_back({first + face[0], first + face[1], first + face[2]});
  }
  const std::string name = path.substr(path.find_last_of('/') + 1);
  table.add(name, "float", faces.size(), examine<float>(vertices, faces, settings));
  table.add(name, "double", faces.size(), examine<double>(vertices, faces, settings));
}

}  // namespace
}  // namespace graze::mesh_exam

int main(int argc, char** argv) {
  graze::mesh_exam::Settings settings;
  std::vector<std::string> paths;
  CLI::App app("Compares graze's answers about meshes with those of CGAL's exact kernel.", "graze_mesh_exam");
  app.add_option("paths", paths, "STL, OBJ, PLY, OFF or glTF files, or folders of them")
      ->required()
      ->check(CLI::ExistingPath);
  app.add_option("--rays", settings.rays, "rays per mesh")->capture_default_str();
  app.add_option("--points", settings.points, "points per mesh")->capture_default_str();
  app.add_option("--places", settings.places, "places of a copy per mesh")->capture_default_str();
  app.add_option("--most-faces", settings.most_faces, "larger meshes are not compared with copies and themselves")
      ->capture_default_str();
  app.add_option("--seed", settings.seed, "chooses other rays, points and places")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    graze::mesh_exam::Table table;
    std::size_t read = 0;
    std::size_t refused = 0;
    for (const std::string& path : paths) {
      for (const std::string& file : graze::mesh_exam::files_at(path)) {
        try {
          graze::mesh_exam::examine_file(file, settings, table);
          ++read;
        } catch (const graze::io::InputError& error) {
          fmt::print("not read: {}\n", error.what());
          ++refused;
        }
      }
    }
    fmt::print("{} files, {} not read, {} wrong answers\n", read, refused, table.faults);
    return table.faults == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "graze_mesh_exam: {}\n", error.what());
    return 2;
  }
}
