// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace graze::io {

/// A name or value from a file for display in messages: in double quotes, `printable`, and if it is long, cut off and
/// followed by "...".
std::string in_quotes(std::string_view text);

}  // namespace graze::io
