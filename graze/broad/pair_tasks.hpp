// SPDX-License-Identifier: MIT
// Work on a list of pairs that name shapes, in tasks.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>

#include <graze/broad/executor.hpp>
#include <graze/broad/pair.hpp>

namespace graze::detail {

/// Throws std::out_of_range when a pair names a shape that is not there.
inline void check_pairs(std::span<const Pair> pairs, std::size_t shapes, const char* caller) {
  std::uint32_t largest_of_all = 0;
  for (const Pair& pair : pairs) largest_of_all = std::max(largest_of_all, std::max(pair.a, pair.b));
  if (pairs.empty() || largest_of_all < shapes) return;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::size_t largest = std::max(pairs[i].a, pairs[i].b);
    if (largest < shapes) continue;
    throw std::out_of_range(std::string(caller) + ": pair " + std::to_string(i) + " names shape " +
                            std::to_string(largest) + ", but there are only " + std::to_string(shapes));
  }
}

/// Runs work(first, last) for tasks of 0 ... count, each of `task_size` but the last.
template <class Work>
void in_tasks(std::size_t count, std::size_t task_size, const Executor& executor, const Work& work) {
  executor.parallel_for((count + task_size - 1) / task_size,
                        [&](std::size_t task) { work(task * task_size, std::min(count, (task + 1) * task_size)); });
}

}  // namespace graze::detail
