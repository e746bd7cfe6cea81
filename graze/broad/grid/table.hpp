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
  GridPlace<N> place;               ///< Of the parent cell.
  std::uint32_t parent = no_index;  ///< The index of the parent cell; none above the roots.
};

/// Finds groups by their cells: a hash table with open addressing and linear probing (Knuth, TAOCP 3, 6.4, algorithms L
/// and R). It stores the hashes, so that it rarely reads a wrong group.
template <Dim N>
class GridTable {
 public:
  /// The group of a cell's children; no_index if there is none.
  std::uint32_t find(const GridPlace<N>& place, const std::vector<GridGroup<N>>& groups) const {
    if (slots_.empty()) return no_index;
    const std::uint32_t hash = hash_of(place);
    for (std::size_t i = hash & mask();; i = (i + 1) & mask()) {
      const Slot& slot = slots_[i];
      if (slot.group == no_index) return no_index;
      if (slot.hash == hash && groups[slot.group].place == place) return slot.group;
    }
  }

  /// Reserves space for `more` groups. May throw.
  void prepare(std::size_t more);

  /// The cell must not be in the table, and space must be reserved.
  void add(const GridPlace<N>& place, std::uint32_t group) noexcept;

  /// The group must be in the table.
  void remove(const GridPlace<N>& place, std::uint32_t group) noexcept;

  /// Removes all groups and keeps the memory.
  void clear() noexcept;

  std::size_t size() const { return count_; }
  std::size_t bytes() const { return slots_.capacity() * sizeof(Slot); }

  /// The same on every machine. Mixes in each number as splitmix64 does (Steele, Lea and Flood 2014, "Fast splittable
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

  std::vector<Slot> slots_;  // a power of two; at most half of them are occupied
  std::size_t count_ = 0;
};

}  // namespace graze::detail
