// SPDX-License-Identifier: MIT
/// @file
/// The plain double loop: too slow for many boxes, too simple to be wrong. The reference for every other method.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/broad/pair.hpp>
#include <graze/shape/aabb.hpp>

namespace graze {
namespace detail {

template <Dim N, class T>
bool has_nan(const Aabb<N, T>& box) {
  for (Dim i = 0; i < N; ++i) {
    if (std::isnan(box.min[i]) || std::isnan(box.max[i])) return true;
  }
  return false;
}

/// Adds the pairs of box `a` and the boxes from `first` on.
template <Dim N, class T>
void add_brute_force_pairs(const Aabb<N, T>& box, std::uint32_t a, std::span<const Aabb<N, T>> boxes,
                           std::uint32_t first, std::vector<Pair>& pairs) {
  if (is_nothing(box)) return;
  for (std::uint32_t b = first; b < boxes.size(); ++b) {
    if (boxes_overlap(box, boxes[b]) && !is_nothing(boxes[b])) pairs.push_back({a, b});
  }
}

}  // namespace detail

/// Every pair of boxes that share a point (touching counts), ascending, with a < b. Exact. A box that contains nothing
/// (min above max) or has a NaN overlaps none. `overlapping_pairs` is faster.
template <Dim N, class T>
std::vector<Pair> brute_force_pairs(std::span<const Aabb<N, T>> boxes) {
  std::vector<Pair> pairs;
  for (std::uint32_t a = 0; a < boxes.size(); ++a) detail::add_brute_force_pairs(boxes[a], a, boxes, a + 1, pairs);
  return pairs;
}

/// Every pair of a box of one sequence (index a) and a box of another (index b) that share a point, ascending.
template <Dim N, class T>
std::vector<Pair> brute_force_pairs(std::span<const Aabb<N, T>> boxes_a, std::span<const Aabb<N, T>> boxes_b) {
  std::vector<Pair> pairs;
  for (std::uint32_t a = 0; a < boxes_a.size(); ++a) {
    detail::add_brute_force_pairs(boxes_a[a], a, boxes_b, 0, pairs);
  }
  return pairs;
}

}  // namespace graze
