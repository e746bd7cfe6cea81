// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace graze::detail {

/// Many lists of numbers that grow and end all the time, in one array. A list is known by its head, which its owner
/// keeps: `none` when it is empty. The newest number comes first.
class IndexLists {
 public:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// Of numbers in all lists.
  std::size_t size() const { return size_; }

  void add(std::uint32_t& head, std::uint32_t number) {
    ++size_;
    if (free_ == none) {
      entries_.push_back({number, std::exchange(head, static_cast<std::uint32_t>(entries_.size()))});
      return;
    }
    const std::uint32_t place = free_;
    free_ = entries_[place].next;
    entries_[place] = {number, std::exchange(head, place)};
  }

  template <class Visit>
  void for_each(std::uint32_t head, const Visit& visit) const {
    for (std::uint32_t i = head; i != none; i = entries_[i].next) visit(entries_[i].number);
  }

  /// Takes the numbers out of a list one by one, so that `visit` may add them to others.
  template <class Visit>
  void drain(std::uint32_t& head, const Visit& visit) {
    while (head != none) {
      const std::uint32_t place = head;
      head = std::exchange(entries_[place].next, free_);
      free_ = place;
      --size_;
      visit(entries_[place].number);
    }
  }

  /// All heads must be forgotten.
  void clear() { *this = {}; }

 private:
  struct Entry {
    std::uint32_t number;
    std::uint32_t next;
  };

  std::vector<Entry> entries_;
  std::uint32_t free_ = none;  // the head of a list of entries in no list
  std::size_t size_ = 0;
};

}  // namespace graze::detail
