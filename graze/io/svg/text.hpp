// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace graze::io::svg {

/// Text escaped for XML, between tags or in an attribute. Characters that XML 1.0 forbids even as entities (most
/// control characters, surrogates, U+FFFE and U+FFFF) and bytes that are not UTF-8 become U+FFFD, the replacement
/// character.
std::string escaped(std::string_view text);

/// The number of characters (code points); every invalid byte counts as one.
std::size_t character_count(std::string_view text);

/// The text, or if it is longer its first `limit - 1` characters and an ellipsis. `limit` is at least 1.
std::string shortened(std::string_view text, std::size_t limit);

/// A number with at most three decimals, as short as possible: "12.5", "-3", "0". Independent of the locale, never
/// "-0". The value must be finite.
std::string number(double value);

/// A length for display: up to six digits, with an exponent if it is very large or small: "250", "0.05", "1e+09".
std::string length_text(double value);

/// "1 pair", "2 pairs"; the plural adds an s unless it is given.
std::string counted(std::size_t count, std::string_view singular, std::string_view plural = {});

}  // namespace graze::io::svg
