// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <graze/broad/grid/cells.hpp>
#include <graze/broad/index/box_cover.hpp>

namespace graze::detail {
namespace {

/// The minimum average number of boxes in an occupied cell: cells of lower levels are too small, of higher levels too
/// large. One level changes the number by a factor of up to eight.
constexpr std::size_t boxes_per_cell = 2;
constexpr std::size_t too_many = 16;

/// With fewer boxes, any cell size is fine.
constexpr std::size_t worth_a_review = 64;

/// If the base level was found to be best, the interval until the next review grows up to this factor.
constexpr std::size_t most_patience = 64;

/// Reserves space for `more` elements; at least doubles the capacity if it is insufficient.
template <class Value>
void reserve_more(std::vector<Value>& values, std::size_t more) {
  if (values.size() + more > values.capacity()) values.reserve(2 * values.size() + more);
}

}  // namespace

template <Dim N, class T>
GridCells<N, T>::GridCells(const GridOptions& options) : options_(options), base_(lowest_grid_level), cells_(1) {
  const double least = options.smallest_cell;
  if (!(least >= 0 && least <= grid_size(highest_grid_level))) {
    throw std::invalid_argument("Grid: smallest_cell is " + std::to_string(least) + "; it must be from 0 to 2^1000");
  }
  base_ = std::max(base_, grid_level_of(least));
}

template <Dim N, class T>
void GridCells<N, T>::insert(std::uint32_t slot, const Box& box) {
  review();
  if (slot >= positions_.size()) positions_.resize(slot + std::size_t{1}, no_index);
  pool_.prepare();
  const std::uint32_t cell = cell_for(box);
  add(cell, {box, slot});
  ++size_;
}

template <Dim N, class T>
void GridCells<N, T>::update(std::uint32_t slot, const Box& box) {
  review();
  const std::uint32_t from = pool_.owner(positions_[slot]);
  const bool stays = has_grid_place(box) ? is_at(from, place_of(box)) : from == outside;
  if (stays) {
    pool_.box(positions_[slot]) = box;
    grow_bounds(from, box);
  } else {
    pool_.prepare();
    const std::uint32_t cell = cell_for(box);
    const std::uint32_t position = positions_[slot];
    add(cell, {box, slot});
    const std::uint32_t new_position = positions_[slot];
    remove(position);
    positions_[slot] = new_position;  // remove wrote to it if the old entry was the last of its list
  }
}

template <Dim N, class T>
void GridCells<N, T>::erase(std::uint32_t slot) noexcept {
  remove(positions_[slot]);
  positions_[slot] = no_index;
  if (--size_ == 0) clear();
}

template <Dim N, class T>
void GridCells<N, T>::clear() noexcept {
  cells_.resize(1);
  cells_[outside] = {};
  groups_.clear();
  free_group_ = no_index;
  free_groups_ = 0;
  table_.clear();
  pool_.clear();
  positions_.clear();
  size_ = filled_ = changes_since_refresh_ = changes_since_choice_ = 0;
  patience_ = 1;
}

template <Dim N, class T>
std::size_t GridCells<N, T>::bytes() const {
  return cells_.capacity() * sizeof(Cell<N, T>) + groups_.capacity() * sizeof(GridGroup<N>) + table_.bytes() +
         pool_.bytes() + positions_.capacity() * sizeof(std::uint32_t);
}

// ---- The cell of a box

template <Dim N, class T>
GridPlace<N> GridCells<N, T>::place(std::uint32_t cell) const {
  const std::uint32_t group = group_of(cell);
  const std::uint32_t child = cell - first_of(group);
  return group == 0 ? place_at_origin<N>(top_, child) : child_of(groups_[group].place, child);
}

template <Dim N, class T>
GridPlace<N> GridCells<N, T>::place_of(const Box& box) const {
  return grid_place(box, std::max(base_, own_grid_level(box)));
}

template <Dim N, class T>
bool GridCells<N, T>::is_at(std::uint32_t cell, const GridPlace<N>& where) const {
  return cell != outside && place(cell) == where;
}

/// The cell for a box, created if necessary. Raises the level of the roots until they contain it.
template <Dim N, class T>
std::uint32_t GridCells<N, T>::cell_for(const Box& box) {
  if (!has_grid_place(box)) return outside;
  const GridPlace<N> where = place_of(box);
  const int needed = level_at_origin(where);
  if (root_count() == 0) {
    groups_.reserve(1);
    cells_.resize(root + children);
    groups_.resize(1);
    top_ = needed;
  }
  while (top_ < needed) raise_roots();
  if (where.level == top_) return root + child_number(where);
  const std::uint32_t group = table_.find(parent_of(where), groups_);
  return group == no_index ? open_cell(where) : first_of(group) + child_number(where);
}

/// Creates the missing cells between a root and a cell.
template <Dim N, class T>
std::uint32_t GridCells<N, T>::open_cell(const GridPlace<N>& where) {
  prepare_groups(static_cast<std::size_t>(top_ - where.level));
  std::uint32_t cell = root + child_number(place_above(where, top_));
  for (int level = top_; level > where.level; --level) {
    const std::uint32_t first =
        cells_[cell].first_child != no_index ? cells_[cell].first_child : new_group(cell, place_above(where, level));
    cell = first + child_number(place_above(where, level - 1));
  }
  return cell;
}

/// Reserves memory so that this many groups can be created without failure.
template <Dim N, class T>
void GridCells<N, T>::prepare_groups(std::size_t count) {
  table_.prepare(count);
  if (count <= free_groups_) return;
  reserve_more(cells_, (count - free_groups_) * children);
  reserve_more(groups_, count - free_groups_);
}

template <Dim N, class T>
std::uint32_t GridCells<N, T>::new_group(std::uint32_t parent, const GridPlace<N>& where) noexcept {
  std::uint32_t first = free_group_;
  if (first == no_index) {
    first = static_cast<std::uint32_t>(cells_.size());
    cells_.resize(first + children);
    groups_.emplace_back();
  } else {
    free_group_ = cells_[first].first_child;
    --free_groups_;
    cells_[first].first_child = no_index;
  }
  groups_[group_of(first)] = {where, parent};
  table_.add(where, group_of(first));
  cells_[parent].first_child = first;
  return first;
}

/// Every non-empty root becomes a child of a new root, which takes its index.
template <Dim N, class T>
void GridCells<N, T>::raise_roots() {
  prepare_groups(children);
  ++top_;
  for (std::uint32_t child = 0; child < children; ++child) {
    const std::uint32_t index = root + child;
    if (is_unused(index)) continue;
    const Cell<N, T> former = std::exchange(cells_[index], Cell<N, T>{cells_[index].bounds, {}, no_index});
    const std::uint32_t below = new_group(index, place_at_origin<N>(top_, child)) + child;
    cells_[below] = former;
    pool_.set_owner(former.entries, below);
    if (former.first_child != no_index) groups_[group_of(former.first_child)].parent = below;
  }
}

// ---- Adding and removing entries

/// A free block must be available.
template <Dim N, class T>
void GridCells<N, T>::add(std::uint32_t cell, const Entry<N, T>& entry) noexcept {
  EntryList& list = cells_[cell].entries;
  positions_[entry.slot] = pool_.add(list, cell, entry);
  if (cell == outside) return;
  if (list.count == 1) ++filled_;
  grow_bounds(cell, entry.box);
}

template <Dim N, class T>
void GridCells<N, T>::remove(std::uint32_t position) noexcept {
  const std::uint32_t cell = pool_.owner(position);
  EntryList& list = cells_[cell].entries;
  positions_[pool_.remove(list, position)] = position;
  if (list.count > 0 || cell == outside) return;
  --filled_;
  prune_from(cell);
}

/// Frees groups without occupied cells, from this cell's group upwards.
template <Dim N, class T>
void GridCells<N, T>::prune_from(std::uint32_t cell) noexcept {
  while (is_unused(cell)) {
    cells_[cell].bounds = Box::nothing();
    const std::uint32_t group = group_of(cell);
    if (group == 0) return;
    const std::uint32_t first = first_of(group);
    for (std::uint32_t k = 0; k < children; ++k) {
      if (!is_unused(first + k)) return;
    }
    table_.remove(groups_[group].place, group);
    cells_[first].first_child = std::exchange(free_group_, first);
    ++free_groups_;
    cell = groups_[group].parent;
    cells_[cell].first_child = no_index;
  }
}

template <Dim N, class T>
bool GridCells<N, T>::is_unused(std::uint32_t cell) const {
  return cells_[cell].entries.count == 0 && cells_[cell].first_child == no_index;
}

/// Ancestors whose bounds already contain the box end the loop.
template <Dim N, class T>
void GridCells<N, T>::grow_bounds(std::uint32_t cell, const Box& box) noexcept {
  if (cell == outside) return;
  for (; cell != no_index && !covers(cells_[cell].bounds, box); cell = groups_[group_of(cell)].parent) {
    grow_at_once(cells_[cell].bounds, box);
  }
}

/// Recalculates the bounds of a cell and all below it. The recursion is at most as deep as there are levels.
template <Dim N, class T>
Aabb<N, T> GridCells<N, T>::refresh(std::uint32_t cell) noexcept {  // NOLINT(misc-no-recursion)
  Box bounds = Box::nothing();
  const std::uint32_t first = cells_[cell].first_child;
  pool_.for_each(cells_[cell].entries, [&bounds](const Entry<N, T>& entry) { grow_at_once(bounds, entry.box); });
  for (std::uint32_t k = 0; k < children && first != no_index; ++k) grow_at_once(bounds, refresh(first + k));
  return cells_[cell].bounds = bounds;
}

// ---- The base level

/// Each time the base is found to be best, the interval until the next review grows.
template <Dim N, class T>
void GridCells<N, T>::review() {
  ++changes_since_refresh_;
  ++changes_since_choice_;
  if (changes_since_choice_ > worth_a_review && changes_since_choice_ / patience_ > size_ / 2) {
    changes_since_choice_ = 0;
    if (base_is_due()) {
      const int base = better_base();
      patience_ = base == base_ ? std::min(2 * patience_, most_patience) : 1;
      if (base != base_) rebuild(base);
    }
  }
  if (changes_since_refresh_ <= std::max(size_, worth_a_review)) return;
  changes_since_refresh_ = 0;
  for (std::uint32_t k = 0; k < root_count(); ++k) refresh(root + k);
}

template <Dim N, class T>
bool GridCells<N, T>::base_is_due() const {
  const std::size_t boxes = size_ - cells_[outside].entries.count;
  return options_.smallest_cell == 0 && boxes >= worth_a_review &&
         (boxes > too_many * filled_ || boxes < boxes_per_cell * filled_);
}

/// The lowest level that fills its cells well: the boxes that are no larger must be a substantial part of all.
template <Dim N, class T>
int GridCells<N, T>::better_base() const {
  std::vector<std::pair<int, std::uint32_t>> boxes;  // own levels and positions
  int low = highest_grid_level;
  int high = lowest_grid_level;
  for (const std::uint32_t position : positions_) {
    if (position == no_index || pool_.owner(position) == outside) continue;
    const int own = own_grid_level(pool_.box(position));
    boxes.emplace_back(own, position);
    low = std::min(low, own);
    high = std::max(high, own);
  }
  high = std::min(high + grid_digits + 1, highest_grid_level);  // at that level, all are in the cells around the origin
  std::vector<bool> is_met;
  const auto is_full = [&](int level) {
    std::size_t present = 0;
    std::size_t cells = 0;
    is_met.assign(16 * boxes.size(), false);  // sparse, so that few cells collide
    for (const auto& [own, position] : boxes) {
      if (own > level) continue;
      const std::uint64_t hash = GridTable<N>::hash_of(grid_place(pool_.box(position), level));
      const auto cell = static_cast<std::size_t>(hash * is_met.size() >> 32U);
      cells += is_met[cell] ? 0U : 1U;
      is_met[cell] = true;
      ++present;
    }
    return 16 * present >= boxes.size() && cells * boxes_per_cell <= present;
  };
  while (low < high) {
    const int middle = low + (high - low) / 2;
    if (is_full(middle)) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return low;
}

/// Moves all boxes to new cells, with roots as low as possible.
template <Dim N, class T>
void GridCells<N, T>::rebuild(int base) {
  GridCells fresh(options_);
  fresh.base_ = base;
  fresh.positions_.resize(positions_.size(), no_index);
  for (const std::uint32_t position : positions_) {
    if (position == no_index) continue;
    const Entry<N, T> entry{pool_.box(position), pool_.slot(position)};
    fresh.pool_.prepare();
    fresh.add(fresh.cell_for(entry.box), entry);
  }
  fresh.size_ = size_;
  *this = std::move(fresh);
}

template class GridCells<2, float>;
template class GridCells<3, float>;
template class GridCells<2, double>;
template class GridCells<3, double>;

}  // namespace graze::detail
