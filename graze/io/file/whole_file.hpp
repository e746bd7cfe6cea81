// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <graze/math/platform/export.hpp>

namespace graze::io {

/// All bytes of a file or pipe. Throws InputError naming the file and the reason if it cannot be read; `what` is what
/// the user should give instead of a folder: "the scene file".
GRAZE_EXPORT std::string read_whole_file(const std::filesystem::path& path, std::string_view what);

}  // namespace graze::io
