// SPDX-License-Identifier: MIT
// Pairs in blocks, when a list of all would not fit into memory. A visitor that returns false ends the search.
#include <cstdio>
#include <memory>
#include <span>
#include <vector>

#include <graze/broad/scene_generators.hpp>
#include <graze/graze.hpp>

int main() {
  const graze::MovingBoxes<2> world(graze::World::heavy, 50'000, 1);
  const std::size_t expected = graze::overlapping_pairs(world.boxes()).size();

  // As they are found, by at most two threads. The visitor is called from this thread alone.
  const std::unique_ptr<graze::Executor> two_threads = graze::limited_executor(2);
  std::size_t found = 0;
  const auto count = [&found](std::span<const graze::Pair> block) {
    found += block.size();
    return true;
  };
  graze::visit_overlapping_pairs(world.boxes(), count, {.executor = two_threads.get()});
  std::printf("%zu pairs with %zu threads of %zu\n", found, two_threads->concurrency(),
              graze::default_executor().concurrency());

  // The same in every frame, with memory that is reused.
  std::size_t found_again = 0;
  graze::PairFinder<2> finder;
  finder.visit(world.boxes(), [&found_again](std::span<const graze::Pair> block) {
    found_again += block.size();
    return true;
  });

  // An executor runs your own tasks, too.
  std::vector<std::size_t> squares(100);
  two_threads->parallel_for(squares.size(), [&squares](std::size_t i) { squares[i] = i * i; });

  // In order, and only those of the first hundred boxes.
  std::size_t of_first = 0;
  bool ascend = true;
  graze::Pair last{};
  graze::visit_sorted_pairs(world.boxes(), [&](std::span<const graze::Pair> block) {
    for (const graze::Pair& pair : block) {
      if (pair.a >= 100) return false;
      ascend = ascend && !(pair < last);
      last = pair;
      ++of_first;
    }
    return true;
  });
  std::printf("%zu pairs of the first hundred boxes\n", of_first);
  return found_again == found && squares.back() == std::size_t{99} * 99 && found == expected && ascend &&
                 of_first > 0 && of_first < found
             ? 0
             : 1;
}
