// SPDX-License-Identifier: MIT
#include <cstddef>

#include <graze/io/text/in_quotes.hpp>
#include <graze/io/text/printable.hpp>

namespace graze::io {

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 80;
  if (text.size() <= longest) return '"' + printable(text) + '"';
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;  // do not split a UTF-8 character
  return '"' + printable(text.substr(0, end)) + "...\"";
}

}  // namespace graze::io
