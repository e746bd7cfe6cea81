// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <graze/broad/bvh/query.hpp>
#include <graze/broad/bvh/tree.hpp>
#include <graze/broad/executor.hpp>
#include <graze/broad/index/index_pairs.hpp>
#include <graze/broad/index/key_table.hpp>
#include <graze/broad/index/region.hpp>
#include <graze/broad/index/swept_box.hpp>
#include <graze/broad/spatial_index.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/distance_squared.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/ray.hpp>

namespace graze {

/// Options of a Bvh.
struct BvhOptions {
  /// How far the bounds of a smallest group extend beyond its boxes, so that boxes can move without a change of bounds;
  /// finite, at least 0. Results never depend on it.
  double margin = 0;
};

/// A group of boxes of a Bvh, for visualization and debugging.
template <Dim N, class T = float>
struct BvhCell {
  Aabb<N, T> box;     ///< Contains all boxes of the group; smallest groups are grown by the margin.
  int depth;          ///< 0 for the group of all boxes.
  std::size_t count;  ///< Number of boxes in the group.
  bool is_leaf;       ///< True for a single box.
};

/// A SpatialIndex (its members' contracts are in spatial_index.hpp) that groups up to sixteen boxes, groups of groups
/// likewise, and stores the bounds of each: a bounding volume hierarchy whose nodes are tested by vector instructions,
/// sixteen entries at a time. It makes no assumptions about positions and sizes and cannot degenerate: after any
/// sequence of changes all boxes have the same depth, and every group but the first has at least six members, so there
/// are at most 1 + log(n / 2) / log(6) levels. A change takes O(log n) steps.
///
/// Boxes with infinite sides are kept in a list beside the tree, which every query scans.
template <Dim N, class T = float>
class Bvh {
 public:
  /// The boxes that the index holds.
  using Box = Aabb<N, T>;

  /// Creates an empty index. Throws std::invalid_argument if the margin is negative or not finite.
  explicit Bvh(const BvhOptions& options = {}) : keys_(detail::bvh_most), tree_(options.margin) {}
  /// Creates an empty index with BvhOptions::margin. Throws std::invalid_argument if it is negative or not finite.
  explicit Bvh(double margin) : Bvh(BvhOptions{margin}) {}

  /// Adds a box and returns its key. Throws std::invalid_argument for a box with a NaN, with a min above its max, or at
  /// infinity, and std::length_error beyond 2^31 - 1 boxes.
  Key insert(const Box& box) {
    detail::require_box(box);
    const Key key = keys_.prepare();
    tree_.insert(key.index, box, key.generation);
    return keys_.take();
  }

  /// Replaces a box. Changes no bounds while the box stays within those of its smallest group, margin included. Throws
  /// std::invalid_argument like `insert` and std::out_of_range like `box`.
  void update(const Key& key, const Box& box) {
    const std::uint32_t slot = keys_.slot_of(key);
    detail::require_box(box);
    tree_.update(slot, box);
    keys_.count_change();
  }

  /// Removes a box; its key is never valid again. Throws std::out_of_range like `box`.
  void erase(const Key& key) {
    const std::uint32_t slot = keys_.slot_of(key);
    tree_.erase(slot);
    keys_.release(slot);
  }

  /// Removes all boxes; their keys are never valid again.
  void clear() {
    tree_.clear();
    keys_.release_all();
  }

  /// Removes all boxes, inserts these, and returns their keys in the order of the boxes. Faster than inserting one by
  /// one and gives a better tree, which does not depend on the executor. The first change afterwards takes O(n) steps.
  /// Throws like `insert`, and what the executor throws; then nothing has changed.
  std::vector<Key> assign(std::span<const Box> boxes, const Executor& executor = default_executor()) {
    detail::require_boxes(boxes);
    detail::KeyTable keys = keys_;
    keys.release_all();
    detail::BlankVector<std::uint32_t> slots(boxes.size());
    keys.take_many(slots);
    std::vector<Key> given = keys.keys_of(slots);
    Tree tree(tree_.margin());
    if (size() == 0) std::swap(tree, tree_);  // reuses its memory
    tree.fill(boxes, slots, executor, keys.generations());
    keys.count_change();
    keys_ = std::move(keys);
    tree_ = std::move(tree);
    return given;
  }

