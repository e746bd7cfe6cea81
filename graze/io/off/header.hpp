// SPDX-License-Identifier: MIT
// The first word of OFF, which tells what the lines of vertices contain.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace graze::io {

/// What the header `[ST][C][N][4][n]OFF` says. Texture coordinates, colours and normals follow the three coordinates of
/// each vertex and are not read.
struct OffHeader {
  std::string_view word;  ///< "COFF"
  bool is_4d = false;     ///< 4 or n: vertices do not have three coordinates.
};

/// The header at the very beginning of a text; none if it does not begin with one.
inline std::optional<OffHeader> off_header_of(std::string_view text) {
  OffHeader header;
  header.word = text.substr(0, text.find_first_of(" \t\r\n"));
  std::string_view rest = header.word;
  const auto skip = [&rest](std::string_view prefix) {
    const bool is_there = rest.starts_with(prefix);
    if (is_there) rest.remove_prefix(prefix.size());
    return is_there;
  };
  skip("ST");
  skip("C");
  skip("N");
  header.is_4d = skip("4");
  header.is_4d = skip("n") || header.is_4d;
  if (rest != "OFF") return std::nullopt;
  return header;
}

}  // namespace graze::io
