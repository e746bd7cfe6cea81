// SPDX-License-Identifier: MIT
// Makes text from untrusted files safe to print on a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <graze/math/platform/export.hpp>

namespace graze::io {

/// The text without anything that controls a terminal: control characters become `\x1b`, characters that reverse or
/// hide text (U+202E, U+200B and similar) become `\u{202e}`, bytes that are not UTF-8 become U+FFFD. All other text is
/// unchanged.
GRAZE_EXPORT std::string printable(std::string_view text);

/// The number of terminal columns of `printable` text: combining marks take none, East Asian characters and emoji two,
/// all others one.
std::size_t display_columns(std::string_view text);

}  // namespace graze::io
