// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>

namespace graze {

/// Two boxes of a world that is spread over many ranks, by the ids that their owners gave them; a < b.
struct IdPair {
  std::uint64_t a = 0;  ///< The lower id.
  std::uint64_t b = 0;  ///< The higher id.

  friend auto operator<=>(const IdPair&, const IdPair&) = default;
};

}  // namespace graze
