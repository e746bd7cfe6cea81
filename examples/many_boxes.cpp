// SPDX-License-Identifier: MIT
// All overlapping pairs among a hundred thousand boxes.
#include <cstdio>
#include <random>
#include <vector>

#include <graze/graze.hpp>

int main() {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> coordinate(0, 100);
  std::vector<graze::Aabb<3>> boxes;
  for (int i = 0; i < 100'000; ++i) {
    const graze::Vec<3> center(coordinate(random), coordinate(random), coordinate(random));
    boxes.push_back(graze::Aabb<3>::from_center(center, graze::Vec<3>(0.5F)));
  }
  const std::vector<graze::Pair> pairs = graze::overlapping_pairs(boxes);
  std::printf("%zu boxes, %zu overlapping pairs\n", boxes.size(), pairs.size());
}
