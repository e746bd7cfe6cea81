// SPDX-License-Identifier: MIT
// How many cases a test tries: GRAZE_TEST_SCALE multiplies their number (default 1, a tenth with sanitizers).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>

namespace graze::test {

inline double number_from_environment(const char* name, double otherwise) {
  const char* const text = std::getenv(name);
  return text != nullptr ? std::strtod(text, nullptr) : otherwise;
}

/// `usual` times the scale, and at least `least`.
inline std::size_t number_of_cases(double usual, std::size_t least = 1) {
  return std::max(least, static_cast<std::size_t>(std::ceil(usual * number_from_environment("GRAZE_TEST_SCALE", 1))));
}

}  // namespace graze::test
