// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include <graze/broad/memory/prefetch.hpp>
#include <graze/broad/pairs/cell_grid.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// Centers that can be processed as a sequence: are_all(count) tells whether the indices are all there are, in order;
/// bounds() and find_cells(grid, cells) then process all.
template <class Center>
concept InARow = requires(const Center& center) {
  center.are_all(std::size_t{});
};

template <Dim N, class T, class Index, class Center>
Aabb<N, T> bounds_of_cluster(const Index* order, std::size_t count, const Center& center) {
  if constexpr (InARow<Center>) {
    if (center.are_all(count)) return center.bounds();
  }
  Aabb<N, T> bounds = Aabb<N, T>::nothing();
  for (std::size_t k = 0; k < count; ++k) {
    center.prefetch(order[std::min(k + prefetch_distance, count - 1)]);
    bounds.grow(center(order[k]));
  }
  return bounds;
}

template <Dim N, class T, class Index, class Center>
void find_cells_of_cluster(const Index* order, std::size_t count, const Center& center, const CellGrid<N, T>& grid,
                           std::uint16_t* cells) {
  if constexpr (InARow<Center>) {
    if (center.are_all(count)) {
      center.find_cells(grid, cells);
      return;
    }
  }
  for (std::size_t k = 0; k < count; ++k) {
    center.prefetch(order[std::min(k + prefetch_distance, count - 1)]);
    cells[k] = cell_of(center(order[k]), grid);
  }
}

/// Sorts indices of centers so that each consecutive piece of at most `small` is spatially compact, as far as the
/// centers differ: by a grid over their bounds, then each overfull cell by a grid of its own. center(index) returns a
/// finite center, center.prefetch(index) prefetches it; `cells` and `spare` are memory for as many elements as there
/// are indices. If almost all centers are in one cell of a grid, a sort along the widest axis replaces further grids,
/// so the time is O(n log n) for any centers.
template <Dim N, class T, class Index, class Center>
// NOLINTNEXTLINE(readability-function-size): with the memory to sort in
void sort_cluster(Index* order, std::size_t count, std::size_t small, const Center& center, std::uint16_t* cells,
                  Index* spare) {
  if (count <= small) return;
  const auto bounds = bounds_of_cluster<N, T>(order, count, center);
  constexpr std::size_t most_cells = 512;
  const CellGrid<N, T> grid = grid_over(bounds, std::min(most_cells / 2, 4 * count / small));
  std::array<std::size_t, most_cells + 1> end{};
  find_cells_of_cluster(order, count, center, grid, cells);
  for (std::size_t k = 0; k < count; ++k) ++end[cells[k] + 1U];
  const std::size_t cell_count = grid.count();
  if (*std::max_element(end.begin(), end.begin() + static_cast<std::ptrdiff_t>(cell_count) + 1) > count - count / 8) {
    Dim widest = 0;
    for (Dim i = 1; i < N; ++i) {
      if (bounds.half_extents()[i] > bounds.half_extents()[widest]) widest = i;
    }
    std::sort(order, order + count, [&](Index i, Index j) {
      const T at_i = center(i)[widest];
      const T at_j = center(j)[widest];
      return at_i != at_j ? at_i < at_j : i < j;
    });
    return;
  }
  for (std::size_t c = 0; c < cell_count; ++c) end[c + 1] += end[c];
  std::copy(order, order + count, spare);
  for (std::size_t k = 0; k < count; ++k) order[end[cells[k]]++] = spare[k];
  std::size_t begin = 0;  // end[c] is now the end of cell c
  for (std::size_t c = 0; c < cell_count; ++c) {
    sort_cluster<N, T>(order + begin, end[c] - begin, small, center, cells + begin, spare + begin);
    begin = end[c];
  }
}

}  // namespace graze::detail
