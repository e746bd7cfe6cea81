// SPDX-License-Identifier: MIT
// Reads a scene file of any supported format and prints which objects touch.
#include <cstdio>
#include <variant>

#include <graze/graze.hpp>
#include <graze/io/input_error.hpp>
#include <graze/io/scene_file.hpp>

int main(int argc, char** argv) {
  try {
    const graze::io::SceneFile file = graze::io::read_scene(argc > 1 ? argv[1] : "data/platform_level.tmx");
    std::visit(
        [](const auto& scene) { std::printf("%zu objects, %zu pairs touch\n", scene.size(), scene.pairs().size()); },
        file.scene);
  } catch (const graze::io::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
