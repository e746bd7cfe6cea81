// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

#include <graze/math/platform/export.hpp>

namespace graze::io {

/// Thrown for input that cannot be used. The message names the file, the place in it (line and column, or object and
/// field), the fault and what is allowed; it can be shown to users as it is.
class GRAZE_EXPORT InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace graze::io
