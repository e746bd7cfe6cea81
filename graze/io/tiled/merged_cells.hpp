// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

namespace graze::io {

/// Adjacent cells of one row, from `begin` to before `end`.
struct CellRun {
  std::int64_t row = 0;
  std::int64_t begin = 0;
  std::int64_t end = 0;

  friend bool operator==(const CellRun&, const CellRun&) = default;
};

/// A rectangle of cells: columns from `begin` to before `end`, rows from `top` to before `bottom`.
struct CellRectangle {
  std::int64_t begin = 0;
  std::int64_t end = 0;
  std::int64_t top = 0;
  std::int64_t bottom = 0;

  friend bool operator==(const CellRectangle&, const CellRectangle&) = default;
};

/// Rectangles that cover the cells of all runs, each cell once: adjacent and overlapping runs in a row are joined, and
/// runs with equal begin and end in consecutive rows form a rectangle. Sorted by top, then begin. A deque, so that a
/// reader of millions of rectangles can release those that it has processed.
std::deque<CellRectangle> merged_cells(std::vector<CellRun> runs);

}  // namespace graze::io
