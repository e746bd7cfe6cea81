// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <graze/broad/index/box_cover.hpp>
#include <graze/broad/orthtree/fill.hpp>
#include <graze/broad/orthtree/place.hpp>
#include <graze/broad/orthtree/tree.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail {

template <Dim N, class T>
CellTree<N, T>::CellTree(const OrthtreeOptions& options) : options_(options), places_(children, CellPosition<N>{}) {
  if (options.capacity < 1) throw std::invalid_argument("Orthtree: capacity is 0; it must be at least 1");
  if (options.max_depth < 0 || options.max_depth > depth_limit) {
    throw std::invalid_argument("Orthtree: max_depth is " + std::to_string(options.max_depth) +
                                "; it must be from 0 to " + std::to_string(depth_limit));
  }
}

template <Dim N, class T>
void CellTree<N, T>::insert(std::uint32_t slot, const Box& box) {
  if (slot >= positions_.size()) positions_.resize(slot + std::size_t{1}, no_index);
  const std::uint32_t cell = cell_for(box);
  pool_.prepare();
  add(cell, {box, slot});
  ++size_;
  count_change();
}

template <Dim N, class T>
void CellTree<N, T>::fill(std::span<const Box> boxes, std::span<const std::uint32_t> slots) {
  CellFilling<N, T>(*this, boxes, slots).run();
}

template <Dim N, class T>
void CellTree<N, T>::update(std::uint32_t slot, const Box& box) {
  const std::uint32_t present = pool_.owner(positions_[slot]);
  if (!stays(present, box)) {
    move(slot, home_near(present, box), box);
  } else if (refit_is_due(present)) {
    move(slot, cell_for(box), box);
  } else {
    pool_.box(positions_[slot]) = box;
    grow_bounds(present, box);
  }
  count_change();
}

/// Looks up the cell last: it may have been split, or all cells rebuilt, in between.
template <Dim N, class T>
void CellTree<N, T>::move(std::uint32_t slot, std::uint32_t cell, const Box& box) {
  pool_.prepare();
  const std::uint32_t position = positions_[slot];
  const std::uint32_t from = pool_.owner(position);
  if (from == cell) {
    pool_.box(position) = box;
    grow_bounds(cell, box);
    return;
  }
  add(cell, {box, slot});
  const std::uint32_t new_position = positions_[slot];
  remove(position);
  positions_[slot] = new_position;  // remove wrote to it if the old entry was the last of its list
  merge_from(from);
}

template <Dim N, class T>
void CellTree<N, T>::erase(std::uint32_t slot) noexcept {
  const std::uint32_t cell = pool_.owner(positions_[slot]);
  remove(positions_[slot]);
  positions_[slot] = no_index;
  --size_;
  merge_from(cell);
  count_change();
}

template <Dim N, class T>
void CellTree<N, T>::clear() noexcept {
  cells_.clear();
  places_.assign(children, {});
  has_root_ = false;
  free_group_ = no_index;
  pool_.clear();
  positions_.clear();
  size_ = changes_since_refresh_ = changes_since_refit_ = 0;
  deepest_level_ = 0;
}

template <Dim N, class T>
std::size_t CellTree<N, T>::bytes() const {
  return cells_.bytes() + places_.capacity() * sizeof(CellPosition<N>) + pool_.bytes() +
         positions_.capacity() * sizeof(std::uint32_t);
}

// ---- The cell of a box

/// Whether a box in the cell may stay there after it moved.
template <Dim N, class T>
bool CellTree<N, T>::stays(std::uint32_t cell, const Box& box) const {
  if (cell == outside) return !(has_root() && takes(places_[root], box));
  const CellPosition<N>& place = places_[cell];
  if (!takes(place, box)) return false;
  return is_leaf(cell) || !fits(child_place(place, child_towards(place, center_of(box))), box);
}

/// The cell for a box. Splits full cells, and creates a new root if necessary.
template <Dim N, class T>
std::uint32_t CellTree<N, T>::cell_for(const Box& box) {
  const auto find = [&] {
    return has_root() && (takes(places_[root], box) || grow_root(box)) ? home_below(root, box) : outside;
  };
  const std::uint32_t cell = find();
  if (refit_is_due(cell)) {
    refit(cell == outside ? 2 : 1);  // if the world has outgrown its root before, leave space to grow
  } else if (root_is_too_large()) {
    refit(1.125);  // so that small movements do not make it grow again at once
  } else {
    return cell;
  }
  return find();
}

/// The same, starting at a cell that takes the box. Grows the bounds on the way, while the cells are cached;
/// recalculates the positions of children, which is cheaper than loading them.
template <Dim N, class T>
std::uint32_t CellTree<N, T>::home_below(std::uint32_t cell, const Box& box) {
  grow_bounds(cell, box);
  const Vec<N, double> center = center_of(box);
  const int deepest = places_[root].level + options_.max_depth;
  CellPosition<N> place = places_[cell];
  while (true) {
    const bool was_leaf = is_leaf(cell);
    if (was_leaf && (cells_.count(cell) < options_.capacity || place.level == deepest || !can_split(place))) {
      return cell;
    }
    const std::uint32_t child = child_towards(place, center);
    place = child_place(place, child);
    if (!fits(place, box)) return cell;
    if (was_leaf) split(cell);
    cell = cells_.first_child(cell) + child;
    cells_.grow(cell, box);
  }
}

