// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>

namespace graze {

/// Two boxes by their indices in the caller's sequences. Pairs within one sequence have a < b.
struct Pair {
  std::uint32_t a = 0;  ///< Index of the first box.
  std::uint32_t b = 0;  ///< Index of the second box.

  friend auto operator<=>(const Pair&, const Pair&) = default;
};

}  // namespace graze
