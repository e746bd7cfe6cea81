// SPDX-License-Identifier: MIT
// Every method finds the same pairs as a double loop. Usage: pair_methods [WORLD [METHOD]]
#include <algorithm>
#include <cstdio>
#include <optional>
#include <span>
#include <vector>

#include <graze/broad/scene_generators.hpp>
#include <graze/graze.hpp>

int main(int argc, char** argv) {
  const std::optional<graze::World> world = graze::world_named(argc > 1 ? argv[1] : "cluster");
  const std::optional<graze::PairMethod> only = graze::pair_method_named(argc > 2 ? argv[2] : "automatic");
  if (!world || !only) {
    std::fprintf(stderr, "the worlds are");
    for (const graze::World known : graze::all_worlds()) std::fprintf(stderr, " %s", graze::name_of(known).data());
    std::fprintf(stderr, "; the methods are");
    for (const graze::PairMethod known : graze::all_pair_methods()) {
      std::fprintf(stderr, " %s", graze::name_of(known).data());
    }
    std::fprintf(stderr, "\n");
    return 2;
  }

  graze::MovingBoxes<3> boxes(*world, 2000, 1);
  bool all_agree = true;
  for (const graze::PairMethod method : graze::all_pair_methods()) {
    if (argc > 2 && method != *only) continue;
    graze::PairFinder<3> finder;  // keeps its memory from frame to frame
    for (int frame = 0; frame < 3; ++frame) {
      boxes.step();
      const std::vector<graze::Pair> expected = graze::brute_force_pairs(boxes.boxes());
      const std::span<const graze::Pair> found = finder.find(boxes.boxes(), {.method = method});
      all_agree = all_agree && std::equal(found.begin(), found.end(), expected.begin(), expected.end());
    }
    std::printf("%s: %s, %zu KiB\n", graze::name_of(method).data(), graze::name_of(finder.method()).data(),
                finder.bytes() / 1024);
  }
  return all_agree ? 0 : 1;
}
