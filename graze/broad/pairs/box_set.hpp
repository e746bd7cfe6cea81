// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

#include <graze/math/platform/throw.hpp>

namespace graze::detail {

/// Which set of boxes of a call a message refers to.
enum class BoxSet { only, first, second };

/// Throws std::invalid_argument, naming the box.
[[noreturn]] inline void refuse_nan(std::size_t box, BoxSet set) {
  const char* const of_set = set == BoxSet::only    ? ""
                             : set == BoxSet::first ? " of the first set"
                                                    : " of the second set";
  GRAZE_THROW(std::invalid_argument("overlapping_pairs: box " + std::to_string(box) + of_set +
                                    " has a coordinate that is NaN"));
}

}  // namespace graze::detail
