// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <graze/broad/grid/place.hpp>
#include <graze/broad/grid/table.hpp>
#include <graze/broad/memory/prefetch.hpp>
#include <graze/broad/orthtree/entry_pool.hpp>
#include <graze/broad/orthtree/tree.hpp>
#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze {

/// The cell size of a Grid.
struct GridOptions {
  /// The least size of a cell, rounded up to a power of two. Boxes up to this size share cells of this size; larger
  /// boxes are in larger cells. Finite and not negative. 0: the grid chooses it so that a cell holds a few boxes, and
  /// adapts it as boxes change.
  double smallest_cell = 0;
};

namespace detail {

/// The cells of a Grid and the boxes in them, by slot. A box is in the cell that contains its center, of the lowest
/// level whose cells are at least as large as the box and at least at the base level. Occupied cells are linked to
/// their ancestors, up to the 2^N roots around the origin, so queries can skip empty space. Insertions and moves do not
/// descend from the roots: they find groups by hashing.
///
/// After as many insertions, moves and removals as there are boxes, the base level is chosen again if cells are too
/// full or too empty, and bounds are recalculated.
template <Dim N, class T>
class GRAZE_EXPORT GridCells {
 public:
  using Box = Aabb<N, T>;

  static constexpr std::uint32_t children = 1U << static_cast<unsigned>(N);
  /// The list of the boxes that are in no cell, stored as a cell without bounds.
  static constexpr std::uint32_t outside = 0;
  static constexpr std::uint32_t root = 1;  ///< The first of root_count().

  /// Throws std::invalid_argument if an option is out of range.
  explicit GridCells(const GridOptions& options);

  /// These throw only std::bad_alloc, and then have no visible effect.
  void insert(std::uint32_t slot, const Box& box);
  void update(std::uint32_t slot, const Box& box);

  void erase(std::uint32_t slot) noexcept;
  void clear() noexcept;

  const Box& box(std::uint32_t slot) const { return pool_.box(positions_[slot]); }

  std::uint32_t root_count() const { return cells_.size() > root ? children : 0; }
  const Cell<N, T>& cell(std::uint32_t index) const { return cells_[index]; }
  void prefetch_cell(std::uint32_t index) const { prefetch_first<sizeof(Cell<N, T>)>(&cells_[index]); }
  GridPlace<N> place(std::uint32_t cell) const;
  const EntryPool<N, T>& pool() const { return pool_; }
  const GridOptions& options() const { return options_; }

  /// The number of occupied cells.
  std::size_t filled() const { return filled_; }

  /// The memory held, in bytes.
  std::size_t bytes() const;

 private:
  static std::uint32_t group_of(std::uint32_t cell) { return (cell - root) / children; }
  static std::uint32_t first_of(std::uint32_t group) { return root + group * children; }

  GridPlace<N> place_of(const Box& box) const;
  bool is_at(std::uint32_t cell, const GridPlace<N>& where) const;
  std::uint32_t cell_for(const Box& box);
  std::uint32_t open_cell(const GridPlace<N>& where);
  void prepare_groups(std::size_t count);
  std::uint32_t new_group(std::uint32_t parent, const GridPlace<N>& where) noexcept;
  void raise_roots();
  void add(std::uint32_t cell, const Entry<N, T>& entry) noexcept;
  void remove(std::uint32_t position) noexcept;
  void prune_from(std::uint32_t cell) noexcept;
  bool is_unused(std::uint32_t cell) const;
  void grow_bounds(std::uint32_t cell, const Box& box) noexcept;
  Box refresh(std::uint32_t cell) noexcept;
  void review();
  bool base_is_due() const;
  int better_base() const;
  void rebuild(int base);

  GridOptions options_;
  int base_;
  int top_ = 0;                          // the level of the roots
  std::vector<Cell<N, T>> cells_;        // outside, the roots, then groups of children
  std::vector<GridGroup<N>> groups_;     // the first is the roots' group
  std::uint32_t free_group_ = no_index;  // a chain by first_child of each group's first cell
  std::size_t free_groups_ = 0;
  GridTable<N> table_;
  EntryPool<N, T> pool_;
  std::vector<std::uint32_t> positions_;  // in the pool, by slot
  std::size_t size_ = 0;
  std::size_t filled_ = 0;
  std::size_t changes_since_refresh_ = 0;
  std::size_t changes_since_choice_ = 0;  // choice of the base level
  std::size_t patience_ = 1;
};

}  // namespace detail
}  // namespace graze
