// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace graze::io {

/// Input that cannot be used. The message names the file, the place in it (line and column, or object and field), the
/// fact found and what would be allowed, and is ready to be shown to a person.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace graze::io
