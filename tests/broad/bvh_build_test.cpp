// SPDX-License-Identifier: MIT
// Which tree comes out; that it is one, bvh_tree_test.cpp says too.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/broad/bvh_build.hpp>
#include <graze/broad/bvh_tree.hpp>

#include "box_worlds.hpp"
#include "bvh_checks.hpp"
#include "thread_executor.hpp"

namespace graze::detail::bvh_build_test {
namespace {

/// A tree of its own, with nodes 1 and up below place 0.
template <Dim N, class T>
struct Built {
  std::vector<BvhNode<N, T>> nodes;
  std::vector<std::uint32_t> places;

  Built(std::vector<BvhLeaf<N, T>> leaves, const Executor& executor)
      : nodes(std::max<std::size_t>(leaves.size(), 1)), places(leaves.size()) {
    std::vector<std::uint32_t> indices(leaves.size() - 1);
    std::iota(indices.begin(), indices.end(), std::uint32_t{1});
    BvhBuilder<N, T>(nodes.data(), indices, places.data(), executor).build(leaves, 0);
  }

  bool operator==(const Built& other) const {
    return places == other.places && std::equal(nodes.begin(), nodes.end(), other.nodes.begin(), other.nodes.end(),
                                                [](const auto& a, const auto& b) {
                                                  return a.boxes == b.boxes && a.children == b.children &&
                                                         a.place == b.place && a.count == b.count;
                                                });
  }
};

template <Dim N, class T>
std::vector<BvhLeaf<N, T>> leaves_of(const std::vector<Aabb<N, T>>& boxes) {
  std::vector<BvhLeaf<N, T>> leaves;
  for (const Aabb<N, T>& box : boxes) {
    if (is_valid(box)) leaves.push_back({box, static_cast<std::uint32_t>(leaves.size())});
  }
  return leaves;
}

Aabb<2> unit_square(float x, float y) { return {{x, y}, {x + 1, y + 1}}; }

TEST(BvhBuild, PartsWhatLiesApart) {
  // Three near 0 and two near 100: an even split would tear the three apart.
  const Built<2, float> tree(leaves_of<2, float>({unit_square(0, 0), unit_square(100, 0), unit_square(0, 2),
                                                  unit_square(2, 0), unit_square(100, 2)}),
                             serial_executor());
  ASSERT_EQ(tree.nodes[0].children[0], BvhChild::node(1));
  EXPECT_EQ(tree.nodes[1].boxes[0], (Aabb<2>{{0, 0}, {3, 3}}));
  EXPECT_EQ(tree.nodes[1].boxes[1], (Aabb<2>{{100, 0}, {101, 3}}));
  EXPECT_EQ(tree.nodes[1].count, 5U);
  EXPECT_EQ(tree.nodes[1].children[0], BvhChild::node(2));
  EXPECT_EQ(tree.nodes[1].children[1], BvhChild::node(4));  // behind the two nodes of the three
  EXPECT_EQ(tree.nodes[4].children[0], BvhChild::leaf(1));
  EXPECT_EQ(tree.places[1], 8U);
}

TEST(BvhBuild, HangsASingleLeafInThePlaceItself) {
  const Built<2, float> tree(leaves_of<2, float>({unit_square(3, 4)}), serial_executor());
  EXPECT_EQ(tree.nodes[0].children[0], BvhChild::leaf(0));
  EXPECT_EQ(tree.nodes[0].boxes[0], unit_square(3, 4));
  EXPECT_EQ(tree.places[0], 0U);
}

TEST(BvhBuild, GivesNoSideMoreThanTwoThirdsOfMany) {
  const auto worlds = test::box_worlds<3, float>(2000, 5);
  for (const auto& world : worlds) {
    const Built<3, float> tree(leaves_of(world.boxes), serial_executor());
    const auto count = [&tree](BvhChild child) { return child.is_leaf() ? 1 : tree.nodes[child.index()].count; };
    for (std::size_t k = 1; k < tree.nodes.size(); ++k) {
      const BvhNode<3, float>& node = tree.nodes[k];
      const std::uint32_t larger = std::max(count(node.children[0]), count(node.children[1]));
      EXPECT_TRUE(node.count <= 12 || 3 * larger <= 2 * node.count)
          << world.name << ": " << larger << " of " << node.count;
    }
  }
}

/// What hangs where follows from the boxes and their slots.
template <Dim N, class T>
void expect_the_same_tree(std::size_t count) {
  for (const auto& world : test::box_worlds<N, T>(count, 3)) {
    std::vector<BvhLeaf<N, T>> leaves = leaves_of(world.boxes);
    const Built<N, T> expected(leaves, serial_executor());
    EXPECT_TRUE((Built<N, T>(leaves, test::ThreadExecutor(3)) == expected)) << world.name;
    std::reverse(leaves.begin(), leaves.end());
    std::rotate(leaves.begin(), leaves.begin() + 17, leaves.end());
    EXPECT_TRUE((Built<N, T>(leaves, serial_executor()) == expected)) << world.name << " in another order";
  }
}

TEST(BvhBuild, DependsNeitherOnThreadsNorOnTheOrderOfTheLeaves) {
  expect_the_same_tree<3, float>(10'000);
  expect_the_same_tree<2, double>(5'000);
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
