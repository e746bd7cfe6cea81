// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <graze/broad/index/index_pairs.hpp>
#include <graze/broad/index/key_table.hpp>
#include <graze/broad/index/region.hpp>
#include <graze/broad/index/swept_box.hpp>
#include <graze/broad/memory/short_list.hpp>
#include <graze/broad/orthtree/cell_kernels.hpp>
#include <graze/broad/orthtree/tree.hpp>
#include <graze/broad/orthtree/walk.hpp>
#include <graze/broad/spatial_index.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/ray.hpp>

namespace graze {

/// A cell of an Orthtree, for visualization and debugging.
template <Dim N, class T = float>
struct OrthtreeCell {
  Aabb<N, T> box;     ///< The cell. A box belongs to it by its center and may extend beyond it by half its size.
  int depth;          ///< 0 for the root.
  std::size_t count;  ///< Number of boxes in the cell itself, without its children.
  bool is_leaf;       ///< True if it has no children.
};

/// A SpatialIndex (its members' contracts are in spatial_index.hpp) that splits crowded cells into 2^N equal ones: in
/// 2D a quadtree, in 3D an octree. It splits and merges cells and places its root around the boxes by itself; the few
/// boxes that are far away or infinite are kept in a list beside it and found like the others.
///
/// A box is in one cell only, whose bounds extend as far as its boxes do. An equally shallow tree that stores a box in
/// every leaf that it touches takes as long to fill one by one, 3x as long to query and 15x as long to move boxes
/// (bench/orthtree.cpp).
template <Dim N, class T = float>
class Orthtree {
 public:
  /// The boxes that the index holds.
  using Box = Aabb<N, T>;

  /// Creates an empty index. Throws std::invalid_argument if the capacity is 0 or max_depth is not from 0 to 32.
  explicit Orthtree(const OrthtreeOptions& options = {}) : keys_(most), tree_(options) {}

  /// Adds a box and returns its key. Throws std::invalid_argument for a box with a NaN, with a min above its max, or at
  /// infinity, and std::length_error beyond 2^29 boxes.
  Key insert(const Box& box) {
    detail::require_box(box);
    tree_.insert(keys_.prepare().index, box);
    return keys_.take();
  }

  /// Replaces a box. Throws std::invalid_argument like `insert` and std::out_of_range like `box`.
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

