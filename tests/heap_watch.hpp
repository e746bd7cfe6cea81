// SPDX-License-Identifier: MIT
// For programs that are linked with heap_watch.cpp, whose operators new and delete take the place of the standard
// library's: what a thread asks of them, and that it be refused.
#pragma once

#include <cstddef>
#include <limits>

namespace graze::test {

/// Of one thread.
struct HeapWatch {
  static constexpr std::size_t no_end = std::numeric_limits<std::size_t>::max();

  std::size_t requests = 0;          ///< How often operator new was called,
  std::size_t bytes = 0;             ///< and for how much in all, but for what was refused.
  std::size_t grants_left = no_end;  ///< So many requests are still granted.
};

extern thread_local HeapWatch heap_watch;

/// How often a call asks for memory.
std::size_t requests_of(const auto& call) {
  const std::size_t before = heap_watch.requests;
  call();
  return heap_watch.requests - before;
}

}  // namespace graze::test
