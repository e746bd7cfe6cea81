// SPDX-License-Identifier: MIT
// Tests what a walk to the boxes in a box visits, and that it handles many boxes; spatial_index_laws.hpp tests that it
// finds the right ones, too.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/grid/cells.hpp>
#include <graze/broad/orthtree/query.hpp>
#include <graze/broad/orthtree/tree.hpp>

namespace graze::detail::cell_query_test {
namespace {

using Box = Aabb<2, float>;

/// A region that counts the boxes and cells that it tests.
struct CountingProbe {
  Box region;
  mutable std::size_t boxes = 0;
  mutable std::size_t cells = 0;

  bool may_meet(const Box& box) const {
    ++cells;
    return boxes_overlap(region, box);
  }
  bool meets(const Box& box) const {
    ++boxes;
    return boxes_overlap(region, box);
  }
};

/// A lattice of a hundred by a hundred, with unit spacing.
template <class Cells>
Cells lattice() {
  Cells cells({});
  for (std::uint32_t slot = 0; slot < 10'000; ++slot) {
    const std::uint32_t row = slot / 100;
    const Vec<2> low(static_cast<float>(slot % 100), static_cast<float>(row));
    cells.insert(slot, {low, low + 0.5F});
  }
  return cells;
}

template <class Cells>
std::vector<std::uint32_t> found_in(const Cells& cells, const CountingProbe& probe, std::size_t most = 1'000'000) {
  std::vector<std::uint32_t> found;
  visit_cells_in_box(cells, probe, [&](std::uint32_t slot) {
    found.push_back(slot);
    return found.size() < most;
  });
  std::sort(found.begin(), found.end());
  return found;
}

template <class Cells>
class CellQuery : public testing::Test {};
using Tested = testing::Types<CellTree<2, float>, GridCells<2, float>>;
TYPED_TEST_SUITE(CellQuery, Tested);

TYPED_TEST(CellQuery, LooksAtLittleBesideWhatItFinds) {
  const auto cells = lattice<TypeParam>();
  const CountingProbe probe{{{40, 40}, {44, 44}}};
  const std::vector<std::uint32_t> found = found_in(cells, probe);
  ASSERT_EQ(found.size(), 25U);
  EXPECT_EQ(found.front(), 4040U);
  EXPECT_EQ(found.back(), 4444U);
  EXPECT_LT(probe.boxes, 300U);
  EXPECT_LT(probe.cells, 200U);
}

/// Many times the capacity of its stack.
TYPED_TEST(CellQuery, FindsEachOfThousandsOnceAndStopsWhereItIsTold) {
  const auto cells = lattice<TypeParam>();
  const CountingProbe all{Box::everything()};
  const std::vector<std::uint32_t> found = found_in(cells, all);
  ASSERT_EQ(found.size(), 10'000U);
  EXPECT_TRUE(std::adjacent_find(found.begin(), found.end()) == found.end());
  for (const std::size_t most : {1U, 2U, 255U, 256U, 257U, 5'000U, 9'999U, 10'000U}) {
    EXPECT_EQ(found_in(cells, all, most).size(), most);
  }
}

/// Their positions in blocks still hold the previous content.
TYPED_TEST(CellQuery, FindsNoneThatWasErased) {
  auto cells = lattice<TypeParam>();
  for (std::uint32_t slot = 0; slot < 10'000; ++slot) {
    if (slot % 3 != 0) cells.erase(slot);
  }
  const std::vector<std::uint32_t> found = found_in(cells, {Box::everything()});
  ASSERT_EQ(found.size(), 3'334U);
  for (std::size_t k = 0; k < found.size(); ++k) EXPECT_EQ(found[k], 3 * k);
}

TYPED_TEST(CellQuery, FindsNothingWhereThereAreNoCells) {
  TypeParam cells({});
  EXPECT_TRUE(found_in(cells, {Box::everything()}).empty());
  cells.insert(0, {{1, 1}, {2, 2}});
  EXPECT_EQ(found_in(cells, {Box::everything()}), std::vector<std::uint32_t>{0});
  EXPECT_TRUE(found_in(cells, {{{3, 3}, {4, 4}}}).empty());
}

}  // namespace
}  // namespace graze::detail::cell_query_test
