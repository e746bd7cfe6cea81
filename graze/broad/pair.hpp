// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>

namespace graze {

/// Two boxes by their position in the caller's sequence. Pairs of one set have a < b.
struct Pair {
  std::uint32_t a = 0;
  std::uint32_t b = 0;

  friend auto operator<=>(const Pair&, const Pair&) = default;
};

}  // namespace graze
