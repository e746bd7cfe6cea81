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
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

template <Dim N, class T>
class CellFilling;

/// The cells of an Orthtree and the boxes in them, by slot. A box is in one cell: the deepest that was split on its way
/// down and whose square, grown to twice its size, contains the box; the box's center decides the way. What does not
/// fit the root so makes it grow, by doubling, as long as the cells below are not pushed deeper than the limit; what
/// is too far off even so is outside. Where that, or cells at the limit, hold too many the root is laid anew.
///
/// Bounds grow with every box, and shrink when as many boxes have come, moved and gone as there are: then all are
/// calculated anew.
template <Dim N, class T>
class CellTree {
 public:
  using Box = Aabb<N, T>;

  static constexpr std::uint32_t children = cells_per_group<N>;
  static constexpr std::uint32_t outside = 0;  ///< The list of the boxes outside of the root, as a cell without bounds.
  static constexpr std::uint32_t root = 1;     ///< Exists when has_root(); one of root_count().
  static constexpr int depth_limit = 32;

  /// Throws std::invalid_argument for options beyond their limits.
  explicit CellTree(const OrthtreeOptions& options);

  /// Each of these throws nothing but std::bad_alloc, and then changes nothing that can be seen.
  void insert(std::uint32_t slot, const Box& box);
  void update(std::uint32_t slot, const Box& box);

  /// Takes in many boxes at once, each in its slot, which differ; for a tree that holds none. Cells of boxes that are
  /// near each other come to lie near each other. Throws nothing but std::bad_alloc; what it holds then is of no use.
  void fill(std::span<const Box> boxes, std::span<const std::uint32_t> slots);

  void erase(std::uint32_t slot) noexcept;
  void clear() noexcept;

  const Box& box(std::uint32_t slot) const { return pool_.box(positions_[slot]); }

  bool has_root() const { return has_root_; }
  std::uint32_t root_count() const { return has_root() ? 1 : 0; }
  Cell<N, T> cell(std::uint32_t index) const { return cells_[index]; }
  const CellGroup<N, T>* groups() const { return cells_.groups(); }
  void prefetch_cell(std::uint32_t index) const { prefetch_whole(cells_.groups() + index / children); }
  const CellPlace<N>& place(std::uint32_t index) const { return places_[index]; }
  const EntryPool<N, T>& pool() const { return pool_; }
  const OrthtreeOptions& options() const { return options_; }
  /// By which the way down to a point is known, as its code.
  const CodeScale<N, T>& code_scale() const { return code_scale_; }

  int depth(std::uint32_t cell) const { return places_[cell].level - places_[root].level; }

  /// The memory that is held, in bytes.
  std::size_t bytes() const;

 private:
  friend class CellFilling<N, T>;

  void lay_root(const CellPlace<N>& place);
  void reserve_groups(std::size_t count);
  bool is_leaf(std::uint32_t cell) const { return !cells_.has_children(cell); }
  bool stays(std::uint32_t cell, const Box& box) const;
  std::uint32_t home_of(const Box& box);
  std::uint32_t home_below(std::uint32_t cell, const Box& box);
  std::uint32_t home_near(std::uint32_t cell, const Box& box);
  void move(std::uint32_t slot, std::uint32_t cell, const Box& box);
  void add(std::uint32_t cell, const Entry<N, T>& entry);
  void remove(std::uint32_t position) noexcept;
  void grow_bounds(std::uint32_t cell, const Box& box);
  bool can_split(const CellPlace<N>& place) const;
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
  CellGroups<N, T> cells_;                      // outside and the root, then groups of children
  std::vector<CellPlace<N>> places_;            // by cell
  CodeScale<N, T> code_scale_{CellPlace<N>{}};  // of the root
  bool has_root_ = false;
  std::uint32_t free_group_ = no_index;  // a chain by first_child of the group's first cell
  EntryPool<N, T> pool_;
  BlankVector<std::uint32_t> positions_;  // in the pool, by slot
  std::size_t size_ = 0;
  int deepest_level_ = 0;  // no cell is deeper; lowered by a refresh
  std::size_t changes_since_refresh_ = 0;
  std::size_t changes_since_refit_ = 0;
};

extern template class CellTree<2, float>;
extern template class CellTree<3, float>;
extern template class CellTree<2, double>;
extern template class CellTree<3, double>;

}  // namespace graze::detail