/// The same for a box that leaves a cell, often to a neighbour.
template <Dim N, class T>
std::uint32_t CellTree<N, T>::home_near(std::uint32_t cell, const Box& box) {
  while (cell != no_index && cell != outside && !takes(places_[cell], box)) cell = places_[cell].parent;
  return cell == no_index || cell == outside ? cell_for(box) : home_below(cell, box);
}

// ---- Adding and removing entries

template <Dim N, class T>
void CellTree<N, T>::add(std::uint32_t cell, const Entry<N, T>& entry) {
  EntryList list = cells_.entries(cell);
  positions_[entry.slot] = pool_.add(list, cell, entry);
  cells_.set_entries(cell, list);
}

template <Dim N, class T>
void CellTree<N, T>::remove(std::uint32_t position) noexcept {
  const std::uint32_t cell = pool_.owner(position);
  EntryList list = cells_.entries(cell);
  positions_[pool_.remove(list, position)] = position;
  cells_.set_entries(cell, list);
  if (list.count == 0 && is_leaf(cell)) cells_.set_bounds(cell, Box::nothing());
}

/// Ancestors whose bounds already contain the box end the loop.
template <Dim N, class T>
void CellTree<N, T>::grow_bounds(std::uint32_t cell, const Box& box) {
  for (; cell != no_index && !covers(cells_.bounds(cell), box); cell = places_[cell].parent) {
    cells_.grow(cell, box);
  }
}

template <Dim N, class T>
void CellTree<N, T>::count_change() {
  ++changes_since_refit_;
  if (size_ == 0) {
    clear();
  } else if (++changes_since_refresh_ > size_) {
    changes_since_refresh_ = 0;
    deepest_level_ = has_root() ? places_[root].level : 0;
    if (has_root()) refresh(root);
  }
}

/// Recalculates the bounds of a cell and all below it. The recursion is at most as deep as the tree.
template <Dim N, class T>
Aabb<N, T> CellTree<N, T>::refresh(std::uint32_t cell) {  // NOLINT(misc-no-recursion)
  Box bounds = Box::nothing();
  deepest_level_ = std::max(deepest_level_, places_[cell].level);
  pool_.for_each(cells_.entries(cell), [&bounds](const Entry<N, T>& entry) { grow_at_once(bounds, entry.box); });
  if (!is_leaf(cell)) {
    for (std::uint32_t k = 0; k < children; ++k) grow_at_once(bounds, refresh(cells_.first_child(cell) + k));
  }
  cells_.set_bounds(cell, bounds);
  return bounds;
}

// ---- Splitting and merging

/// Whether a leaf may be split apart from the depth limit.
template <Dim N, class T>
bool CellTree<N, T>::can_split(const CellPosition<N>& place) const {
  return place.half > 0 && cells_.size() < no_index - children;
}

/// Reserves memory so that adding blocks moves nothing.
template <Dim N, class T>
void CellTree<N, T>::reserve_groups(std::size_t count) {
  cells_.reserve(count);
  places_.reserve(count * children);
}

template <Dim N, class T>
std::uint32_t CellTree<N, T>::new_group(std::uint32_t parent) {
  std::uint32_t first = free_group_;
  if (first == no_index) {
    places_.resize(cells_.size() + children);
    first = cells_.add_group();
  } else {
    free_group_ = cells_.first_child(first);
    cells_.reset(first);
  }
  for (std::uint32_t k = 0; k < children; ++k) {
    places_[first + k] = child_place(places_[parent], k);
    places_[first + k].parent = parent;
  }
  return first;
}

/// Moves each box to the child that takes it; those too large for any child stay.
template <Dim N, class T>
void CellTree<N, T>::split(std::uint32_t cell) {
  pool_.prepare(pool_.blocks_of(cells_.count(cell)) + children);
  const std::uint32_t first = new_group(cell);
  const CellPosition<N> place = places_[cell];
  EntryList held = cells_.entries(cell);
  cells_.set_entries(cell, {});
  cells_.set_first_child(cell, first);
  deepest_level_ = std::max(deepest_level_, place.level + 1);
  pool_.for_each(held, [&](const Entry<N, T>& entry) {
    const std::uint32_t child = first + child_towards(place, center_of(entry.box));
    const std::uint32_t home = fits(places_[child], entry.box) ? child : cell;
    cells_.grow(home, entry.box);
    add(home, entry);
  });
  pool_.release(held);
}

template <Dim N, class T>
void CellTree<N, T>::merge_from(std::uint32_t cell) noexcept {
  merge_upwards(is_leaf(cell) ? places_[cell].parent : cell);
}

