// SPDX-License-Identifier: MIT
// A Bvh's nodes, built from boxes at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/broad/bvh/node.hpp>
#include <graze/broad/executor.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// Where a node hangs, and how many entries it has.
struct BvhPlace {
  std::uint32_t parent;  ///< The number of a node, that of the root no_box.
  std::uint32_t count;
};

/// Which nodes a tree of so many boxes has: as few as there can be of sixteen entries, level by level, whose entries
/// differ in number by one at most. The nodes of a level are numbered from left to right, those of the leaves first.
class BvhPlan {
 public:
  /// For one box at least.
  explicit BvhPlan(std::size_t boxes);

  /// How many levels of nodes there are; level 0 are the leaf nodes.
  std::size_t height() const { return sizes_.size() - 1; }
  std::size_t nodes() const { return firsts_.back(); }
  std::size_t leaf_nodes() const { return sizes_[1]; }

  std::uint32_t index(std::size_t level, std::size_t node) const {
    return static_cast<std::uint32_t>(firsts_[level] + node);
  }

  /// The first entry of a node of a level, as the number of a node of the level below, or of a box; for the one behind
  /// the last node how many there are.
  std::size_t first_entry(std::size_t level, std::size_t node) const {
    return static_cast<std::size_t>(std::uint64_t{node} * sizes_[level] / sizes_[level + 1]);
  }

  /// The first box below a node of a level; for the one behind the last node how many there are.
  std::size_t first_box(std::size_t level, std::size_t node) const {
    for (std::size_t k = level + 1; k-- > 0;) node = first_entry(k, node);
    return node;
  }

 private:
  std::vector<std::size_t> sizes_;   // how many boxes there are, leaf nodes, nodes above them, ..., the root
  std::vector<std::size_t> firsts_;  // the number of each level's first node, and of all
};

/// Whether each slot is the next one of that before it, as they are where nothing was erased. Looks at all.
inline bool are_in_a_row(std::span<const std::uint32_t> slots) {
  std::uint32_t apart = 0;
  for (std::size_t k = 0; k < slots.size(); ++k) apart |= slots[k] - slots[0] - static_cast<std::uint32_t>(k);
  return apart == 0;
}

/// What a tree is built of, boxes and their generations by slot, and into: nodes and places by number, as many as the
/// plan has.
template <Dim N, class T>
struct BvhArrays {
  const Aabb<N, T>* boxes;
  BvhNode<N, T>* nodes;
  BvhPlace* places;
  std::span<const std::uint32_t> generations = {};
  std::uint32_t generation = 0;  ///< Of all boxes, where there are no generations by slot.
};

/// Builds a tree of the boxes in these slots, where the bounds of leaf nodes are grown by a margin. Where boxes have to
/// be parted, it is along the longest axis of a box around their centers, into parts that fill as many nodes each
/// (Friedman, Bentley and Finkel 1977, "An algorithm for finding best matches in logarithmic expected time"). The boxes
/// are finite. The tree depends on the set of slots alone, neither on their order nor on the executor. Throws
/// std::bad_alloc, and what the executor does.
template <Dim N, class T>
void build_bvh(std::span<const std::uint32_t> slots, double margin, const BvhPlan& plan, const BvhArrays<N, T>& arrays,
               const Executor& executor);

}  // namespace graze::detail
