// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace graze::detail {

/// Pseudo-random indices for sampling: the same sequence on every machine, evenly distributed. Knuth's linear
/// congruential generator (TAOCP 2, 3.3.4); only the upper half of the state is used.
class LinearCongruential {
 public:
  explicit LinearCongruential(std::uint64_t seed = 1) : state_(seed * 0x9E3779B97F4A7C15U) {}

  /// An index below `count`, which must be from 1 to 2^32.
  std::size_t below(std::size_t count) {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<std::size_t>(((state_ >> 32U) * count) >> 32U);
  }

 private:
  std::uint64_t state_;
};

}  // namespace graze::detail
