// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

#include <graze/math/platform/export.hpp>

namespace graze::io {

/// Thrown for output that cannot be written. The message names the file, the fault and the way out; it can be shown to
/// users as it is.
class GRAZE_EXPORT OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace graze::io
