// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <iostream>

namespace graze::test::fuzz {

/// Ends the program where a law does not hold, which the fuzzer takes for a find: it keeps the input. Says what it was
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
