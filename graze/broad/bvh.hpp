// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <graze/broad/bvh/query.hpp>
#include <graze/broad/bvh/tree.hpp>
#include <graze/broad/executor.hpp>
#include <graze/broad/index/index_pairs.hpp>
#include <graze/broad/index/key_table.hpp>
#include <graze/broad/index/region.hpp>
#include <graze/broad/spatial_index.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/distance_squared.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/ray.hpp>

namespace graze {

struct BvhOptions {
  /// How much farther than its boxes a smallest group reaches, so that its bounds need not change while boxes move
  /// within them; finite, 0 or more. Answers never depend on it.
  double margin = 0;
};

/// A group of boxes of a Bvh, for pictures and for the curious.
template <Dim N, class T = float>
struct BvhCell {
  Aabb<N, T> box;     ///< Contains all boxes of the group; the smallest groups' are grown by the margin.
  int depth;          ///< That of all boxes has 0.
  std::size_t count;  ///< How many boxes the group has.
  bool is_leaf;       ///< A single box, as it is.
};

/// A SpatialIndex (spatial_index.hpp says what its members do) that groups up to sixteen boxes, groups likewise, and
/// keeps the bounds of each: a bounding volume hierarchy, whose groups are looked at by vector instructions, sixteen at
/// a time. It asks nothing about where the boxes are or how large, and cannot degenerate: whatever comes, moves and
/// goes, all boxes are equally deep and every group but the first has six members or more, so that there are at most 1
/// + log(n / 2) / log(6) levels of groups. A change takes O(log n) steps.
///
/// Boxes with infinite sides are kept in a list beside the tree: each of them costs every query a look.
template <Dim N, class T = float>
class Bvh {
 public:
  using Box = Aabb<N, T>;

  /// Throws std::invalid_argument for a margin that is negative or not finite.
  explicit Bvh(const BvhOptions& options = {}) : keys_(detail::bvh_most), tree_(options.margin) {}
  explicit Bvh(double margin) : Bvh(BvhOptions{margin}) {}

  /// At most 2^31 - 1 boxes.
  Key insert(const Box& box) {
    detail::require_box(box);
    const Key key = keys_.prepare();
    tree_.insert(key.index, box, key.generation);
    return keys_.take();
  }

  /// Changes no bounds while the box stays within those of its smallest group, margin included.
  void update(const Key& key, const Box& box) {
    const std::uint32_t slot = keys_.slot_of(key);
    detail::require_box(box);
    tree_.update(slot, box);
    keys_.count_change();
  }

  void erase(const Key& key) {
    const std::uint32_t slot = keys_.slot_of(key);
    tree_.erase(slot);
    keys_.release(slot);
  }

  void clear() {
    tree_.clear();
    keys_.release_all();
  }

  /// Erases all boxes, inserts these, and gives their keys in the order of the boxes: quicker than one by one, and the
  /// better tree, which does not depend on the executor. The first change afterwards takes O(n) steps. Throws like
  /// insert and what the executor throws, and then changes nothing.
  std::vector<Key> assign(std::span<const Box> boxes, const Executor& executor = default_executor()) {
    detail::require_boxes(boxes);
    detail::KeyTable keys = keys_;
    keys.release_all();
    detail::BlankVector<std::uint32_t> slots(boxes.size());
    keys.take_many(slots);
    std::vector<Key> given = keys.keys_of(slots);
    Tree tree(tree_.margin());
    if (size() == 0) std::swap(tree, tree_);  // whose memory is used again
    tree.fill(boxes, slots, executor, keys.generations());
    keys.count_change();
    keys_ = std::move(keys);
    tree_ = std::move(tree);
    return given;
  }

  bool contains(const Key& key) const { return keys_.contains(key); }
  const Box& box(const Key& key) const { return tree_.box(keys_.slot_of(key)); }
  std::size_t size() const { return keys_.size(); }
  BvhOptions options() const { return {tree_.margin()}; }

  /// The memory that is held, in bytes.
  std::size_t bytes() const { return keys_.bytes() + tree_.bytes(); }

  /// Allocates nothing.
  template <RegionIn<N, T> R, VisitorOf<Key> Visit>
  void query(const R& region, Visit&& visit) const {
    const detail::RegionProbe<R> probe(region);
    detail::GuardedVisit guarded(visit, keys_);
    detail::visit_met(tree_, probe, [&](const detail::BvhName& name) { return guarded(key_of(name)); });
  }

  template <VisitorOf<Key, double> Visit>
  void ray_cast(const Ray<N, T>& ray, Visit&& visit) const {
    detail::require_ray(ray);
    detail::GuardedVisit guarded(visit, keys_);
    detail::visit_along(tree_, ray, [&](const detail::BvhName& name, double t) { return guarded(key_of(name), t); });
  }

  std::vector<Neighbour> nearest(const Vec<N, T>& point, std::size_t k) const {
    detail::require_point(point);
    if (k == 0 || size() == 0) return {};
    detail::NearestKeys nearest(std::min(k, size()));
    detail::find_near(tree_, point, nearest);
    std::vector<Neighbour> sorted = nearest.sorted();
    for (Neighbour& neighbour : sorted) neighbour.key.owner = keys_.owner();
    return sorted;
  }

  /// By the batch method, which is quicker than any walk through a tree; holds all pairs while it visits them.
  template <VisitorOf<Key, Key> Visit>
  void pairs(Visit&& visit) const {
    detail::visit_index_pairs(
        keys_, [this](std::uint32_t slot) { return tree_.box(slot); }, visit);
  }

  /// visit(BvhCell) for every group, the whole before its parts. Boxes with infinite sides are in none.
  template <VisitorOf<BvhCell<N, T>> Visit>
  void visit_cells(Visit&& visit) const {
    detail::GuardedVisit guarded(visit, keys_);
    detail::ShortList<Group, detail::bvh_path> open;
    if (size() > tree_.infinite().size()) open.push({tree_.bounds(), tree_.root().code(), 0, false});
    while (!open.empty()) {
      const Group group = open.pop();
      const detail::BvhLink link = detail::BvhLink::of_code(group.code);
      const std::size_t count = group.is_box ? 1 : tree_.boxes_below(link);
      if (!guarded(BvhCell<N, T>{group.box, group.depth, count, group.is_box})) return;
      if (group.is_box) continue;
      const detail::BvhNode<N, T>& node = tree_.node(link);
      for (std::uint32_t lane = tree_.count(link); lane-- > 0;) {
        open.push({box_in(node.boxes, lane), node.entries[lane], group.depth + 1, link.is_leaf()});
      }
    }
  }

 private:
  /// What a visit of all groups still has to look at: a node by its link's code, or a box by its slot.
  struct Group {
    Box box;
    std::uint32_t code;
    int depth;
    bool is_box;
  };

  using Tree = detail::BvhTree<N, T>;

  Key key_of(const detail::BvhName& name) const { return {name.slot, name.generation, keys_.owner()}; }

  detail::KeyTable keys_;
  Tree tree_;
};

}  // namespace graze
