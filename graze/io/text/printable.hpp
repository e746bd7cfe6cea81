// SPDX-License-Identifier: MIT
// Text from a stranger's file on the way to a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace graze::io {

/// The text with nothing in it that a terminal would obey: control characters become `\x1b`, those that turn or hide
/// text (U+202E, U+200B and their like) become `\u{202e}`, bytes that are not UTF-8 become U+FFFD. Other text stays as
/// it is.
std::string printable(std::string_view text);

/// How many columns of a terminal `printable` text takes: accents none, East Asian signs and emoji two, the rest one.
std::size_t display_columns(std::string_view text);

}  // namespace graze::io
