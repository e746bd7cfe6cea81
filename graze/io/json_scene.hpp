// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

#include <graze/io/scene_file.hpp>

namespace graze::io {

class JsonDocument;

/// What "schema" says in the scene files that this version reads and writes.
inline constexpr std::string_view json_scene_schema = "graze.scene/1";

/// Reads graze's own scene format, documented in docs/scene_format.md. Throws InputError.
SceneFile parse_json_scene(std::string_view text, const std::string& source);

/// The same from a document that has been parsed already. Throws InputError.
SceneFile read_json_scene(const JsonDocument& document);

/// Writes a scene in graze's own format. Numbers survive the round trip bit for bit; what `file.omissions` counts is
/// not in the scene and so is not written. A layer without a name gets one. Throws OutputError for what the format
/// cannot hold: a name that is not UTF-8, compounds nested deeper than 32. The state of `out` is the caller's to check.
void write_json_scene(std::ostream& out, const SceneFile& file);

}  // namespace graze::io
