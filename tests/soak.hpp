// SPDX-License-Identifier: MIT
// How long what lives on is exercised, and how full it is meanwhile.
#pragma once

#include <cstddef>
#include <cstdlib>

namespace graze::test {

/// 20,000, and so many times as many as GRAZE_TEST_SCALE says: 50 for a million.
inline std::size_t soak_operations() {
  const char* const scale = std::getenv("GRAZE_TEST_SCALE");
  return static_cast<std::size_t>(20'000 * (scale != nullptr ? std::strtod(scale, nullptr) : 1.0));
}

/// In so many operations a world fills and is emptied.
constexpr std::size_t soak_breath = 10'000;

/// How many things should be there at an operation: from none to `most` and back.
constexpr std::size_t soak_target(std::size_t operation, std::size_t most) {
  const std::size_t phase = operation % soak_breath;
  const std::size_t half = soak_breath / 2;
  return most * (phase < half ? phase : soak_breath - phase) / half;
}

}  // namespace graze::test
