// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace graze::io::svg {

/// Text that may stand in XML, between tags or in an attribute. What XML 1.0 forbids even as an entity (most control
/// characters, surrogates, U+FFFE and U+FFFF) and bytes that are not UTF-8 become U+FFFD, the replacement character.
std::string escaped(std::string_view text);

/// The number of characters (code points); every byte that is not part of one counts as one.
std::size_t character_count(std::string_view text);

/// The text, or its first `limit - 1` characters and an ellipsis where it is longer. `limit` is at least 1.
std::string shortened(std::string_view text, std::size_t limit);

/// A number with at most three decimals, as short as it goes: "12.5", "-3", "0". Never locale dependent, never "-0".
/// The value is finite.
std::string number(double value);

/// A length for people: up to six digits, with an exponent where it is very large or small: "250", "0.05", "1e+09".
std::string length_text(double value);

/// "1 pair", "2 pairs"; the plural adds an s unless it is given.
std::string counted(std::size_t count, std::string_view singular, std::string_view plural = {});

}  // namespace graze::io::svg
