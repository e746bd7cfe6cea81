// SPDX-License-Identifier: MIT
// The terminal, if the program runs on one.
#pragma once

#include <string>
#include <string_view>

#include <graze/io/report/check.hpp>

#include "system.hpp"

namespace graze::cli {

/// True if the stream is a terminal that can move its cursor: not TERM=dumb.
bool has_cursor(Stream stream);

/// On for a terminal with a movable cursor, unless NO_COLOR is set and not empty (no-color.org).
io::Colours colours_for(Stream stream);

/// Writes "graze: MESSAGE" to the error stream, made printable; never fails.
void say(std::string_view message);

/// The same for an error: "graze: error: MESSAGE".
void say_error(std::string_view message);

/// Writes our own lines unchanged to the error stream; never fails.
void say_text(const std::string& text);

}  // namespace graze::cli
