// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace graze::io {

/// Writes numbers with commas between in place of rows of <tile gid="7"/> elements that fill a <data> or <chunk> of
/// Tiled's XML: parsed, each element would take a hundred bytes, and a large map has millions. Everything else stays
/// where it is; blanks fill what is left over. Rows that hold anything else stay as they are.
void shorten_tile_elements(std::string& xml);

/// Behind the row of <tile gid="7"/> elements, and blanks between them, that begins at `at`; `at` if there is none.
std::size_t behind_tile_elements(std::string_view xml, std::size_t at);

}  // namespace graze::io
