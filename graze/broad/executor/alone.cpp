// SPDX-License-Identifier: MIT
// Replaces tbb.cpp if oneTBB is not available: everything runs on the calling thread.
#include <stdexcept>

#include <graze/broad/executor.hpp>

namespace graze {
namespace {

class LimitedExecutor final : public Executor {
 public:
  void parallel_for(std::size_t count, const std::function<void(std::size_t)>& task) const override {
    serial_executor().parallel_for(count, task);
  }
  std::size_t concurrency() const override { return 1; }
};

}  // namespace

const Executor& default_executor() { return serial_executor(); }

std::unique_ptr<Executor> limited_executor(std::size_t threads) {
  if (threads == 0) throw std::invalid_argument("limited_executor: at least one thread is needed, 0 were asked for");
  return std::make_unique<LimitedExecutor>();
}

}  // namespace graze
