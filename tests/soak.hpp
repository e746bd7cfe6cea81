// SPDX-License-Identifier: MIT
// How long soak tests run, and how full they are meanwhile.
#pragma once

#include <algorithm>
#include <cstddef>

#include "number_of_cases.hpp"

namespace graze::test {

/// 20,000, multiplied by GRAZE_TEST_SCALE: 50 for a million. Never so few that a set stays small.
inline std::size_t soak_operations() { return number_of_cases(20'000, 8'000); }

/// The number of operations in which a set is filled and emptied once: at least four cycles, more in longer runs.
constexpr std::size_t soak_cycle(std::size_t operations) { return std::min<std::size_t>(operations / 4, 10'000); }

/// The target size at an operation: from none to `most` and back in each cycle.
constexpr std::size_t soak_target(std::size_t operation, std::size_t breath, std::size_t most) {
  const std::size_t phase = operation % breath;
  const std::size_t half = breath / 2;
  return most * (phase < half ? phase : breath - phase) / half;
}

}  // namespace graze::test
