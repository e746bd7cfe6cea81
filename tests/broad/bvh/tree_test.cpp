// SPDX-License-Identifier: MIT
// Invariants of the tree after any sequence of calls, its height, and its quality over time.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/broad/bvh/query.hpp>
#include <graze/broad/bvh/tree.hpp>
#include <graze/broad/spatial_index.hpp>
#include <graze/shape/ray.hpp>

#include "broad/box_worlds.hpp"
#include "broad/bvh_checks.hpp"
#include "number_of_cases.hpp"

namespace graze::detail::bvh_tree_test {
namespace {

using Tree = BvhTree<2, float>;
using Box = Aabb<2, float>;
using Inspection = test::BvhInspection<2, float>;

/// The unit square at a position; in 3D the unit cube on the floor.
template <Dim N>
Aabb<N> unit_cube(double x, double y) {
  Vec<N> low(0.0F);
  low[0] = static_cast<float>(x);
  low[1] = static_cast<float>(y);
  return {low, low + 1.0F};
}

Box unit_square(double x, double y) { return unit_cube<2>(x, y); }

/// A tree and the boxes that it must contain.
template <Dim N>
struct HeldIn {
  BvhTree<N, float> tree;
  std::map<std::uint32_t, Aabb<N>> boxes;
  std::map<std::uint32_t, std::uint32_t> generations = {};
  std::uint32_t inserted = 0;

  explicit HeldIn(double margin = 0) : tree(margin) {}

