// SPDX-License-Identifier: MIT
#include "scene_files.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <graze/io/text/in_quotes.hpp>

namespace graze::wasm {
namespace {

namespace fs = std::filesystem;

/// The folder of the scene: so deep that files that it refers to as "../../tiles.tsx" are still inside `top`. It is the
/// current folder, so that messages show paths as they are in the scene.
const fs::path top = "/scene";
const fs::path folder = top / "1/2/3/4/5/6/7/8";

}  // namespace

void add_scene_file(std::string path, std::string content) {
  const fs::path relative(path);
  const fs::path place = (folder / relative).lexically_normal();
  const bool is_inside = std::mismatch(top.begin(), top.end(), place.begin(), place.end()).first == top.end();
  if (relative.empty() || relative.is_absolute() || !is_inside) {
    throw std::invalid_argument("files: " + io::in_quotes(path) +
                                " is not a path relative to the scene, at most eight folders up");
  }
  fs::create_directories(place.parent_path());
  std::ofstream out(place, std::ios::binary);
  out << content;
  out.close();
  if (!out) throw std::runtime_error("files: " + io::in_quotes(path) + " cannot be stored");
}

void remove_scene_files() {
  fs::current_path("/");
  fs::remove_all(top);
}

io::SceneFile scene_of_text(const std::string& content, const std::string& name) {
  fs::create_directories(folder);
  fs::current_path(folder);
  return io::parse_scene(content, name, "");
}

}  // namespace graze::wasm
