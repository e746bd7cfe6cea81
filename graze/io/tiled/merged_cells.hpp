// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

namespace graze::io {

/// Cells side by side in one row, from `begin` to before `end`.
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

/// Rectangles that cover the cells of all runs, each cell once: runs that adjoin or overlap in a row become one, and
/// those that begin and end alike in rows on top of each other a rectangle. By top, then begin. In a deque, as there
/// may be millions, of which a reader can give up those that it has passed.
std::deque<CellRectangle> merged_cells(std::vector<CellRun> runs);

}  // namespace graze::io
