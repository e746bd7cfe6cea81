// SPDX-License-Identifier: MIT
// Any bytes as a field of the formats that reports are written in.
#pragma once

#include <string>
#include <string_view>

namespace graze::io {

/// A JSON string with its quotes; bytes that are not UTF-8 become U+FFFD.
std::string json_string(std::string_view text);

/// A field as RFC 4180 wants it: in quotes when it holds a separator, and quotes doubled.
std::string csv_field(std::string_view text);

}  // namespace graze::io