/// Merges the children of a cell into it, then those of its parent and so on, as long as they leave it at most half
/// full, so that a box that comes and goes does not split and merge each time. If memory is lacking, the children are
/// kept.
template <Dim N, class T>
void CellTree<N, T>::merge_upwards(std::uint32_t cell) noexcept {
  for (; cell != no_index; cell = places_[cell].parent) {
    const std::uint32_t first = cells_.first_child(cell);
    std::size_t total = cells_.count(cell);
    for (std::uint32_t k = 0; k < children; ++k) {
      if (!is_leaf(first + k)) return;
      total += cells_.count(first + k);
    }
    if (total > options_.capacity / 2) return;
    try {
      pool_.prepare(pool_.blocks_of(total) + 1);
    } catch (const std::bad_alloc&) {
      return;
    }
    for (std::uint32_t k = 0; k < children; ++k) {
      EntryList held = cells_.entries(first + k);
      cells_.set_entries(first + k, {});
      pool_.for_each(held, [&](const Entry<N, T>& entry) { add(cell, entry); });
      pool_.release(held);
    }
    cells_.set_first_child(cell, no_index);
    cells_.set_first_child(first, std::exchange(free_group_, first));
    refresh(cell);
  }
}

// ---- The root

template <Dim N, class T>
void CellTree<N, T>::create_root(const CellPosition<N>& place) {
  places_[root] = place;
  code_scale_ = CodeScale<N, T>(place);
  has_root_ = true;
}

/// Doubles the root until a box fits, if the cells below stay within the depth limit.
template <Dim N, class T>
bool CellTree<N, T>::grow_root(const Box& box) {
  CellPosition<N> place = places_[root];
  if (!is_valid(box) || !(place.half > 0)) return false;
  const Vec<N, double> target = center_of(box);
  while (!takes(place, box)) {
    place = doubled_place(place, target);
    if (deepest_level_ - place.level > options_.max_depth) return false;
  }
  while (!takes(places_[root], box)) double_root(target);
  return true;
}

/// The root becomes a child of a new root, which takes its index.
template <Dim N, class T>
void CellTree<N, T>::double_root(const Vec<N, double>& target) {
  const CellPosition<N> old_place = places_[root];
  const CellPosition<N> new_place = doubled_place(old_place, target);
  places_[root] = new_place;
  code_scale_ = CodeScale<N, T>(new_place);
  const std::uint32_t first = new_group(root);
  const std::uint32_t child = first + child_towards(new_place, old_place.center);
  places_[child] = old_place;
  places_[child].parent = root;
  const Cell<N, T> former = cells_[root];
  cells_.set(child, former);
  cells_.set(root, {former.bounds, {}, first});
  pool_.set_owner(former.entries, child);
  if (is_leaf(child)) return;
  for (std::uint32_t k = 0; k < children; ++k) places_[former.first_child + k].parent = child;
}

/// Whether a new root may pay: many boxes are outside, or in a cell that cannot be split, and enough have been added or
/// moved since.
template <Dim N, class T>
bool CellTree<N, T>::refit_is_due(std::uint32_t cell) const {
  if (cell != outside && depth(cell) < options_.max_depth) return false;
  return changes_since_refit_ >= size_ / 2 && cells_.count(cell) >= options_.capacity + size_ / 32;
}

/// Whether two thirds of the root's size would suffice in every direction: levels that do not separate boxes cost every
/// query.
template <Dim N, class T>
bool CellTree<N, T>::root_is_too_large() const {
  if (!has_root() || changes_since_refit_ < size_ / 2) return false;
  const Box bounds = cells_.bounds(root);
  for (Dim i = 0; i < N; ++i) {
    const double extent = static_cast<double>(bounds.max[i]) - static_cast<double>(bounds.min[i]);
    if (!(3 * extent < 4 * places_[root].half)) return false;
  }
  return true;
}

/// Rebuilds all cells below a new root if it is better. If it follows another root, it is larger than necessary by a
/// factor.
template <Dim N, class T>
void CellTree<N, T>::refit(double margin) {
  std::vector<Box> finite;
  for (const std::uint32_t position : positions_) {
    if (position != no_index && is_valid(pool_.box(position))) finite.push_back(pool_.box(position));
  }
  changes_since_refit_ = 0;
  if (finite.empty()) return;
  CellPosition<N> place = place_of_root(finite, options_);
  if (has_root()) place.half *= margin;
  if (has_root() && is_as_good(places_[root], place)) return;
  CellTree fresh(options_);
  fresh.positions_.resize(positions_.size(), no_index);
  fresh.create_root(place);
  for (const std::uint32_t position : positions_) {
    if (position == no_index) continue;
    const Entry<N, T> entry{pool_.box(position), pool_.slot(position)};
    fresh.add(takes(place, entry.box) ? fresh.home_below(root, entry.box) : outside, entry);
  }
  fresh.size_ = size_;
  *this = std::move(fresh);
}

template class CellTree<2, float>;
template class CellTree<3, float>;
template class CellTree<2, double>;
template class CellTree<3, double>;

}  // namespace graze::detail
