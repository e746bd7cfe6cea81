// SPDX-License-Identifier: MIT
// For programs linked with heap_watch.cpp, whose operators new and delete replace those of the standard library: counts
// a thread's allocations, and can make them fail.
#pragma once

#include <cstddef>
#include <limits>

namespace graze::test {

/// Of one thread.
struct HeapWatch {
  static constexpr std::size_t no_end = std::numeric_limits<std::size_t>::max();

  std::size_t requests = 0;          ///< Calls of operator new,
  std::size_t bytes = 0;             ///< and the total size of the successful ones.
  std::size_t grants_left = no_end;  ///< This many requests still succeed.
};

extern thread_local HeapWatch heap_watch;

/// The number of allocations of a call.
std::size_t requests_of(const auto& call) {
  const std::size_t before = heap_watch.requests;
  call();
  return heap_watch.requests - before;
}

}  // namespace graze::test
