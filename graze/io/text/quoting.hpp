// SPDX-License-Identifier: MIT
// Quotes arbitrary bytes for the report formats.
#pragma once

#include <string>
#include <string_view>

#include <graze/math/platform/export.hpp>

namespace graze::io {

/// A JSON string with its quotes; bytes that are not UTF-8 become U+FFFD.
GRAZE_EXPORT std::string json_string(std::string_view text);

/// A CSV field (RFC 4180): in quotes, with inner quotes doubled, if it contains a separator.
std::string csv_field(std::string_view text);

}  // namespace graze::io
