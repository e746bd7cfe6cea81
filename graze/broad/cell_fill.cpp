// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <graze/broad/box_cover.hpp>
#include <graze/broad/buffer.hpp>
#include <graze/broad/cell_fill.hpp>
#include <graze/broad/cell_place.hpp>
#include <graze/broad/cell_tree.hpp>
#include <graze/broad/prefetch.hpp>

namespace graze::detail {
namespace {

/// Spreads the lowest bits of a number, so that between two of them there is room for those of the other axes.
template <Dim N>
std::uint32_t spread_bits(std::uint32_t bits) {
  if constexpr (N == 2) {
    bits = (bits | bits << 8U) & 0x00FF'00FFU;
    bits = (bits | bits << 4U) & 0x0F0F'0F0FU;
    bits = (bits | bits << 2U) & 0x3333'3333U;
    return (bits | bits << 1U) & 0x5555'5555U;
  } else {
    bits = (bits | bits << 16U) & 0x0300'00FFU;
    bits = (bits | bits << 8U) & 0x0300'F00FU;
    bits = (bits | bits << 4U) & 0x030C'30C3U;
    return (bits | bits << 2U) & 0x0924'9249U;
  }
}

/// The code of a point in a root: CodedBox says what it is.
template <Dim N>
class CellCode {
 public:
  explicit CellCode(const CellPlace<N>& root)
      : center_(root.center), half_cells_(std::ldexp(1.0, code_levels<N> - 1)), scale_(half_cells_ / root.half) {}

  std::uint32_t operator()(const Vec<N, double>& point) const {
    const double last = 2 * half_cells_ - 1;
    std::uint32_t code = 0;
    for (Dim i = 0; i < N; ++i) {
      const double along = (point[i] - center_[i]) * scale_ + half_cells_;
      const double within = along < last ? along : last;
      const std::uint32_t cell = within > 0 ? static_cast<std::uint32_t>(within) : 0U;  // a point for a root gives NaN
      code |= spread_bits<N>(cell) << static_cast<unsigned>(i);
    }
    return code;
  }

