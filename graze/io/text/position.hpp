// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <graze/io/input_error.hpp>

namespace graze::io {

/// A position in a text as editors count it: line and column from 1, columns in characters (UTF-8 sequences), lines
/// ended by LF.
struct TextPosition {
  std::size_t line = 1;
  std::size_t column = 1;

  friend bool operator==(const TextPosition&, const TextPosition&) = default;
};

/// The position of a byte; an offset beyond the end counts as the end. Reads the text up to there, so use it for
/// messages only.
TextPosition position_of(std::string_view text, std::size_t offset);

/// The error "source: line 3, column 7: message", where the text begins at line `first_line` of its source.
InputError error_at(std::string_view text, std::string_view source, std::size_t offset, std::string_view message,
                    std::size_t first_line = 1);

}  // namespace graze::io
