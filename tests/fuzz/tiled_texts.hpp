// SPDX-License-Identifier: MIT
// Tiled maps with the files that they refer to.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <graze/io/tiled/map.hpp>
#include <graze/io/tiled/model.hpp>

#include "fuzz/texts.hpp"
#include "scratch_folder.hpp"

namespace graze::test::fuzz {

/// The files in a text, separated by lines "=====".
inline std::vector<std::string_view> files_in(std::string_view text) {
  constexpr std::string_view line = "\n=====\n";
  constexpr std::size_t most = 4;
  std::vector<std::string_view> files;
  while (files.size() + 1 < most) {
    const std::size_t end = text.find(line);
    if (end == std::string_view::npos) break;
    files.push_back(text.substr(0, end + 1));
    text.remove_prefix(end + line.size());
  }
  files.push_back(text);
  return files;
}

/// The first file is a map; the following ones are named 1, 2 and 3 and may be its tilesets and templates.
inline void check_map(std::string_view text) {
  static const ScratchFolder folder("graze fuzz");
  static std::size_t there = 1;
  const std::vector<std::string_view> files = files_in(text);
  for (std::size_t i = 1; i < files.size(); ++i) folder.write(std::to_string(i), files[i]);
  for (; there > files.size(); --there) folder.remove(std::to_string(there - 1));
  there = files.size();
  const auto file = read_or_refuse([&] { return io::parse_tiled_map(files.front(), "map", folder.path()); });
  if (file) require_survival(*file);
}

}  // namespace graze::test::fuzz
