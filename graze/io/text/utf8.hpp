// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace graze::io {

/// The length, 1 to 4 bytes, of the well-formed UTF-8 sequence at `offset` (Unicode 15, table 3-7); 0 if there is none.
std::size_t utf8_sequence_length(std::string_view text, std::size_t offset);

/// The offset of the first byte that is not well-formed UTF-8, or `npos`.
std::size_t find_invalid_utf8(std::string_view text);

/// The text without the byte order mark that some editors prepend.
std::string_view without_byte_order_mark(std::string_view text);

/// The encoding of text that is not UTF-8, detected by its byte order mark or by zero bytes beside its first
/// characters: "UTF-16" or "UTF-32"; empty if unknown.
std::string_view other_encoding(std::string_view text);

/// Throws InputError, naming the position, unless all of `text` is UTF-8 without zero bytes. `source` names it in
/// messages, where the text begins at line `first_line`.
void require_utf8(std::string_view text, const std::string& source, std::size_t first_line = 1);

}  // namespace graze::io