  void set(std::uint32_t slot, const Aabb<N>& box) {
    if (boxes.count(slot) == 0) {
      generations[slot] = ++inserted;
      tree.insert(slot, box, generations[slot]);
    } else {
      tree.update(slot, box);
    }
    boxes[slot] = box;
  }
  void erase(std::uint32_t slot) {
    tree.erase(slot);
    boxes.erase(slot);
    generations.erase(slot);
  }
  test::BvhInspection<N, float> inspect() const { return {tree, boxes, generations}; }
};

using Held = HeldIn<2>;

RC_GTEST_PROP(BvhTree, IsSoundAfterAnySequenceOfCalls, ()) {
  Held held(*rc::gen::element(0.0, 0.5, 5.0));
  std::uint32_t slots = 0;
  const auto small = rc::gen::inRange(0, 40);
  const auto steps = *rc::gen::scale(
      5.0, rc::gen::container<std::vector<std::vector<int>>>(rc::gen::container<std::vector<int>>(6, small)));
  for (const std::vector<int>& step : steps) {
    const float scale = step[1] == 0 ? 1e6F : step[1] == 1 ? 1e-3F : 1.0F;
    const Vec<2> low = Vec<2>(step[2], step[3]) * scale;
    Box box{low, low + Vec<2>(step[4] % 7, step[5] % 7) * scale};
    if (step[1] == 2) box.max.x = std::numeric_limits<float>::infinity();
    const auto pick = held.boxes.begin();
    const auto count = static_cast<int>(held.boxes.size());
    if (step[0] % 8 < 4 || count == 0) {
      held.set(slots++, box);
    } else if (step[0] % 8 < 6) {
      held.set(std::next(pick, step[1] % count)->first, box);
    } else {
      held.erase(std::next(pick, step[1] % count)->first);
    }
    if (step[0] == 0) RC_ASSERT(held.inspect().fault() == "");
  }
  RC_ASSERT(held.inspect().fault() == "");
  while (!held.boxes.empty()) held.erase(held.boxes.begin()->first);
  RC_ASSERT(held.tree.root().is_none());
  RC_ASSERT(held.tree.spare_nodes() == 0U);
}

TEST(BvhTree, RefusesAMarginThatIsNone) {
  for (const double margin : {-1.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
    EXPECT_THROW(Tree{margin}, std::invalid_argument);
  }
  try {
    Tree tree(-0.5);
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()), "Bvh: margin is -0.500000; it must be finite and not negative");
  }
}

// ---- The margin

/// The bounds of all leaf nodes, as their parents have them.
std::vector<Box> leaf_bounds(const Tree& tree) {
  std::vector<Box> bounds;
  const BvhNode<2, float>& root = tree.node(tree.root());
  for (std::uint32_t lane = 0; lane < tree.count(tree.root()); ++lane) bounds.push_back(box_in(root.boxes, lane));
  return bounds;
}

TEST(BvhTree, BoundsDoNotChangeWhileBoxesStayWithinTheMargin) {
  Held held(2);
  for (std::uint32_t k = 0; k < 40; ++k) held.set(k, unit_square(5 * k, 0));
  ASSERT_FALSE(held.tree.root().is_leaf());
  ASSERT_EQ(held.inspect().height(), 2U);
  EXPECT_EQ(held.tree.bounds(), (Box{{-2, -2}, {198, 3}}));
  const std::vector<Box> before = leaf_bounds(held.tree);
  held.set(0, unit_square(-2, 2));  // to the limit
  EXPECT_EQ(leaf_bounds(held.tree), before);
  EXPECT_EQ(held.inspect().fault(), "");
  EXPECT_EQ(test::effort_of(held.tree, unit_square(-2, 2)).found, 1U);
  held.set(0, unit_square(-2.5, 0));
  EXPECT_EQ(held.tree.bounds(), (Box{{-4.5F, -2}, {198, 3}}));
  EXPECT_EQ(held.inspect().fault(), "");
  EXPECT_EQ(test::effort_of(held.tree, unit_square(-2.5, 0)).found, 1U);
}

TEST(BvhTree, BoundsShrinkWhenABoxHasShrunk) {
  Held held(1);
  for (std::uint32_t k = 1; k < 20; ++k) held.set(k, unit_square(10 * k, 0));
  held.set(0, {{0, 0}, {5, 100}});
  EXPECT_EQ(held.tree.bounds(), (Box{{-1, -1}, {192, 101}}));
  held.set(0, {{0, 0}, {5, 98}});  // no update needed
  EXPECT_EQ(held.tree.bounds(), (Box{{-1, -1}, {192, 101}}));
  held.set(0, {{0, 0}, {5, 50}});
  EXPECT_EQ(held.tree.bounds(), (Box{{-1, -1}, {192, 51}}));
  EXPECT_EQ(held.inspect().fault(), "");
}

TEST(BvhTree, GrowsBoundsNoFartherThanNumbersGo) {
  constexpr float most = std::numeric_limits<float>::max();
  Held held(1e300);
  for (std::uint32_t k = 0; k < 40; ++k) held.set(k, unit_square(k, 2));
  held.set(1, {{-most, -most}, {most, most}});
  EXPECT_EQ(held.tree.bounds(), (Box{{-most, -most}, {most, most}}));
  EXPECT_EQ(held.inspect().fault(), "");
}

// ---- Quality

/// The number of hits of a ray that are compared.
constexpr std::size_t first_hits = 20;

/// The first hits, calculated from the boxes themselves.
template <Dim N>
std::vector<BvhHit> hits_by_all(const HeldIn<N>& held, const Ray<N>& ray) {
  std::vector<BvhHit> hits;
  for (const auto& [slot, box] : held.boxes) {
    if (const auto t = entry_of(ray, box)) hits.push_back({*t, {slot, held.generations.at(slot)}});
  }
  const std::size_t kept = std::min(first_hits, hits.size());
  std::partial_sort(hits.begin(), hits.begin() + static_cast<std::ptrdiff_t>(kept), hits.end());
  hits.erase(hits.begin() + static_cast<std::ptrdiff_t>(kept), hits.end());
  return hits;
}

template <Dim N>
std::vector<BvhHit> hits_by_tree(const BvhTree<N, float>& tree, const Ray<N>& ray) {
  std::vector<BvhHit> hits;
  visit_along(tree, ray, [&hits](const BvhName& name, double t) {
    hits.push_back({t, name});
    return hits.size() < first_hits;
  });
  return hits;
}

/// The ratio of the number of nodes to that of a tree with full nodes, if all have the minimum number of entries.
constexpr double scarcely_filled = static_cast<double>(block_size) / bvh_least;

/// Each box is found, each ray finds what it must, and neither visits many more nodes than in a tree that was built in
/// bulk, whose nodes are full: grown nodes are two thirds full, except for sequences that leave each node as soon as it
/// is split.
template <Dim N>
void expect_as_good_as_new(const HeldIn<N>& held, double most = 2) {
  std::vector<Aabb<N>> boxes;
  std::vector<std::uint32_t> slots;
  for (const auto& [slot, box] : held.boxes) {
    boxes.push_back(box);
    slots.push_back(slot);
  }
  BvhTree<N, float> fresh(0);
  fresh.fill(boxes, slots, serial_executor());
  test::Effort queries;
  test::Effort fresh_queries;
  for (std::size_t k = 0; k < boxes.size(); k += 1 + (boxes.size() * boxes.size() >> 18U)) {
    const test::Effort effort = test::effort_of(held.tree, boxes[k]);
    const test::Effort fresh_effort = test::effort_of(fresh, boxes[k]);
    EXPECT_GE(effort.found, 1U);
    EXPECT_EQ(effort.found, fresh_effort.found);
    queries.looks += effort.looks;
    fresh_queries.looks += fresh_effort.looks;
  }
  EXPECT_LE(static_cast<double>(queries.looks), most * static_cast<double>(fresh_queries.looks));
  std::size_t looks = 0;
  std::size_t fresh_looks = 0;
  for (const Ray<N>& ray : test::rays_at(boxes, fresh.bounds())) {
    EXPECT_EQ(hits_by_tree(held.tree, ray), hits_by_all(held, ray));
    looks += test::looks_along(held.tree, ray);
    fresh_looks += test::looks_along(fresh, ray);
  }
  EXPECT_LE(static_cast<double>(looks), scarcely_filled * static_cast<double>(fresh_looks));
}

// ---- Sequences that make naive trees tall

/// The height may be 1 + log(n / 2) / log(6), which the inspection checks.
template <Dim N>
void expect_low_and_good(const HeldIn<N>& held, const std::string& sequence) {
  SCOPED_TRACE(sequence);
  EXPECT_EQ(held.inspect().fault(), "");
  expect_as_good_as_new(held, scarcely_filled);
}

constexpr std::uint32_t many = 4096;

template <Dim N>
void insert_in_any_order() {
  using Cube = Aabb<N>;
  const auto insert_all = [](const std::string& sequence, const auto& box_of) {
    HeldIn<N> held;
    for (std::uint32_t k = 0; k < many; ++k) held.set(k, box_of(k));
    expect_low_and_good(held, sequence);
  };
  insert_all("ascending", [](std::uint32_t k) { return unit_cube<N>(2.0 * k, 0); });
  insert_all("descending", [](std::uint32_t k) { return unit_cube<N>(-2.0 * k, 0); });
  insert_all("equal", [](std::uint32_t) { return unit_cube<N>(3, 4); });
  insert_all("points", [](std::uint32_t) { return Cube{Vec<N>(3), Vec<N>(3)}; });
  insert_all("ever larger", [](std::uint32_t k) { return Cube{Vec<N>(0), Vec<N>(static_cast<float>(k))}; });
  insert_all("ever smaller", [](std::uint32_t k) { return Cube{Vec<N>(0), Vec<N>(static_cast<float>(many - k))}; });
  insert_all("doubling distances", [](std::uint32_t k) {
    const float place = std::ldexp(1.0F, static_cast<int>(k % 120));
    return Cube{Vec<N>(place), Vec<N>(place * 1.25F)};
  });
  insert_all("back and forth", [](std::uint32_t k) { return unit_cube<N>(k % 2 == 0 ? 2.0 * k : -2.0 * k, 0); });
}

TEST(BvhTree, StaysLowAndGoodInAnyOrderOfInsertion) {
  insert_in_any_order<2>();
  insert_in_any_order<3>();
}

template <Dim N>
void move_all_to_one_side() {
  HeldIn<N> held;
  for (std::uint32_t k = 0; k < many; ++k) {
    const std::uint32_t row = k / 64;
    held.set(k, unit_cube<N>(2 * (k % 64), 2 * row));
  }
  for (std::uint32_t k = 0; k < many; ++k) held.set(k, unit_cube<N>(1e5 + 2.0 * k, 0));
  expect_low_and_good(held, "all moved away in a row");
  for (std::uint32_t k = 0; k < many; ++k) held.set(k, unit_cube<N>(-7, -7));
  expect_low_and_good(held, "all moved to one position");
}

TEST(BvhTree, StaysLowAndGoodWhenAllMoveToOneSide) {
  move_all_to_one_side<2>();
  move_all_to_one_side<3>();
}

TEST(BvhTree, StaysLowAndGoodWhenOneSideIsErased) {
  Held held;
  for (std::uint32_t k = 0; k < many; ++k) held.set(k, unit_square(2.0 * k, 0));
  for (std::uint32_t k = many; k-- > many / 64;) {
    held.erase(k);
    if ((k & (k - 1)) == 0) expect_low_and_good(held, "erased from the top to " + std::to_string(k));
  }
}

/// Boxes in every third slot, built in bulk; every hundredth has an infinite side.
Held held_at_once(std::uint32_t count) {
  Held held;
  std::vector<Box> boxes;
  std::vector<std::uint32_t> slots;
  std::vector<std::uint32_t> generations;
  for (std::uint32_t k = 0; k < count; ++k) {
    Box box = unit_square(k * 37 % 101, k * 59 % 97);
    if (k % 100 == 99) box.max.x = std::numeric_limits<float>::infinity();
    slots.push_back(3 * k);
    boxes.push_back(box);
    held.boxes[3 * k] = box;
    generations.resize(3 * k + std::size_t{1});
    held.generations[3 * k] = generations.back() = ++held.inserted;
  }
  held.tree.fill(boxes, slots, serial_executor(), generations);
  return held;
}

TEST(BvhTree, AnyChangeMayBeTheFirstAfterAllWereBuiltAtOnce) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const std::vector<std::function<void(Held&)>> changes = {
      [](Held& held) { held.set(1, unit_square(3, 4)); },
      [](Held& held) { held.set(1, {{0, 0}, {1, infinity}}); },
      [](Held& held) { held.set(0, unit_square(0.5, 0.5)); },
      [](Held& held) { held.set(0, unit_square(1e6, 1e6)); },
      [](Held& held) { held.set(0, {{0, 0}, {1, infinity}}); },
      [](Held& held) { held.erase(0); },
      [](Held& held) { held.erase(held.boxes.rbegin()->first); },
  };
  for (const std::uint32_t count : {1U, 2U, 16U, 17U, 100U, 300U, 5000U}) {
    const Held built = held_at_once(count);
    for (std::size_t first = 0; first < changes.size(); ++first) {
      SCOPED_TRACE(std::to_string(count) + " boxes, change " + std::to_string(first));
      Held held = built;
      for (const auto& [slot, box] : held.boxes) held.tree.prefetch_node(slot);
      changes[first](held);
      EXPECT_EQ(held.inspect().fault(), "");
      for (std::uint32_t slot = 0; slot < 3 * count; slot += 6) {
        if (held.boxes.count(slot) > 0) held.erase(slot);
      }
      EXPECT_EQ(held.inspect().fault(), "");
      while (!held.boxes.empty()) held.erase(held.boxes.begin()->first);
      EXPECT_TRUE(held.tree.root().is_none());
    }
  }
}

