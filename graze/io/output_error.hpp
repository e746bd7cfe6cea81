// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace graze::io {

/// Output that cannot be written. The message names the file, the fact found and the way out, and is ready to be shown
/// to a person.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace graze::io
