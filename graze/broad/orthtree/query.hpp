// SPDX-License-Identifier: MIT
// Finds the boxes in cells that share a point with a box. Branch-free in the tests of cells and boxes, because the
// outcomes are unpredictable and a misprediction costs more than some needless tests.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <graze/broad/memory/prefetch.hpp>
#include <graze/broad/memory/short_list.hpp>
#include <graze/broad/orthtree/entry_pool.hpp>

namespace graze::detail {

/// The stack of a walk that does not allocate: the siblings on a path down through 32 levels of a quadtree.
inline constexpr std::size_t cell_walk_room = 128;

/// Collects cells whose boxes are then tested together, so that the next ones are prefetched early.
template <class Cells, class Probe>
class MetCells {
 public:
  MetCells(const Cells& cells, const Probe& probe) : cells_(cells), probe_(probe) {}

  void push_if(unsigned condition, std::uint32_t cell) {
    met_[count_] = cell;
    count_ += condition;
  }

  bool has_room_for(std::size_t more) const { return met_.size() - count_ > more; }

  /// Calls visit(slot) for every box in the cells that is met until it returns false, and clears the cells. Returns
  /// false if it did.
  template <class Visit>
  bool visit_boxes(const Visit& visit) {
    const auto& pool = cells_.pool();
    const auto meets = [this](const auto& box) { return probe_.meets(box); };
    for (std::size_t k = 0; k < count_; ++k) pool.prefetch_block(first_block(k));
    std::size_t found = 0;
    for (std::size_t k = 0; k < count_; ++k) {
      for (EntryBlock block = first_block(k); !block.is_none(); block = pool.next_block(block)) {
        found += pool.write_where(block, meets, found_.data() + found);
        if (found_.size() - found >= pool.block_size) continue;
        if (!visit_found(found, visit)) return false;
        found = 0;
      }
    }
    count_ = 0;
    return visit_found(found, visit);
  }

 private:
  EntryBlock first_block(std::size_t k) const { return cells_.pool().first_block(cells_.cell(met_[k]).entries); }

  template <class Visit>
  bool visit_found(std::size_t count, const Visit& visit) const {
    for (std::size_t k = 0; k < count; ++k) {
      if (!visit(found_[k])) return false;
    }
    return true;
  }

  const Cells& cells_;
  const Probe& probe_;
  std::size_t count_ = 0;
  std::array<std::uint32_t, 64> met_;     // NOLINT(*-member-init): only what was written is read
  std::array<std::uint32_t, 256> found_;  // NOLINT(*-member-init): slots
};

/// Calls visit(slot) for every box that shares a point with the probe's until it returns false.
template <class Cells, class Probe, class Visit>
void visit_cells_in_box(const Cells& cells, const Probe& probe, const Visit& visit) {
  ShortList<std::uint32_t, cell_walk_room> open;  // the first cells of groups
  MetCells<Cells, Probe> met(cells, probe);
  const auto look_at = [&](std::uint32_t first, std::uint32_t count) {
    std::uint32_t* const groups = open.room_for(Cells::children);
    std::size_t opened = 0;
    for (std::uint32_t index = first; index < first + count; ++index) {
      const auto& cell = cells.cell(index);
      const unsigned is_met = probe.may_meet(cell.bounds) ? 1U : 0U;
      groups[opened] = cell.first_child;
      opened += is_met & static_cast<unsigned>(cell.first_child != no_index);
      met.push_if(is_met & static_cast<unsigned>(cell.entries.count != 0), index);
    }
    for (std::size_t k = 0; k < opened; ++k) cells.prefetch_cell(groups[k]);
    open.append(opened);
  };
  met.push_if(cells.cell(Cells::outside).entries.count != 0, Cells::outside);
  look_at(Cells::root, cells.root_count());
  while (!open.empty()) {
    if (!met.has_room_for(Cells::children) && !met.visit_boxes(visit)) return;
    look_at(open.pop(), Cells::children);
  }
  met.visit_boxes(visit);
}

}  // namespace graze::detail
