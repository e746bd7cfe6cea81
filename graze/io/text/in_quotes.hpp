// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include <graze/math/platform/export.hpp>

namespace graze::io {

/// A name or value from a file for display in messages: in double quotes, `printable`, and if it is long, cut off and
/// followed by "...".
GRAZE_EXPORT std::string in_quotes(std::string_view text);

}  // namespace graze::io
