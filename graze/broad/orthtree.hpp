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
#include <graze/broad/memory/short_list.hpp>
#include <graze/broad/orthtree/cell_kernels.hpp>
#include <graze/broad/orthtree/tree.hpp>
#include <graze/broad/orthtree/walk.hpp>
#include <graze/broad/spatial_index.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/ray.hpp>

namespace graze {

/// A cell of an Orthtree, for pictures and for the curious.
template <Dim N, class T = float>
struct OrthtreeCell {
  Aabb<N, T> box;     ///< The square. A box belongs to it by its center, and may stick out by half the square's size.
  int depth;          ///< The root has 0.
  std::size_t count;  ///< How many boxes it holds itself.
  bool is_leaf;
};

/// A SpatialIndex (spatial_index.hpp says what its members do) that cuts space into 2^N equal cells where there are
/// many boxes, and those again: in 2D a quad tree, in 3D an octree. Splits and merges by itself, and lays its root by
/// itself around the boxes; the few that are far off or infinite are kept in a list beside it and found like the
/// others.
///
/// A box lies in one cell only, whose bounds reach as far as its boxes do. A tree as flat whose boxes lie in every leaf
/// that they touch takes as long to fill one by one, three times as long to ask and 15 times as long to move
/// (bench/orthtree.cpp).
template <Dim N, class T = float>
class Orthtree {
 public:
  using Box = Aabb<N, T>;

  /// Throws std::invalid_argument for a capacity of 0 and a max_depth that is not in 0 to 32.
  explicit Orthtree(const OrthtreeOptions& options = {}) : keys_(most), tree_(options) {}

  /// At most 2^29 boxes.
  Key insert(const Box& box) {
    detail::require_box(box);
    tree_.insert(keys_.prepare().index, box);
    return keys_.take();
  }

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

  /// Erases all boxes, inserts these, and gives their keys in the order of the boxes: several times as quick as one by
  /// one, and neighbours come to lie side by side in memory. Its cells may be others than one by one. Throws like
  /// insert, and then changes nothing.
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

  bool contains(const Key& key) const { return keys_.contains(key); }
  const Box& box(const Key& key) const { return tree_.box(keys_.slot_of(key)); }
  std::size_t size() const { return keys_.size(); }
  const OrthtreeOptions& options() const { return tree_.options(); }

  /// How many boxes are in no cell, because they are far off or infinite.
  std::size_t outside() const { return tree_.cell(Tree::outside).entries.count; }

  /// The memory that is held, in bytes.
  std::size_t bytes() const { return keys_.bytes() + tree_.bytes(); }

  /// Visits cell by cell, from the root down.
  template <RegionIn<N, T> R, VisitorOf<Key> Visit>
  void query(const R& region, Visit&& visit) const {
    const detail::RegionProbe<R> probe(region);
    detail::GuardedVisit guarded(visit, keys_);
    detail::visit_cells_met(tree_, probe, [&](std::uint32_t slot) { return guarded(keys_.key_of(slot)); });
  }

  template <VisitorOf<Key, double> Visit>
  void ray_cast(const Ray<N, T>& ray, Visit&& visit) const {
    detail::require_ray(ray);
    detail::GuardedVisit guarded(visit, keys_);
    detail::visit_cells_along(tree_, ray, [&](std::uint32_t slot, double t) { return guarded(keys_.key_of(slot), t); });
  }

  std::vector<Neighbour> nearest(const Vec<N, T>& point, std::size_t k) const {
    detail::require_point(point);
    if (k == 0 || size() == 0) return {};
    detail::NearestKeys nearest(std::min(k, size()));
    const auto offer = [&](std::uint32_t slot, double distance) { nearest.offer({keys_.key_of(slot), distance}); };
    detail::visit_cells_near(tree_, point, offer, [&nearest] { return nearest.reach(); });
    return nearest.sorted();
  }

  /// By the batch method, which is quicker than any walk through a tree; holds all pairs while it visits them.
  template <VisitorOf<Key, Key> Visit>
  void pairs(Visit&& visit) const {
    detail::visit_index_pairs(
        keys_, [this](std::uint32_t slot) { return tree_.box(slot); }, visit);
  }

  /// visit(OrthtreeCell) for every cell, parents before their children.
  template <VisitorOf<OrthtreeCell<N, T>> Visit>
  void visit_cells(Visit&& visit) const {
    detail::GuardedVisit guarded(visit, keys_);
    detail::ShortList<std::uint32_t, detail::cell_walk_room> open;
    if (tree_.has_root()) open.push(Tree::root);
    while (!open.empty()) {
      const std::uint32_t index = open.pop();
      const detail::Cell<N, T>& cell = tree_.cell(index);
      const detail::CellPlace<N>& place = tree_.place(index);
      const bool is_leaf = cell.first_child == detail::no_index;
      const Box box{Vec<N, T>(place.center - place.half), Vec<N, T>(place.center + place.half)};
      if (!guarded(OrthtreeCell<N, T>{box, tree_.depth(index), cell.entries.count, is_leaf})) return;
      for (std::uint32_t k = is_leaf ? 0 : Tree::children; k-- > 0;) open.push(cell.first_child + k);
    }
  }

 private:
  using Tree = detail::CellTree<N, T>;

  /// Positions of boxes fit 32 bits even if each has a block of eight to itself.
  static constexpr std::uint32_t most = std::uint32_t{1} << 29U;

  detail::KeyTable keys_;
  Tree tree_;
};

template <class T = float>
using QuadTree = Orthtree<2, T>;

template <class T = float>
using Octree = Orthtree<3, T>;

}  // namespace graze
