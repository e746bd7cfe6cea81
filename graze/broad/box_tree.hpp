// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <graze/broad/pair.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// A balanced binary tree over boxes, built once by splitting at the median center along the widest axis. Flat: node
/// k's children are stored at `left` and `left + 1`, and a leaf owns a range of `order`.
template <Dim N, class T>
class BoxTree {
 public:
  /// A tree over the boxes at the given indices. The boxes must outlive it.
  BoxTree(std::span<const Aabb<N, T>> boxes, std::vector<std::uint32_t> indices)
      : boxes_(boxes), order_(std::move(indices)) {
    if (order_.empty()) return;
    nodes_.reserve(2 * (order_.size() / (leaf_size / 2) + 1));
    nodes_.push_back({});
    build(0, 0, static_cast<std::uint32_t>(order_.size()));
  }

  /// Calls visit(i, j) once for every two overlapping boxes of the tree, in a fixed but unspecified order.
  template <class Visit>
  void visit_pairs(const Visit& visit) const {
    if (!nodes_.empty()) meet_itself(0, visit);
  }

  /// Calls visit(i, j) for every box i of this tree that overlaps a box j of the other.
  template <class Visit>
  void visit_pairs(const BoxTree& other, const Visit& visit) const {
    if (!nodes_.empty() && !other.nodes_.empty()) meet(0, other, 0, visit);
  }

 private:
  static constexpr std::uint32_t leaf_size = 8;

  struct Node {
    Aabb<N, T> box = Aabb<N, T>::nothing();
    std::uint32_t begin = 0;  // the range of order_ below this node
    std::uint32_t end = 0;
    std::uint32_t left = 0;  // 0 in a leaf: the root is nobody's child

    bool is_leaf() const { return left == 0; }
  };

  // The depth is at most the logarithm of the number of boxes, since every split halves the range.
  void build(std::uint32_t at, std::uint32_t begin, std::uint32_t end) {
    Node node;
    node.begin = begin;
    node.end = end;
    Aabb<N, T> centers = Aabb<N, T>::nothing();
    for (std::uint32_t i = begin; i < end; ++i) {
      node.box.grow(boxes_[order_[i]]);
      centers.grow(boxes_[order_[i]].center());
    }
    if (end - begin > leaf_size) {
      const std::uint32_t middle = split(centers, begin, end);
      node.left = static_cast<std::uint32_t>(nodes_.size());
      nodes_.resize(nodes_.size() + 2);
      build(node.left, begin, middle);
      build(node.left + 1, middle, end);
    }
    nodes_[at] = node;
  }

  // Ties are broken by index, so that the tree does not depend on the library's nth_element.
  std::uint32_t split(const Aabb<N, T>& centers, std::uint32_t begin, std::uint32_t end) {
    Dim axis = 0;
    const Vec<N, T> half_extents = centers.half_extents();
    for (Dim i = 1; i < N; ++i) {
      if (half_extents[i] > half_extents[axis]) axis = i;
    }
    const std::uint32_t middle = begin + (end - begin) / 2;
    const auto center_below = [this, axis](std::uint32_t i, std::uint32_t j) {
      const T center_i = boxes_[i].center()[axis];
      const T center_j = boxes_[j].center()[axis];
      return center_i != center_j ? center_i < center_j : i < j;
    };
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end, center_below);
    return middle;
  }

  template <class Visit>
  void meet_itself(std::uint32_t at, const Visit& visit) const {
    const Node& node = nodes_[at];
    if (!node.is_leaf()) {
      meet_itself(node.left, visit);
      meet_itself(node.left + 1, visit);
      meet(node.left, *this, node.left + 1, visit);
      return;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      for (std::uint32_t j = i + 1; j < node.end; ++j) {
        if (boxes_overlap(boxes_[order_[i]], boxes_[order_[j]])) visit(order_[i], order_[j]);
      }
    }
  }

  // Descends into the node that holds more boxes, until both are leaves.
  template <class Visit>
  void meet(std::uint32_t at, const BoxTree& other, std::uint32_t other_at, const Visit& visit) const {
    const Node& node = nodes_[at];
    const Node& other_node = other.nodes_[other_at];
    if (!boxes_overlap(node.box, other_node.box)) return;
    const bool descend_here = node.end - node.begin >= other_node.end - other_node.begin;
    if (!node.is_leaf() && (descend_here || other_node.is_leaf())) {
      meet(node.left, other, other_at, visit);
      meet(node.left + 1, other, other_at, visit);
    } else if (!other_node.is_leaf()) {
      meet(at, other, other_node.left, visit);
      meet(at, other, other_node.left + 1, visit);
    } else {
      meet_leaves(node, other, other_node, visit);
    }
  }

  template <class Visit>
  void meet_leaves(const Node& node, const BoxTree& other, const Node& other_node, const Visit& visit) const {
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      const Aabb<N, T>& box = boxes_[order_[i]];
      if (!boxes_overlap(box, other_node.box)) continue;
      for (std::uint32_t j = other_node.begin; j < other_node.end; ++j) {
        if (boxes_overlap(box, other.boxes_[other.order_[j]])) visit(order_[i], other.order_[j]);
      }
    }
  }

  std::span<const Aabb<N, T>> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace graze::detail
