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
#include <graze/broad/memory/short_list.hpp>
#include <graze/broad/orthtree/walk.hpp>
#include <graze/broad/spatial_index.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/ray.hpp>

namespace graze {

/// A cell of a Grid, for pictures and for the curious.
template <Dim N, class T = float>
struct GridCell {
  Aabb<N, T> box;     ///< The square. A box belongs to it by its center, and may stick out by half the square's size.
  double size;        ///< The length of its sides, a power of two.
  std::size_t count;  ///< How many boxes it holds; never 0.
};

/// A SpatialIndex (spatial_index.hpp says what its members do) that keeps boxes in equal cells, found by hashing: a
/// hierarchical grid, with a level of its own for every size of boxes, each twice that of the one before. Each box is
/// in one cell of one level. Only cells that hold boxes exist, wherever they are; boxes that are infinite, or as large
/// as numbers get, are kept in a list, and found like the others.
///
/// An Orthtree has small cells where there are many boxes, a Grid the same ones everywhere. It is filled in the time of
/// an Orthtree, or, where boxes crowd together, in half of it, moves boxes as fast, and takes up to a fifth longer to
/// answer. A Bvh answers in a third of the time of either, and takes about as long as an Orthtree to fill box by box
/// and to move (100,000 boxes in space; bench/bvh.cpp).
template <Dim N, class T = float>
class Grid {
 public:
  using Box = Aabb<N, T>;

  /// Throws std::invalid_argument for a smallest_cell that is negative, not a number, or above 2^1000.
  explicit Grid(const GridOptions& options = {}) : keys_(most), cells_(options) {}
  explicit Grid(double smallest_cell) : Grid(GridOptions{smallest_cell}) {}

  /// At most 2^29 boxes.
  Key insert(const Box& box) {
    detail::require_box(box);
    cells_.insert(keys_.prepare().index, box);
    return keys_.take();
  }

  void update(const Key& key, const Box& box) {
    const std::uint32_t slot = keys_.slot_of(key);
    detail::require_box(box);
    cells_.update(slot, box);
    keys_.count_change();
  }

  void erase(const Key& key) {
    const std::uint32_t slot = keys_.slot_of(key);
    cells_.erase(slot);
    keys_.release(slot);
  }

  void clear() {
    cells_.clear();
    keys_.release_all();
  }

  bool contains(const Key& key) const { return keys_.contains(key); }
  const Box& box(const Key& key) const { return cells_.box(keys_.slot_of(key)); }
  std::size_t size() const { return keys_.size(); }
  const GridOptions& options() const { return cells_.options(); }

  /// How many boxes are in no cell, because they are infinite or as large as numbers get.
  std::size_t outside() const { return cells_.cell(Cells::outside).entries.count; }

  /// The memory that is held, in bytes.
  std::size_t bytes() const { return keys_.bytes() + cells_.bytes(); }

  /// Visits cell by cell, from the largest down.
  template <RegionIn<N, T> R, VisitorOf<Key> Visit>
  void query(const R& region, Visit&& visit) const {
    const detail::RegionProbe<R> probe(region);
    detail::GuardedVisit guarded(visit, keys_);
    detail::visit_cells_met(cells_, probe, [&](std::uint32_t slot) { return guarded(keys_.key_of(slot)); });
  }

  template <VisitorOf<Key, double> Visit>
  void ray_cast(const Ray<N, T>& ray, Visit&& visit) const {
    detail::require_ray(ray);
    detail::GuardedVisit guarded(visit, keys_);
    detail::visit_cells_along(cells_, ray,
                              [&](std::uint32_t slot, double t) { return guarded(keys_.key_of(slot), t); });
  }

  std::vector<Neighbour> nearest(const Vec<N, T>& point, std::size_t k) const {
    detail::require_point(point);
    if (k == 0 || size() == 0) return {};
    detail::NearestKeys nearest(std::min(k, size()));
    const auto offer = [&](std::uint32_t slot, double distance) { nearest.offer({keys_.key_of(slot), distance}); };
    detail::visit_cells_near(cells_, point, offer, [&nearest] { return nearest.reach(); });
    return nearest.sorted();
  }

  /// By the batch method, which is quicker than any walk through cells; holds all pairs while it visits them.
  template <VisitorOf<Key, Key> Visit>
  void pairs(Visit&& visit) const {
    detail::visit_index_pairs(
        keys_, [this](std::uint32_t slot) { return cells_.box(slot); }, visit);
  }

  /// visit(GridCell) for every cell that holds boxes, larger ones before those in them.
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

  /// Positions of boxes fit 32 bits even if each has a block of eight to itself.
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
