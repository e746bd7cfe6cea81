// SPDX-License-Identifier: MIT
// Files that another file refers to.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace graze::io {

/// The bytes of a file, or why it cannot be read: "there is no such file".
struct ReferencedFile {
  std::string bytes;
  std::string_view fault = {};  ///< Empty if it was read.
};

/// Reads a regular file. Devices and pipes are refused, because reading them may never end.
ReferencedFile read_referenced_file(const std::filesystem::path& path);

}  // namespace graze::io
