// SPDX-License-Identifier: MIT
// Builds the nodes of a Bvh from all boxes at once.
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

/// A node's parent and its number of entries.
struct BvhPlace {
  std::uint32_t parent;  ///< The parent's number; no_box for the root.
  std::uint32_t count;
};

/// The nodes of a tree for a number of boxes: as few as possible with sixteen entries each, level by level, where entry
/// counts in a level differ by at most one. Nodes of a level are numbered from left to right, leaf nodes first.
class BvhPlan {
 public:
  /// `boxes` must be at least 1.
  explicit BvhPlan(std::size_t boxes);

  /// The number of levels of nodes; level 0 contains the leaf nodes.
  std::size_t height() const { return sizes_.size() - 1; }
  std::size_t nodes() const { return firsts_.back(); }
  std::size_t leaf_nodes() const { return sizes_[1]; }

  std::uint32_t index(std::size_t level, std::size_t node) const {
    return static_cast<std::uint32_t>(firsts_[level] + node);
  }

  /// The first entry of a node of a level, as the number of a node in the level below, or of a box. For the number
  /// after the last node: the count of entries.
  std::size_t first_entry(std::size_t level, std::size_t node) const {
    return static_cast<std::size_t>(std::uint64_t{node} * sizes_[level] / sizes_[level + 1]);
  }

  /// The first box below a node of a level. For the number after the last node: the count of boxes.
  std::size_t first_box(std::size_t level, std::size_t node) const {
    for (std::size_t k = level + 1; k-- > 0;) node = first_entry(k, node);
    return node;
  }

 private:
  std::vector<std::size_t> sizes_;   // number of boxes, of leaf nodes, of nodes above them, ..., of roots
  std::vector<std::size_t> firsts_;  // the number of each level's first node, then the total
};

/// Whether the slots are consecutive, as they are if nothing was erased.
inline bool are_in_a_row(std::span<const std::uint32_t> slots) {
  std::uint32_t apart = 0;
  for (std::size_t k = 0; k < slots.size(); ++k) apart |= slots[k] - slots[0] - static_cast<std::uint32_t>(k);
  return apart == 0;
}

/// Input and output of building a tree: boxes and their generations by slot; nodes and their parents by number, as many
/// as the plan has.
template <Dim N, class T>
struct BvhArrays {
  const Aabb<N, T>* boxes;
  BvhNode<N, T>* nodes;
  BvhPlace* places;
  std::span<const std::uint32_t> generations = {};
  std::uint32_t generation = 0;  ///< Of all boxes, if there are no generations by slot.
};

/// Builds a tree of the finite boxes in these slots; the bounds of leaf nodes are grown by a margin. Boxes are split
/// along the longest axis of the box around their centers, into parts that fill equal numbers of nodes (Friedman,
/// Bentley and Finkel 1977, "An algorithm for finding best matches in logarithmic expected time"). The tree depends
/// only on the set of slots, not on their order or the executor. Throws std::bad_alloc, and what the executor throws.
template <Dim N, class T>
void build_bvh(std::span<const std::uint32_t> slots, double margin, const BvhPlan& plan, const BvhArrays<N, T>& arrays,
               const Executor& executor);

}  // namespace graze::detail
