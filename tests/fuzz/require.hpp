// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <iostream>

namespace graze::test::fuzz {

/// Aborts the program if a law does not hold, which the fuzzer reports as a crash, keeping the input. Prints a message
/// first: say(std::cerr).
template <class Say>
void require(bool holds, const Say& say) {
  if (holds) return;
  std::cerr << "\nnot so: ";
  say(std::cerr);
  std::cerr << "\n";
  std::abort();
}

}  // namespace graze::test::fuzz
