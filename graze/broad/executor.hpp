// SPDX-License-Identifier: MIT
/// @file
/// What runs parallel work: oneTBB, the calling thread, or the job system of the host program.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include <graze/math/platform/export.hpp>

namespace graze {

/// Runs independent tasks. Results never depend on it: either work is split into the same tasks for every executor, or
/// each result depends on its own input alone.
class GRAZE_EXPORT Executor {
 public:
  virtual ~Executor() = default;

  /// Calls task(i) once for every i below count, in any order and on any threads, and returns when all have ended. May
  /// be called from several threads and from within a task. If tasks throw, rethrows one of the exceptions; tasks that
  /// have not started may be skipped.
  virtual void parallel_for(std::size_t count, const std::function<void(std::size_t)>& task) const = 0;

  /// The number of tasks that may run at the same time, at least 1. A hint only.
  virtual std::size_t concurrency() const = 0;
};

/// Uses all cores, through oneTBB's shared pool.
GRAZE_EXPORT const Executor& default_executor();

/// Uses the calling thread alone, with tasks in ascending order.
GRAZE_EXPORT const Executor& serial_executor();

/// Uses at most this many threads of oneTBB's pool, the calling thread included, and at most as many as the machine
/// has. Throws std::invalid_argument for 0.
GRAZE_EXPORT std::unique_ptr<Executor> limited_executor(std::size_t threads);

namespace detail {

/// The executor of a call: the one in its options, or the default.
template <class Options>
const Executor& executor_of(const Options& options) {
  return options.executor != nullptr ? *options.executor : default_executor();
}

}  // namespace detail

}  // namespace graze
