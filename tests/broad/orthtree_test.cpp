// SPDX-License-Identifier: MIT
// The cells: where they split and merge, and what happens to boxes that do not fit. spatial_index_laws.hpp compares
// answers with those of BruteForce.
#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/orthtree.hpp>

namespace graze::orthtree_test {
namespace {

using Cell2 = OrthtreeCell<2, float>;

template <Dim N, class T>
std::vector<OrthtreeCell<N, T>> cells_of(const Orthtree<N, T>& tree) {
  std::vector<OrthtreeCell<N, T>> cells;
  tree.visit_cells([&cells](const auto& cell) { cells.push_back(cell); });
  return cells;
}

std::size_t boxes_in(const std::vector<Cell2>& cells) {
  std::size_t count = 0;
  for (const Cell2& cell : cells) count += cell.count;
  return count;
}

int depth_of(const std::vector<Cell2>& cells) {
  int depth = -1;
  for (const Cell2& cell : cells) depth = std::max(depth, cell.depth);
  return depth;
}

/// A box of the given size at a position of a square lattice with this many positions along its side.
Aabb<2> at(int k, int side, float size = 0.25F) {
  const int column = k % side;
  const int row = k / side;
  return Aabb<2>::from_center({static_cast<float>(column), static_cast<float>(row)}, Vec<2>(size / 2));
}

TEST(Orthtree, SplitsAtItsCapacityAndTellsItsCells) {
  QuadTree<> tree({.capacity = 4, .max_depth = 8});
  for (int k = 0; k < 4; ++k) tree.insert(at(k, 2));
  EXPECT_TRUE(cells_of(tree).empty());  // too few for a root
  tree.insert(at(3, 2));
  const std::vector<Cell2> cells = cells_of(tree);
  ASSERT_EQ(cells.size(), 5U);
  EXPECT_EQ(cells[0].box, (Aabb<2>{{-0.125F, -0.125F}, {1.125F, 1.125F}}));
  EXPECT_FALSE(cells[0].is_leaf);
  EXPECT_EQ(cells[1].box, (Aabb<2>{{-0.125F, -0.125F}, {0.5F, 0.5F}}));
  EXPECT_EQ(cells[2].box, (Aabb<2>{{0.5F, -0.125F}, {1.125F, 0.5F}}));
  EXPECT_EQ(cells[4].count, 2U);
  EXPECT_EQ(boxes_in(cells), 5U);
}

TEST(Orthtree, MergesCellsThatEmpty) {
  QuadTree<> tree({.capacity = 4, .max_depth = 8});
  std::vector<Key> keys;
  for (int k = 0; k < 256; ++k) keys.push_back(tree.insert(at(k, 16)));
  EXPECT_GE(cells_of(tree).size(), 85U);  // 64 leaves and those above
  for (std::size_t k = 2; k < keys.size(); ++k) tree.erase(keys[k]);
  EXPECT_EQ(cells_of(tree).size(), 1U);
  EXPECT_EQ(cells_of(tree)[0].count + tree.outside(), 2U);
}

TEST(Orthtree, NeverGoesBeyondItsDepth) {
  for (const int max_depth : {0, 1, 3, 32}) {
    QuadTree<> tree({.capacity = 1, .max_depth = max_depth});
    for (int k = 0; k < 100; ++k) tree.insert({{1, 1}, {1, 1}});  // nothing separates these
    for (int k = 0; k < 100; ++k) tree.insert(at(k, 10));
    for (int k = 0; k < 10; ++k) tree.insert(at(k, 1000, 1));
    EXPECT_LE(depth_of(cells_of(tree)), max_depth);
    EXPECT_EQ(count(tree, Vec<2>(1, 1)), 101U);
    EXPECT_EQ(boxes_in(cells_of(tree)) + tree.outside(), 210U);
  }
}

TEST(Orthtree, RefusesSettingsByName) {
  try {
    QuadTree<> tree({.capacity = 0});
    FAIL() << "no error";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()), "Orthtree: capacity is 0; it must be at least 1");
  }
  try {
    Octree<double> tree({.max_depth = 40});
    FAIL() << "no error";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()), "Orthtree: max_depth is 40; it must be from 0 to 32");
  }
}

