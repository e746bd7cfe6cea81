// SPDX-License-Identifier: MIT
// Invariants of a CellTree after bulk insertion and later changes; spatial_index_laws.hpp compares what is found in it
// with BruteForce.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/broad/orthtree/tree.hpp>

#include "broad/cell_checks.hpp"

namespace graze::detail::cell_fill_test {
namespace {

template <Dim N, class T>
using Boxes = std::vector<Aabb<N, T>>;

/// Boxes in clusters, most of them small, some as large as the world, far away, equal or infinite.
template <Dim N, class T>
Boxes<N, T> mixed_boxes(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto number = [&random](std::uint32_t below) { return static_cast<T>(random() % below); };
  Boxes<N, T> boxes(count);
  for (Aabb<N, T>& box : boxes) {
    const std::uint32_t kind = random() % 64;
    const T unit = kind < 8 ? T(0.001) : kind == 8 ? T(1e5) : T(1);
    for (Dim i = 0; i < N; ++i) {
      box.min[i] = number(100) * unit;
      box.max[i] = box.min[i] + number(kind == 9 ? 80 : 3) * unit;
    }
    if (kind == 10) box = {Vec<N, T>(T(1)), Vec<N, T>(T(1))};
    if (kind == 11) box.max[0] = std::numeric_limits<T>::infinity();
  }
  return boxes;
}

std::vector<std::uint32_t> shuffled_slots(std::size_t count, std::uint32_t seed) {
  std::vector<std::uint32_t> slots(count);
  std::iota(slots.begin(), slots.end(), 3U);
  std::shuffle(slots.begin(), slots.end(), std::mt19937(seed));
  return slots;
}

template <Dim N, class T>
void expect_sound_after_filling(const OrthtreeOptions& options, const Boxes<N, T>& boxes, std::uint32_t seed) {
  const std::vector<std::uint32_t> slots = shuffled_slots(boxes.size(), seed);
  CellTree<N, T> tree(options);
  tree.fill(boxes, slots);
  std::map<std::uint32_t, Aabb<N, T>> expected;
  for (std::size_t k = 0; k < boxes.size(); ++k) expected[slots[k]] = boxes[k];
  test::expect_sound(tree, expected);
  for (std::size_t k = 0; k < boxes.size(); k += 3) {
    tree.update(slots[k], boxes[boxes.size() - 1 - k]);
    expected[slots[k]] = boxes[boxes.size() - 1 - k];
  }
  test::expect_sound(tree, expected);
  for (const std::uint32_t slot : slots) {
    if (slot % 4 == 0) continue;
    tree.erase(slot);
    expected.erase(slot);
  }
  test::expect_sound(tree, expected);
}

RC_GTEST_PROP(CellFill, LeavesASoundTreeThatCanBeChanged, ()) {
  const OrthtreeOptions options{*rc::gen::inRange<std::size_t>(1, 20), *rc::gen::inRange(0, 33)};
  const auto count = *rc::gen::inRange<std::size_t>(0, 400);
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  expect_sound_after_filling(options, mixed_boxes<2, float>(count, seed), seed);
  expect_sound_after_filling(options, mixed_boxes<3, double>(count, seed), seed);
}

/// The number of boxes in the fullest cell, including the list outside.
template <Dim N, class T>
std::size_t fullest(const CellTree<N, T>& tree) {
  using Tree = CellTree<N, T>;
  std::size_t most = tree.cell(Tree::outside).entries.count;
  const auto visit = [&](std::uint32_t index, const auto& self) -> void {
    most = std::max<std::size_t>(most, tree.cell(index).entries.count);
    if (tree.cell(index).first_child == no_index) return;
    for (std::uint32_t k = 0; k < Tree::children; ++k) self(tree.cell(index).first_child + k, self);
  };
  if (tree.has_root()) visit(Tree::root, visit);
  return most;
}

template <Dim N>
Boxes<N, float> spread_boxes(std::size_t count, float side) {
  std::mt19937 random(20261121);
  std::uniform_real_distribution<float> place(0.0F, side);
  Boxes<N, float> boxes(count);
  for (Aabb<N, float>& box : boxes) {
    for (Dim i = 0; i < N; ++i) box.min[i] = place(random);
    box.max = box.min + 1.0F;
  }
  return boxes;
}

TEST(CellFill, FillsNoCellBeyondItsCapacityWhereBoxesAreSmall) {
  CellTree<2, float> flat({8, 16});
  flat.fill(spread_boxes<2>(5000, 1000.0F), shuffled_slots(5000, 1));
  EXPECT_LE(fullest(flat), 8U);
  CellTree<3, float> solid({8, 16});
  solid.fill(spread_boxes<3>(5000, 1000.0F), shuffled_slots(5000, 1));
  EXPECT_LE(fullest(solid), 8U);
}

/// More levels than are sorted at a time, so that the levels below are sorted separately.
TEST(CellFill, SortsBelowWhatIsSortedAtATime) {
  Boxes<2, float> boxes = spread_boxes<2>(20'000, 4.0F);
  for (Aabb<2, float>& box : boxes) box.max = box.min + 0.001F;
  boxes.push_back({Vec<2>(3000.0F), Vec<2>(3001.0F)});
  CellTree<2, float> tree({8, 32});
  tree.fill(boxes, shuffled_slots(boxes.size(), 1));
  EXPECT_LE(fullest(tree), 8U);
  for (const std::uint32_t slot : {3U, 4U, 20'003U}) tree.erase(slot);
}

/// With a few far away, the others need more levels than a code distinguishes.
TEST(CellFill, PartsAClusterThatTheOthersMakeLookLikeAPoint) {
  Boxes<3, float> boxes = spread_boxes<3>(500, 100.0F);
  for (Aabb<3, float>& box : boxes) box.max = box.min + 0.01F;
  boxes.push_back({Vec<3>(1e6F), Vec<3>(1e6F)});
  CellTree<3, float> tree({8, 32});
  tree.fill(boxes, shuffled_slots(boxes.size(), 1));
  EXPECT_LE(fullest(tree), 8U);
}

TEST(CellFill, OneFarOffOrInfiniteBoxSpoilsNothing) {
  Boxes<2, float> boxes = spread_boxes<2>(5000, 1000.0F);
  boxes.push_back({Vec<2>(1e30F), Vec<2>(2e30F)});
  boxes.push_back(Aabb<2, float>::everything());
  CellTree<2, float> tree({8, 16});
  tree.fill(boxes, shuffled_slots(boxes.size(), 1));
  EXPECT_EQ(tree.cell(CellTree<2, float>::outside).entries.count, 2U);
  EXPECT_LE(fullest(tree), 8U);
}

TEST(CellFill, EqualBoxesStayTogether) {
  for (const float size : {0.0F, 4.0F}) {
    const Boxes<2, float> boxes(100, Aabb<2, float>{Vec<2>(3.0F), Vec<2>(3.0F + size)});
    CellTree<2, float> tree({8, 16});
    tree.fill(boxes, shuffled_slots(boxes.size(), 1));
    EXPECT_EQ(fullest(tree), 100U) << size;
  }
}

}  // namespace
}  // namespace graze::detail::cell_fill_test
