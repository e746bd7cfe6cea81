// SPDX-License-Identifier: MIT
#include <graze/broad/executor.hpp>

namespace graze {
namespace {

class SerialExecutor final : public Executor {
 public:
  void parallel_for(std::size_t count, const std::function<void(std::size_t)>& task) const override {
    for (std::size_t i = 0; i < count; ++i) task(i);
  }
  std::size_t concurrency() const override { return 1; }
};

}  // namespace

const Executor& serial_executor() {
  static const SerialExecutor executor;
  return executor;
}

}  // namespace graze
