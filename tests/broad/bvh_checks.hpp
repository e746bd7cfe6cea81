// SPDX-License-Identifier: MIT
// What every Bvh's tree must be, whatever came before, and how much a walk through it looks at.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

#include <graze/broad/box_cover.hpp>
#include <graze/broad/bvh_query.hpp>
#include <graze/broad/bvh_tree.hpp>
#include <graze/shape/shape.hpp>

namespace graze::test {

/// Walks through all nodes of a tree and notes the first thing that is wrong.
template <Dim N, class T>
class BvhInspection {
 public:
  using Tree = detail::BvhTree<N, T>;
  using Box = Aabb<N, T>;

  /// The boxes that must be found, by slot.
  BvhInspection(const Tree& tree, const std::map<std::uint32_t, Box>& expected) : tree_(tree), expected_(expected) {
    for (const std::uint32_t slot : tree.infinite()) {
      expect(!is_valid(tree.box(slot)), "a finite box is in the list of the infinite");
      find(slot);
    }
    const detail::BvhChild root = tree.child(0);
    if (!root.is_none()) height_ = inspect(0);
    expect(found_.size() == expected.size(), "boxes are lost");
    expect(tree.crown().children[1].is_none(), "the crown has two children");
    const double leaves = static_cast<double>(expected.size() - tree.infinite().size());
    expect(leaves < 2 || static_cast<double>(height_) <= std::log(leaves) / std::log(1.25) + 1e-9,
           "the tree is too tall");
  }

  /// Empty when all is well.
  const std::string& fault() const { return fault_; }
  std::size_t height() const { return height_; }
  std::size_t nodes() const { return nodes_; }

 private:
  void expect(bool holds, const char* fault) {
    if (!holds && fault_.empty()) fault_ = fault;
  }

  void find(std::uint32_t slot) {
    expect(++found_[slot] == 1, "a box is there twice");
    const auto wanted = expected_.find(slot);
    expect(wanted != expected_.end() && tree_.box(slot) == wanted->second, "a box is there that should not");
  }

  std::size_t inspect(std::uint32_t place) {
    const detail::BvhChild child = tree_.child(place);
    const Box& bounds = tree_.bounds(place);
    if (child.is_leaf()) {
      find(child.index());
      expect(is_valid(bounds) && detail::covers(bounds, tree_.box(child.index())), "a leaf does not cover its box");
      return 0;
    }
    ++nodes_;
    const detail::BvhNode<N, T>& node = tree_.node(child.index());
    expect(node.place == place, "a node does not know its place");
    expect(bounds == detail::box_around(node.boxes[0], node.boxes[1]), "bounds are not tight");
    const std::size_t first = inspect(2 * child.index());
    const std::size_t second = inspect(2 * child.index() + 1);
    const std::uint32_t larger = std::max(count(node.children[0]), count(node.children[1]));
    expect(node.count == count(node.children[0]) + count(node.children[1]), "a node counts wrong");
    expect(!detail::is_out_of_balance(larger, node.count), "a node is out of balance");
    return 1 + std::max(first, second);
  }

  std::uint32_t count(detail::BvhChild child) const { return child.is_leaf() ? 1 : tree_.node(child.index()).count; }

  const Tree& tree_;
  const std::map<std::uint32_t, Box>& expected_;
  std::map<std::uint32_t, int> found_;
  std::string fault_;
  std::size_t height_ = 0;
  std::size_t nodes_ = 0;
};

/// A region that counts how many bounds it is shown.
template <Dim N, class T>
struct CountingRegion {
  Aabb<N, T> region;
  mutable std::size_t looks = 0;

  bool may_meet(const Aabb<N, T>& box) const {
    ++looks;
    return boxes_overlap(region, box);
  }
  bool may_meet_closely(const Aabb<N, T>&) const { return true; }
  bool meets(const Aabb<N, T>& box) const { return boxes_overlap(region, box); }
};

/// What a query for a region costs and finds.
struct Effort {
  std::size_t looks = 0;
  std::size_t found = 0;
};

template <Dim N, class T>
Effort effort_of(const detail::BvhTree<N, T>& tree, const Aabb<N, T>& region) {
  const CountingRegion<N, T> probe{region};
  std::size_t found = 0;
  detail::visit_met(tree, probe, [&found](std::uint32_t) { return ++found > 0; });
  return {probe.looks, found};
}

}  // namespace graze::test
