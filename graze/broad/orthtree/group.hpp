// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <graze/broad/index/box_cover.hpp>
#include <graze/broad/memory/buffer.hpp>
#include <graze/broad/memory/prefetch.hpp>
#include <graze/broad/orthtree/entry_pool.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// What a query reads of a cell. The bounds contain all boxes in the cell and below it.
template <Dim N, class T>
struct Cell {
  Aabb<N, T> bounds = Aabb<N, T>::nothing();
  EntryList entries;
  std::uint32_t first_child = no_index;  ///< Children are consecutive.
};

/// The number of children of a cell.
template <Dim N>
inline constexpr std::uint32_t cells_per_group = 1U << static_cast<unsigned>(N);

/// The children of a cell in the layout that queries read: in 2D, with floats, two cache lines, of which the first
/// suffices to decide which are met.
template <Dim N, class T>
struct alignas(64) CellGroup {
  static constexpr std::uint32_t size = cells_per_group<N>;

  T min[N][size];  ///< Of the bounds, like max.
  T max[N][size];
  std::uint32_t below[size];   ///< The numbers of the groups of their children; 0 if there are none.
  std::uint32_t heads[size];   ///< Of their lists of entries.
  std::uint32_t counts[size];  ///< The same.
};

/// Cells in groups; the first group has no parent. A cell's index is its group's number times the group size, plus its
/// position in the group.
template <Dim N, class T>
class CellGroups {
 public:
  using Box = Aabb<N, T>;
  using Group = CellGroup<N, T>;

  CellGroups() { add_group(); }

  std::size_t size() const { return groups_.size() * Group::size; }
  const Group* groups() const { return groups_.data(); }

  /// Adds a group of empty cells and returns the index of the first. May throw.
  std::uint32_t add_group() {
    const auto first = static_cast<std::uint32_t>(size());
    groups_.resize(groups_.size() + 1);
    reset(first);
    return first;
  }

  /// Empties all cells of a group, given its first cell.
  void reset(std::uint32_t first) {
    for (std::uint32_t k = 0; k < Group::size; ++k) set(first + k, {});
  }

  /// Removes all groups except the first, which is emptied. The memory is kept.
  void clear() {
    groups_.resize(1);
    reset(0);
  }

  void reserve(std::size_t groups) { groups_.reserve(groups); }

  Cell<N, T> operator[](std::uint32_t cell) const { return {bounds(cell), entries(cell), first_child(cell)}; }
  void set(std::uint32_t cell, const Cell<N, T>& value) {
    set_bounds(cell, value.bounds);
    set_entries(cell, value.entries);
    set_first_child(cell, value.first_child);
  }

  Box bounds(std::uint32_t cell) const {
    const Group& in = group(cell);
    Box box;
    for (Dim i = 0; i < N; ++i) {
      box.min[i] = in.min[i][cell % Group::size];
      box.max[i] = in.max[i][cell % Group::size];
    }
    return box;
  }
  void set_bounds(std::uint32_t cell, const Box& box) {
    Group& in = group(cell);
    for (Dim i = 0; i < N; ++i) {
      in.min[i][cell % Group::size] = box.min[i];
      in.max[i][cell % Group::size] = box.max[i];
    }
  }

  /// Grows the bounds to contain a box.
  void grow(std::uint32_t cell, const Box& box) { set_bounds(cell, box_around(bounds(cell), box)); }

  EntryList entries(std::uint32_t cell) const {
    return {group(cell).heads[cell % Group::size], group(cell).counts[cell % Group::size]};
  }
  std::uint32_t count(std::uint32_t cell) const { return group(cell).counts[cell % Group::size]; }
  void set_entries(std::uint32_t cell, const EntryList& list) {
    group(cell).heads[cell % Group::size] = list.head;
    group(cell).counts[cell % Group::size] = list.count;
  }

  std::uint32_t first_child(std::uint32_t cell) const {
    const std::uint32_t below = group(cell).below[cell % Group::size];
    return below == 0 ? no_index : below * Group::size;
  }
  bool has_children(std::uint32_t cell) const { return group(cell).below[cell % Group::size] != 0; }
  void set_first_child(std::uint32_t cell, std::uint32_t first) {
    group(cell).below[cell % Group::size] = first == no_index ? 0 : first / Group::size;
  }

  /// The memory held, in bytes.
  std::size_t bytes() const { return groups_.capacity() * sizeof(Group); }

 private:
  Group& group(std::uint32_t cell) { return groups_[cell / Group::size]; }
  const Group& group(std::uint32_t cell) const { return groups_[cell / Group::size]; }

  BlankVector<Group> groups_;
};

}  // namespace graze::detail
