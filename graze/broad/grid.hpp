// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <graze/broad/grid/cells.hpp>
#include <graze/broad/index/index_pairs.hpp>
#include <graze/broad/index/key_table.hpp>
#include <graze/broad/index/region.hpp>
#include <graze/broad/index/swept_box.hpp>
#include <graze/broad/memory/short_list.hpp>
#include <graze/broad/orthtree/walk.hpp>
#include <graze/broad/spatial_index.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/ray.hpp>

namespace graze {

/// A cell of a Grid, for visualization and debugging.
template <Dim N, class T = float>
struct GridCell {
  Aabb<N, T> box;     ///< The cell. A box belongs to it by its center and may extend beyond it by half its size.
  double size;        ///< Length of its sides, a power of two.
  std::size_t count;  ///< Number of boxes in it; never 0.
};

/// A SpatialIndex (its members' contracts are in spatial_index.hpp) that keeps boxes in equal cells, found by hashing:
/// a hierarchical grid with one level for each size of boxes, each twice that of the one before. Each box is in one
/// cell of one level. Only cells that hold boxes exist, anywhere; boxes that are infinite, or near the largest numbers,
/// are kept in a list and found like the others.
///
/// An Orthtree has small cells where there are many boxes, a Grid has equal ones everywhere. A Grid fills as fast as an
/// Orthtree, twice as fast if boxes are crowded, moves boxes equally fast, and takes up to 1.2x as long to answer. A
/// Bvh answers 3x faster than either and takes about as long as an Orthtree to fill box by box and to move boxes
/// (100,000 boxes in 3D; bench/bvh.cpp).
template <Dim N, class T = float>
class Grid {
 public:
  /// The boxes that the index holds.
  using Box = Aabb<N, T>;

  /// Creates an empty index. Throws std::invalid_argument if smallest_cell is negative, NaN, or above 2^1000.
  explicit Grid(const GridOptions& options = {}) : keys_(most), cells_(options) {}
  /// Creates an empty index with GridOptions::smallest_cell. Throws std::invalid_argument if it is negative, NaN, or
  /// above 2^1000.
  explicit Grid(double smallest_cell) : Grid(GridOptions{smallest_cell}) {}

  /// Adds a box and returns its key. Throws std::invalid_argument for a box with a NaN, with a min above its max, or at
  /// infinity, and std::length_error beyond 2^29 boxes.
  Key insert(const Box& box) {
    detail::require_box(box);
    cells_.insert(keys_.prepare().index, box);
    return keys_.take();
  }

  /// Replaces a box. Throws std::invalid_argument like `insert` and std::out_of_range like `box`.
  void update(const Key& key, const Box& box) {
    const std::uint32_t slot = keys_.slot_of(key);
    detail::require_box(box);
    cells_.update(slot, box);
    keys_.count_change();
  }

  /// Removes a box; its key is never valid again. Throws std::out_of_range like `box`.
  void erase(const Key& key) {
    const std::uint32_t slot = keys_.slot_of(key);
    cells_.erase(slot);
    keys_.release(slot);
  }

  /// Removes all boxes; their keys are never valid again.
  void clear() {
    cells_.clear();
    keys_.release_all();
  }

  /// True while the key names a box of this index.
  bool contains(const Key& key) const { return keys_.contains(key); }
  /// The box of a key. Throws std::out_of_range for the key of a removed box, of another index, or a default one. The
  /// reference is valid until the next change of the index.
  const Box& box(const Key& key) const { return cells_.box(keys_.slot_of(key)); }
  /// Number of boxes.
  std::size_t size() const { return keys_.size(); }
  /// The options that the index was created with.
  const GridOptions& options() const { return cells_.options(); }

  /// Number of boxes in no cell, because they are infinite or near the largest numbers.
  std::size_t outside() const { return cells_.cell(Cells::outside).entries.count; }

  /// Memory in use, in bytes.
  std::size_t bytes() const { return keys_.bytes() + cells_.bytes(); }

