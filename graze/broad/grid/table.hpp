// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <graze/broad/grid/place.hpp>
#include <graze/broad/orthtree/entry_pool.hpp>
#include <graze/math/vec.hpp>

namespace graze::detail {

/// The children of a cell of a Grid.
template <Dim N>
struct GridGroup {
  GridPlace<N> place;               ///< Of the cell whose children they are.
  std::uint32_t parent = no_index;  ///< The cell itself; none above the roots.
};

/// Finds groups by their places: a hash table with open addressing and linear steps (Knuth, TAOCP 3, 6.4, algorithms L
/// and R), which knows so much of each hash that hardly any group is looked at in vain.
template <Dim N>
class GridTable {
 public:
  /// Which of the groups is that of a place; no_index if none is.
  std::uint32_t find(const GridPlace<N>& place, const std::vector<GridGroup<N>>& groups) const {
    if (slots_.empty()) return no_index;
    const std::uint32_t hash = hash_of(place);
    for (std::size_t i = hash & mask();; i = (i + 1) & mask()) {
      const Slot& slot = slots_[i];
      if (slot.group == no_index) return no_index;
      if (slot.hash == hash && groups[slot.group].place == place) return slot.group;
    }
  }

  /// Sees to room for so many more. May throw.
  void prepare(std::size_t more);

  /// The place is not in the table yet, and there is room.
  void add(const GridPlace<N>& place, std::uint32_t group) noexcept;

  /// The group is in the table.
  void remove(const GridPlace<N>& place, std::uint32_t group) noexcept;

  /// Forgets all groups and keeps the memory.
  void clear() noexcept;

  std::size_t size() const { return count_; }
  std::size_t bytes() const { return slots_.capacity() * sizeof(Slot); }

  /// The same on every machine. Each number is mixed in as in splitmix64 (Steele, Lea and Flood 2014, "Fast splittable
  /// pseudorandom number generators").
  static std::uint32_t hash_of(const GridPlace<N>& place) {
    auto hash = static_cast<std::uint64_t>(place.level) * 0x9E3779B97F4A7C15U;
    for (const std::int64_t number : place.numbers) {
      hash += static_cast<std::uint64_t>(number);
      hash = (hash ^ hash >> 30U) * 0xBF58476D1CE4E5B9U;
      hash = (hash ^ hash >> 27U) * 0x94D049BB133111EBU;
    }
    return static_cast<std::uint32_t>(hash >> 32U);
  }

 private:
  struct Slot {
    std::uint32_t hash = 0;
    std::uint32_t group = no_index;
  };

  std::size_t mask() const { return slots_.size() - 1; }

  std::vector<Slot> slots_;  // a power of two, at most half of them full
  std::size_t count_ = 0;
};

extern template class GridTable<2>;
extern template class GridTable<3>;

}  // namespace graze::detail
