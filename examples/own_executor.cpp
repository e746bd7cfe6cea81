// SPDX-License-Identifier: MIT
// Finds pairs on the threads of a program's own job system, here a minimal one.
#include <atomic>
#include <cstdio>
#include <thread>
#include <vector>

#include <graze/broad/scene_generators.hpp>
#include <graze/graze.hpp>

class Jobs : public graze::Executor {
 public:
  void parallel_for(std::size_t count, const std::function<void(std::size_t)>& task) const override {
    std::atomic<std::size_t> next = 0;
    std::vector<std::jthread> threads;  // joined when they go out of scope
    for (std::size_t k = 0; k < concurrency(); ++k) {
      threads.emplace_back([&] {
        for (std::size_t i = next++; i < count; i = next++) task(i);
      });
    }
  }
  std::size_t concurrency() const override { return 2; }
};

int main() {
  const graze::MovingBoxes<3, float> world(graze::World::brownian, 100'000, 1);
  const Jobs jobs;
  const auto pairs = graze::overlapping_pairs(world.boxes(), {.executor = &jobs});
  std::printf("%zu boxes, %zu overlapping pairs\n", world.boxes().size(), pairs.size());
  return pairs == graze::overlapping_pairs(world.boxes(), {.executor = &graze::serial_executor()}) ? 0 : 1;
}
