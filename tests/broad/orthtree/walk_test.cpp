// SPDX-License-Identifier: MIT
// Tests that a walk visits few cells; spatial_index_laws.hpp tests what it finds.
#include <cstddef>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include <graze/broad/grid/cells.hpp>
#include <graze/broad/orthtree/walk.hpp>

#include "broad/box_worlds.hpp"

namespace graze::detail::cell_walk_test {
namespace {

using Box = Aabb<2, float>;

/// Ten thousand boxes on a lattice with unit spacing.
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

/// A region that counts the boxes that it tests.
struct CountingProbe {
  Box region;
  mutable std::size_t looks = 0;

  static constexpr bool is_box = false;

  bool may_meet(const Box& box) const { return boxes_overlap(region, box); }
  bool may_meet_closely(const Box&) const { return true; }
  bool meets(const Box& box) const {
    ++looks;
    return boxes_overlap(region, box);
  }
};

template <class Cells>
class CellWalk : public testing::Test {};
using Tested = testing::Types<CellTree<2, float>, GridCells<2, float>>;
TYPED_TEST_SUITE(CellWalk, Tested);

TYPED_TEST(CellWalk, LooksAtFewBoxesBesideThoseThatItFinds) {
  const auto cells = lattice<TypeParam>();
  const CountingProbe probe{{{40, 40}, {44, 44}}};
  std::size_t found = 0;
  visit_cells_met(cells, probe, [&found](std::uint32_t) { return ++found > 0; });
  EXPECT_EQ(found, 25U);
  EXPECT_LT(probe.looks, 200U);
}

TYPED_TEST(CellWalk, OffersFewBoxesToWhoLooksForTheNearest) {
  const auto cells = lattice<TypeParam>();
  std::size_t offers = 0;
  double nearest = std::numeric_limits<double>::infinity();
  const auto offer = [&](std::uint32_t, double distance) {
    ++offers;
    nearest = distance < nearest ? distance : nearest;
  };
  visit_cells_near(cells, Vec<2>(30.75F, 30.25F), offer, [&nearest] { return nearest; });
  EXPECT_EQ(nearest, 0.0625);
  EXPECT_LT(offers, 100U);
}

TYPED_TEST(CellWalk, GoesAlongARayInOrderUntilItIsToldToStop) {
  const auto cells = lattice<TypeParam>();
  const Ray<2> ray{{-3, 7.25F}, {2, 0}};
  std::size_t visits = 0;
  visit_cells_along(
      cells, [&ray](const auto& box) { return entry_of(ray, box); },
      [&visits](std::uint32_t slot, double t) {
        EXPECT_EQ(slot, 700 + visits);
        EXPECT_EQ(t, (3 + static_cast<double>(visits)) / 2);
        return ++visits < 50;
      });
  EXPECT_EQ(visits, 50U);
}

}  // namespace
}  // namespace graze::detail::cell_walk_test
