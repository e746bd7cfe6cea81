// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <graze/io/json/document.hpp>
#include <graze/io/scene_file.hpp>

namespace graze::io {

/// Reads the objects of a Tiled map, XML (.tmx) or JSON (.tmj), and the collision shapes of the tiles in its layers; y
/// points down, lengths are pixels of the screen. External tilesets and templates are looked up relative to the file
/// that names them, the map's from `folder`. Throws InputError.
SceneFile parse_tiled_map(std::string_view text, const std::string& source, const std::filesystem::path& folder);

/// The same from JSON, parsed with the packed field "data" (see JsonDocument). `text` is without byte order mark.
SceneFile read_tiled_map(const JsonDocument& document, std::string_view text, const std::string& source,
                         const std::filesystem::path& folder);

}  // namespace graze::io
