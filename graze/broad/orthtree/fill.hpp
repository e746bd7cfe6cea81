// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/broad/memory/buffer.hpp>
#include <graze/broad/orthtree/code.hpp>
#include <graze/broad/orthtree/tree.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// Bulk insertion into an empty CellTree: sorts the boxes by their codes as deep as cells are needed, divides the
/// sequence from the root down, and creates cells, entries and bounds in one pass. Boxes that do not fit where their
/// code leads are added at the end, one by one.
template <Dim N, class T>
class CellFilling {
 public:
  using Box = Aabb<N, T>;
  using Tree = CellTree<N, T>;

  CellFilling(Tree& tree, std::span<const Box> boxes, std::span<const std::uint32_t> slots)
      : tree_(tree), boxes_(boxes), slots_(slots) {}

  /// Must be called only once.
  void run();

 private:
  /// Consecutive boxes whose centers are in one cell.
  struct Range {
    std::size_t first;
    std::size_t last;
    int depth;
    int sorted_depth;  // depth to which the boxes are sorted

    std::size_t count() const { return last - first; }
  };

  void create_root();
  void code_boxes();
  bool is_leaf(std::uint32_t cell, const Range& range) const;
  std::array<std::size_t, Tree::children> ends_in(const Range& range) const;
  Box fill_cell(std::uint32_t cell, Range range);
  void ask_ahead(std::size_t place) const;
  std::uint32_t slot_of(std::uint32_t index) const { return slots_are_row_ ? slots_[0] + index : slots_[index]; }
  Box fill_at_once(std::uint32_t cell, const Range& range);
  Box fill_leaf(std::uint32_t cell, const Range& range);
  void add_alone(std::uint32_t index);

  Tree& tree_;
  std::span<const Box> boxes_;
  std::span<const std::uint32_t> slots_;
  bool slots_are_row_ = false;   // whether the slots are consecutive
  std::size_t asked_until_ = 0;  // position in the order up to which boxes are prefetched
  BlankVector<CodedBox> sorted_;
  BlankVector<CodedBox> spare_;           // for sorting
  std::vector<std::uint32_t> left_over_;  // indices
};

}  // namespace graze::detail
