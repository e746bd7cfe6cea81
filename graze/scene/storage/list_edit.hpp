// SPDX-License-Identifier: MIT
// A long sorted list of which little changes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

namespace graze::detail {

/// The first position from `from` on, up to `end`, whose item is not before `item`. Soon found where it is near.
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

/// How some items are taken out of an ascending list and others put in: thought out first, which may fail, and then
/// done in the list's own memory, which cannot. What lies between two changes is moved as a whole, and not at all where
/// it stays in its place. Keeps its memory.
template <class Item>
class ListEdit {
 public:
  static_assert(std::is_trivially_copyable_v<Item>);

  /// For a list from which the items at the positions `removed` are taken, ascending, and into which `added` are put,
  /// ascending, none of which equals one that is left.
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

  /// How many items the list will have. It must have the capacity.
  std::size_t size() const { return size_; }

  /// Changes the list that was planned for.
  void apply(std::vector<Item>& list, std::span<const Item> added) const noexcept {
    if (list.size() < size_) list.resize(size_);
    // A run that goes to the right comes after those behind it which do; one that goes to the left, after those before.
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
  /// Items that stay together.
  struct Run {
    std::size_t first;
    std::size_t last;
    std::size_t place;  // of the first, afterwards
  };

  /// Returns `last`.
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

  std::vector<Run> runs_;            // that move
  std::vector<std::size_t> places_;  // of what is put in, afterwards
  std::size_t size_ = 0;
};

}  // namespace graze::detail
