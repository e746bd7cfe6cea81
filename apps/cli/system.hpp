// SPDX-License-Identifier: MIT
// What the program asks of the operating system: system_posix.cpp and system_windows.cpp implement it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace graze::cli {

/// The streams for data and for messages.
enum class Stream { output = 1, error = 2 };

/// True if the stream is a terminal that understands escape sequences.
bool is_terminal(Stream stream);

/// The width of the error stream's terminal; 80 if it is unknown.
std::size_t terminal_columns();

/// Writes to the standard output. Returns the number of bytes written, or a negative number and the reason in errno.
std::ptrdiff_t write_to_output(const char* bytes, std::size_t count);

/// Call it before anything else. Data passes the standard streams unchanged. Standard streams that the caller has
/// closed are opened in such a way that using them fails; otherwise the next opened file would get their number and
/// receive our messages. Writing to a closed pipe, or beyond the maximum size of a file, returns an error. If the user
/// or the system ends the program, incomplete files are removed.
void prepare_process();

/// The arguments in UTF-8, the program's name first.
std::vector<std::string> arguments_in_utf8(int count, const char* const* arguments);

/// The value of an environment variable, in UTF-8; empty if it is not set.
std::string environment(const char* name);

/// The running program; empty if the system does not report it.
std::filesystem::path program_path();

/// Ends like a program whose reader has closed the pipe, so that a shell sees the usual code.
[[noreturn]] void die_of_closed_pipe();

}  // namespace graze::cli
