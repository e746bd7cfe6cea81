// SPDX-License-Identifier: MIT
// The files that a scene refers to, in an in-memory file system.
#pragma once

#include <string>

#include <graze/io/scene_file.hpp>

namespace graze::wasm {

/// Stores a file where the next scene that is read finds it. Throws std::invalid_argument for a path that is not
/// relative, or leads too far up.
void add_scene_file(std::string path, std::string content);

void remove_scene_files();

/// Reads a scene that may refer to those files. Throws io::InputError.
io::SceneFile scene_of_text(const std::string& content, const std::string& name);

}  // namespace graze::wasm