  /// True while the key names a box of this index.
  bool contains(const Key& key) const { return keys_.contains(key); }
  /// The box of a key. Throws std::out_of_range for the key of a removed box, of another index, or a default one. The
  /// reference is valid until the next change of the index.
  const Box& box(const Key& key) const { return tree_.box(keys_.slot_of(key)); }
  /// Number of boxes.
  std::size_t size() const { return keys_.size(); }
  /// The options that the index was created with.
  BvhOptions options() const { return {tree_.margin()}; }

  /// Memory in use, in bytes.
  std::size_t bytes() const { return keys_.bytes() + tree_.bytes(); }

  /// Calls visit(key) once for every box that meets the region, until it returns false. Allocates nothing. Throws
  /// std::invalid_argument for an invalid region, and what the visitor throws.
  template <RegionIn<N, T> R, VisitorOf<Key> Visit>
  void query(const R& region, Visit&& visit) const {
    const detail::RegionProbe<R> probe(region);
    detail::GuardedVisit guarded(visit, keys_);
    detail::visit_met(tree_, probe, [&](const detail::BvhName& name) { return guarded(key_of(name)); });
  }

  /// Calls visit(key, t) for every box that the ray enters, in order of t, ties by key, until it returns false. t is 0
  /// if the ray starts inside the box. Throws std::invalid_argument for an invalid ray.
  template <VisitorOf<Key, double> Visit>
  void ray_cast(const Ray<N, T>& ray, Visit&& visit) const {
    detail::require_ray(ray);
    detail::GuardedVisit guarded(visit, keys_);
    detail::visit_along(tree_, ray, [&](const detail::BvhName& name, double t) { return guarded(key_of(name), t); });
  }

  /// Calls visit(key, t) for every box that `box` touches while it moves along `motion`, in order of t, ties by key,
  /// until it returns false. t is from 0 to 1; 0 if they touch at the start. Throws std::invalid_argument for an
  /// invalid box and if the motion is not finite.
  template <VisitorOf<Key, double> Visit>
  void cast(const Box& box, const Vec<N, T>& motion, Visit&& visit) const {
    const detail::SweptBox<N> sweep = detail::swept_box_in_index(box, motion);
    detail::GuardedVisit guarded(visit, keys_);
    constexpr double forever = std::numeric_limits<double>::infinity();
    detail::visit_swept(
        tree_, sweep, [&sweep](const Box& other) { return sweep.touch(other); },
        [&](const detail::BvhName& name, double t) { return guarded(key_of(name), t) ? forever : -forever; });
  }

  /// The k boxes nearest to the point, or all if there are fewer: by distance, ties by key. Throws
  /// std::invalid_argument if the point is not finite.
  std::vector<Neighbour> nearest(const Vec<N, T>& point, std::size_t k) const {
    detail::require_point(point);
    if (k == 0 || size() == 0) return {};
    detail::NearestKeys nearest(std::min(k, size()));
    detail::find_near(tree_, point, nearest);
    std::vector<Neighbour> sorted = nearest.sorted();
    for (Neighbour& neighbour : sorted) neighbour.key.owner = keys_.owner();
    return sorted;
  }

  /// Calls visit(a, b) once for every two boxes that share a point, ascending, a < b, until it returns false. Uses the
  /// batch method, which is faster than walking the tree; holds all pairs in memory while it visits them.
  template <VisitorOf<Key, Key> Visit>
  void pairs(Visit&& visit) const {
    detail::visit_index_pairs(
        keys_, [this](std::uint32_t slot) { return tree_.box(slot); }, visit);
  }

  /// Calls visit(BvhCell) for every group, groups before their members, until it returns false. Boxes with infinite
  /// sides are in no group.
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
  /// What `visit_cells` has yet to visit: a node by its link's code, or a box by its slot.
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
