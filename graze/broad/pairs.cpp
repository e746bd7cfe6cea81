// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <graze/broad/box_tree.hpp>
#include <graze/broad/brute_force.hpp>
#include <graze/broad/pairs.hpp>

namespace graze {
namespace {

// Below this many boxes the double loop beats building a tree.
constexpr std::size_t brute_force_limit = 64;

template <Dim N, class T>
void require_numbers(std::span<const Aabb<N, T>> boxes) {
  if (boxes.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw std::length_error("overlapping_pairs: there are more than 2^32 - 1 boxes");
  }
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    for (Dim i = 0; i < N; ++i) {
      if (std::isnan(boxes[k].min[i]) || std::isnan(boxes[k].max[i])) {
        throw std::invalid_argument("overlapping_pairs: box " + std::to_string(k) + " has a coordinate that is NaN");
      }
    }
  }
}

/// Boxes that a tree can sort by their centers, and those that reach to infinity, which would only bloat its nodes.
struct Sorted {
  std::vector<std::uint32_t> finite;
  std::vector<std::uint32_t> infinite;
};

template <Dim N, class T>
Sorted sorted_by_extent(std::span<const Aabb<N, T>> boxes) {
  Sorted sorted;
  for (std::uint32_t k = 0; k < boxes.size(); ++k) {
    if (is_nothing(boxes[k])) continue;
    const bool finite = is_finite(boxes[k].min) && is_finite(boxes[k].max);
    (finite ? sorted.finite : sorted.infinite).push_back(k);
  }
  return sorted;
}

template <Dim N, class T>
std::vector<Pair> tree_pairs(std::span<const Aabb<N, T>> boxes) {
  Sorted sorted = sorted_by_extent(boxes);
  std::vector<Pair> pairs;
  const auto add = [&pairs](std::uint32_t i, std::uint32_t j) { pairs.push_back({std::min(i, j), std::max(i, j)}); };
  for (std::size_t i = 0; i < sorted.infinite.size(); ++i) {
    const Aabb<N, T>& box = boxes[sorted.infinite[i]];
    for (std::size_t j = i + 1; j < sorted.infinite.size(); ++j) {
      if (boxes_overlap(box, boxes[sorted.infinite[j]])) add(sorted.infinite[i], sorted.infinite[j]);
    }
    for (const std::uint32_t k : sorted.finite) {
      if (boxes_overlap(box, boxes[k])) add(sorted.infinite[i], k);
    }
  }
  detail::BoxTree<N, T>(boxes, std::move(sorted.finite)).visit_pairs(add);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

template <Dim N, class T>
std::vector<Pair> tree_pairs(std::span<const Aabb<N, T>> boxes_a, std::span<const Aabb<N, T>> boxes_b) {
  Sorted sorted_a = sorted_by_extent(boxes_a);
  Sorted sorted_b = sorted_by_extent(boxes_b);
  std::vector<Pair> pairs;
  const auto add = [&pairs](std::uint32_t a, std::uint32_t b) { pairs.push_back({a, b}); };
  const auto add_overlaps = [&](std::span<const std::uint32_t> from_a, std::span<const std::uint32_t> from_b) {
    for (const std::uint32_t a : from_a) {
      for (const std::uint32_t b : from_b) {
        if (boxes_overlap(boxes_a[a], boxes_b[b])) add(a, b);
      }
    }
  };
  add_overlaps(sorted_a.infinite, sorted_b.infinite);
  add_overlaps(sorted_a.infinite, sorted_b.finite);
  add_overlaps(sorted_a.finite, sorted_b.infinite);
  const detail::BoxTree<N, T> tree_b(boxes_b, std::move(sorted_b.finite));
  detail::BoxTree<N, T>(boxes_a, std::move(sorted_a.finite)).visit_pairs(tree_b, add);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

bool use_brute_force(const PairOptions& options, std::size_t count) {
  if (options.method == PairMethod::automatic) return count <= brute_force_limit;
  return options.method == PairMethod::brute_force;
}

}  // namespace

template <Dim N, class T>
std::vector<Pair> overlapping_pairs(std::span<const Aabb<N, T>> boxes, const PairOptions& options) {
  require_numbers(boxes);
  return use_brute_force(options, boxes.size()) ? brute_force_pairs(boxes) : tree_pairs(boxes);
}

template <Dim N, class T>
std::vector<Pair> overlapping_pairs(std::span<const Aabb<N, T>> boxes_a, std::span<const Aabb<N, T>> boxes_b,
                                    const PairOptions& options) {
  require_numbers(boxes_a);
  require_numbers(boxes_b);
  const bool brute_force = use_brute_force(options, std::min(boxes_a.size(), boxes_b.size()));
  return brute_force ? brute_force_pairs(boxes_a, boxes_b) : tree_pairs(boxes_a, boxes_b);
}

#define GRAZE_INSTANTIATE(N, T)                                                                                \
  template std::vector<Pair> overlapping_pairs<N, T>(std::span<const Aabb<N, T>>, const PairOptions&);         \
  template std::vector<Pair> overlapping_pairs<N, T>(std::span<const Aabb<N, T>>, std::span<const Aabb<N, T>>, \
                                                     const PairOptions&);

GRAZE_INSTANTIATE(2, float)
GRAZE_INSTANTIATE(3, float)
GRAZE_INSTANTIATE(2, double)
GRAZE_INSTANTIATE(3, double)

#undef GRAZE_INSTANTIATE

}  // namespace graze