TEST(Orthtree, FindsWhatIsOnBordersLargerThanCellsAndEqual) {
  QuadTree<> tree({.capacity = 2, .max_depth = 10});
  for (int k = 0; k < 400; ++k) tree.insert(at(k, 20));
  std::vector<Key> twins;
  const Aabb<2> cross{{9.4F, 9.4F}, {9.6F, 9.6F}};  // about the root's center, on the border of four cells
  for (int k = 0; k < 30; ++k) twins.push_back(tree.insert(cross));
  const Key floor = tree.insert({{-1, -1}, {20, 20}});
  std::vector<Key> found;
  tree.query(Vec<2>(9.5F, 9.5F), [&found](Key key) { found.push_back(key); });
  std::sort(found.begin(), found.end());
  std::vector<Key> expected = twins;
  expected.push_back(floor);
  EXPECT_EQ(found, expected);
}

TEST(Orthtree, ItsRootGrowsWithTheWorld) {
  QuadTree<> tree;
  for (int k = 0; k < 100; ++k) tree.insert(at(k, 10));
  const Aabb<2> before = cells_of(tree)[0].box;
  for (int k = 0; k < 100; ++k) tree.insert({{100.0F + static_cast<float>(k), 5}, {100.5F + static_cast<float>(k), 6}});
  const Aabb<2> after = cells_of(tree)[0].box;
  EXPECT_GT(after.max.x - after.min.x, before.max.x - before.min.x);
  EXPECT_EQ(tree.outside(), 0U);
  EXPECT_EQ(count(tree, Aabb<2>{{99, 0}, {500, 9}}), 100U);
}

TEST(Orthtree, KeepsWhatIsFarOffOrInfiniteInAList) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  QuadTree<> tree({.capacity = 4});
  for (int k = 0; k < 1000; ++k) tree.insert(at(k, 32));
  const Key far = tree.insert({{1e30F, 1e30F}, {2e30F, 1e30F}});
  const Key strip = tree.insert({{-infinity, 3}, {infinity, 4}});
  EXPECT_EQ(tree.outside(), 2U);
  EXPECT_GT(cells_of(tree).size(), 100U);  // the distant one does no harm
  EXPECT_EQ(count(tree, Vec<2>(1.5e30F, 1e30F)), 1U);
  EXPECT_EQ(tree.nearest({1e30F, 9e29F}, 1)[0].key, far);
  tree.update(far, at(5, 32));
  tree.update(strip, at(6, 32));
  EXPECT_EQ(tree.outside(), 0U);
}

TEST(Orthtree, FollowsAWorldThatMovesAwayOrShrinks) {
  QuadTree<> tree({.capacity = 8, .max_depth = 6});
  std::vector<Key> keys;
  for (int k = 0; k < 4096; ++k) keys.push_back(tree.insert(at(k, 64)));
  const auto fullest = [&tree] {
    std::size_t most = tree.outside();
    for (const Cell2& cell : cells_of(tree)) most = std::max(most, cell.count);
    return most;
  };
  EXPECT_LE(fullest(), 8U);
  for (int frame = 0; frame < 3; ++frame) {  // far beyond what six levels can bridge
    for (int k = 0; k < 4096; ++k) {
      Aabb<2> box = at(k, 64);
      box.min += 1e5F;
      box.max += 1e5F;
      tree.update(keys[static_cast<std::size_t>(k)], box);
    }
  }
  EXPECT_LE(fullest(), 64U);
  for (int frame = 0; frame < 3; ++frame) {
    for (int k = 0; k < 4096; ++k) {
      const Aabb<2> box = at(k, 64);
      tree.update(keys[static_cast<std::size_t>(k)], {box.min * 1e-3F, box.max * 1e-3F});
    }
  }
  EXPECT_LE(fullest(), 64U);
  EXPECT_EQ(count(tree, Aabb<2>::everything()), 4096U);
}

TEST(Orthtree, AnOctreesCellsHaveEightChildren) {
  Octree<double> tree({.capacity = 1, .max_depth = 1});
  for (int k = 0; k < 8; ++k) {
    const Vec<3, double> corner(k & 1, k >> 1 & 1, k >> 2);
    tree.insert({corner, corner});
  }
  const auto cells = cells_of(tree);
  ASSERT_EQ(cells.size(), 9U);
  for (std::size_t k = 1; k < 9; ++k) EXPECT_EQ(cells[k].count, 1U);
  int visits = 0;
  tree.visit_cells([&visits](const auto&) { return ++visits < 3; });
  EXPECT_EQ(visits, 3);
}

TEST(Orthtree, SaysHowMuchMemoryItHolds) {
  QuadTree<> tree;
  for (int k = 0; k < 10000; ++k) tree.insert(at(k, 100));
  EXPECT_LT(tree.bytes(), std::size_t{10000} * 200);
  EXPECT_GT(tree.bytes(), std::size_t{10000} * 20);
}

}  // namespace
}  // namespace graze::orthtree_test
