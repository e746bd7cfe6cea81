// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include <fmt/format.h>

#include <graze/io/text/position.hpp>
#include <graze/io/text/utf8.hpp>

namespace graze::io {
namespace {

unsigned byte_at(std::string_view text, std::size_t offset) { return static_cast<unsigned char>(text[offset]); }

bool is_between(unsigned byte, unsigned low, unsigned high) { return low <= byte && byte <= high; }

/// What the first byte of a sequence determines: its length, and the bounds of the second byte. The bounds exclude
/// overlong forms (E0, F0), surrogates (ED) and values above U+10FFFF (F4).
struct Lead {
  std::size_t length = 0;
  unsigned second_low = 0x80;
  unsigned second_high = 0xBF;
};

Lead lead_of(unsigned byte) {
  if (byte < 0x80) return {1};
  if (is_between(byte, 0xC2, 0xDF)) return {2};
  if (byte == 0xE0) return {3, 0xA0, 0xBF};
  if (byte == 0xED) return {3, 0x80, 0x9F};
  if (is_between(byte, 0xE1, 0xEF)) return {3};
  if (byte == 0xF0) return {4, 0x90, 0xBF};
  if (is_between(byte, 0xF1, 0xF3)) return {4};
  if (byte == 0xF4) return {4, 0x80, 0x8F};
  return {};
}

/// The first position from `offset` on that is not within eight bytes of plain ASCII: a fast path for most text.
std::size_t skip_ascii(std::string_view text, std::size_t offset) {
  constexpr std::uint64_t high_bits = 0x8080808080808080U;
  while (text.size() - offset >= sizeof(std::uint64_t)) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, text.data() + offset, sizeof eight);
    if ((eight & high_bits) != 0) break;
    offset += sizeof eight;
  }
  return offset;
}

}  // namespace

std::size_t utf8_sequence_length(std::string_view text, std::size_t offset) {
  if (offset >= text.size()) return 0;
  const Lead lead = lead_of(byte_at(text, offset));
  if (lead.length < 2) return lead.length;
  if (lead.length > text.size() - offset) return 0;
  if (!is_between(byte_at(text, offset + 1), lead.second_low, lead.second_high)) return 0;
  for (std::size_t i = 2; i < lead.length; ++i) {
    if (!is_between(byte_at(text, offset + i), 0x80, 0xBF)) return 0;
  }
  return lead.length;
}

std::size_t find_invalid_utf8(std::string_view text) {
  std::size_t offset = skip_ascii(text, 0);
  while (offset < text.size()) {
    const std::size_t length = utf8_sequence_length(text, offset);
    if (length == 0) return offset;
    offset = skip_ascii(text, offset + length);
  }
  return std::string_view::npos;
}

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

std::string_view other_encoding(std::string_view text) {
  using namespace std::string_view_literals;
  if (text.starts_with("\xFF\xFE\0\0"sv) || text.starts_with("\0\0\xFE\xFF"sv)) return "UTF-32";
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return "UTF-16";
  if (text.size() < 4) return "";
  const auto zeros = [text](std::array<bool, 4> expected) {
    for (std::size_t i = 0; i < expected.size(); ++i) {
      if ((text[i] == '\0') != expected[i]) return false;
    }
    return true;
  };
  if (zeros({false, true, true, true}) || zeros({true, true, true, false})) return "UTF-32";
  return zeros({false, true, false, true}) || zeros({true, false, true, false}) ? "UTF-16" : "";
}

void require_utf8(std::string_view text, const std::string& source, std::size_t first_line) {
  const std::size_t invalid = find_invalid_utf8(text);
  const std::size_t zero = text.find('\0');
  if (invalid == std::string_view::npos && zero == std::string_view::npos) return;
  if (const std::string_view encoding = other_encoding(text); !encoding.empty()) {
    throw InputError(fmt::format("{}: this is {}; save it as UTF-8", source, encoding));
  }
  const std::size_t first = std::min(invalid, zero);
  throw error_at(text, source, first,
                 fmt::format("byte 0x{:02X} is not UTF-8 text; save the file as UTF-8", byte_at(text, first)),
                 first_line);
}

}  // namespace graze::io
