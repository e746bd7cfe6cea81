// SPDX-License-Identifier: MIT
// One question to many, in parallel.
#pragma once

#include <cstddef>
#include <vector>

#include <graze/broad/batch/tasks.hpp>
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
  return written_by_tasks<Answer>(count, per_task, executor_of(options),
                                  [&ask](std::size_t first, std::size_t last, Answer* out) {
                                    for (std::size_t i = first; i < last; ++i) *out++ = ask(i);
                                  });
}

}  // namespace detail
}  // namespace graze
