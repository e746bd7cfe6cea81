// SPDX-License-Identifier: MIT
// Who runs parallel work: oneTBB, the calling thread, or the job system of the program that graze is part of.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace graze {

/// Runs independent tasks. Answers never depend on it: work is cut into the same tasks whoever runs them.
class Executor {
 public:
  virtual ~Executor() = default;

  /// Calls task(i) once for every i below count, in any order and on any threads, and returns when all have ended. May
  /// be called from several threads, and from within a task. When a task throws, one of the exceptions comes out
  /// of here, and tasks that have not begun may be left out.
  virtual void parallel_for(std::size_t count, const std::function<void(std::size_t)>& task) const = 0;

  /// How many tasks may run at the same time; at least 1. Only a hint.
  virtual std::size_t concurrency() const = 0;
};

/// All cores of the machine, through oneTBB's shared pool.
const Executor& default_executor();

/// The calling thread alone, task by task in ascending order.
const Executor& serial_executor();

/// At most so many threads of oneTBB's pool, the calling thread among them, and no more than the machine has. Throws
/// std::invalid_argument for none.
std::unique_ptr<Executor> limited_executor(std::size_t threads);

namespace detail {

/// Who runs the work of a call: the executor that its options name, or the usual one.
template <class Options>
const Executor& executor_of(const Options& options) {
  return options.executor != nullptr ? *options.executor : default_executor();
}

}  // namespace detail

}  // namespace graze
