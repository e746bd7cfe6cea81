// SPDX-License-Identifier: MIT
// Where data goes: the standard output, or a file that is replaced in one step.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

namespace graze::cli {

/// Whoever read our standard output has closed it, as `head` does: no error, but nothing more to do.
struct ClosedPipe {};

/// True for the name of the standard output (or input): "-".
bool is_standard_stream(const std::string& name);

/// True when two names lead to the same file, or to the same standard stream.
bool name_same_file(const std::string& a, const std::string& b);

/// Throws UsageError when what is written to `output` would take the place of the scene that is read.
void require_not_overwritten(const std::string& scene, const std::string& output);

/// Calls `write` with a stream to the target: "-" for the standard output, otherwise a file, which keeps its old
/// content unless everything has been written (see write_atomically). Throws OutputError, and ClosedPipe out of
/// `write`.
void write_output(const std::string& target, const std::function<void(std::ostream&)>& write);

}  // namespace graze::cli
