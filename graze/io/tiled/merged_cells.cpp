// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <tuple>
#include <utility>
#include <vector>

#include <graze/io/tiled/merged_cells.hpp>

namespace graze::io {
namespace {

/// Sorts runs by row, then column, and joins those that adjoin or overlap.
void join_in_rows(std::vector<CellRun>& runs) {
  const auto before = [](const CellRun& a, const CellRun& b) {
    return std::tie(a.row, a.begin) < std::tie(b.row, b.begin);
  };
  if (!std::is_sorted(runs.begin(), runs.end(), before)) std::sort(runs.begin(), runs.end(), before);
  std::size_t kept = 0;
  for (const CellRun& run : runs) {
    if (kept > 0 && runs[kept - 1].row == run.row && runs[kept - 1].end >= run.begin) {
      runs[kept - 1].end = std::max(runs[kept - 1].end, run.end);
    } else {
      runs[kept++] = run;
    }
  }
  runs.resize(kept);
}

}  // namespace

std::deque<CellRectangle> merged_cells(std::vector<CellRun> runs) {
  join_in_rows(runs);
  std::deque<CellRectangle> rectangles;
  std::vector<std::size_t> above;  // rectangles that reach down to the current row, by column
  std::vector<std::size_t> here;   // those that continue through it
  std::size_t candidate = 0;       // in `above`: the first that does not begin before the current run
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const CellRun& run = runs[i];
    if (i == 0 || runs[i - 1].row != run.row) {
      above = std::exchange(here, {});
      candidate = 0;
    }
    while (candidate < above.size() && rectangles[above[candidate]].begin < run.begin) ++candidate;
    if (candidate < above.size()) {
      CellRectangle& rectangle = rectangles[above[candidate]];
      if (rectangle.bottom == run.row && rectangle.begin == run.begin && rectangle.end == run.end) {
        ++rectangle.bottom;
        here.push_back(above[candidate]);
        continue;
      }
    }
    here.push_back(rectangles.size());
    rectangles.push_back({run.begin, run.end, run.row, run.row + 1});
  }
  return rectangles;
}

}  // namespace graze::io
