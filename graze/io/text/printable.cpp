// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include <graze/io/text/printable.hpp>
#include <graze/io/text/utf8.hpp>

namespace graze::io {
namespace {

struct CodePoint {
  char32_t value = 0;
  std::size_t bytes = 1;
};

/// The first code point of a nonempty text; none if the bytes are not UTF-8.
std::optional<CodePoint> first_code_point(std::string_view text) {
  const std::size_t length = utf8_sequence_length(text, 0);
  if (length == 0) return std::nullopt;
  const auto bits_below = [&](std::size_t i, unsigned mask) { return static_cast<unsigned char>(text[i]) & mask; };
  // The lead byte of a sequence of 2, 3, 4 bytes holds 5, 4, 3 bits of the value, each byte after it 6.
  char32_t value = bits_below(0, length == 1 ? 0x7fU : 0x7fU >> length);
  for (std::size_t i = 1; i < length; ++i) value = value << 6U | bits_below(i, 0x3fU);
  return CodePoint{value, length};
}

struct Range {
  char32_t first;
  char32_t last;
};

template <std::size_t Count>
bool is_in(const std::array<Range, Count>& ranges, char32_t value) {
  return std::any_of(ranges.begin(), ranges.end(),
                     [&](const Range& range) { return range.first <= value && value <= range.last; });
}

/// Zero-width and direction marks, line and paragraph separators, the byte order mark, tag characters.
constexpr std::array<Range, 7> deceptive{{{0x061c, 0x061c},
                                          {0x200b, 0x200f},
                                          {0x2028, 0x202e},
                                          {0x2060, 0x2069},
                                          {0xfeff, 0xfeff},
                                          {0xfff9, 0xfffb},
                                          {0xe0000, 0xe007f}}};

/// Combining marks and variation selectors.
constexpr std::array<Range, 6> without_width{
    {{0x0300, 0x036f}, {0x1ab0, 0x1aff}, {0x1dc0, 0x1dff}, {0x20d0, 0x20ff}, {0xfe00, 0xfe0f}, {0xfe20, 0xfe2f}}};

/// Unicode's East Asian Width W and F, in complete blocks.
constexpr std::array<Range, 10> double_width{{{0x1100, 0x115f},
                                              {0x2e80, 0x303e},
                                              {0x3041, 0xa4cf},
                                              {0xac00, 0xd7a3},
                                              {0xf900, 0xfaff},
                                              {0xfe30, 0xfe6f},
                                              {0xff00, 0xff60},
                                              {0xffe0, 0xffe6},
                                              {0x1f300, 0x1faff},
                                              {0x20000, 0x3fffd}}};

bool is_control(char32_t value) { return value < 0x20 || (0x7f <= value && value < 0xa0); }

}  // namespace

std::string printable(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const std::optional<CodePoint> point = first_code_point(text);
    const std::size_t bytes = point ? point->bytes : 1;
    if (!point) {
      result += "\xef\xbf\xbd";
    } else if (is_control(point->value)) {
      fmt::format_to(std::back_inserter(result), "\\x{:02x}", static_cast<unsigned>(point->value));
    } else if (is_in(deceptive, point->value)) {
      fmt::format_to(std::back_inserter(result), "\\u{{{:x}}}", static_cast<unsigned>(point->value));
    } else {
      result += text.substr(0, bytes);
    }
    text.remove_prefix(bytes);
  }
  return result;
}

std::size_t display_columns(std::string_view text) {
  std::size_t columns = 0;
  while (!text.empty()) {
    const CodePoint point = first_code_point(text).value_or(CodePoint{});
    if (is_in(double_width, point.value)) {
      columns += 2;
    } else if (!is_in(without_width, point.value)) {
      columns += 1;
    }
    text.remove_prefix(point.bytes);
  }
  return columns;
}

}  // namespace graze::io
