// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <graze/broad/memory/short_list.hpp>
#include <graze/broad/orthtree/entry_pool.hpp>
#include <graze/shape/aabb.hpp>

namespace bench {

/// The alternative that graze did not choose: a quadtree as flat as graze's that stores boxes in every leaf that they
/// touch. Each box is reported once, without flags, by the leaf that contains the lower corner of its intersection with
/// the region. Splits as graze's does; does not merge, which favours it.
class SeveralLeaves {
 public:
  using Box = graze::Aabb<2, float>;

  SeveralLeaves(const Box& world, std::uint32_t capacity, int max_depth)
      : cells_{{world, {}, graze::detail::no_index, 0}}, capacity_(capacity), max_depth_(max_depth) {}

  void insert(std::uint32_t id, const Box& box) { insert_below(0, {box, id}); }

  void update(std::uint32_t id, const Box& old_box, const Box& box) {
    graze::detail::ShortList<std::uint32_t, 128> open;
    open.push(0);
    while (!open.empty()) {
      Cell& cell = cells_[open.pop()];
      if (!boxes_overlap(cell.box, old_box)) continue;
      if (cell.first_child == graze::detail::no_index) {
        remove(cell, id);
      } else {
        for (std::uint32_t k = 0; k < 4; ++k) open.push(cell.first_child + k);
      }
    }
    insert(id, box);
  }

  template <class Visit>
  void query(const Box& region, const Visit& visit) const {
    graze::detail::ShortList<std::uint32_t, 128> open;
    open.push(0);
    while (!open.empty()) {
      const Cell& cell = cells_[open.pop()];
      pool_.for_each(cell.entries, [&](const Entry& entry) {
        if (boxes_overlap(entry.box, region) && is_first(cell, entry.box, region)) visit(entry.slot);
      });
      if (cell.first_child == graze::detail::no_index) continue;
      for (std::uint32_t k = 0; k < 4; ++k) {
        if (boxes_overlap(cells_[cell.first_child + k].box, region)) open.push(cell.first_child + k);
      }
    }
  }

 private:
  using Entry = graze::detail::Entry<2, float>;

  struct Cell {
    Box box;
    graze::detail::EntryList entries;
    std::uint32_t first_child;
    int depth;
  };

  /// The corner belongs to the cell on whose lower sides it lies.
  static bool is_first(const Cell& cell, const Box& box, const Box& region) {
    for (graze::Dim i = 0; i < 2; ++i) {
      const float corner = std::max(box.min[i], region.min[i]);
      if (!(cell.box.min[i] <= corner && corner < cell.box.max[i])) return false;
    }
    return true;
  }

  void insert_below(std::uint32_t root, const Entry& entry) {
    graze::detail::ShortList<std::uint32_t, 128> open;
    open.push(root);
    while (!open.empty()) {
      const std::uint32_t index = open.pop();
      if (!boxes_overlap(cells_[index].box, entry.box)) continue;
      const bool is_full = cells_[index].entries.count >= capacity_ && cells_[index].depth < max_depth_;
      if (cells_[index].first_child == graze::detail::no_index && is_full) split(index);
      if (cells_[index].first_child == graze::detail::no_index) {
        pool_.add(cells_[index].entries, index, entry);
      } else {
        for (std::uint32_t k = 0; k < 4; ++k) open.push(cells_[index].first_child + k);
      }
    }
  }

  void split(std::uint32_t index) {
    const auto first = static_cast<std::uint32_t>(cells_.size());
    const Box box = cells_[index].box;
    const auto center = box.center();
    const int depth = cells_[index].depth + 1;
    cells_.push_back({{box.min, center}, {}, graze::detail::no_index, depth});
    cells_.push_back({{{center.x, box.min.y}, {box.max.x, center.y}}, {}, graze::detail::no_index, depth});
    cells_.push_back({{{box.min.x, center.y}, {center.x, box.max.y}}, {}, graze::detail::no_index, depth});
    cells_.push_back({{center, box.max}, {}, graze::detail::no_index, depth});
    graze::detail::EntryList held = cells_[index].entries;
    cells_[index].entries = {};
    cells_[index].first_child = first;
    std::vector<Entry> entries;
    pool_.for_each(held, [&entries](const Entry& entry) { entries.push_back(entry); });
    pool_.release(held);
    for (const Entry& entry : entries) insert_below(index, entry);
  }

  void remove(Cell& cell, std::uint32_t id) {
    std::uint32_t position = graze::detail::no_index;
    for (auto block = pool_.first_block(cell.entries); !block.is_none(); block = pool_.next_block(block)) {
      for (std::uint32_t at = block.index * pool_.block_size, k = 0; k < block.filled; ++at, ++k) {
        if (pool_.slot(at) == id) position = at;
      }
    }
    if (position != graze::detail::no_index) pool_.remove(cell.entries, position);
  }

  std::vector<Cell> cells_;
  graze::detail::EntryPool<2, float> pool_;
  std::uint32_t capacity_;
  int max_depth_;
};

}  // namespace bench
