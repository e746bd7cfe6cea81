// SPDX-License-Identifier: MIT
// The plain double loop: too slow for many boxes, too simple to be wrong. The judge of every other method.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <graze/broad/pair.hpp>
#include <graze/shape/aabb.hpp>

namespace graze {

/// Every pair of boxes that share a point, ascending. A box with min above max contains nothing and overlaps none.
template <Dim N, class T>
std::vector<Pair> brute_force_pairs(std::span<const Aabb<N, T>> boxes) {
  std::vector<Pair> pairs;
  const auto count = static_cast<std::uint32_t>(boxes.size());
  for (std::uint32_t a = 0; a < count; ++a) {
    if (is_nothing(boxes[a])) continue;
    for (std::uint32_t b = a + 1; b < count; ++b) {
      if (boxes_overlap(boxes[a], boxes[b]) && !is_nothing(boxes[b])) pairs.push_back({a, b});
    }
  }
  return pairs;
}

/// The same between two sets.
template <Dim N, class T>
std::vector<Pair> brute_force_pairs(std::span<const Aabb<N, T>> boxes_a, std::span<const Aabb<N, T>> boxes_b) {
  std::vector<Pair> pairs;
  for (std::uint32_t a = 0; a < boxes_a.size(); ++a) {
    if (is_nothing(boxes_a[a])) continue;
    for (std::uint32_t b = 0; b < boxes_b.size(); ++b) {
      if (boxes_overlap(boxes_a[a], boxes_b[b]) && !is_nothing(boxes_b[b])) pairs.push_back({a, b});
    }
  }
  return pairs;
}

}  // namespace graze
