// SPDX-License-Identifier: MIT
// Features of Grid beyond those of other indexes. spatial_index_laws.hpp compares its answers with those of BruteForce.
#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/brute_force.hpp>
#include <graze/broad/grid.hpp>
#include <graze/shape/frustum.hpp>
#include <graze/shape/sphere.hpp>

#include "box_worlds.hpp"

namespace graze::grid_test {
namespace {

template <Dim N, class T>
std::vector<GridCell<N, T>> cells_of(const Grid<N, T>& grid) {
  std::vector<GridCell<N, T>> cells;
  grid.visit_cells([&cells](const auto& cell) { cells.push_back(cell); });
  return cells;
}

template <class Index, class R>
std::vector<std::uint32_t> found(const Index& index, const R& region) {
  std::vector<std::uint32_t> indices;
  index.query(region, [&indices](Key key) { indices.push_back(key.index); });
  std::sort(indices.begin(), indices.end());
  return indices;
}

template <class Index>
std::vector<std::pair<std::uint32_t, double>> hits(const Index& index, const Ray<3>& ray) {
  std::vector<std::pair<std::uint32_t, double>> result;
  index.ray_cast(ray, [&result](Key key, double t) { result.emplace_back(key.index, t); });
  return result;
}

template <class Index>
std::vector<std::pair<std::uint32_t, double>> nearest(const Index& index, const Vec<3>& point) {
  std::vector<std::pair<std::uint32_t, double>> result;
  for (const Neighbour& neighbour : index.nearest(point, 9)) {
    result.emplace_back(neighbour.key.index, neighbour.distance_squared);
  }
  return result;
}

TEST(Grid, TellsItsCellsLargerOnesFirst) {
  Grid<2> grid({.smallest_cell = 1});
  grid.insert({{0.25F, 0.25F}, {0.5F, 0.5F}});
  grid.insert({{0, 0}, {1, 1}});
  grid.insert({{-3, 5}, {0, 6}});  // three long: in a cell of size 4
  const auto cells = cells_of(grid);
  ASSERT_EQ(cells.size(), 2U);
  EXPECT_EQ(cells[0].box, (Aabb<2>{{0, 0}, {1, 1}}));
  EXPECT_EQ(cells[0].count, 2U);
  EXPECT_EQ(cells[1].box, (Aabb<2>{{-4, 4}, {0, 8}}));
  EXPECT_EQ(cells[1].size, 4);
  int visits = 0;
  grid.visit_cells([&visits](const auto&) { return ++visits < 1; });
  EXPECT_EQ(visits, 1);
}

TEST(Grid, ASmallestCellIsThePowerOfTwoThatIsNotBelow) {
  Grid<2> grid({.smallest_cell = 3});
  grid.insert({{5, 5}, {5, 5}});
  EXPECT_EQ(cells_of(grid)[0].box, (Aabb<2>{{4, 4}, {8, 8}}));
  EXPECT_EQ(grid.options().smallest_cell, 3);
}

TEST(Grid, TakesItsSmallestCellAsANumber) {
  EXPECT_EQ(Grid<3>(0.001).options().smallest_cell, 0.001);
  EXPECT_EQ((Grid<2, double>(3).options().smallest_cell), 3);
}

TEST(Grid, RefusesSettingsByName) {
  try {
    const Grid<2> grid({.smallest_cell = -2});
    FAIL() << "no error";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()), "Grid: smallest_cell is -2.000000; it must be from 0 to 2^1000");
  }
}

TEST(Grid, KeepsWhatIsInfiniteOrHugeInAList) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Grid<2, double> grid;
  const Key strip = grid.insert({{-infinity, 3}, {infinity, 4}});
  const Key huge = grid.insert({{-1e308, 0}, {1e308, 1}});
  EXPECT_EQ(grid.outside(), 2U);
  EXPECT_TRUE(cells_of(grid).empty());
  EXPECT_EQ(count(grid, Vec<2, double>(1e300, 3.5)), 1U);
  EXPECT_EQ(grid.nearest({5, 0.5}, 1)[0].key, huge);
  grid.update(strip, {{3, 3}, {4, 4}});
  grid.update(huge, {{3, 3}, {4, 4}});
  EXPECT_EQ(grid.outside(), 0U);
  EXPECT_EQ(cells_of(grid)[0].count, 2U);
}

