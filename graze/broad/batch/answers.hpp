// SPDX-License-Identifier: MIT
// One question to many, in parallel.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <graze/broad/executor.hpp>

namespace graze {

/// Options of `ray_casts`, `closest_points`, `signed_distances` and `winding_numbers`.
struct BatchOptions {
  const Executor* executor = nullptr;  ///< Runs parallel work; nullptr means default_executor().
};

namespace detail {

/// ask(i) for every i below count, in order.
template <class Answer, class Ask>
std::vector<Answer> answers(std::size_t count, const BatchOptions& options, const Ask& ask) {
  constexpr std::size_t per_task = 256;
  std::vector<Answer> result(count);
  executor_of(options).parallel_for((count + per_task - 1) / per_task, [&](std::size_t task) {
    const std::size_t end = std::min(count, (task + 1) * per_task);
    for (std::size_t i = task * per_task; i < end; ++i) result[i] = ask(i);
  });
  return result;
}

}  // namespace detail
}  // namespace graze
