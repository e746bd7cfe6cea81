// SPDX-License-Identifier: MIT
// The person at the terminal, if there is one.
#pragma once

#include <string>
#include <string_view>

#include <graze/io/report/check.hpp>

namespace graze::cli {

/// The stream that data goes to, and the one for talk.
enum class Stream { output = 1, error = 2 };

/// True when a person reads the stream on a terminal.
bool is_terminal(Stream stream);

/// True when the stream is a terminal that moves its cursor: not TERM=dumb.
bool has_cursor(Stream stream);

/// On for a terminal with a cursor, unless NO_COLOR is set and not empty (no-color.org).
io::Colours colours_for(Stream stream);

/// Writes "graze: MESSAGE" to the error stream, made printable; never fails.
void say(std::string_view message);

/// The same for an error: "graze: error: MESSAGE".
void say_error(std::string_view message);

/// Writes lines of our own, as they are, to the error stream; never fails.
void say_text(const std::string& text);

/// Opens standard streams that the caller has closed, in such a way that using them fails. Otherwise the next file
/// opened would take their number, and what we say would end up in it.
void claim_standard_streams();

}  // namespace graze::cli
