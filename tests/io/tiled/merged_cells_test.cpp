// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <deque>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/io/tiled/merged_cells.hpp>

namespace graze::io::merged_cells_test {
namespace {

using Rectangles = std::deque<CellRectangle>;

TEST(MergedCells, MakeRectanglesOfRunsThatBeginAndEndAlike) {
  EXPECT_EQ(merged_cells({}), Rectangles{});
  EXPECT_EQ(merged_cells({{0, 2, 5}, {1, 2, 5}, {2, 2, 5}}), (Rectangles{{2, 5, 0, 3}}));
  EXPECT_EQ(merged_cells({{0, 2, 5}, {2, 2, 5}}), (Rectangles{{2, 5, 0, 1}, {2, 5, 2, 3}})) << "a row is missing";
  EXPECT_EQ(merged_cells({{0, 0, 4}, {1, 0, 2}, {2, 0, 2}}), (Rectangles{{0, 4, 0, 1}, {0, 2, 1, 3}}));
  EXPECT_EQ(merged_cells({{0, 0, 1}, {0, 2, 3}, {1, 0, 1}, {1, 2, 3}}), (Rectangles{{0, 1, 0, 2}, {2, 3, 0, 2}}));
}

TEST(MergedCells, JoinRunsOfOneRowInAnyOrder) {
  EXPECT_EQ(merged_cells({{1, 4, 6}, {0, -2, 0}, {1, 0, 4}, {0, 0, 6}, {1, -2, 1}}), (Rectangles{{-2, 6, 0, 2}}));
}

RC_GTEST_PROP(MergedCellsLaws, CoverTheSameCellsEachOnce, ()) {
  using Cell = std::pair<std::int64_t, std::int64_t>;
  std::set<Cell> cells;
  std::vector<CellRun> runs;
  const auto count = *rc::gen::inRange(0, 60);
  for (int i = 0; i < count; ++i) {
    const std::int64_t row = *rc::gen::inRange(-4, 5);
    const std::int64_t begin = *rc::gen::inRange(-8, 8);
    runs.push_back({row, begin, begin + *rc::gen::inRange(1, 4)});
    for (std::int64_t x = begin; x < runs.back().end; ++x) cells.insert({row, x});
  }
  std::size_t area = 0;
  std::set<Cell> covered;
  for (const CellRectangle& rectangle : merged_cells(runs)) {
    area += static_cast<std::size_t>((rectangle.end - rectangle.begin) * (rectangle.bottom - rectangle.top));
    for (std::int64_t y = rectangle.top; y < rectangle.bottom; ++y) {
      for (std::int64_t x = rectangle.begin; x < rectangle.end; ++x) covered.insert({y, x});
    }
  }
  RC_ASSERT(covered == cells);
  RC_ASSERT(area == cells.size());
}

}  // namespace
}  // namespace graze::io::merged_cells_test
