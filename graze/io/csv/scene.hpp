// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include <graze/io/scene_file.hpp>

namespace graze::io {

/// Reads a scene from values separated by commas, semicolons or tabs, whichever occurs first in the header line. The
/// header determines what each line contains (header.hpp); docs/scene_format.md documents the format. Throws
/// InputError.
SceneFile parse_csv_scene(std::string_view text, const std::string& source);

}  // namespace graze::io
