// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <graze/io/json/document.hpp>
#include <graze/io/scene_file.hpp>

namespace graze::io {

/// Reads the objects of a Tiled map, XML (.tmx) or JSON (.tmj), and the collision shapes of its tiles. y points down,
/// and lengths are screen pixels. External tilesets and templates are resolved relative to the file that refers to
/// them; those of the map from `folder`. Throws InputError.
SceneFile parse_tiled_map(std::string_view text, const std::string& source, const std::filesystem::path& folder);

/// The same from JSON, parsed with the packed field "data" (see JsonDocument). `text` has no byte order mark.
SceneFile read_tiled_map(const JsonDocument& document, std::string_view text, const std::string& source,
                         const std::filesystem::path& folder);

}  // namespace graze::io