TEST(Grid, AnswersAsBruteForceDoesInHardWorlds) {
  for (const auto& world : test::box_worlds<3, float>(1500, 11)) {
    SCOPED_TRACE(world.name);
    Grid<3> grid;
    BruteForce<3> judge;
    for (const Aabb<3>& box : world.boxes) {
      if (is_nothing(box)) continue;
      grid.insert(box);
      judge.insert(box);
    }
    for (std::size_t k = 0; k < 24; ++k) {
      const Aabb<3>& box = world.boxes[k * 61];
      const Vec<3> a = is_valid(box) ? box.center() : Vec<3>(1);
      const Vec<3> b = world.boxes[k * 53 + 1].min;
      if (!is_finite(b) || a == b || !is_finite(b - a)) continue;
      EXPECT_EQ(found(grid, Aabb<3>::from_corners(a, a + (b - a) * 0.2F)),
                found(judge, Aabb<3>::from_corners(a, a + (b - a) * 0.2F)));
      EXPECT_EQ(found(grid, Sphere<3>{a, 3}), found(judge, Sphere<3>{a, 3}));
      EXPECT_EQ(hits(grid, {a, b - a}), hits(judge, {a, b - a}));
      EXPECT_EQ(nearest(grid, b), nearest(judge, b));
    }
  }
}

TEST(Grid, FindsWhatAFrustumSees) {
  Grid<3> grid;
  BruteForce<3> judge;
  test::Numbers numbers(8);
  for (int k = 0; k < 2000; ++k) {
    const Vec<3> low = numbers.point<3, float>(-50, 50);
    const Aabb<3> box{low, low + static_cast<float>(numbers.between(0, 2))};
    grid.insert(box);
    judge.insert(box);
  }
  Frustum<3> frustum;
  for (std::size_t k = 0; k < 8; ++k) {
    const float far = k < 4 ? 1.0F : 40.0F;
    frustum.corners[k] = {(k & 1U) != 0 ? far : -far, (k & 2U) != 0 ? far : -far, far};
  }
  const auto seen = found(grid, frustum);
  EXPECT_EQ(seen, found(judge, frustum));
  EXPECT_GT(seen.size(), 100U);
  EXPECT_LT(seen.size(), 1000U);
}

TEST(Grid, FollowsAWorldThatMovesAwayOrShrinks) {
  Grid<2> grid;
  std::vector<Key> keys;
  const auto box = [](int k, float scale, float offset) {
    const int row = k / 64;
    const Vec<2> low = Vec<2>(static_cast<float>(k % 64), static_cast<float>(row)) * scale + offset;
    return Aabb<2>{low, low + 0.25F * scale};
  };
  for (int k = 0; k < 4096; ++k) keys.push_back(grid.insert(box(k, 1, 0)));
  const auto fullest = [&grid] {
    std::size_t most = 0;
    for (const auto& cell : cells_of(grid)) most = std::max(most, cell.count);
    return most;
  };
  EXPECT_LE(fullest(), 64U);
  for (const auto& [scale, offset] : {std::pair{1.0F, 1e5F}, {1e-3F, 0.0F}, {1e3F, -1e6F}}) {
    for (int frame = 0; frame < 3; ++frame) {
      for (int k = 0; k < 4096; ++k) grid.update(keys[static_cast<std::size_t>(k)], box(k, scale, offset));
    }
    EXPECT_LE(fullest(), 64U) << scale;
    EXPECT_EQ(count(grid, Aabb<2>::everything()), 4096U);
  }
}

TEST(Grid, SaysHowMuchMemoryItHolds) {
  Grid<2> grid;
  for (int k = 0; k < 10000; ++k) {
    const int row = k / 100;
    const Vec<2> low(static_cast<float>(k % 100), static_cast<float>(row));
    grid.insert({low, low + 0.5F});
  }
  EXPECT_LT(grid.bytes(), std::size_t{10000} * 300);
  EXPECT_GT(grid.bytes(), std::size_t{10000} * 20);
}

}  // namespace
}  // namespace graze::grid_test
