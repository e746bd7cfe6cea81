// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

#include <graze/broad/executor.hpp>

namespace graze::test {

/// Starts this many threads for each call, whatever the machine has.
class ThreadExecutor final : public Executor {
 public:
  explicit ThreadExecutor(std::size_t threads) : threads_(threads) {}

  void parallel_for(std::size_t count, const std::function<void(std::size_t)>& task) const override {
    std::atomic<std::size_t> next = 0;
    std::vector<std::thread> threads;
    for (std::size_t k = 0; k < threads_; ++k) {
      threads.emplace_back([&] {
        for (std::size_t i = next++; i < count; i = next++) task(i);
      });
    }
    for (std::thread& thread : threads) thread.join();
  }
  std::size_t concurrency() const override { return threads_; }

 private:
  std::size_t threads_;
};

}  // namespace graze::test
