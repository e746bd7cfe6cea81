// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace graze::io {

/// Replaces the <tile gid="7"/> elements that fill a <data> or <chunk> of Tiled's XML by comma-separated numbers,
/// because parsed elements would take a hundred bytes each, and a large map has millions. Everything else keeps its
/// position; blanks fill the gaps. Sequences with any other content are not changed.
void shorten_tile_elements(std::string& xml);

/// The position after the sequence of <tile gid="7"/> elements and blanks at `at`; `at` if there is none.
std::size_t behind_tile_elements(std::string_view xml, std::size_t at);

}  // namespace graze::io