  /// Removes all boxes, inserts these, and returns their keys in the order of the boxes. Several times faster than
  /// inserting one by one, and neighbours become adjacent in memory; the cells may differ. Throws like `insert`; then
  /// nothing has changed.
  std::vector<Key> assign(std::span<const Box> boxes) {
    if (is_nothing(detail::cell_kernels<N, T>().bounds(boxes.data(), boxes.size()))) {
      for (const Box& box : boxes) detail::require_box(box);
    }
    detail::KeyTable keys = keys_;
    keys.release_all();
    detail::BlankVector<std::uint32_t> slots(boxes.size());
    keys.take_many(slots);
    std::vector<Key> given = keys.keys_of(slots);
    Tree tree(tree_.options());
    tree.fill(boxes, slots);
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
  const OrthtreeOptions& options() const { return tree_.options(); }

  /// Number of boxes in no cell, because they are far away or infinite.
  std::size_t outside() const { return tree_.cell(Tree::outside).entries.count; }

  /// Memory in use, in bytes.
  std::size_t bytes() const { return keys_.bytes() + tree_.bytes(); }

  /// Calls visit(key) once for every box that meets the region, cell by cell from the root down, until it returns
  /// false. Throws std::invalid_argument for an invalid region.
  template <RegionIn<N, T> R, VisitorOf<Key> Visit>
  void query(const R& region, Visit&& visit) const {
    const detail::RegionProbe<R> probe(region);
    detail::GuardedVisit guarded(visit, keys_);
    detail::visit_cells_met(tree_, probe, [&](std::uint32_t slot) { return guarded(keys_.key_of(slot)); });
  }

  /// Calls visit(key, t) for every box that the ray enters, in order of t, ties by key, until it returns false. t is 0
  /// if the ray starts inside the box. Throws std::invalid_argument for an invalid ray.
  template <VisitorOf<Key, double> Visit>
  void ray_cast(const Ray<N, T>& ray, Visit&& visit) const {
    detail::require_ray(ray);
    detail::GuardedVisit guarded(visit, keys_);
    detail::visit_cells_along(
        tree_, [&ray](const Box& box) { return detail::entry_of(ray, box); },
        [&](std::uint32_t slot, double t) { return guarded(keys_.key_of(slot), t); });
  }

  /// Calls visit(key, t) for every box that `box` touches while it moves along `motion`, in order of t, ties by key,
  /// until it returns false. t is from 0 to 1; 0 if they touch at the start. Throws std::invalid_argument for an
  /// invalid box and if the motion is not finite.
  template <VisitorOf<Key, double> Visit>
  void cast(const Box& box, const Vec<N, T>& motion, Visit&& visit) const {
    const detail::SweptBox<N> sweep = detail::swept_box_in_index(box, motion);
    detail::GuardedVisit guarded(visit, keys_);
    detail::visit_cells_along(
        tree_, [&sweep](const Box& other) { return sweep.touch(other); },
        [&](std::uint32_t slot, double t) { return guarded(keys_.key_of(slot), t); });
  }

  /// The k boxes nearest to the point, or all if there are fewer: by distance, ties by key. Throws
  /// std::invalid_argument if the point is not finite.
  std::vector<Neighbour> nearest(const Vec<N, T>& point, std::size_t k) const {
    detail::require_point(point);
    if (k == 0 || size() == 0) return {};
    detail::NearestKeys nearest(std::min(k, size()));
    const auto offer = [&](std::uint32_t slot, double distance) { nearest.offer({keys_.key_of(slot), distance}); };
    detail::visit_cells_near(tree_, point, offer, [&nearest] { return nearest.reach(); });
    return nearest.sorted();
  }

  /// Calls visit(a, b) once for every two boxes that share a point, ascending, a < b, until it returns false. Uses the
  /// batch method, which is faster than walking the tree; holds all pairs in memory while it visits them.
  template <VisitorOf<Key, Key> Visit>
  void pairs(Visit&& visit) const {
    detail::visit_index_pairs(
        keys_, [this](std::uint32_t slot) { return tree_.box(slot); }, visit);
  }

  /// Calls visit(OrthtreeCell) for every cell, parents before their children, until it returns false.
  template <VisitorOf<OrthtreeCell<N, T>> Visit>
  void visit_cells(Visit&& visit) const {
    detail::GuardedVisit guarded(visit, keys_);
    detail::ShortList<std::uint32_t, detail::cell_walk_room> open;
    if (tree_.has_root()) open.push(Tree::root);
    while (!open.empty()) {
      const std::uint32_t index = open.pop();
      const detail::Cell<N, T>& cell = tree_.cell(index);
      const detail::CellPosition<N>& place = tree_.place(index);
      const bool is_leaf = cell.first_child == detail::no_index;
      const Box box{Vec<N, T>(place.center - place.half), Vec<N, T>(place.center + place.half)};
      if (!guarded(OrthtreeCell<N, T>{box, tree_.depth(index), cell.entries.count, is_leaf})) return;
      for (std::uint32_t k = is_leaf ? 0 : Tree::children; k-- > 0;) open.push(cell.first_child + k);
    }
  }

 private:
  using Tree = detail::CellTree<N, T>;

  /// Positions fit 32 bits even if each box has a block of eight to itself.
  static constexpr std::uint32_t most = std::uint32_t{1} << 29U;

  detail::KeyTable keys_;
  Tree tree_;
};

/// The 2D Orthtree.
template <class T = float>
using QuadTree = Orthtree<2, T>;

/// The 3D Orthtree.
template <class T = float>
using Octree = Orthtree<3, T>;

}  // namespace graze
