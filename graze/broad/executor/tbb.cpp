// SPDX-License-Identifier: MIT
#include <algorithm>
#include <stdexcept>

#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>

#include <graze/broad/executor.hpp>

namespace graze {
namespace {

using Task = std::function<void(std::size_t)>;

class TbbExecutor final : public Executor {
 public:
  explicit TbbExecutor(int threads) : arena_(threads) {}

  void parallel_for(std::size_t count, const Task& task) const override {
    if (count <= 1 || concurrency() <= 1) {
      for (std::size_t i = 0; i < count; ++i) task(i);
      return;
    }
    // graze's tasks are large, so each may run on another thread.
    arena_.execute([&] { tbb::parallel_for(std::size_t{0}, count, task, tbb::simple_partitioner()); });
  }

  std::size_t concurrency() const override { return static_cast<std::size_t>(arena_.max_concurrency()); }

 private:
  mutable tbb::task_arena arena_;
};

}  // namespace

const Executor& default_executor() {
  static const TbbExecutor executor(tbb::task_arena::automatic);
  return executor;
}

std::unique_ptr<Executor> limited_executor(std::size_t threads) {
  if (threads == 0) throw std::invalid_argument("limited_executor: at least one thread is needed, 0 were asked for");
  // oneTBB prints a warning if more threads are requested than exist.
  const auto available = static_cast<std::size_t>(tbb::info::default_concurrency());
  return std::make_unique<TbbExecutor>(static_cast<int>(std::min(threads, available)));
}

}  // namespace graze
