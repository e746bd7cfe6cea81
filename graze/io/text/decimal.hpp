// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include <graze/math/platform/export.hpp>

namespace graze::io {

/// A number that was read from text, or why there is none.
struct Decimal {
  double value = 0;
  std::string fault =
      {};  ///< Continues the number's name: `is "1,5", which is not a number; ...`; empty if there is none.
};

/// Reads a decimal number, rounded to the nearest double. A leading plus sign is allowed, blanks are not. The whole
/// text must be the number, which must be finite.
GRAZE_EXPORT Decimal decimal_of(std::string_view text);

}  // namespace graze::io