 private:
  Vec<N, double> center_;
  double half_cells_;
  double scale_;
};

/// Sorts by the code, boxes of one code by their index, by counting digits of eleven bits (Knuth, "The Art of Computer
/// Programming", volume 3, section 5.2.5).
void sort_by_code(BlankVector<CodedBox>& boxes) {
  constexpr std::uint32_t digits = 1U << 11U;
  std::vector<std::array<std::uint32_t, 3>> places(digits, {0, 0, 0});
  for (const CodedBox& box : boxes) {
    for (std::uint32_t pass = 0; pass < 3; ++pass) ++places[box.code >> 11U * pass & (digits - 1)][pass];
  }
  BlankVector<CodedBox> sorted(boxes.size());
  for (std::uint32_t pass = 0; pass < 3; ++pass) {
    std::uint32_t first = 0;
    for (auto& place : places) first += std::exchange(place[pass], first);
    for (const CodedBox& box : boxes) sorted[places[box.code >> 11U * pass & (digits - 1)][pass]++] = box;
    std::swap(boxes, sorted);
  }
}

/// All finite boxes, thinned out evenly when they are many.
template <Dim N, class T>
std::vector<Aabb<N, T>> sample_of(std::span<const Aabb<N, T>> boxes) {
  constexpr std::size_t enough = 2048;
  std::vector<Aabb<N, T>> sample;
  const std::size_t step = std::max<std::size_t>(1, boxes.size() / enough);
  for (std::size_t k = 0; k < boxes.size(); k += step) {
    if (is_finite_box(boxes[k])) sample.push_back(boxes[k]);
  }
  return sample;
}

/// place_of_root, told from a sample of the boxes and from what is around all of them.
template <Dim N, class T>
CellPlace<N> place_of_root_for(std::span<const Aabb<N, T>> boxes, const OrthtreeOptions& options) {
  std::vector<Aabb<N, T>> sample = sample_of(boxes);
  if (sample.empty()) return {};
  Aabb<N, T> all = Aabb<N, T>::nothing();
  for (const Aabb<N, T>& box : boxes) grow_at_once(all, is_finite_box(box) ? box : sample[0]);
  return place_of_root(sample, all, boxes.size(), options);
}

}  // namespace

template <Dim N, class T>
void CellFilling<N, T>::run() {
  if (boxes_.empty()) return;
  const std::size_t slots = std::size_t{*std::max_element(slots_.begin(), slots_.end())} + 1;
  tree_.positions_.resize(slots, no_index);
  tree_.pool_.reserve(boxes_.size() / 5 + 8);
  tree_.size_ = boxes_.size();
  if (boxes_.size() > tree_.options_.capacity) {
    lay_root();
    sort_boxes();
    fill_cell(Tree::root, {0, boxes_.size(), 0});
  } else {
    for (std::uint32_t index = 0; index < boxes_.size(); ++index) left_over_.push_back(index);
  }
  for (const std::uint32_t index : left_over_) add_alone(index);
}

template <Dim N, class T>
void CellFilling<N, T>::lay_root() {
  tree_.cells_.resize(Tree::root + 1);
  tree_.places_.resize(Tree::root + 1);
  tree_.places_[Tree::root] = place_of_root_for(boxes_, tree_.options_);
}

template <Dim N, class T>
void CellFilling<N, T>::sort_boxes() {
  const CellCode<N> code(tree_.places_[Tree::root]);
  sorted_.resize(boxes_.size());
  for (std::uint32_t k = 0; k < boxes_.size(); ++k) sorted_[k] = {k, code(center_of(boxes_[k]))};
  sort_by_code(sorted_);
}

/// Whether the boxes that are left for a cell stay there: because they are few, or because no cell below takes any.
/// Above the levels where leaves are expected the boxes are not looked at for it.
template <Dim N, class T>
bool CellFilling<N, T>::is_leaf(std::uint32_t cell, const Range& range) const {
  const CellPlace<N>& place = tree_.places_[cell];
  const int deepest = std::min(tree_.options_.max_depth, code_levels<N>);
  if (range.count() <= tree_.options_.capacity || range.depth >= deepest || !tree_.can_split(place)) return true;
  if (boxes_.size() >> static_cast<unsigned>(N * range.depth) > tree_.options_.capacity) return false;
  for (std::size_t k = range.first; k < range.last; ++k) {
    const Box& box = boxes_[sorted_[k].index];
    if (fits(child_place(place, child_towards(place, center_of(box))), box)) return false;
  }
  return true;
}

/// Where the boxes of a child end that begin at `first`.
template <Dim N, class T>
std::size_t CellFilling<N, T>::end_of(std::uint32_t child, const Range& range, std::size_t first) const {
  const auto shift = static_cast<unsigned>(N * (code_levels<N> - 1 - range.depth));
  const CodedBox* const last =
      std::partition_point(sorted_.data() + first, sorted_.data() + range.last,
                           [&](const CodedBox& box) { return (box.code >> shift & (Tree::children - 1)) <= child; });
  return static_cast<std::size_t>(last - sorted_.data());
}

/// Returns the bounds. Calls itself code_levels deep at most.
template <Dim N, class T>
Aabb<N, T> CellFilling<N, T>::fill_cell(std::uint32_t cell, const Range& range) {  // NOLINT(misc-no-recursion)
  if (is_leaf(cell, range)) return fill_leaf(cell, range);
  const std::uint32_t first_child = tree_.new_group(cell);
  tree_.cells_[cell].first_child = first_child;
  tree_.deepest_level_ = std::max(tree_.deepest_level_, tree_.places_[first_child].level);
  Box bounds = Box::nothing();
  Range part{range.first, range.first, range.depth + 1};
  for (std::uint32_t child = 0; child < Tree::children; ++child) {
    part.first = part.last;
    part.last = end_of(child, range, part.first);
    if (part.count() > 0) grow_at_once(bounds, fill_cell(first_child + child, part));
  }
  return tree_.cells_[cell].bounds = bounds;
}

/// Asks for what will be looked at after the box at a place of the row: it lies anywhere in memory.
template <Dim N, class T>
void CellFilling<N, T>::ask_ahead(std::size_t place) const {
  constexpr std::size_t ahead = 12;
  if (place + 2 * ahead >= sorted_.size()) return;
  const std::uint32_t far = sorted_[place + 2 * ahead].index;
  prefetch(&boxes_[far]);
  prefetch(&slots_[far]);
  prefetch_to_write(&tree_.positions_[slots_[sorted_[place + ahead].index]]);
}

template <Dim N, class T>
Aabb<N, T> CellFilling<N, T>::fill_leaf(std::uint32_t cell, const Range& range) {
  const CellPlace<N> place = tree_.places_[cell];
  const bool may_split = range.depth < tree_.options_.max_depth && tree_.can_split(place);
  Box bounds = Box::nothing();
  EntryList list;
  for (std::size_t k = range.first; k < range.last; ++k) {
    ask_ahead(k);
    const std::uint32_t index = sorted_[k].index;
    const Box box = boxes_[index];
    if (!takes(place, box) || (may_split && list.count == tree_.options_.capacity)) {
      left_over_.push_back(index);
      continue;
    }
    grow_at_once(bounds, box);
    tree_.positions_[slots_[index]] = tree_.pool_.add(list, cell, {box, slots_[index]});
  }
  tree_.cells_[cell].entries = list;
  return tree_.cells_[cell].bounds = bounds;
}

template <Dim N, class T>
void CellFilling<N, T>::add_alone(std::uint32_t index) {
  const Box& box = boxes_[index];
  const bool is_inside = tree_.has_root() && takes(tree_.places_[Tree::root], box);
  const std::uint32_t cell = is_inside ? tree_.home_below(Tree::root, box) : Tree::outside;
  tree_.pool_.prepare();
  tree_.add(cell, {box, slots_[index]});
}

template class CellFilling<2, float>;
template class CellFilling<3, float>;
template class CellFilling<2, double>;
template class CellFilling<3, double>;

}  // namespace graze::detail
