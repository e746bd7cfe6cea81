// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// A regular grid over centers, with cells numbered in boustrophedon order: each cell shares a face with the next.
template <Dim N, class T>
struct CellGrid {
  Vec<N, T> origin = Vec<N, T>(T(0));
  Vec<N, T> cells_per_unit = Vec<N, T>(T(0));
  std::uint32_t cells[N];  // powers of two

  std::uint32_t count() const {
    std::uint32_t product = 1;
    for (Dim i = 0; i < N; ++i) product *= cells[i];
    return product;
  }
};

/// Fits the cells along one axis to the bounds; a single cell if these are too flat or too wide to be divided.
template <Dim N, class T>
void fit_cells(CellGrid<N, T>& grid, const Aabb<N, T>& bounds, Dim axis) {
  const T extent = bounds.max[axis] - bounds.min[axis];
  grid.cells_per_unit[axis] = static_cast<T>(grid.cells[axis]) / extent;
  if (std::isfinite(extent) && std::isfinite(grid.cells_per_unit[axis])) return;
  grid.cells[axis] = 1;
  grid.cells_per_unit[axis] = T(0);
  grid.origin[axis] = T(0);  // from here, no finite point is infinitely far
}

/// A grid over finite bounds with at least `wanted` cells and less than twice as many; a single cell if the bounds are
/// a point. Cells are as close to cubes as halving permits. All divisions are by two, so the grid is the same on every
/// machine.
template <Dim N, class T>
CellGrid<N, T> grid_over(const Aabb<N, T>& bounds, std::size_t wanted) {
  CellGrid<N, T> grid;
  Vec<N, T> side = bounds.half_extents();
  for (Dim i = 0; i < N; ++i) grid.cells[i] = 1;
  for (std::size_t cells = 1; cells < wanted; cells *= 2) {
    Dim widest = 0;
    for (Dim i = 1; i < N; ++i) {
      if (side[i] > side[widest]) widest = i;
    }
    if (!(side[widest] > 0)) break;
    side[widest] *= T(0.5);
    grid.cells[widest] *= 2;
  }
  grid.origin = bounds.min;
  for (Dim i = 0; i < N; ++i) fit_cells(grid, bounds, i);
  return grid;
}

/// The same grid with every row of cells divided into `times` as many; a power of two.
template <Dim N, class T>
CellGrid<N, T> with_finer_rows(CellGrid<N, T> grid, const Aabb<N, T>& bounds, std::uint32_t times) {
  Dim row = 0;
  while (row < N - 1 && grid.cells[row] == 1) ++row;
  grid.cells[row] *= times;
  fit_cells(grid, bounds, row);
  return grid;
}

/// The number of the cell with these coordinates along each axis.
template <Dim N, class T, class Along>
std::uint16_t cell_number(const CellGrid<N, T>& grid, const Along& along) {
  std::uint32_t number = 0;
  for (Dim i = N; i-- > 0;) {
    std::uint32_t place = along(i);
    if ((number & 1U) != 0) place ^= grid.cells[i] - 1;
    number = number * grid.cells[i] + place;
  }
  return static_cast<std::uint16_t>(number);
}

/// The number of the cell of a point within the bounds of the grid.
template <Dim N, class T>
std::uint16_t cell_of(const Vec<N, T>& point, const CellGrid<N, T>& grid) {
  return cell_number(grid, [&](Dim i) {
    const auto place = static_cast<std::uint32_t>((point[i] - grid.origin[i]) * grid.cells_per_unit[i]);
    return place > grid.cells[i] - 1 ? grid.cells[i] - 1 : place;
  });
}

/// The number of the cell nearest to a finite point, which may be out of bounds.
template <Dim N, class T>
std::uint16_t nearest_cell_of(const Vec<N, T>& point, const CellGrid<N, T>& grid) {
  return cell_number(grid, [&](Dim i) {
    const T place = (point[i] - grid.origin[i]) * grid.cells_per_unit[i];
    return static_cast<std::uint32_t>(std::min(std::max(place, T(0)), static_cast<T>(grid.cells[i] - 1)));
  });
}

}  // namespace graze::detail