  /// Calls visit(key) once for every box that meets the region, cell by cell from the largest down, until it returns
  /// false. Throws std::invalid_argument for an invalid region.
  template <RegionIn<N, T> R, VisitorOf<Key> Visit>
  void query(const R& region, Visit&& visit) const {
    const detail::RegionProbe<R> probe(region);
    detail::GuardedVisit guarded(visit, keys_);
    detail::visit_cells_met(cells_, probe, [&](std::uint32_t slot) { return guarded(keys_.key_of(slot)); });
  }

  /// Calls visit(key, t) for every box that the ray enters, in order of t, ties by key, until it returns false. t is 0
  /// if the ray starts inside the box. Throws std::invalid_argument for an invalid ray.
  template <VisitorOf<Key, double> Visit>
  void ray_cast(const Ray<N, T>& ray, Visit&& visit) const {
    detail::require_ray(ray);
    detail::GuardedVisit guarded(visit, keys_);
    detail::visit_cells_along(
        cells_, [&ray](const Box& box) { return detail::entry_of(ray, box); },
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
        cells_, [&sweep](const Box& other) { return sweep.touch(other); },
        [&](std::uint32_t slot, double t) { return guarded(keys_.key_of(slot), t); });
  }

  /// The k boxes nearest to the point, or all if there are fewer: by distance, ties by key. Throws
  /// std::invalid_argument if the point is not finite.
  std::vector<Neighbour> nearest(const Vec<N, T>& point, std::size_t k) const {
    detail::require_point(point);
    if (k == 0 || size() == 0) return {};
    detail::NearestKeys nearest(std::min(k, size()));
    const auto offer = [&](std::uint32_t slot, double distance) { nearest.offer({keys_.key_of(slot), distance}); };
    detail::visit_cells_near(cells_, point, offer, [&nearest] { return nearest.reach(); });
    return nearest.sorted();
  }

  /// Calls visit(a, b) once for every two boxes that share a point, ascending, a < b, until it returns false. Uses the
  /// batch method, which is faster than walking the cells; holds all pairs in memory while it visits them.
  template <VisitorOf<Key, Key> Visit>
  void pairs(Visit&& visit) const {
    detail::visit_index_pairs(
        keys_, [this](std::uint32_t slot) { return cells_.box(slot); }, visit);
  }

  /// Calls visit(GridCell) for every cell that holds boxes, larger ones before those in them, until it returns false.
  template <VisitorOf<GridCell<N, T>> Visit>
  void visit_cells(Visit&& visit) const {
    detail::GuardedVisit guarded(visit, keys_);
    detail::ShortList<std::uint32_t, detail::cell_walk_room> open;
    for (std::uint32_t k = cells_.root_count(); k-- > 0;) open.push(Cells::root + k);
    while (!open.empty()) {
      const std::uint32_t index = open.pop();
      const detail::Cell<N, T>& cell = cells_.cell(index);
      if (cell.entries.count > 0 && !guarded(picture_of(index))) return;
      if (cell.first_child == detail::no_index) continue;
      for (std::uint32_t k = Cells::children; k-- > 0;) open.push(cell.first_child + k);
    }
  }

 private:
  using Cells = detail::GridCells<N, T>;

  /// Positions fit 32 bits even if each box has a block of eight to itself.
  static constexpr std::uint32_t most = std::uint32_t{1} << 29U;

  GridCell<N, T> picture_of(std::uint32_t index) const {
    const detail::GridPlace<N> place = cells_.place(index);
    const double size = detail::grid_size(place.level);
    GridCell<N, T> picture{Box{}, size, cells_.cell(index).entries.count};
    for (Dim i = 0; i < N; ++i) {
      const auto number = static_cast<double>(place.numbers[static_cast<std::size_t>(i)]);
      picture.box.min[i] = static_cast<T>(number * size);
      picture.box.max[i] = static_cast<T>((number + 1) * size);
    }
    return picture;
  }

  detail::KeyTable keys_;
  Cells cells_;
};

}  // namespace graze
