// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace graze::io {

/// The number of bytes, 1 to 4, of the well-formed UTF-8 sequence that begins at `offset` (Unicode 15, table 3-7);
/// 0 when none begins there.
std::size_t utf8_sequence_length(std::string_view text, std::size_t offset);

/// The offset of the first byte that is not well-formed UTF-8, or `npos`.
std::size_t find_invalid_utf8(std::string_view text);

/// The text without the byte order mark that some editors put before it.
std::string_view without_byte_order_mark(std::string_view text);

/// The encoding of a text that is not UTF-8, as its byte order mark tells, or zeros beside its first characters:
/// "UTF-16" or "UTF-32"; empty where nothing tells one.
std::string_view other_encoding(std::string_view text);

/// Throws InputError, naming the place, unless all of `text` is UTF-8 without zero bytes. `source` names it in
/// messages, where the text begins in its line `first_line`.
void require_utf8(std::string_view text, const std::string& source, std::size_t first_line = 1);

}  // namespace graze::io
