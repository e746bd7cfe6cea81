// SPDX-License-Identifier: MIT
// Invariants of GridCells after any sequence of calls; grid_test.cpp and spatial_index_laws.hpp have the rest.
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/broad/grid/cells.hpp>
#include <graze/broad/index/box_cover.hpp>

#include "broad/box_worlds.hpp"

namespace graze::detail::grid_cells_test {
namespace {

using Cells = GridCells<2, float>;
using Box = Aabb<2, float>;

/// Every box is in one cell, that of its center, which is as large as the box, and inside the bounds of all ancestors.
void expect_sound(const Cells& cells, const std::map<std::uint32_t, Box>& expected) {
  std::map<std::uint32_t, Box> found;
  std::size_t filled = 0;
  const auto find = [&](const Cell<2, float>& cell) {
    cells.pool().for_each(cell.entries, [&](const Entry<2, float>& entry) {
      RC_ASSERT(found.emplace(entry.slot, entry.box).second);
      RC_ASSERT(cells.box(entry.slot) == entry.box);
    });
  };
  const auto visit = [&](std::uint32_t index, const auto& self) -> void {
    const Cell<2, float>& cell = cells.cell(index);
    const GridPlace<2> place = cells.place(index);
    if (cell.entries.count > 0) ++filled;
    find(cell);
    cells.pool().for_each(cell.entries, [&](const Entry<2, float>& entry) {
      RC_ASSERT(covers(cell.bounds, entry.box));
      RC_ASSERT(grid_place(entry.box, place.level) == place);
      RC_ASSERT(own_grid_level(entry.box) <= place.level);
    });
    if (cell.first_child == no_index) return;
    bool is_used = false;
    for (std::uint32_t k = 0; k < Cells::children; ++k) {
      const std::uint32_t child = cell.first_child + k;
      RC_ASSERT(cells.place(child) == child_of(place, k));
      RC_ASSERT(is_nothing(cells.cell(child).bounds) || covers(cell.bounds, cells.cell(child).bounds));
      is_used = is_used || cells.cell(child).entries.count > 0 || cells.cell(child).first_child != no_index;
      self(child, self);
    }
    RC_ASSERT(is_used);
  };
  find(cells.cell(Cells::outside));
  for (std::uint32_t k = 0; k < cells.root_count(); ++k) visit(Cells::root + k, visit);
  RC_ASSERT(found == expected);
  RC_ASSERT(filled == cells.filled());
}

RC_GTEST_PROP(GridCells, AreSoundAfterAnySequenceOfCalls, ()) {
  Cells cells({*rc::gen::element(0.0, 0.0, 0.01, 5.0)});
  std::map<std::uint32_t, Box> boxes;
  std::uint32_t slots = 0;
  const auto small = rc::gen::inRange(-10, 40);
  const auto steps = *rc::gen::scale(
      3.0, rc::gen::container<std::vector<std::vector<int>>>(rc::gen::container<std::vector<int>>(6, small)));
  for (const std::vector<int>& step : steps) {
    const float scale = step[1] == 0 ? 1e6F : step[1] == 1 ? 1e-3F : 1.0F;
    const Vec<2> low = Vec<2>(step[2], step[3]) * scale;
    const Vec<2> size = Vec<2>((step[4] + 10) % 7, (step[5] + 10) % 7) * scale;
    const auto picked =
        boxes.empty() ? boxes.end() : std::next(boxes.begin(), (step[1] + 10) % static_cast<int>(boxes.size()));
    if ((step[0] + 16) % 8 < 4 || boxes.empty()) {
      boxes[slots] = {low, low + size};
      cells.insert(slots++, {low, low + size});
    } else if ((step[0] + 16) % 8 < 6) {
      picked->second = {low, low + size};
      cells.update(picked->first, picked->second);
    } else {
      cells.erase(picked->first);
      boxes.erase(picked);
    }
    if (step[0] == 0) expect_sound(cells, boxes);
  }
  expect_sound(cells, boxes);
}

/// Hundreds of boxes, so that the cell size is chosen again, in sets of every kind.
TEST(GridCells, AreSoundInHardWorlds) {
  for (const auto& world : test::box_worlds<2, float>(700, 5)) {
    Cells cells({});
    std::map<std::uint32_t, Box> boxes;
    for (std::uint32_t slot = 0; slot < 700; ++slot) {
      if (is_nothing(world.boxes[slot])) continue;
      cells.insert(slot, boxes[slot] = world.boxes[slot]);
    }
    SCOPED_TRACE(world.name);
    expect_sound(cells, boxes);
    for (auto& [slot, box] : boxes) cells.update(slot, box = {box.min * 0.5F, box.max * 0.5F});
    SCOPED_TRACE(world.name);
    expect_sound(cells, boxes);
    for (std::uint32_t slot = 0; slot < 700; slot += 2) {
      if (boxes.erase(slot) > 0) cells.erase(slot);
    }
    SCOPED_TRACE(world.name);
    expect_sound(cells, boxes);
  }
}

TEST(GridCells, ChooseTheirSizeByHowManyBoxesThereAre) {
  test::Numbers numbers(3);
  for (const float extent : {1e-3F, 1.0F, 1e5F}) {
    Cells cells({});
    for (std::uint32_t slot = 0; slot < 5000; ++slot) {
      const Vec<2> point = numbers.point<2, float>(0, 1) * extent;
      cells.insert(slot, {point, point});
    }
    EXPECT_GT(5000U, cells.filled());
    EXPECT_LT(5000U, 24 * cells.filled());
    for (std::uint32_t slot = 0; slot < 5000; ++slot) {  // then half of them move much closer
      const Vec<2> point = numbers.point<2, float>(0, 1) * extent * (slot % 2 == 0 ? 1e-3F : 1.0F);
      cells.update(slot, {point, point});
    }
    EXPECT_LT(5000U, 24 * cells.filled());
  }
}

TEST(GridCells, RefuseOptionsBeyondTheirLimits) {
  EXPECT_THROW(Cells({-1}), std::invalid_argument);
  EXPECT_THROW(Cells({0x1p1001}), std::invalid_argument);
  EXPECT_THROW(Cells({std::numeric_limits<double>::quiet_NaN()}), std::invalid_argument);
  EXPECT_NO_THROW(Cells({0x1p1000}));
}

/// Insertions, moves and removals forever do not increase the memory.
TEST(GridCells, DoNotGrowWithTheNumberOfCalls) {
  Cells cells({2});
  const auto box = [](std::uint32_t slot, std::uint32_t round) {
    const Vec<2> place(static_cast<float>((slot * 7 + round * 13) % 97), static_cast<float>((slot * 31 + round) % 89));
    return Box{place, place + 1.0F};
  };
  for (std::uint32_t slot = 0; slot < 300; ++slot) cells.insert(slot, box(slot, 0));
  std::size_t bytes = 0;
  for (std::uint32_t round = 1; round < 60; ++round) {
    for (std::uint32_t slot = 0; slot < 300; ++slot) {
      if ((slot + round) % 3 == 0) {
        cells.erase(slot);
        cells.insert(slot, box(slot, round));
      } else {
        cells.update(slot, box(slot, round));
      }
    }
    if (round == 20) bytes = cells.bytes();
  }
  EXPECT_LE(cells.bytes(), 2 * bytes);
  for (std::uint32_t slot = 0; slot < 300; ++slot) cells.erase(slot);
  EXPECT_EQ(cells.root_count(), 0U);
  EXPECT_EQ(cells.filled(), 0U);
}

}  // namespace
}  // namespace graze::detail::grid_cells_test
