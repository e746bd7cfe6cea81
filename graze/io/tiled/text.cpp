// SPDX-License-Identifier: MIT
#include <cstddef>
#include <string>

#include <graze/io/text/position.hpp>
#include <graze/io/tiled/text.hpp>

namespace graze::io {

void fail_at(const TiledText& file, std::size_t offset, const std::string& fact) {
  throw error_at(file.text, file.name, offset, fact);
}

}  // namespace graze::io
