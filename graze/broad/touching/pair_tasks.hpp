// SPDX-License-Identifier: MIT
// Distributes a list of pairs of shapes to tasks.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <graze/broad/batch/tasks.hpp>
#include <graze/broad/executor.hpp>
#include <graze/broad/pair.hpp>
#include <graze/math/platform/throw.hpp>

namespace graze::detail {

/// Throws std::out_of_range if a pair names a shape that does not exist.
inline void check_pairs(std::span<const Pair> pairs, std::size_t shapes, const char* caller) {
  if (pairs.empty()) return;
  if (shapes > 0 && shapes <= std::size_t{1} << 31U) {
    // The highest bit of an index, or of its distance below the last one, is set exactly if it is too large: three
    // operations for four indices, fewer than unsigned comparisons take.
    const auto last = static_cast<std::uint32_t>(shapes - 1);
    std::uint32_t any = 0;
    for (const Pair& pair : pairs) any |= pair.a | (last - pair.a) | pair.b | (last - pair.b);
    if (any >> 31U == 0) return;
  }
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::size_t largest = std::max(pairs[i].a, pairs[i].b);
    if (largest < shapes) continue;
    GRAZE_THROW(std::out_of_range(std::string(caller) + ": pair " + std::to_string(i) + " names shape " +
                                  std::to_string(largest) + ", but there are only " + std::to_string(shapes)));
  }
}

/// Concatenates what keep(first, last, out) writes for each task; it returns how many it wrote.
template <class Kept, class Keep>
std::vector<Kept> kept_of_tasks(std::size_t count, std::size_t task_size, const Executor& executor, const Keep& keep) {
  std::vector<Kept> kept(count);
  std::vector<std::size_t> counts((count + task_size - 1) / task_size);
  in_tasks(count, task_size, executor, [&](std::size_t first, std::size_t last) {
    counts[first / task_size] = keep(first, last, kept.data() + first);
  });
  std::size_t end = 0;
  for (std::size_t task = 0; task < counts.size(); ++task) {
    const auto first = kept.begin() + static_cast<std::ptrdiff_t>(task * task_size);
    std::copy(first, first + static_cast<std::ptrdiff_t>(counts[task]),
              kept.begin() + static_cast<std::ptrdiff_t>(end));
    end += counts[task];
  }
  kept.resize(end);
  return kept;
}

}  // namespace graze::detail
