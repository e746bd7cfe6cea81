// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace graze::io {

/// All bytes of a file or pipe. Throws InputError that names the file and what it is not, or why it cannot be read;
/// `what` is what was wanted of a folder: "the scene file".
std::string read_whole_file(const std::filesystem::path& path, std::string_view what);

}  // namespace graze::io
