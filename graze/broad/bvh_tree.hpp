// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/broad/bvh_build.hpp>
#include <graze/broad/executor.hpp>
#include <graze/broad/prefetch.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// The boxes of a Bvh by slot, and the binary tree over them. A leaf is one box, grown by the margin. A new leaf goes
/// down to where it adds the least surface (Catto 2019, "Dynamic bounding volume hierarchies"), one that moves out of
/// the small group around it goes up as far as it must and down from there. What breaks the rule of balance
/// (is_out_of_balance) is built anew, by which the height is bounded and the tree stays nearly as good as one built at
/// once: measured on 100,000 boxes that were inserted, moved and inserted again, a query looks at 1.0 to 1.4 times as
/// many.
///
/// Boxes with infinite sides are in a list beside the tree, whose boxes are all finite.
template <Dim N, class T>
class BvhTree {
 public:
  using Box = Aabb<N, T>;
  using Node = BvhNode<N, T>;

  /// Throws std::invalid_argument for a margin that is negative or not finite.
  explicit BvhTree(double margin);

  /// Each of these throws nothing but std::bad_alloc, and then changes nothing that can be seen.
  void insert(std::uint32_t slot, const Box& box);
  void update(std::uint32_t slot, const Box& box);

  void erase(std::uint32_t slot) noexcept;
  void clear() noexcept;

  /// Into an empty tree: boxes[i] in slots[i]. Throws also what the executor does; the tree is then of no use.
  void fill(std::span<const Box> boxes, std::span<const std::uint32_t> slots, const Executor& executor);

  const Box& box(std::uint32_t slot) const { return boxes_[slot]; }
  double margin() const { return margin_; }

  /// The first place of node 0, the crown, holds the tree; its second is empty for ever.
  const Node& crown() const { return nodes_[0]; }
  const Node& node(std::uint32_t index) const { return nodes_[index]; }
  /// Asks for a node that will be looked at soon.
  void prefetch(std::uint32_t index) const { detail::prefetch(&nodes_[index].boxes[0]); }
  BvhChild child(std::uint32_t place) const { return nodes_[place / 2].children[place % 2]; }
  const Box& bounds(std::uint32_t place) const { return nodes_[place / 2].boxes[place % 2]; }

  /// The slots of the boxes beside the tree.
  std::span<const std::uint32_t> infinite() const { return infinite_; }

  /// Of all nodes that were ever made, how many are not in the tree.
  std::size_t spare_nodes() const { return spare_.size(); }

  /// The memory that is held, in bytes.
  std::size_t bytes() const;

 private:
  std::uint32_t count(BvhChild child) const { return child.is_leaf() ? 1 : nodes_[child.index()].count; }
  Box grown(const Box& box) const;
  bool stays(std::uint32_t slot, const Box& box) const;
  bool settles(std::uint32_t place, const Box& box) const;
  std::uint32_t prepare_node();
  void hang(std::uint32_t place, BvhChild child);
  std::uint32_t better_side(const Node& node, const Box& box) const;
  bool stops_at(const Node& node, std::uint32_t place, const Box& box) const;
  void attach(std::uint32_t slot, const Box& box, std::uint32_t place);
  std::uint32_t detach(std::uint32_t slot, const Box* target) noexcept;
  void tighten_above(std::uint32_t place);
  void remove_from_list(std::uint32_t slot) noexcept;
  void count_change() noexcept;
  void renumber() noexcept;
  void rebuild(std::uint32_t place) noexcept;
  void gather(std::uint32_t place);

  double margin_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> spare_;   // nodes that are not in the tree
  std::vector<Box> boxes_;             // by slot, as they are
  std::vector<std::uint32_t> places_;  // by slot: in the tree, or in the list
  std::vector<std::uint32_t> infinite_;
  std::size_t changes_ = 0;             // since the nodes were numbered
  std::vector<BvhLeaf<N, T>> leaves_;   // for one rebuild
  std::vector<std::uint32_t> indices_;  // for one rebuild
};

extern template class BvhTree<2, float>;
extern template class BvhTree<3, float>;
extern template class BvhTree<2, double>;
extern template class BvhTree<3, double>;

}  // namespace graze::detail
