// SPDX-License-Identifier: MIT
// Where data is written: the standard output, or a file that is replaced in one step.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

namespace graze::cli {

/// The reader of our standard output has closed it, as `head` does: not an error, but the program can end.
struct ClosedPipe {};

/// True for the name of the standard output (or input): "-".
bool is_standard_stream(const std::string& name);

/// True if two names refer to the same file, or to the same standard stream.
bool name_same_file(const std::string& a, const std::string& b);

/// Throws UsageError if `output` would replace the scene that is read.
void require_not_overwritten(const std::string& scene, const std::string& output);

/// Calls `write` with a stream to the target: "-" for the standard output, otherwise a file, which keeps its old
/// content unless everything has been written (see write_atomically). Throws OutputError, and ClosedPipe from within
/// `write`.
void write_output(const std::string& target, const std::function<void(std::ostream&)>& write);

}  // namespace graze::cli
