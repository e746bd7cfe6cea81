// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <graze/broad/grid/table.hpp>

namespace graze::detail {

template <Dim N>
void GridTable<N>::prepare(std::size_t more) {
  std::size_t size = std::max<std::size_t>(slots_.size(), 16);
  while (size < 2 * (count_ + more)) size *= 2;
  if (size == slots_.size()) return;
  const std::vector<Slot> former = std::exchange(slots_, std::vector<Slot>(size));
  for (const Slot& slot : former) {
    if (slot.group == no_index) continue;
    std::size_t i = slot.hash & mask();
    while (slots_[i].group != no_index) i = (i + 1) & mask();
    slots_[i] = slot;
  }
}

template <Dim N>
void GridTable<N>::add(const GridPlace<N>& place, std::uint32_t group) noexcept {
  const std::uint32_t hash = hash_of(place);
  std::size_t i = hash & mask();
  while (slots_[i].group != no_index) i = (i + 1) & mask();
  slots_[i] = {hash, group};
  ++count_;
}

/// Entries of the same run that would no longer be found move up to fill the gap.
template <Dim N>
void GridTable<N>::remove(const GridPlace<N>& place, std::uint32_t group) noexcept {
  std::size_t gap = hash_of(place) & mask();
  while (slots_[gap].group != group) gap = (gap + 1) & mask();
  for (std::size_t i = (gap + 1) & mask(); slots_[i].group != no_index; i = (i + 1) & mask()) {
    const std::size_t way_from_home = (i - slots_[i].hash) & mask();
    const std::size_t way_from_gap = (i - gap) & mask();
    if (way_from_home < way_from_gap) continue;
    slots_[gap] = slots_[i];
    gap = i;
  }
  slots_[gap] = {};
  --count_;
}

template <Dim N>
void GridTable<N>::clear() noexcept {
  std::fill(slots_.begin(), slots_.end(), Slot{});
  count_ = 0;
}

template class GridTable<2>;
template class GridTable<3>;

}  // namespace graze::detail
