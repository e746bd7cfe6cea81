// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

#include <graze/io/tiled/tile_elements.hpp>

namespace graze::io {
namespace {

/// One <tile> element: its gid as written (empty for none), and its end.
struct TileElement {
  std::string_view gid;
  std::size_t end = 0;
};

std::size_t behind_blanks(std::string_view text, std::size_t at) {
  while (at < text.size() && (text[at] == ' ' || text[at] == '\n' || text[at] == '\r' || text[at] == '\t')) ++at;
  return at;
}

/// The position after `word` if the text continues with it, otherwise 0. Compares a fixed length, because there are
/// millions of tiles.
template <std::size_t size>
std::size_t behind(std::string_view text, std::size_t at, const char (&word)[size]) {
  constexpr std::size_t length = size - 1;
  if (text.size() < length || at > text.size() - length) return 0;
  return std::memcmp(text.data() + at, word, length) == 0 ? at + length : 0;
}

/// The element at `at`, if it is a <tile> with nothing but a gid of digits.
std::optional<TileElement> tile_element_at(std::string_view text, std::size_t at) {
  const std::size_t name_end = behind(text, at, "<tile");
  if (name_end == 0) return std::nullopt;
  TileElement element;
  at = behind_blanks(text, name_end);
  if (const std::size_t first = behind(text, at, "gid=\""); first > 0 && at > name_end) {
    std::size_t last = first;
    while (last < text.size() && text[last] >= '0' && text[last] <= '9') ++last;
    if (last == first || behind(text, last, "\"") == 0) return std::nullopt;
    element.gid = text.substr(first, last - first);
    at = behind_blanks(text, last + 1);
  }
  element.end = std::max(behind(text, at, "/>"), behind(text, at, "></tile>"));
  return element.end == 0 ? std::nullopt : std::optional(element);
}

/// Calls `visit(element)` for each consecutive <tile> element from `at` on, and returns the position of the first thing
/// that is not one.
template <class Visit>
std::size_t for_each_tile(std::string_view text, std::size_t at, const Visit& visit) {
  for (at = behind_blanks(text, at);; at = behind_blanks(text, at)) {
    const std::optional<TileElement> element = tile_element_at(text, at);
    if (!element) return at;
    visit(*element);
    at = element->end;
  }
}

/// Shortens the elements from `begin` up to an end tag; returns the position to continue from.
std::size_t shorten_row(std::string& xml, std::size_t begin) {
  const std::size_t end = for_each_tile(xml, begin, [](const TileElement&) {});
  if (xml.compare(end, 2, "</") != 0) return end;
  std::size_t out = begin;
  for_each_tile(xml, begin, [&](const TileElement& element) {
    // The output is shorter than the element that it replaces, so it never reaches the next one.
    if (element.gid.empty()) xml[out++] = '0';
    out = static_cast<std::size_t>(
        std::copy(element.gid.begin(), element.gid.end(), xml.begin() + static_cast<std::ptrdiff_t>(out)) -
        xml.begin());
    xml[out++] = ',';
  });
  std::fill(xml.begin() + static_cast<std::ptrdiff_t>(out), xml.begin() + static_cast<std::ptrdiff_t>(end), ' ');
  return end;
}

}  // namespace

std::size_t behind_tile_elements(std::string_view xml, std::size_t at) {
  std::size_t end = at;
  for_each_tile(xml, at, [&end](const TileElement& element) { end = element.end; });
  return end;
}

void shorten_tile_elements(std::string& xml) {
  std::size_t at = 0;
  while ((at = xml.find("<tile", at)) != std::string::npos) {
    // Only if the preceding element is an open <data> or <chunk>.
    const std::size_t open = xml.rfind('<', at == 0 ? 0 : at - 1);
    const std::size_t close = open == std::string::npos ? open : xml.find('>', open);
    const bool is_first = close < at && behind_blanks(xml, close + 1) == at && xml[close - 1] != '/' &&
                          (xml.compare(open, 5, "<data") == 0 || xml.compare(open, 6, "<chunk") == 0);
    at = is_first ? std::max(shorten_row(xml, close + 1), at + 1) : at + 1;
  }
}

}  // namespace graze::io
