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

/// Calls `write` with a stream to the target: "-" for the standard output, otherwise a file, which keeps its old
/// content unless everything has been written (see write_atomically). Throws OutputError, and ClosedPipe out of
/// `write`.
void write_output(const std::string& target, const std::function<void(std::ostream&)>& write);

}  // namespace graze::cli
