// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/broad/memory/buffer.hpp>
#include <graze/broad/memory/prefetch.hpp>
#include <graze/broad/orthtree/code.hpp>
#include <graze/broad/orthtree/entry_pool.hpp>
#include <graze/broad/orthtree/group.hpp>
#include <graze/broad/orthtree/place.hpp>
#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

template <Dim N, class T>
class CellFilling;

/// The cells of an Orthtree and the boxes in them, by slot. The center of a box determines its path from the root; the
/// box is in the deepest split cell on it whose square, grown to twice its size, contains the box. If a box does not
/// fit the root, the root doubles until it does, unless cells below would exceed the depth limit; a box that is too far
/// away is outside. If that list, or a cell at the limit, becomes too long, all cells are rebuilt below a new root.
///
/// Bounds grow with every box. After as many insertions, moves and removals as there are boxes, all bounds are
/// recalculated.
template <Dim N, class T>
class GRAZE_EXPORT CellTree {
 public:
  using Box = Aabb<N, T>;

  static constexpr std::uint32_t children = cells_per_group<N>;
  /// The list of the boxes outside the root, stored as a cell without bounds.
  static constexpr std::uint32_t outside = 0;
  static constexpr std::uint32_t root = 1;  ///< Exists if has_root(); one of root_count().
  static constexpr int depth_limit = 32;

  /// Throws std::invalid_argument if an option is out of range.
  explicit CellTree(const OrthtreeOptions& options);

  /// These throw only std::bad_alloc, and then have no visible effect.
  void insert(std::uint32_t slot, const Box& box);
  void update(std::uint32_t slot, const Box& box);

  /// Fills an empty tree with many boxes, each in its slot; slots must be distinct. Cells of nearby boxes are near each
  /// other in memory. Throws only std::bad_alloc; the content is unusable after an exception.
  void fill(std::span<const Box> boxes, std::span<const std::uint32_t> slots);

  void erase(std::uint32_t slot) noexcept;
  void clear() noexcept;

  const Box& box(std::uint32_t slot) const { return pool_.box(positions_[slot]); }

  bool has_root() const { return has_root_; }
  std::uint32_t root_count() const { return has_root() ? 1 : 0; }
  Cell<N, T> cell(std::uint32_t index) const { return cells_[index]; }
  const CellGroup<N, T>* groups() const { return cells_.groups(); }
  void prefetch_cell(std::uint32_t index) const { prefetch_whole(cells_.groups() + index / children); }
  const CellPosition<N>& place(std::uint32_t index) const { return places_[index]; }
  const EntryPool<N, T>& pool() const { return pool_; }
  const OrthtreeOptions& options() const { return options_; }
  /// The scale that maps a point to its code.
  const CodeScale<N, T>& code_scale() const { return code_scale_; }

  int depth(std::uint32_t cell) const { return places_[cell].level - places_[root].level; }

  /// The memory held, in bytes.
  std::size_t bytes() const;

 private:
  friend class CellFilling<N, T>;

  void create_root(const CellPosition<N>& place);
  void reserve_groups(std::size_t count);
  bool is_leaf(std::uint32_t cell) const { return !cells_.has_children(cell); }
  bool stays(std::uint32_t cell, const Box& box) const;
  std::uint32_t cell_for(const Box& box);
  std::uint32_t home_below(std::uint32_t cell, const Box& box);
  std::uint32_t home_near(std::uint32_t cell, const Box& box);
  void move(std::uint32_t slot, std::uint32_t cell, const Box& box);
  void add(std::uint32_t cell, const Entry<N, T>& entry);
  void remove(std::uint32_t position) noexcept;
  void grow_bounds(std::uint32_t cell, const Box& box);
  bool can_split(const CellPosition<N>& place) const;
  std::uint32_t new_group(std::uint32_t parent);
  void split(std::uint32_t cell);
  void merge_from(std::uint32_t cell) noexcept;
  void merge_upwards(std::uint32_t cell) noexcept;
  void count_change();
  Box refresh(std::uint32_t cell);
  bool grow_root(const Box& box);
  void double_root(const Vec<N, double>& target);
  bool refit_is_due(std::uint32_t cell) const;
  bool root_is_too_large() const;
  void refit(double margin);

  OrthtreeOptions options_;
  CellGroups<N, T> cells_;                         // outside and the root, then groups of children
  std::vector<CellPosition<N>> places_;            // by cell
  CodeScale<N, T> code_scale_{CellPosition<N>{}};  // of the root
  bool has_root_ = false;
  std::uint32_t free_group_ = no_index;  // a chain by first_child of each group's first cell
  EntryPool<N, T> pool_;
  BlankVector<std::uint32_t> positions_;  // in the pool, by slot
  std::size_t size_ = 0;
  int deepest_level_ = 0;  // an upper bound, lowered by a refresh
  std::size_t changes_since_refresh_ = 0;
  std::size_t changes_since_refit_ = 0;
};

}  // namespace graze::detail
