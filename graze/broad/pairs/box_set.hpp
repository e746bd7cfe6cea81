// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

#include <graze/math/platform/throw.hpp>

namespace graze::detail {

/// Which boxes of a call are meant.
enum class BoxSet { only, first, second };

/// Throws std::invalid_argument, which names the box.
[[noreturn]] inline void refuse_nan(std::size_t box, BoxSet set) {
  const char* const of_set = set == BoxSet::only    ? ""
                             : set == BoxSet::first ? " of the first set"
                                                    : " of the second set";
  GRAZE_THROW(std::invalid_argument("overlapping_pairs: box " + std::to_string(box) + of_set +
                                    " has a coordinate that is NaN"));
}

}  // namespace graze::detail
