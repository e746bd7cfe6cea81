// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace graze::io {

/// Thrown for output that cannot be written. The message names the file, the fault and the way out; it can be shown to
/// users as it is.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace graze::io
