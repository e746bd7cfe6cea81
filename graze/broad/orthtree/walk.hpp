// SPDX-License-Identifier: MIT
// Walks of linked cells: those of a CellTree and of GridCells, which have the same interface. The bounds of a cell
// contain all boxes in it and below it.
#pragma once

#include <cstddef>
#include <cstdint>

#include <graze/broad/memory/short_list.hpp>
#include <graze/broad/orthtree/cell_kernels.hpp>
#include <graze/broad/orthtree/entry_pool.hpp>
#include <graze/broad/orthtree/query.hpp>
#include <graze/broad/orthtree/tree.hpp>
#include <graze/broad/spatial_index.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/distance_squared.hpp>
#include <graze/shape/ray.hpp>

namespace graze::detail {

/// Cells that the kernels support.
template <class Cells>
concept HasGroups = requires(const Cells& cells) {
  cells.groups();
};

/// Calls visit(slot) for every box that shares a point with `region` until it returns false. If `region` has a NaN,
/// there is none.
template <HasGroups Cells, Dim N, class T, class Visit>
void visit_groups_in_box(const Cells& cells, const Aabb<N, T>& region, const Visit& visit) {
  CellMetWalk<N, T> walk;
  walk.start(region);
  for (std::uint32_t k = 0; k < cells.root_count(); ++k) {
    walk.add_entries(cells.cell(Cells::root + k).entries);
    if (cells.cell(Cells::root + k).first_child != no_index)
      walk.add_group(cells.cell(Cells::root + k).first_child / Cells::children);
  }
  walk.add_entries(cells.cell(Cells::outside).entries);
  walk.follow(CellWay<N>::to_middle(region, cells.code_scale()));
  const auto find_overlapping = cell_kernels<N, T>().find_overlapping;
  while (!walk.is_over()) {
    walk.found_count = 0;
    find_overlapping(cells.groups(), cells.pool().pages(), walk);
    for (std::size_t k = 0; k < walk.found_count; ++k) {
      if (!visit(walk.found[k])) return;
    }
  }
}

/// Calls visit(slot) for every box that meets the region of `probe` (a RegionProbe or a class with its interface), cell
/// by cell, until it returns false.
template <class Cells, class Probe, class Visit>
void visit_cells_met(const Cells& cells, const Probe& probe, const Visit& visit) {
  if constexpr (Probe::is_box && HasGroups<Cells>) return visit_groups_in_box(cells, probe.reach(0), visit);
  if constexpr (Probe::is_box) return visit_cells_in_box(cells, probe, visit);
  const auto meets = [&probe](const auto& box) { return probe.meets(box); };
  ShortList<std::uint32_t, cell_walk_room> open;
  const auto open_group = [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t cell = first; cell < first + count; ++cell) {
      open.push_if(probe.may_meet(cells.cell(cell).bounds), cell);
    }
  };
  open_group(Cells::root, cells.root_count());
  open.push(Cells::outside);
  while (!open.empty()) {
    const auto& cell = cells.cell(open.pop());
    if (!cells.pool().visit_where(cell.entries, meets, visit)) return;
    if (cell.first_child == no_index || !probe.may_meet_closely(cell.bounds)) continue;
    open_group(cell.first_child, Cells::children);
  }
}

/// A box, by its slot, or a cell that a ray or a moving box enters.
struct CellHit {
  double t;
  bool is_box;
  std::uint32_t index;

  /// Cells come before boxes with the same t: a cell may contain a box that precedes them.
  struct Sooner {
    bool operator()(const CellHit& a, const CellHit& b) const {
      if (a.t != b.t) return a.t < b.t;
      return a.is_box != b.is_box ? b.is_box : a.index < b.index;
    }
  };
};

/// Calls visit(slot, t) for every box that a ray or a moving box enters, in order of t = *time(box), ties by slot,
/// until it returns false. Of a box that contains another, the time must not be later.
template <class Cells, class Time, class Visit>
void visit_cells_along(const Cells& cells, const Time& time, const Visit& visit) {
  ShortHeap<CellHit, cell_walk_room, CellHit::Sooner> open;
  const auto push_entries = [&](const auto& cell) {
    cells.pool().for_each(cell.entries, [&](const auto& entry) {
      if (const auto t = time(entry.box)) open.push({*t, true, entry.slot});
    });
  };
  const auto open_group = [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t cell = first; cell < first + count; ++cell) {
      if (const auto t = time(cells.cell(cell).bounds)) open.push({*t, false, cell});
    }
  };
  push_entries(cells.cell(Cells::outside));
  open_group(Cells::root, cells.root_count());
  while (!open.empty()) {
    const CellHit next = open.pop();
    if (next.is_box) {
      if (!visit(next.index, next.t)) return;
      continue;
    }
    const auto& cell = cells.cell(next.index);
    push_entries(cell);
    if (cell.first_child != no_index) open_group(cell.first_child, Cells::children);
  }
}

/// A cell and its distance from a point.
struct NearCell {
  double distance_squared;
  std::uint32_t index;

  struct Nearer {
    bool operator()(const NearCell& a, const NearCell& b) const { return a.distance_squared < b.distance_squared; }
  };
};

/// Calls offer(slot, squared distance) for boxes near a point until everything left is beyond reach().
template <class Cells, Dim N, class T, class Offer, class Reach>
void visit_cells_near(const Cells& cells, const Vec<N, T>& point, const Offer& offer, const Reach& reach) {
  const auto offer_entries = [&](const Cell<N, T>& cell) {
    cells.pool().for_each(cell.entries,
                          [&](const Entry<N, T>& entry) { offer(entry.slot, distance_squared(point, entry.box)); });
  };
  ShortHeap<NearCell, cell_walk_room, NearCell::Nearer> open;
  const auto open_group = [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t cell = first; cell < first + count; ++cell) {
      const double distance = distance_squared(point, cells.cell(cell).bounds);
      if (distance <= reach()) open.push({distance, cell});
    }
  };
  offer_entries(cells.cell(Cells::outside));
  open_group(Cells::root, cells.root_count());
  while (!open.empty()) {
    const NearCell next = open.pop();
    if (next.distance_squared > reach()) return;
    const Cell<N, T>& cell = cells.cell(next.index);
    offer_entries(cell);
    if (cell.first_child != no_index) open_group(cell.first_child, Cells::children);
  }
}

}  // namespace graze::detail