TEST(BvhTree, StaysAsGoodAsNewWhileEverythingDrifts) {
  constexpr std::uint32_t count = 400;
  Held held;
  test::Numbers numbers(13);
  for (std::uint32_t k = 0; k < count; ++k) held.set(k, unit_square(numbers.between(0, 80), numbers.between(0, 80)));
  for (int frame = 0; frame < 300; ++frame) {
    for (std::uint32_t k = 0; k < count; ++k) {
      const Vec<2> step = numbers.point<2, float>(-0.3, 0.3);
      held.set(k, {held.boxes[k].min + step, held.boxes[k].max + step});
    }
    if (frame % 100 == 99) {
      EXPECT_EQ(held.inspect().fault(), "");
      expect_as_good_as_new(held);
    }
  }
}

TEST(BvhTree, StaysAsGoodAsNewWhileEverythingJumpsAbout) {
  constexpr std::uint32_t count = 400;
  Held held;
  test::Numbers numbers(17);
  for (std::uint32_t call = 0; call < 10 * count; ++call) {
    held.set(call % count, unit_square(numbers.between(0, 80), numbers.between(0, 80)));
  }
  EXPECT_EQ(held.inspect().fault(), "");
  expect_as_good_as_new(held);
}

/// Nothing is lost, and memory does not grow.
template <Dim N>
void erase_and_insert_all(std::size_t rounds) {
  constexpr std::uint32_t count = 256;
  HeldIn<N> held;
  test::Numbers numbers(11);
  const auto place = [&numbers] { return unit_cube<N>(numbers.between(0, 64), numbers.between(0, 64)); };
  for (std::uint32_t k = 0; k < count; ++k) held.set(k, place());
  for (std::uint32_t round = 0; round < rounds; ++round) {
    for (std::uint32_t k = 0; k < count; ++k) held.erase((k * 37 + round) % count);
    EXPECT_EQ(held.tree.spare_nodes(), 0U);
    for (std::uint32_t k = 0; k < count; ++k) held.set((k * 101 + round) % count, place());
    if (round % 50 != 0) continue;
    EXPECT_LE(held.tree.spare_nodes() + held.inspect().nodes(), count / 5 + 1);  // n / 6 + n / 36 + ...
    expect_as_good_as_new(held);
  }
  EXPECT_EQ(held.inspect().fault(), "");
  expect_as_good_as_new(held);
}

