// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace graze::detail {

/// Places drawn one after another, for samples: the same ones each time and on every machine, spread evenly and without
/// regard to each other. Knuth's linear congruential generator, TAOCP 2, 3.3.4, of which the upper half is taken.
class LinearCongruential {
 public:
  /// Other seeds give other rows of places.
  explicit LinearCongruential(std::uint64_t seed = 1) : state_(seed * 0x9E3779B97F4A7C15U) {}

  /// A place below `count`, which is at least 1 and at most 2^32.
  std::size_t below(std::size_t count) {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<std::size_t>(((state_ >> 32U) * count) >> 32U);
  }

 private:
  std::uint64_t state_;
};

}  // namespace graze::detail
