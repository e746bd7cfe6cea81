// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

#include <graze/io/scene_file.hpp>
#include <graze/math/platform/export.hpp>

namespace graze::io {

class JsonDocument;

/// The value of "schema" in the scene files that this version reads and writes.
inline constexpr std::string_view json_scene_schema = "graze.scene/1";

/// Reads a scene in the library's own format, documented in docs/scene_format.md. `source` names it in messages. Throws
/// InputError.
GRAZE_EXPORT SceneFile parse_json_scene(std::string_view text, const std::string& source);

/// Reads a scene from a parsed document. The files of meshes are relative to `folder`; without one, such meshes are
/// refused, as by parse_json_scene. Throws InputError.
GRAZE_EXPORT SceneFile read_json_scene(const JsonDocument& document,
                                       const std::optional<std::filesystem::path>& folder = std::nullopt);

/// Writes a scene in the library's own format. Numbers survive the round trip bit for bit. `file.omissions` are not in
/// the scene and not written; layers without a name get one. Throws OutputError for what the format cannot hold: a name
/// that is not UTF-8, compounds nested deeper than 32. The caller checks the state of `out`.
GRAZE_EXPORT void write_json_scene(std::ostream& out, const SceneFile& file);

}  // namespace graze::io
