// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <graze/broad/bvh_query.hpp>
#include <graze/broad/bvh_tree.hpp>
#include <graze/broad/executor.hpp>
#include <graze/broad/index_pairs.hpp>
#include <graze/broad/key_table.hpp>
#include <graze/broad/region.hpp>
#include <graze/broad/spatial_index.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/distance_squared.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/ray.hpp>

namespace graze {

struct BvhOptions {
  /// How far a box may move from where it was last entered before the tree has to change; finite, 0 or more. Answers
  /// never depend on it.
  double margin = 0;
};

/// A group of boxes of a Bvh, for pictures and for the curious.
template <Dim N, class T>
struct BvhCell {
  Aabb<N, T> box;     ///< Contains all boxes of the group.
  int depth;          ///< That of all boxes has 0.
  std::size_t count;  ///< How many boxes the group has.
  bool is_leaf;       ///< A single box, perhaps grown by the margin.
};

/// A SpatialIndex (spatial_index.hpp says what its members do) that groups boxes two by two, groups likewise, and keeps
/// the bounds of each: a bounding volume hierarchy. It asks nothing about where the boxes are or how large, and cannot
/// degenerate: whatever comes, moves and goes, it has at most log(n) / log(5/4) levels, about 3.1 log2(n), and it sees
/// to its quality by itself. A change takes O(log n) steps, on average over all changes so far.
///
/// Boxes with infinite sides are kept in a list beside the tree: each of them costs every query a look.
template <Dim N, class T = float>
class Bvh {
 public:
  using Box = Aabb<N, T>;

  /// Throws std::invalid_argument for a margin that is negative or not finite.
  explicit Bvh(const BvhOptions& options = {}) : keys_(detail::bvh_most), tree_(options.margin) {}

  /// At most 2^31 - 1 boxes.
  Key insert(const Box& box) {
    detail::require_box(box);
    tree_.insert(keys_.prepare(), box);
    return keys_.take();
  }

  /// Leaves the tree as it is while the box stays within the margin around where it was when it last entered.
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
    release_all(keys_);
  }

  /// Erases all boxes, inserts these, and gives their keys in the order of the boxes: quicker than one by one, and the
  /// better tree, which does not depend on the executor. Throws like insert and what the executor throws, and then
  /// changes nothing.
  std::vector<Key> assign(std::span<const Box> boxes, const Executor& executor = default_executor()) {
    for (const Box& box : boxes) detail::require_box(box);
    detail::KeyTable keys = keys_;
    release_all(keys);
    std::vector<Key> given;
    std::vector<std::uint32_t> slots;
    given.reserve(boxes.size());
    slots.reserve(boxes.size());
    while (given.size() < boxes.size()) {
      slots.push_back(keys.prepare());
      given.push_back(keys.take());
    }
    Tree tree(tree_.margin());
    tree.fill(boxes, slots, executor);
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
    detail::visit_met(tree_, probe, [&](std::uint32_t slot) { return guarded(keys_.key_of(slot)); });
  }

  template <VisitorOf<Key, double> Visit>
  void ray_cast(const Ray<N, T>& ray, Visit&& visit) const {
    detail::require_ray(ray);
    detail::GuardedVisit guarded(visit, keys_);
    detail::visit_along(tree_, detail::RayProbe(ray),
                        [&](std::uint32_t slot, double t) { return guarded(keys_.key_of(slot), t); });
  }

  std::vector<Neighbour> nearest(const Vec<N, T>& point, std::size_t k) const {
    detail::require_point(point);
    if (k == 0) return {};
    detail::NearestKeys nearest(std::min(k, size()));
    const auto offer = [&](std::uint32_t slot, double distance) { nearest.offer({keys_.key_of(slot), distance}); };
    if (size() > 0) detail::visit_near(tree_, point, offer, [&nearest] { return nearest.reach(); });
    return nearest.sorted();
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
    detail::ShortList<Place, detail::bvh_path> open;
    if (!tree_.child(0).is_none()) open.push({0, 0});
    while (!open.empty()) {
      const Place at = open.pop();
      const detail::BvhChild child = tree_.child(at.place);
      const std::size_t count = child.is_leaf() ? 1 : tree_.node(child.index()).count;
      if (!guarded(BvhCell<N, T>{tree_.bounds(at.place), at.depth, count, child.is_leaf()})) return;
      if (child.is_leaf()) continue;
      open.push({2 * child.index() + 1, at.depth + 1});
      open.push({2 * child.index(), at.depth + 1});
    }
  }

 private:
  /// Where a group hangs, and how deep.
  struct Place {
    std::uint32_t place;
    int depth;
  };

  using Tree = detail::BvhTree<N, T>;

  static void release_all(detail::KeyTable& keys) {
    for (std::uint32_t slot = 0; slot < keys.slots(); ++slot) {
      if (keys.is_taken(slot)) keys.release(slot);
    }
  }

  detail::KeyTable keys_;
  Tree tree_;
};

}  // namespace graze
