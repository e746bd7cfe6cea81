// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include <graze/io/svg/text.hpp>
#include <graze/io/text/utf8.hpp>

namespace graze::io::svg {
namespace {

/// The first character of a nonempty text; one byte if that does not begin a valid character.
std::string_view first_character(std::string_view text) {
  return text.substr(0, std::max<std::size_t>(utf8_sequence_length(text, 0), 1));
}

/// The escape of a character with a meaning in XML; empty for others.
std::string_view entity(char character) {
  switch (character) {
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '&':
      return "&amp;";
    case '"':
      return "&quot;";
    case '\'':
      return "&apos;";
    // Unescaped, an attribute would turn these three into spaces, and a carriage return into a line feed.
    case '\t':
      return "&#9;";
    case '\n':
      return "&#10;";
    case '\r':
      return "&#13;";
    default:
      return "";
  }
}

/// Whether XML 1.0 (fifth edition, production 2) allows the character in a document: invalid UTF-8, most control
/// characters, U+FFFE and U+FFFF are not allowed.
bool allowed_in_xml(std::string_view character) {
  if (utf8_sequence_length(character, 0) == 0) return false;
  if (character.size() == 1) return static_cast<unsigned char>(character[0]) >= 0x20 || !entity(character[0]).empty();
  return character != "\uFFFE" && character != "\uFFFF";
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const std::string_view character = first_character(text);
    text.remove_prefix(character.size());
    if (!allowed_in_xml(character)) {
      result += "\uFFFD";
    } else if (const std::string_view name = entity(character.front()); !name.empty()) {
      result += name;
    } else {
      result += character;
    }
  }
  return result;
}

std::size_t character_count(std::string_view text) {
  std::size_t count = 0;
  for (; !text.empty(); ++count) text.remove_prefix(first_character(text).size());
  return count;
}

std::string shortened(std::string_view text, std::size_t limit) {
  if (character_count(text) <= limit) return std::string(text);
  std::size_t kept = 0;
  for (std::size_t i = 0; i + 1 < limit; ++i) kept += first_character(text.substr(kept)).size();
  return std::string(text.substr(0, kept)) + "…";
}

std::string number(double value) {
  std::string text = fmt::format("{:.3f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string length_text(double value) { return fmt::format("{:.6g}", value); }

std::string counted(std::size_t count, std::string_view singular, std::string_view plural) {
  if (count == 1) return fmt::format("{} {}", count, singular);
  return plural.empty() ? fmt::format("{} {}s", count, singular) : fmt::format("{} {}", count, plural);
}

}  // namespace graze::io::svg
