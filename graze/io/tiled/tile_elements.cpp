// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <graze/io/tiled/tile_elements.hpp>

namespace graze::io {
namespace {

/// One <tile> element: its gid as it is written, empty for none, and where it ends.
struct TileElement {
  std::string_view gid;
  std::size_t end = 0;
};

std::size_t behind_blanks(std::string_view text, std::size_t at) {
  while (at < text.size() && (text[at] == ' ' || text[at] == '\n' || text[at] == '\r' || text[at] == '\t')) ++at;
  return at;
}

/// The element that begins at `at`, if it is a <tile> with nothing but a gid of digits.
std::optional<TileElement> tile_element_at(std::string_view text, std::size_t at) {
  constexpr std::string_view begin = "<tile";
  if (text.substr(at, begin.size()) != begin) return std::nullopt;
  TileElement element;
  const std::size_t name_end = at + begin.size();
  at = behind_blanks(text, name_end);
  constexpr std::string_view gid = "gid=\"";
  if (at > name_end && text.substr(at, gid.size()) == gid) {
    const std::size_t first = at + gid.size();
    std::size_t last = first;
    while (last < text.size() && text[last] >= '0' && text[last] <= '9') ++last;
    if (last == first || text.substr(last, 1) != "\"") return std::nullopt;
    element.gid = text.substr(first, last - first);
    at = behind_blanks(text, last + 1);
  }
  for (const std::string_view end : {"/>", "></tile>"}) {
    if (text.substr(at, end.size()) != end) continue;
    element.end = at + end.size();
    return element;
  }
  return std::nullopt;
}

/// Calls `visit(element)` for each of the <tile> elements from `at` on, and returns where the first of another kind
/// begins, or what else is there.
template <class Visit>
std::size_t for_each_tile(std::string_view text, std::size_t at, const Visit& visit) {
  for (at = behind_blanks(text, at);; at = behind_blanks(text, at)) {
    const std::optional<TileElement> element = tile_element_at(text, at);
    if (!element) return at;
    visit(*element);
    at = element->end;
  }
}

/// Shortens the elements from `begin` on, up to an end tag; returns where to go on.
std::size_t shorten_row(std::string& xml, std::size_t begin) {
  const std::size_t end = for_each_tile(xml, begin, [](const TileElement&) {});
  if (xml.compare(end, 2, "</") != 0) return end;
  std::size_t out = begin;
  for_each_tile(xml, begin, [&](const TileElement& element) {
    // What is written is shorter than the element that it comes from, so that it never reaches the next one.
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

void shorten_tile_elements(std::string& xml) {
  std::size_t at = 0;
  while ((at = xml.find("<tile", at)) != std::string::npos) {
    // Only where the element before is an open <data> or <chunk>.
    const std::size_t open = xml.rfind('<', at == 0 ? 0 : at - 1);
    const std::size_t close = open == std::string::npos ? open : xml.find('>', open);
    const bool is_first = close < at && behind_blanks(xml, close + 1) == at && xml[close - 1] != '/' &&
                          (xml.compare(open, 5, "<data") == 0 || xml.compare(open, 6, "<chunk") == 0);
    at = is_first ? std::max(shorten_row(xml, close + 1), at + 1) : at + 1;
  }
}

}  // namespace graze::io
