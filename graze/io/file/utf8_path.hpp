// SPDX-License-Identifier: MIT
// Paths are UTF-8 in files, arguments and messages; on Windows, std::filesystem::path reads a plain std::string in the
// code page of the system.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace graze::io {

inline std::filesystem::path path_from_utf8(std::string_view text) { return {std::u8string(text.begin(), text.end())}; }

inline std::string utf8_from_path(const std::filesystem::path& path) {
  const std::u8string text = path.u8string();
  return {text.begin(), text.end()};
}

}  // namespace graze::io
