// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/broad/bvh/build.hpp>
#include <graze/broad/bvh/node.hpp>
#include <graze/broad/bvh/split.hpp>
#include <graze/broad/executor.hpp>
#include <graze/broad/memory/buffer.hpp>
#include <graze/broad/memory/prefetch.hpp>
#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// Calls require_box for each; fast if all are finite.
template <Dim N, class T>
GRAZE_EXPORT void require_boxes(std::span<const Aabb<N, T>> boxes);

/// The boxes of a Bvh by slot, and the tree over them: an R-tree (Guttman 1984, "R-trees: a dynamic index structure for
/// spatial searching") whose nodes have up to sixteen entries. All leaf nodes have the same depth, and all nodes except
/// the root have at least bvh_least entries, which bounds the height; every change takes O(log n) steps. A new box
/// descends to where the bounds grow least. An overfull node is split; an underfull one takes entries from a sibling or
/// merges with it. A box that moves stays in its node unless a sibling is better.
///
/// The bounds of leaf nodes are grown by the margin; all others are tight. Boxes with infinite sides are in a list
/// beside the tree, whose boxes are all finite.
template <Dim N, class T>
class GRAZE_EXPORT BvhTree {
 public:
  using Box = Aabb<N, T>;
  using Node = BvhNode<N, T>;

  /// Throws std::invalid_argument if the margin is negative or not finite.
  explicit BvhTree(double margin);

  /// These throw only std::bad_alloc, and then have no visible effect. `generation` becomes part of the box's name,
  /// wherever it moves.
  void insert(std::uint32_t slot, const Box& box, std::uint32_t generation = 0);
  void update(std::uint32_t slot, const Box& box);

  void erase(std::uint32_t slot) noexcept;
  void clear() noexcept;

  /// Prefetches where a box is stored, and the node that contains it if known. Only for occupied slots.
  void prefetch_place(std::uint32_t slot) const {
    prefetch(&leaf_nodes_[slot]);
    prefetch(&boxes_[slot]);
  }
  void prefetch_node(std::uint32_t slot) const {
    if (are_leaf_nodes_known() && leaf_nodes_[slot] < nodes_.size()) prefetch_whole(&nodes_[leaf_nodes_[slot]]);
  }

  /// Fills an empty tree: boxes[i] in slots[i]. Generations are by slot; if the span is empty, all are 0. Also throws
  /// what the executor throws; the tree is unusable after an exception. The leaf node of each box is recorded before
  /// the next change, in O(n) steps, so queries need not wait for it.
  void fill(std::span<const Box> boxes, std::span<const std::uint32_t> slots, const Executor& executor,
            std::span<const std::uint32_t> generations = {});

  const Box& box(std::uint32_t slot) const { return boxes_[slot]; }
  double margin() const { return margin_; }

  BvhLink root() const { return root_; }
  const Node* nodes() const { return nodes_.data(); }
  const Node& node(BvhLink link) const { return nodes_[link.index()]; }
  std::uint32_t count(BvhLink link) const { return places_[link.index()].count; }
  std::uint32_t parent(BvhLink link) const { return places_[link.index()].parent; }
  std::size_t boxes_below(BvhLink link) const;
  Box bounds() const;  ///< Of a tree that is not empty.

  /// The boxes beside the tree.
  std::span<const BvhName> infinite() const { return infinite_; }

  /// The number of allocated nodes that are not in the tree.
  std::size_t spare_nodes() const { return spare_.size(); }

  /// The memory held, in bytes.
  std::size_t bytes() const;

 private:
  BvhLink parent_link(BvhLink link) const { return BvhLink::inner(places_[link.index()].parent); }
  std::uint32_t lane_of(std::uint32_t node, std::uint32_t entry) const;

  bool are_leaf_nodes_known() const { return unknown_leaf_nodes_ == 0; }
  void note_leaf_nodes() noexcept;
  void require_nodes();
  std::uint32_t take_node() noexcept;
  void release_node(std::uint32_t index) noexcept;
  void put(BvhLink link, std::uint32_t lane, const BvhEntry<N, T>& entry) noexcept;
  void fill_node(BvhLink link, std::span<const BvhEntry<N, T>> entries) noexcept;
  void remove_lane(std::uint32_t node, std::uint32_t lane) noexcept;
  Box bounds_of(BvhLink link) const;
  void plant(BvhLink link, const BvhEntry<N, T>& first) noexcept;

  void attach(const BvhEntry<N, T>& leaf) noexcept;
  void add(BvhLink link, BvhEntry<N, T> entry) noexcept;
  BvhEntry<N, T> detach(std::uint32_t slot) noexcept;
  void mend(BvhLink link) noexcept;
  bool join(BvhLink link) noexcept;
  bool shift(std::uint32_t slot, const Box& box) noexcept;
  bool fit(const Box& bounds, const Box& around) const;
  void tighten_above(BvhLink link) noexcept;
  void clear_tree() noexcept;
  BvhName remove_from_list(std::uint32_t slot) noexcept;

  double margin_;
  BlankVector<Node> nodes_;
  PageVector<BvhPlace> places_;       // by node
  std::vector<std::uint32_t> spare_;  // nodes that are not in the tree
  BvhLink root_;
  std::size_t height_ = 0;                 // levels of nodes
  BlankVector<Box> boxes_;                 // by slot
  BlankVector<std::uint32_t> leaf_nodes_;  // by slot: the number of the node, or the index in `infinite_`
  // the boxes of this many first leaf nodes do not have their nodes recorded yet
  std::uint32_t unknown_leaf_nodes_ = 0;
  std::vector<BvhName> infinite_;
};

}  // namespace graze::detail
