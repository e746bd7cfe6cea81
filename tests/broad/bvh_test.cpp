// SPDX-License-Identifier: MIT
// Features of Bvh beyond those of other indexes. spatial_index_laws.hpp compares its answers with those of BruteForce.
#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/brute_force.hpp>
#include <graze/broad/bvh.hpp>
#include <graze/shape/sphere.hpp>

#include "box_worlds.hpp"
#include "thread_executor.hpp"

namespace graze::bvh_test {
namespace {

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
std::vector<std::pair<std::uint32_t, double>> nearest(const Index& index, const Vec<3>& point, std::size_t k) {
  std::vector<std::pair<std::uint32_t, double>> result;
  for (const Neighbour& neighbour : index.nearest(point, k)) {
    result.emplace_back(neighbour.key.index, neighbour.distance_squared);
  }
  return result;
}

std::vector<Aabb<3>> some_boxes(std::size_t count, std::uint64_t seed) {
  test::Numbers numbers(seed);
  std::vector<Aabb<3>> boxes;
  for (std::size_t k = 0; k < count; ++k) {
    const auto size = static_cast<float>(k % 50 == 0 ? numbers.between(1, 30) : numbers.between(0, 1));
    const Vec<3> low = numbers.point<3, float>(0, 40);
    boxes.push_back({low, low + size});
  }
  boxes[count / 2].max.y = std::numeric_limits<float>::infinity();
  return boxes;
}

/// Asks both the same queries and expects the same answers.
void expect_agreement(const Bvh<3>& bvh, const BruteForce<3>& judge, std::uint64_t seed) {
  test::Numbers numbers(seed);
  for (int question = 0; question < 40; ++question) {
    const Vec<3> a = numbers.point<3, float>(-5, 45);
    const Vec<3> b = numbers.point<3, float>(-5, 45);
    EXPECT_EQ(found(bvh, Aabb<3>::from_center(a, Vec<3>(3))), found(judge, Aabb<3>::from_center(a, Vec<3>(3))));
    EXPECT_EQ(found(bvh, Sphere<3>{a, 4}), found(judge, Sphere<3>{a, 4}));
    EXPECT_EQ(hits(bvh, {a, b - a}), hits(judge, {a, b - a}));
    EXPECT_EQ(nearest(bvh, a, 12), nearest(judge, a, 12));
  }
}

TEST(Bvh, AssignGivesKeysInTheOrderOfTheBoxes) {
  Bvh<3> bvh;
  const Key old = bvh.insert({});
  const std::vector<Aabb<3>> boxes = some_boxes(1000, 1);
  const std::vector<Key> keys = bvh.assign(boxes);
  ASSERT_EQ(keys.size(), 1000U);
  EXPECT_EQ(bvh.size(), 1000U);
  EXPECT_FALSE(bvh.contains(old));
  for (std::size_t k = 0; k < keys.size(); ++k) EXPECT_EQ(bvh.box(keys[k]), boxes[k]);
  BruteForce<3> judge;
  for (const Aabb<3>& box : boxes) judge.insert(box);
  expect_agreement(bvh, judge, 2);
  EXPECT_TRUE(bvh.assign({}).empty());
  EXPECT_EQ(bvh.size(), 0U);
  EXPECT_FALSE(bvh.contains(keys[0]));
}

TEST(Bvh, AssignsAgainToPlacesThatWereUsedBefore) {
  Bvh<3> bvh;
  for (const std::size_t count : {700U, 30U, 1U, 2000U}) {
    std::vector<Aabb<3>> boxes = some_boxes(count, count);
    if (count == 30) bvh.clear();
    const std::vector<Key> keys = bvh.assign(boxes);
    ASSERT_EQ(bvh.size(), count);
    for (std::size_t k = 0; k < count; ++k) EXPECT_EQ(bvh.box(keys[k]), boxes[k]);
    for (std::size_t k = 0; k < count; k += 7) {
      std::vector<std::uint32_t> expected;
      for (std::size_t other = 0; other < count; ++other) {
        if (boxes_overlap(boxes[k], boxes[other])) expected.push_back(keys[other].index);
      }
      std::sort(expected.begin(), expected.end());
      EXPECT_EQ(found(bvh, boxes[k]), expected);
    }
  }
}

TEST(Bvh, AnswersInTheSameOrderHoweverManyThreadsBuiltIt) {
  const std::vector<Aabb<3>> boxes = some_boxes(20'000, 3);
  const auto order = [&boxes](const Executor& executor) {
    Bvh<3> bvh;
    bvh.assign(boxes, executor);
    std::vector<std::uint32_t> visited;
    bvh.query(Aabb<3>::everything(), [&visited](Key key) { visited.push_back(key.index); });
    return visited;
  };
  const std::vector<std::uint32_t> expected = order(serial_executor());
  EXPECT_EQ(expected.size(), boxes.size());
  EXPECT_EQ(order(test::ThreadExecutor(2)), expected);
  EXPECT_EQ(order(test::ThreadExecutor(8)), expected);
}

TEST(Bvh, AssignThatFailsChangesNothing) {
  struct Unable final : Executor {
    void parallel_for(std::size_t, const std::function<void(std::size_t)>&) const override {
      throw std::runtime_error("no threads");
    }
    std::size_t concurrency() const override { return 1; }
  };
  Bvh<3> bvh;
  const Key key = bvh.insert({});
  std::vector<Aabb<3>> boxes = some_boxes(10'000, 4);
  EXPECT_THROW(bvh.assign(boxes, Unable()), std::runtime_error);
  boxes[77].min.x = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(bvh.assign(boxes), std::invalid_argument);
  boxes[77] = {{5, 5, 5}, {4, 6, 6}};
  EXPECT_THROW(bvh.assign(boxes), std::invalid_argument);
  EXPECT_EQ(bvh.size(), 1U);
  EXPECT_EQ(bvh.box(key), Aabb<3>{});
  EXPECT_EQ(count(bvh, Vec<3>(0, 0, 0)), 1U);
  bvh.clear();
  boxes = some_boxes(10'000, 4);
  EXPECT_THROW(bvh.assign(boxes, Unable()), std::runtime_error);
  EXPECT_EQ(bvh.size(), 0U);
  EXPECT_EQ(count(bvh, Aabb<3>::everything()), 0U);
  EXPECT_EQ(bvh.assign(boxes).size(), boxes.size());
  EXPECT_EQ(count(bvh, Aabb<3>::everything()), boxes.size());
}

TEST(Bvh, ABoxAssignedIsUpdatedAndErasedLikeAnyOther) {
  Bvh<3> bvh(0.5);  // the margin
  BruteForce<3> judge;
  std::vector<Aabb<3>> boxes = some_boxes(600, 5);
  std::vector<Key> keys = bvh.assign(boxes);
  std::vector<Key> judge_keys;
  for (const Aabb<3>& box : boxes) judge_keys.push_back(judge.insert(box));
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const float step = k % 3 == 0 ? 0.3F : 7.0F;
    boxes[k] = {boxes[k].min + step, boxes[k].max + step};
    bvh.update(keys[k], boxes[k]);
    judge.update(judge_keys[k], boxes[k]);
    if (k % 5 != 0) continue;
    bvh.erase(keys[k]);
    judge.erase(judge_keys[k]);
  }
  expect_agreement(bvh, judge, 6);
  EXPECT_EQ(bvh.options().margin, 0.5);
}

/// Like hours of a game: insert, move, erase and query, until nothing is left.
TEST(Bvh, ASoakLosesNothingAndReturnsToZero) {
  Bvh<3> bvh({.margin = 0.2});
  BruteForce<3> judge;
  std::vector<std::pair<Key, Key>> keys;
  test::Numbers numbers(7);
  for (int call = 0; call < 20'000; ++call) {
    const Vec<3> low = numbers.point<3, float>(0, 40);
    const Aabb<3> box{low, low + static_cast<float>(numbers.between(0, 2))};
    const auto pick = static_cast<std::size_t>(numbers.between(0, 1) * static_cast<double>(keys.size()));
    const double dice = numbers.between(0, 3);
    if (keys.size() < 300 && (dice < 1 || keys.empty())) {
      keys.emplace_back(bvh.insert(box), judge.insert(box));
    } else if (dice < 2 || keys.size() < 100) {
      bvh.update(keys[pick].first, box);
      judge.update(keys[pick].second, box);
    } else {
      bvh.erase(keys[pick].first);
      judge.erase(keys[pick].second);
      keys[pick] = keys.back();
      keys.pop_back();
    }
    if (call % 2000 == 0) expect_agreement(bvh, judge, static_cast<std::uint64_t>(call));
  }
  EXPECT_EQ(bvh.size(), keys.size());
  for (const auto& [key, judge_key] : keys) bvh.erase(key);
  EXPECT_EQ(bvh.size(), 0U);
  EXPECT_EQ(count(bvh, Aabb<3>::everything()), 0U);
}

template <Dim N, class T>
std::vector<BvhCell<N, T>> cells_of(const Bvh<N, T>& tree) {
  std::vector<BvhCell<N, T>> cells;
  tree.visit_cells([&cells](const auto& cell) { cells.push_back(cell); });
  return cells;
}

TEST(Bvh, TellsItsGroupsTheWholeBeforeItsParts) {
  Bvh<2> tree({.margin = 0.5});
  EXPECT_TRUE(cells_of(tree).empty());
  tree.insert({{0, 0}, {1, 1}});
  tree.insert({{10, 0}, {11, 1}});
  tree.insert({{0, 0}, {std::numeric_limits<float>::infinity(), 1}});
  const auto cells = cells_of(tree);
  ASSERT_EQ(cells.size(), 3U);
  EXPECT_EQ(cells[0].count, 2U);
  EXPECT_EQ(cells[0].depth, 0);
  EXPECT_FALSE(cells[0].is_leaf);
  EXPECT_EQ(cells[0].box, (Aabb<2>{{0, 0}, {11, 1}}));
  EXPECT_TRUE(cells[1].is_leaf && cells[2].is_leaf);
  EXPECT_EQ(cells[1].box, (Aabb<2>{{0, 0}, {1, 1}}));
  EXPECT_EQ(cells[2].box, (Aabb<2>{{10, 0}, {11, 1}}));
  EXPECT_EQ(cells[1].count, 1U);
  EXPECT_EQ(cells[1].depth, 1);
}

TEST(Bvh, GroupsCountAndContainWhatIsInThem) {
  for (const double margin : {0.0, 0.25}) {
    Bvh<3> tree({.margin = margin});
    const auto worlds = test::box_worlds<3, float>(1000, 5);
    for (const Aabb<3>& box : worlds.front().boxes) tree.insert(box);
    const auto cells = cells_of(tree);
    std::vector<std::size_t> boxes_below(cells.size(), 0);
    std::vector<std::size_t> open;  // groups that the next ones may join
    for (std::size_t i = 0; i < cells.size(); ++i) {
      while (!open.empty() && cells[open.back()].depth >= cells[i].depth) open.pop_back();
      EXPECT_EQ(static_cast<std::size_t>(cells[i].depth), open.size());
      if (!open.empty()) {
        EXPECT_EQ(detail::shared_box(cells[open.back()].box, cells[i].box), cells[i].box);
      }
      open.push_back(i);
      if (!cells[i].is_leaf) continue;
      for (const std::size_t group : open) ++boxes_below[group];
    }
    for (std::size_t i = 0; i < cells.size(); ++i) EXPECT_EQ(cells[i].count, boxes_below[i]);
    EXPECT_EQ(boxes_below[0], 1000U);
    EXPECT_LE(cells.size(), 1000U + 1000 / 5 + 1);  // n / 6 + n / 36 + ... groups
  }
}

TEST(Bvh, AVisitOfGroupsEndsWhenItsVisitorSaysSo) {
  Bvh<2> tree;
  for (int k = 0; k < 10; ++k) tree.insert({Vec<2>(static_cast<float>(k)), Vec<2>(static_cast<float>(k + 1))});
  int visits = 0;
  tree.visit_cells([&visits](const auto&) { return ++visits < 3; });
  EXPECT_EQ(visits, 3);
  EXPECT_THROW(tree.visit_cells([&tree](const auto&) { tree.clear(); }), std::logic_error);
}

TEST(Bvh, SaysHowMuchMemoryItHolds) {
  Bvh<3> bvh;
  bvh.assign(some_boxes(10'000, 8));
  EXPECT_LT(bvh.bytes(), std::size_t{10'000} * 200);
  EXPECT_GT(bvh.bytes(), std::size_t{10'000} * (24 + 28));  // a box, and one in a node with its slot
}

}  // namespace
}  // namespace graze::bvh_test
