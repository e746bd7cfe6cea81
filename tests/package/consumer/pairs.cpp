// SPDX-License-Identifier: MIT
#include <array>

#include <graze/broad/pairs.hpp>

int main() {
  const std::array<graze::Aabb<2>, 3> boxes{{{{0, 0}, {1, 1}}, {{1, 1}, {2, 2}}, {{3, 3}, {4, 4}}}};
  return graze::overlapping_pairs<2, float>(boxes).size() == 1 ? 0 : 1;
}
