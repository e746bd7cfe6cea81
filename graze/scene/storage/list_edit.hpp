// SPDX-License-Identifier: MIT
// Edits of long sorted lists with few changes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

namespace graze::detail {

/// The first position in [from, end) whose item is not before `item`. Fast if it is near `from`.
template <class Item>
std::size_t position_of(std::span<const Item> list, const Item& item, std::size_t from, std::size_t end) {
  std::size_t step = 1;
  while (from + step <= end && list[from + step - 1] < item) {
    from += step;
    step *= 2;
  }
  const auto first = list.begin() + static_cast<std::ptrdiff_t>(from);
  const auto last = list.begin() + static_cast<std::ptrdiff_t>(std::min(from + step, end));
  return static_cast<std::size_t>(std::lower_bound(first, last, item) - list.begin());
}

/// A plan for removing items from an ascending list and inserting others. Planning may throw; applying the plan works
/// within the list's memory and cannot. Items between two changes are moved as a block, and not at all if their
/// position stays the same. Keeps its memory.
template <class Item>
class ListEdit {
 public:
  static_assert(std::is_trivially_copyable_v<Item>);

  /// Plans for a list from which the items at the positions `removed`, ascending, are removed, and into which `added`,
  /// ascending, are inserted; no added item equals a remaining one.
  void plan(std::span<const Item> list, std::span<const std::size_t> removed, std::span<const Item> added) {
    runs_.clear();
    places_.clear();
    size_ = 0;
    std::size_t from = 0;
    for (std::size_t k = 0; k <= removed.size(); ++k) {
      const std::size_t stop = k < removed.size() ? removed[k] : list.size();
      while (places_.size() < added.size()) {
        const Item& next = added[places_.size()];
        if (k < removed.size() && list[stop] < next) break;
        from = keep(from, position_of(list, next, from, stop));
        places_.push_back(size_++);
      }
      from = keep(from, stop) + 1;
    }
  }

  /// The number of items after the edit; the list must have this capacity.
  std::size_t size() const { return size_; }

  /// Edits the list for which the edit was planned.
  void apply(std::vector<Item>& list, std::span<const Item> added) const noexcept {
    if (list.size() < size_) list.resize(size_);
    // Runs that move right are moved last to first, runs that move left first to last.
    for (std::size_t k = 0; k < runs_.size();) {
      const std::size_t first = k;
      while (k < runs_.size() && runs_[k].first < runs_[k].place) ++k;
      for (std::size_t each = k; each-- > first;) move_right(list, runs_[each]);
      if (k < runs_.size()) move_left(list, runs_[k++]);
    }
    for (std::size_t k = 0; k < places_.size(); ++k) list[places_[k]] = added[k];
    list.resize(size_);
  }

 private:
  /// Consecutive items that stay together.
  struct Run {
    std::size_t first;
    std::size_t last;
    std::size_t place;  // new position of the first
  };

  /// Plans to keep items [first, last); returns `last`.
  std::size_t keep(std::size_t first, std::size_t last) {
    if (first < last && first != size_) runs_.push_back({first, last, size_});
    size_ += last - first;
    return last;
  }

  static auto at(std::vector<Item>& list, std::size_t position) {
    return list.begin() + static_cast<std::ptrdiff_t>(position);
  }
  static void move_left(std::vector<Item>& list, const Run& run) {
    std::copy(at(list, run.first), at(list, run.last), at(list, run.place));
  }
  static void move_right(std::vector<Item>& list, const Run& run) {
    std::copy_backward(at(list, run.first), at(list, run.last), at(list, run.place + run.last - run.first));
  }

  std::vector<Run> runs_;            // the runs that move
  std::vector<std::size_t> places_;  // new positions of the added items
  std::size_t size_ = 0;
};

}  // namespace graze::detail
