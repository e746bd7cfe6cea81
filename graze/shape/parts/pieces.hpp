// SPDX-License-Identifier: MIT
// Work on many boxes or faces that may be shared among threads: by an Executor (broad/executor.hpp), or anything else
// with its parallel_for.
#pragma once

#include <algorithm>
#include <cstddef>

namespace graze::detail {

/// An executor that uses the calling thread.
struct OneByOne {
  template <class Task>
  void parallel_for(std::size_t count, const Task& task) const {
    for (std::size_t i = 0; i < count; ++i) task(i);
  }
};

inline constexpr std::size_t length_of_piece = std::size_t{1} << 14U;

/// Calls task(first, last) for the pieces of a range, the same ones for every executor.
template <class Executor, class Task>
void for_pieces(const Executor& executor, std::size_t count, const Task& task) {
  executor.parallel_for((count + length_of_piece - 1) / length_of_piece,
                        [&](std::size_t i) { task(i * length_of_piece, std::min((i + 1) * length_of_piece, count)); });
}

}  // namespace graze::detail
