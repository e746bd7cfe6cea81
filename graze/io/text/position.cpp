// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/format.h>

#include <graze/io/text/position.hpp>

namespace graze::io {

TextPosition position_of(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const std::size_t line_break = before.rfind('\n');
  const std::string_view line = line_break == std::string_view::npos ? before : before.substr(line_break + 1);
  const auto begins_character = [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; };
  return {1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')),
          1 + static_cast<std::size_t>(std::count_if(line.begin(), line.end(), begins_character))};
}

InputError error_at(std::string_view text, std::string_view source, std::size_t offset, std::string_view message,
                    std::size_t first_line) {
  const TextPosition position = position_of(text, offset);
  return InputError(
      fmt::format("{}: line {}, column {}: {}", source, position.line + first_line - 1, position.column, message));
}

}  // namespace graze::io
