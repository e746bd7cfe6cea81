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

/// How a CellTree that holds none takes in many boxes at once: it sorts them by their codes, as far as there are cells,
/// divides the row from the root down, and so comes by cells, entries and bounds in one walk along it. What does not
/// fit where its code leads is added at the end, one by one.
template <Dim N, class T>
class CellFilling {
 public:
  using Box = Aabb<N, T>;
  using Tree = CellTree<N, T>;

  CellFilling(Tree& tree, std::span<const Box> boxes, std::span<const std::uint32_t> slots)
      : tree_(tree), boxes_(boxes), slots_(slots) {}

  /// To be called once.
  void run();

 private:
  /// Boxes in a row whose centers are in one cell.
  struct Range {
    std::size_t first;
    std::size_t last;
    int depth;
    int sorted_depth;  // down to which cells stand in their order

    std::size_t count() const { return last - first; }
  };

  void lay_root();
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
  bool slots_are_row_ = false;   // each is the next after the one before
  std::size_t asked_until_ = 0;  // the place in the row up to which boxes are asked for ahead
  BlankVector<CodedBox> sorted_;
  BlankVector<CodedBox> spare_;           // for whoever sorts
  std::vector<std::uint32_t> left_over_;  // indices
};

extern template class CellFilling<2, float>;
extern template class CellFilling<3, float>;
extern template class CellFilling<2, double>;
extern template class CellFilling<3, double>;

}  // namespace graze::detail
