// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace graze::io {

/// A name or value from a file as messages show it: in double quotes, `printable`, and of a long one only the
/// beginning, with
/// "..." behind it.
std::string in_quotes(std::string_view text);

}  // namespace graze::io
