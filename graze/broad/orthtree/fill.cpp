// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <graze/broad/index/box_cover.hpp>
#include <graze/broad/memory/buffer.hpp>
#include <graze/broad/memory/prefetch.hpp>
#include <graze/broad/orthtree/cell_kernels.hpp>
#include <graze/broad/orthtree/code.hpp>
#include <graze/broad/orthtree/fill.hpp>
#include <graze/broad/orthtree/place.hpp>
#include <graze/broad/orthtree/tree.hpp>

namespace graze::detail {
namespace {

/// A stable counting sort by some digits of the code, the lower half of the digits first (Knuth, "The Art of Computer
/// Programming", volume 3, section 5.2.5).
void sort_by_digits(std::span<CodedBox> boxes, std::span<CodedBox> spare, unsigned lowest, unsigned bits) {
  constexpr unsigned most_bits = 20;
  std::array<std::array<std::uint32_t, 1U << most_bits / 2>, 2> places;  // NOLINT(*-member-init): as far as needed
  const unsigned half = bits / 2;
  const unsigned shifts[] = {lowest, lowest + half};
  const std::uint32_t masks[] = {(1U << half) - 1U, (1U << (bits - half)) - 1U};
  for (const unsigned pass : {0U, 1U}) std::fill_n(places[pass].begin(), masks[pass] + 1, 0U);
  for (const CodedBox& box : boxes) {
    ++places[0][box.code >> shifts[0] & masks[0]];
    ++places[1][box.code >> shifts[1] & masks[1]];
  }
  for (const unsigned pass : {0U, 1U}) {
    std::uint32_t first = 0;
    for (std::uint32_t digit = 0; digit <= masks[pass]; ++digit) first += std::exchange(places[pass][digit], first);
    for (const CodedBox& box : boxes) spare[places[pass][box.code >> shifts[pass] & masks[pass]]++] = box;
    std::swap(boxes, spare);
  }
}

/// The number of levels to sort by at a time: as many as the boxes will fill, and one more.
template <Dim N>
int levels_for(std::size_t count, std::size_t capacity) {
  constexpr int most = 20 / N;
  int levels = 2;
  while (levels < most && count >> static_cast<unsigned>(N * (levels - 1)) > capacity) ++levels;
  return levels;
}

/// The finite boxes, or an evenly spaced sample of them.
template <Dim N, class T>
std::vector<Aabb<N, T>> sample_of(std::span<const Aabb<N, T>> boxes) {
  constexpr std::size_t enough = 512;
  std::vector<Aabb<N, T>> sample;
  const std::size_t step = std::max<std::size_t>(1, boxes.size() / enough);
  for (std::size_t k = 0; k < boxes.size(); k += step) {
    if (is_finite_box(boxes[k])) sample.push_back(boxes[k]);
  }
  return sample;
}

/// place_of_root, estimated from a sample of the boxes and the bounds of all.
template <Dim N, class T>
CellPosition<N> place_of_root_for(std::span<const Aabb<N, T>> boxes, const OrthtreeOptions& options) {
  std::vector<Aabb<N, T>> sample = sample_of(boxes);
  if (sample.empty()) return {};
  Aabb<N, T> all = cell_kernels<N, T>().bounds(boxes.data(), boxes.size());
  if (is_nothing(all)) {
    for (const Aabb<N, T>& box : boxes) grow_at_once(all, is_finite_box(box) ? box : sample[0]);
  }
  return place_of_root(sample, all, boxes.size(), options);
}

/// Boxes up to this many bytes stay in the cache and need no prefetch.
constexpr std::size_t in_cache = std::size_t{1} << 18U;

}  // namespace

template <Dim N, class T>
void CellFilling<N, T>::run() {
  if (boxes_.empty()) return;
  std::uint32_t last = 0;
  std::uint32_t breaks = 0;
  for (std::size_t k = 0; k < slots_.size(); ++k) {
    last = std::max(last, slots_[k]);
    breaks |= slots_[k] ^ (slots_[0] + static_cast<std::uint32_t>(k));
  }
  slots_are_row_ = breaks == 0;
  asked_until_ = boxes_.size() * sizeof(Box) > in_cache ? boxes_.size() : 0;
  tree_.positions_.resize(last + std::size_t{1}, no_index);
  tree_.pool_.reserve(boxes_.size() / 5 + 8);
  tree_.reserve_groups(boxes_.size() / tree_.options_.capacity + 1);
  tree_.size_ = boxes_.size();
  if (boxes_.size() > tree_.options_.capacity) {
    create_root();
    code_boxes();
    fill_cell(Tree::root, {0, boxes_.size(), 0, 0});
  } else {
    for (std::uint32_t index = 0; index < boxes_.size(); ++index) left_over_.push_back(index);
  }
  for (const std::uint32_t index : left_over_) add_alone(index);
}

template <Dim N, class T>
void CellFilling<N, T>::create_root() {
  tree_.create_root(place_of_root_for(boxes_, tree_.options_));
}

template <Dim N, class T>
void CellFilling<N, T>::code_boxes() {
  sorted_.resize(boxes_.size());
  spare_.resize(boxes_.size());
  cell_kernels<N, T>().code(boxes_.data(), boxes_.size(), CodeScale<N, T>(tree_.places_[Tree::root]), sorted_.data());
}

/// Whether the boxes remaining for a cell stay there: because they are few, or because no child takes any. Above the
/// levels where leaves are expected, the boxes are not tested.
template <Dim N, class T>
bool CellFilling<N, T>::is_leaf(std::uint32_t cell, const Range& range) const {
  const CellPosition<N>& place = tree_.places_[cell];
  const int deepest = std::min(tree_.options_.max_depth, code_levels<N>);
  if (range.count() <= tree_.options_.capacity || range.depth >= deepest || !tree_.can_split(place)) return true;
  if (boxes_.size() >> static_cast<unsigned>(N * range.depth) > tree_.options_.capacity) return false;
  for (std::size_t k = range.first; k < range.last; ++k) {
    const Box& box = boxes_[sorted_[k].index];
    if (fits(child_place(place, child_towards(place, center_of(box))), box)) return false;
  }
  return true;
}

/// The end of the range of each child. Short ranges are counted, because a search would mispredict.
template <Dim N, class T>
auto CellFilling<N, T>::ends_in(const Range& range) const -> std::array<std::size_t, Tree::children> {
  constexpr unsigned bits = 64U / Tree::children;  // per count
  constexpr std::size_t few = 128;
  const auto shift = static_cast<unsigned>(N * (code_levels<N> - 1 - range.depth));
  const auto child_of = [shift](const CodedBox& box) { return box.code >> shift & (Tree::children - 1); };
  std::array<std::size_t, Tree::children> ends;  // NOLINT(*-member-init)
  if (range.count() <= few) {
    std::uint64_t counts = 0;
    for (std::size_t k = range.first; k < range.last; ++k) counts += std::uint64_t{1} << bits * child_of(sorted_[k]);
    std::size_t end = range.first;
    for (std::size_t& one : ends) {
      end += counts & ((1U << bits) - 1U);
      counts >>= bits;
      one = end;
    }
    return ends;
  }
  const CodedBox* first = sorted_.data() + range.first;
  for (std::uint32_t child = 0; child < Tree::children; ++child) {
    first = std::partition_point(first, sorted_.data() + range.last,
                                 [&](const CodedBox& box) { return child_of(box) <= child; });
    ends[child] = static_cast<std::size_t>(first - sorted_.data());
  }
  return ends;
}

/// Returns the bounds. Recurses at most code_levels deep.
template <Dim N, class T>
Aabb<N, T> CellFilling<N, T>::fill_cell(std::uint32_t cell, Range range) {  // NOLINT(misc-no-recursion)
  if (is_leaf(cell, range)) return fill_leaf(cell, range);
  if (range.depth == range.sorted_depth) {
    const int levels = levels_for<N>(range.count(), tree_.options_.capacity);
    range.sorted_depth = std::min(range.depth + levels, code_levels<N>);
    const auto lowest = static_cast<unsigned>(N * (code_levels<N> - range.sorted_depth));
    sort_by_digits({sorted_.data() + range.first, range.count()}, {spare_.data(), range.count()}, lowest,
                   static_cast<unsigned>(N * (range.sorted_depth - range.depth)));
  }
  const std::uint32_t first_child = tree_.new_group(cell);
  tree_.cells_.set_first_child(cell, first_child);
  tree_.deepest_level_ = std::max(tree_.deepest_level_, tree_.places_[first_child].level);
  Box bounds = Box::nothing();
  Range part{range.first, range.first, range.depth + 1, range.sorted_depth};
  const auto ends = ends_in(range);
  for (std::uint32_t child = 0; child < Tree::children; ++child) {
    part.first = part.last;
    part.last = ends[child];
    if (part.count() > 0) grow_at_once(bounds, fill_cell(first_child + child, part));
  }
  tree_.cells_.set_bounds(cell, bounds);
  return bounds;
}

/// Prefetches what the boxes after this position of the order need: they are scattered in memory.
template <Dim N, class T>
[[gnu::always_inline]] inline void CellFilling<N, T>::ask_ahead(std::size_t place) const {
  constexpr std::size_t ahead = 12;
  if (place + 2 * ahead >= asked_until_) return;
  const std::uint32_t far = sorted_[place + 2 * ahead].index;
  prefetch_first<1>(&boxes_[far]);
  if (!slots_are_row_) prefetch_first<1>(&slots_[far]);
  prefetch_to_write(&tree_.positions_[slot_of(sorted_[place + ahead].index)]);
}

/// Fills a leaf with all boxes of a range, which usually fit its loose bounds; codes only describe centers, and may
/// round. Returns the bounds of all boxes. If they do not fit, the leaf stays empty.
template <Dim N, class T>
Aabb<N, T> CellFilling<N, T>::fill_at_once(std::uint32_t cell, const Range& range) {
  EntryList list;
  Box bounds = Box::nothing();
  std::uint32_t* const positions = tree_.positions_.data();
  for (std::size_t first = range.first; first < range.last; first += tree_.pool_.block_size) {
    const std::size_t count = std::min<std::size_t>(range.last - first, tree_.pool_.block_size);
    const std::uint32_t position = tree_.pool_.add_block(list, cell, static_cast<std::uint32_t>(count));
    auto& page = tree_.pool_.page(position);
    for (std::uint32_t k = 0; k < count; ++k) {
      ask_ahead(first + k);
      const std::uint32_t index = sorted_[first + k].index;
      const std::uint32_t slot = slot_of(index);
      page.boxes[k] = boxes_[index];
      page.slots[k] = slot;
      positions[slot] = position + k;
    }
    for (std::uint32_t k = 0; k < count; ++k) grow_at_once(bounds, page.boxes[k]);
  }
  if (!fits(tree_.places_[cell], bounds)) tree_.pool_.release(list);
  tree_.cells_.set_entries(cell, list);
  return bounds;
}

template <Dim N, class T>
Aabb<N, T> CellFilling<N, T>::fill_leaf(std::uint32_t cell, const Range& range) {
  if (range.count() <= tree_.options_.capacity) {
    const Box all = fill_at_once(cell, range);
    tree_.cells_.set_bounds(cell, all);
    if (tree_.cells_.count(cell) > 0) return all;
  }
  const CellPosition<N> place = tree_.places_[cell];
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
    tree_.positions_[slot_of(index)] = tree_.pool_.add(list, cell, {box, slot_of(index)});
  }
  tree_.cells_.set_entries(cell, list);
  tree_.cells_.set_bounds(cell, bounds);
  return bounds;
}

template <Dim N, class T>
void CellFilling<N, T>::add_alone(std::uint32_t index) {
  const Box& box = boxes_[index];
  const bool is_inside = tree_.has_root() && takes(tree_.places_[Tree::root], box);
  const std::uint32_t cell = is_inside ? tree_.home_below(Tree::root, box) : Tree::outside;
  tree_.pool_.prepare();
  tree_.add(cell, {box, slot_of(index)});
}

template class CellFilling<2, float>;
template class CellFilling<3, float>;
template class CellFilling<2, double>;
template class CellFilling<3, double>;

}  // namespace graze::detail