TEST(BvhTree, StaysAsGoodAsNewThroughManyRoundsOfErasingAndInserting) {
  erase_and_insert_all<2>(test::number_of_cases(1000));
  erase_and_insert_all<3>(test::number_of_cases(300));
}

/// Insertions, moves and removals forever neither increase the memory nor leak nodes.
TEST(BvhTree, HoldsNoMoreAfterAHundredThousandCalls) {
  Held held(0.25);
  test::Numbers numbers(3);
  std::size_t bytes = 0;
  std::size_t most = 0;
  for (std::uint32_t call = 0; call < 100'000; ++call) {
    const std::uint32_t slot = static_cast<std::uint32_t>(numbers.between(0, 400));
    if (held.boxes.count(slot) != 0 && numbers.between(0, 3) < 1) {
      held.erase(slot);
    } else {
      held.set(slot, unit_square(numbers.between(0, 30), numbers.between(0, 30)));
    }
    most = std::max(most, held.boxes.size());
    if (call % 10'000 == 9'999) {
      const Inspection inspection = held.inspect();
      ASSERT_EQ(inspection.fault(), "");
      EXPECT_LE(inspection.nodes() + held.tree.spare_nodes(), most / 5 + 1);  // n / 6 + n / 36 + ...
    }
    if (call == 20'000) bytes = held.tree.bytes();
  }
  EXPECT_LE(held.tree.bytes(), 2 * bytes);
  while (!held.boxes.empty()) held.erase(held.boxes.begin()->first);
  EXPECT_TRUE(held.tree.root().is_none());
  EXPECT_EQ(held.tree.spare_nodes(), 0U);
}

/// Boxes inserted and erased where a node is full, and where it has the minimum number of entries.
TEST(BvhTree, IsSoundWhereNodesAreFullOrHaveJustEnough) {
  for (const std::uint32_t count : {1U, 2U, 6U, 7U, 16U, 17U, 18U, 96U, 97U, 256U, 257U, 258U}) {
    Held held;
    for (std::uint32_t k = 0; k < count; ++k) held.set(k, unit_square(2.0 * k, k % 3));
    for (std::uint32_t round = 0; round < 20; ++round) {
      held.erase(round % count);
      ASSERT_EQ(held.inspect().fault(), "") << count;
      held.set(round % count, unit_square(3.0 * round, 1));
      ASSERT_EQ(held.inspect().fault(), "") << count;
    }
    while (!held.boxes.empty()) {
      held.erase(held.boxes.begin()->first);
      ASSERT_EQ(held.inspect().fault(), "") << count;
    }
  }
}

}  // namespace
}  // namespace graze::detail::bvh_tree_test
