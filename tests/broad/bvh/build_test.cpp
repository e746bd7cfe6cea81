// SPDX-License-Identifier: MIT
// Tests which tree is built; bvh_tree_test.cpp tests that it is valid.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/broad/bvh/build.hpp>
#include <graze/broad/bvh/tree.hpp>

#include "broad/box_worlds.hpp"
#include "broad/bvh_checks.hpp"
#include "broad/thread_executor.hpp"
#include "number_of_cases.hpp"

namespace graze::detail::bvh_build_test {
namespace {

TEST(BvhPlan, HasAsFewNodesAsThereCanBeAndSharesEntriesEvenly) {
  for (const std::size_t boxes : {1U, 15U, 16U, 17U, 256U, 257U, 4096U, 4097U, 100'000U}) {
    const BvhPlan plan(boxes);
    std::size_t below = boxes;
    std::size_t nodes = 0;
    for (std::size_t level = 0; level < plan.height(); ++level) {
      const std::size_t here = (below + block_size - 1) / block_size;
      EXPECT_EQ(plan.index(level, 0), nodes);
      std::size_t next = 0;
      for (std::size_t k = 0; k < here; ++k) {
        EXPECT_EQ(plan.first_entry(level, k), next);
        next = plan.first_entry(level, k + 1);
        const std::size_t entries = next - plan.first_entry(level, k);
        ASSERT_LE(entries, block_size);
        ASSERT_GE(entries, below / here);
        ASSERT_TRUE(here == 1 || entries >= bvh_least);
      }
      EXPECT_EQ(next, below);
      EXPECT_EQ(plan.first_box(level, here), boxes);
      nodes += here;
      below = here;
    }
    EXPECT_EQ(below, 1U);
    EXPECT_EQ(plan.nodes(), nodes);
    EXPECT_EQ(plan.leaf_nodes(), plan.height() == 1 ? 1U : plan.index(1, 0));
  }
}

/// A tree with its own memory.
template <Dim N, class T>
struct Built {
  BvhPlan plan;
  std::vector<BvhNode<N, T>> nodes;
  std::vector<BvhPlace> places;

  Built(const std::vector<Aabb<N, T>>& boxes, const std::vector<std::uint32_t>& slots, const Executor& executor)
      : plan(slots.size()), nodes(plan.nodes()), places(plan.nodes()) {
    build_bvh<N, T>(slots, 0, plan, {boxes.data(), nodes.data(), places.data()}, executor);
  }

  /// Bit-identical, including lanes without an entry.
  bool operator==(const Built& other) const {
    return nodes.size() == other.nodes.size() &&
           std::memcmp(nodes.data(), other.nodes.data(), nodes.size() * sizeof(nodes[0])) == 0 &&
           std::equal(places.begin(), places.end(), other.places.begin(),
                      [](const auto& a, const auto& b) { return a.parent == b.parent && a.count == b.count; });
  }
};

Aabb<2> unit_square(float x, float y) { return {{x, y}, {x + 1, y + 1}}; }

TEST(BvhBuild, PartsWhatLiesApart) {
  std::vector<Aabb<2>> boxes;
  std::vector<std::uint32_t> slots;
  for (std::uint32_t k = 0; k < 32; ++k) {
    boxes.push_back(unit_square(k % 2 == 0 ? 0.0F : 100.0F, static_cast<float>(k)));
    slots.push_back(31 - k);
  }
  const Built<2, float> tree(boxes, slots, serial_executor());
  ASSERT_EQ(tree.nodes.size(), 3U);
  EXPECT_EQ(box_in(tree.nodes[2].boxes, 0), (Aabb<2>{{0, 0}, {1, 31}}));
  EXPECT_EQ(box_in(tree.nodes[2].boxes, 1), (Aabb<2>{{100, 1}, {101, 32}}));
  EXPECT_EQ(tree.nodes[2].entries[0], BvhLink::leaf(0).code());
  EXPECT_EQ(tree.nodes[0].entries[3], 6U);  // by slot
  EXPECT_EQ(box_in(tree.nodes[0].boxes, 3), boxes[6]);
  EXPECT_EQ(tree.places[0].parent, 2U);
  EXPECT_EQ(tree.places[0].count, 16U);
  EXPECT_EQ(tree.places[2].parent, no_box);
  EXPECT_EQ(tree.places[2].count, 2U);
}

/// The structure follows from the boxes and their slots.
template <Dim N, class T>
void expect_the_same_tree(std::size_t count) {
  for (const auto& world : test::box_worlds<N, T>(count, 3)) {
    std::vector<std::uint32_t> slots;
    for (std::uint32_t k = 0; k < world.boxes.size(); ++k) {
      if (is_valid(world.boxes[k])) slots.push_back(k);
    }
    const Built<N, T> expected(world.boxes, slots, serial_executor());
    EXPECT_TRUE((Built<N, T>(world.boxes, slots, test::ThreadExecutor(3)) == expected)) << world.name;
    std::reverse(slots.begin(), slots.end());
    std::rotate(slots.begin(), slots.begin() + 17, slots.end());
    EXPECT_TRUE((Built<N, T>(world.boxes, slots, serial_executor()) == expected)) << world.name << " in another order";
  }
}

TEST(BvhBuild, DependsNeitherOnThreadsNorOnTheOrderOfTheSlots) {
  expect_the_same_tree<3, float>(10'000);
  expect_the_same_tree<2, double>(5'000);
}

/// The slots below some nodes of a level, in the order of the boxes' centers along an axis.
template <Dim N, class T>
class BuiltTree {
 public:
  BuiltTree(const Built<N, T>& tree, const std::vector<Aabb<N, T>>& boxes) : tree_(tree), boxes_(boxes) {}

  /// Splits the boxes of nodes that are entries of one node by sorting, according to the contract of build_bvh.
  void expect_parted(std::size_t level, std::size_t first, std::size_t last, Aabb<N, T> bounds) const {
    if (last - first == 1) return level > 0 ? expect_parted(level, first) : void();
    Dim axis = 0;
    for (Dim i = 1; i < N; ++i) {
      if (bounds.max[i] - bounds.min[i] > bounds.max[axis] - bounds.min[axis]) axis = i;
    }
    const std::size_t middle = (first + last) / 2;
    std::vector<std::uint32_t> sorted = slots(level, first, last);
    std::sort(sorted.begin(), sorted.end(), [&](std::uint32_t a, std::uint32_t b) {
      const T at_a = boxes_[a].center()[axis];
      const T at_b = boxes_[b].center()[axis];
      return at_a != at_b ? at_a < at_b : a < b;
    });
    const std::vector<std::uint32_t> low = slots(level, first, middle);
    const std::vector<std::uint32_t> expected(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(low.size()));
    ASSERT_TRUE(std::is_permutation(low.begin(), low.end(), expected.begin()));
    Aabb<N, T> upper = bounds;
    bounds.max[axis] = upper.min[axis] = boxes_[sorted[low.size()]].center()[axis];
    expect_parted(level, first, middle, bounds);
    expect_parted(level, middle, last, upper);
  }

  /// The entries of a node.
  void expect_parted(std::size_t level, std::size_t node) const {
    Aabb<N, T> bounds = Aabb<N, T>::nothing();
    for (const std::uint32_t slot : slots(level, node, node + 1)) bounds.grow(boxes_[slot].center());
    expect_parted(level - 1, tree_.plan.first_entry(level, node), tree_.plan.first_entry(level, node + 1), bounds);
  }

 private:
  std::vector<std::uint32_t> slots(std::size_t level, std::size_t first, std::size_t last) const {
    for (; level > 0; --level) {
      first = tree_.plan.first_entry(level, first);
      last = tree_.plan.first_entry(level, last);
    }
    std::vector<std::uint32_t> result;
    for (; first < last; ++first) {
      const std::uint32_t* const entries = tree_.nodes[first].entries;
      EXPECT_TRUE(std::is_sorted(entries, entries + tree_.places[first].count));
      result.insert(result.end(), entries, entries + tree_.places[first].count);
    }
    return result;
  }

  const Built<N, T>& tree_;
  const std::vector<Aabb<N, T>>& boxes_;
};

TEST(BvhBuild, PartsAsSortingDoes) {
  for (const std::size_t count : {std::size_t{300}, test::number_of_cases(6000, 1200)}) {
    for (const auto& world : test::box_worlds<3, float>(count, 7)) {
      SCOPED_TRACE(world.name);
      std::vector<std::uint32_t> slots;
      for (std::uint32_t k = 0; k < world.boxes.size(); ++k) {
        if (is_valid(world.boxes[k])) slots.push_back(k);
      }
      const Built<3, float> tree(world.boxes, slots, serial_executor());
      BuiltTree<3, float>(tree, world.boxes).expect_parted(tree.plan.height() - 1, 0);
    }
  }
}

TEST(BvhBuild, MakesASoundTreeOfEveryWorld) {
  for (const std::size_t count : {100U, 1000U, 5000U}) {
    for (const auto& world : test::box_worlds<3, float>(count, 9)) {
      std::map<std::uint32_t, Aabb<3>> expected;
      std::vector<std::uint32_t> slots;
      for (std::uint32_t k = 0; k < world.boxes.size(); ++k) {
        slots.push_back(k);
        expected[k] = world.boxes[k];
      }
      BvhTree<3, float> tree(0.5);
      tree.fill(world.boxes, slots, serial_executor());
      EXPECT_EQ((test::BvhInspection<3, float>(tree, expected).fault()), "") << world.name;
    }
  }
}

RC_GTEST_PROP(BvhBuild, MakesASoundTreeOfAnyBoxes, ()) {
  const auto number = rc::gen::inRange(0, 30);
  const auto rows = *rc::gen::scale(
      5.0, rc::gen::container<std::vector<std::vector<int>>>(rc::gen::container<std::vector<int>>(4, number)));
  std::map<std::uint32_t, Aabb<2>> expected;
  std::vector<Aabb<2>> boxes;
  std::vector<std::uint32_t> slots;
  for (const std::vector<int>& row : rows) {
    const Vec<2> low(row[0], row[1]);
    slots.push_back(static_cast<std::uint32_t>(3 * boxes.size()));
    boxes.push_back({low, low + Vec<2>(row[2] % 5, row[3] % 5)});
    expected[slots.back()] = boxes.back();
  }
  BvhTree<2, float> tree(0);
  tree.fill(boxes, slots, serial_executor());
  RC_ASSERT((test::BvhInspection<2, float>(tree, expected).fault()) == "");
}

}  // namespace
}  // namespace graze::detail::bvh_build_test
