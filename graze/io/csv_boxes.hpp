// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include <graze/io/scene_file.hpp>

namespace graze::io {

/// Reads boxes from comma-separated values (RFC 4180). The header line names the columns: `id`, `min_x`, `min_y`,
/// `max_x`, `max_y`, in 3D also `min_z` and `max_z`, optionally `layer`, in any order; further columns are counted as
/// omissions. Throws InputError.
SceneFile parse_csv_boxes(std::string_view text, const std::string& source);

}  // namespace graze::io
