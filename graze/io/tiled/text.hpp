// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace graze::io {

/// A file's text without byte order mark, and its name in messages.
struct TiledText {
  std::string name;
  std::string_view text;
};

/// A place in a file.
struct TiledPlace {
  const TiledText& file;
  std::size_t offset = 0;
};

/// Throws InputError: "name: line 3, column 7: fact" for the byte at `offset`.
[[noreturn]] void fail_at(const TiledText& file, std::size_t offset, const std::string& fact);

/// The same for a place.
[[noreturn]] inline void fail_at(const TiledPlace& place, const std::string& fact) {
  fail_at(place.file, place.offset, fact);
}

}  // namespace graze::io
