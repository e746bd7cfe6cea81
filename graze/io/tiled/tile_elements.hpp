// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace graze::io {

/// Writes numbers with commas between in place of rows of <tile gid="7"/> elements that fill a <data> or <chunk> of
/// Tiled's XML: parsed, each element would take a hundred bytes, and a large map has millions. Everything else stays
/// where it is; blanks fill what is left over. Rows that hold anything else stay as they are.
void shorten_tile_elements(std::string& xml);

}  // namespace graze::io
