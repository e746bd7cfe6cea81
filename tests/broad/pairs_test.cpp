// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/brute_force_pairs.hpp>
#include <graze/broad/pairs.hpp>

#include "box_worlds.hpp"
#include "number_of_cases.hpp"
#include "simd_targets.hpp"
#include "spaces.hpp"
#include "thread_executor.hpp"

namespace graze::pairs_test {
namespace {

template <class Space>
class PairsTest : public testing::Test {};

TYPED_TEST_SUITE(PairsTest, test::Spaces);

constexpr PairOptions by_tree{.method = PairMethod::tree};
constexpr PairOptions by_brute_force{.method = PairMethod::brute_force};

TYPED_TEST(PairsTest, FindThePairsOfAHandMadeRow) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  using Box = Aabb<N, T>;
  const auto along = [](T low, T high) {
    Box box{Vec<N, T>(T(0)), Vec<N, T>(T(1))};
    box.min[0] = low;
    box.max[0] = high;
    return box;
  };
  // 0 and 1 overlap, 1 and 2 touch, 3 is alone, 4 contains 3.
  const std::vector<Box> boxes = {along(0, 2), along(1, 3), along(3, 4), along(6, 7), along(5, 8)};
  const std::vector<Pair> expected = {{0, 1}, {1, 2}, {3, 4}};
  for (const PairOptions& options : {PairOptions{}, by_tree, by_brute_force}) {
    EXPECT_EQ(overlapping_pairs(boxes, options), expected);
  }
}

TYPED_TEST(PairsTest, TreeEqualsBruteForceInEveryWorld) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  PairFinder<N, T> finder;  // the same finder for all
  for (const std::size_t count : {0U, 1U, 2U, 9U, 64U, 65U, 700U, 2500U}) {
    for (const auto& world : test::box_worlds<N, T>(count, 20261121 + count)) {
      SCOPED_TRACE(world.name + ", " + std::to_string(count) + " boxes");
      const std::vector<Pair> expected = brute_force_pairs(std::span<const Aabb<N, T>>(world.boxes));
      EXPECT_EQ(overlapping_pairs(world.boxes, by_tree), expected);
      const std::span<const Pair> found = finder.find(world.boxes);
      EXPECT_TRUE(std::equal(found.begin(), found.end(), expected.begin(), expected.end()));
    }
  }
}

/// The pairs and their order do not depend on the executor.
template <Dim N, class T>
void expect_same_from_everyone(const std::vector<Aabb<N, T>>& boxes) {
  const PairOptions as_found{.executor = &serial_executor(), .order = PairOrder::any, .method = PairMethod::tree};
  const std::vector<Pair> expected = overlapping_pairs(boxes, as_found);
  std::vector<Pair> sorted = expected;
  std::sort(sorted.begin(), sorted.end());
  for (const std::size_t threads : {1U, 2U, 7U}) {
    const test::ThreadExecutor executor(threads);
    PairOptions options = as_found;
    options.executor = &executor;
    EXPECT_EQ(overlapping_pairs(boxes, options), expected) << threads << " threads";
    options.order = PairOrder::sorted;
    EXPECT_EQ(overlapping_pairs(boxes, options), sorted) << threads << " threads";
  }
  for (const std::int64_t target : test::simd_targets()) {
    const test::ForcedTarget forced(target);
    EXPECT_EQ(overlapping_pairs(boxes, as_found), expected) << hwy::TargetName(target);
    EXPECT_EQ(overlapping_pairs(boxes, by_tree), sorted) << hwy::TargetName(target);
  }
}

TYPED_TEST(PairsTest, NeitherThreadsNorInstructionSetsChangeAnything) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for (const auto& world : test::box_worlds<N, T>(1000, 17)) {
    SCOPED_TRACE(world.name);
    expect_same_from_everyone(world.boxes);
  }
  // Enough for many tasks, each of which finds a part.
  expect_same_from_everyone(test::box_worlds<N, T>(20'000, 18).front().boxes);
}

/// A cluster among boxes so far away that a grid over all has one cell for it.
template <Dim N, class T>
std::vector<Aabb<N, T>> cluster(std::size_t count) {
  test::Numbers numbers(23);
  const T width = N == 2 ? T(100) : T(30);
  std::vector<Aabb<N, T>> boxes;
  for (std::size_t k = 0; k < count; ++k) {
    const bool is_far = k % 5000 == 0;
    boxes.push_back(Aabb<N, T>::from_center(numbers.point<N, T>(0, is_far ? 100'000 : width), Vec<N, T>(T(0.5))));
  }
  return boxes;
}

TYPED_TEST(PairsTest, CrowdsAreFoundWhetherTheyAreOneRunOrMany) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for (const std::size_t count : {6000U, 15'000U, 25'000U}) {
    const std::vector<Aabb<N, T>> boxes = cluster<N, T>(count);
    const std::vector<Pair> expected = overlapping_pairs(boxes, {.method = PairMethod::dense});
    EXPECT_GT(expected.size(), count / 2);
    EXPECT_EQ(overlapping_pairs(boxes, by_tree), expected) << count;
  }
}

TYPED_TEST(PairsTest, BetweenTwoSetsTreeEqualsBruteForceInEveryWorld) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const auto worlds_a = test::box_worlds<N, T>(2000, 1);
  for (const std::size_t count : {0U, 1U, 90U, 700U}) {  // trees of all heights
    const auto worlds_b = test::box_worlds<N, T>(count, 2);
    for (std::size_t i = 0; i < worlds_a.size(); ++i) {
      SCOPED_TRACE(worlds_a[i].name + ", " + std::to_string(count));
      const std::span<const Aabb<N, T>> a = worlds_a[i].boxes;
      const std::span<const Aabb<N, T>> b = worlds_b[i].boxes;
      EXPECT_EQ(overlapping_pairs(a, b, by_tree), brute_force_pairs(a, b));
      EXPECT_EQ(overlapping_pairs(b, a), brute_force_pairs(b, a));
    }
  }
}

TYPED_TEST(PairsTest, TwoSetsAreThePairsOfTheirUnionAcross) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const auto boxes = test::box_worlds<N, T>(300, 5).front().boxes;
  const std::vector<Aabb<N, T>> first(boxes.begin(), boxes.begin() + 120);
  const std::vector<Aabb<N, T>> second(boxes.begin() + 120, boxes.end());
  std::vector<Pair> expected;
  for (const Pair& pair : overlapping_pairs(boxes)) {
    if (pair.a < 120 && pair.b >= 120) expected.push_back({pair.a, pair.b - 120});
  }
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(overlapping_pairs(first, second), expected);
}

TYPED_TEST(PairsTest, AVisitorSeesEveryPairOnceInBlocks) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for (const auto& world : test::box_worlds<N, T>(800, 6)) {
    SCOPED_TRACE(world.name);
    const std::span<const Aabb<N, T>> boxes = world.boxes;
    for (const PairOptions& options : {PairOptions{}, by_brute_force}) {
      std::vector<Pair> seen;
      const PairVisitor add = [&seen](std::span<const Pair> pairs) {
        EXPECT_FALSE(pairs.empty());
        seen.insert(seen.end(), pairs.begin(), pairs.end());
        return true;
      };
      visit_overlapping_pairs(boxes, add, options);
      std::sort(seen.begin(), seen.end());
      EXPECT_EQ(seen, overlapping_pairs(boxes));
      seen.clear();
      visit_overlapping_pairs(boxes.first(300), boxes.last(400), add, options);
      std::sort(seen.begin(), seen.end());
      EXPECT_EQ(seen, overlapping_pairs(boxes.first(300), boxes.last(400)));
    }
  }
}

TYPED_TEST(PairsTest, AVisitorThatHasEnoughIsLeftAlone) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const std::vector<Aabb<N, T>> boxes(4000);  // eight million pairs
  for (const PairOptions& options : {PairOptions{}, by_brute_force}) {
    int calls = 0;
    std::size_t pairs_seen = 0;
    visit_overlapping_pairs<N, T>(
        boxes,
        [&](std::span<const Pair> pairs) {
          ++calls;
          pairs_seen += pairs.size();
          return false;
        },
        options);
    EXPECT_EQ(calls, 1);
    EXPECT_LT(pairs_seen, 300'000U);
  }
}

TYPED_TEST(PairsTest, AMarginIsAddedOnEverySideOfEveryBox) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for (const auto& world : test::box_worlds<N, T>(700, 8)) {
    SCOPED_TRACE(world.name);
    std::vector<Aabb<N, T>> larger = world.boxes;
    for (auto& box : larger) {
      if (!is_nothing(box)) box = {box.min - T(0.25), box.max + T(0.25)};
    }
    const std::vector<Pair> expected = brute_force_pairs(std::span<const Aabb<N, T>>(larger));
    EXPECT_EQ(overlapping_pairs(world.boxes, {.margin = 0.25, .method = PairMethod::tree}), expected);
    EXPECT_EQ(overlapping_pairs(world.boxes, {.margin = 0.25, .method = PairMethod::brute_force}), expected);
  }
}

TYPED_TEST(PairsTest, MarginsThatAreNoneAreRefused) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const std::vector<Aabb<N, T>> boxes(3);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double margin : {-1.0, infinity, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(overlapping_pairs(boxes, {.margin = margin}), std::invalid_argument) << margin;
    EXPECT_THROW(overlapping_pairs(boxes, boxes, {.margin = margin}), std::invalid_argument) << margin;
  }
}

TYPED_TEST(PairsTest, ShufflingTheBoxesRenamesThePairs) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const auto boxes = test::box_worlds<N, T>(400, 9)[1].boxes;
  std::vector<std::uint32_t> order(boxes.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  std::vector<Aabb<N, T>> shuffled;
  for (const std::uint32_t i : order) shuffled.push_back(boxes[i]);
  std::vector<Pair> renamed;
  for (const Pair& pair : overlapping_pairs(shuffled)) {
    renamed.push_back({std::min(order[pair.a], order[pair.b]), std::max(order[pair.a], order[pair.b])});
  }
  std::sort(renamed.begin(), renamed.end());
  EXPECT_EQ(renamed, overlapping_pairs(boxes));
}

TYPED_TEST(PairsTest, AllBoxesAtOnePointGiveAllPairs) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const std::vector<Aabb<N, T>> boxes(3000);
  for (const PairMethod method : {PairMethod::automatic, PairMethod::dense, PairMethod::tree}) {
    SCOPED_TRACE(name_of(method));
    const std::vector<Pair> pairs = overlapping_pairs(boxes, {.method = method});
    ASSERT_EQ(pairs.size(), 4'498'500U);
    const Pair* next = pairs.data();
    bool are_all = true;
    for (std::uint32_t a = 0; a < 3000; ++a) {
      for (std::uint32_t b = a + 1; b < 3000; ++b) are_all = are_all && *next++ == Pair{a, b};
    }
    EXPECT_TRUE(are_all);
  }
}

template <Dim N, class T>
void expect_giants_over_dwarfs_are_found() {
  const std::size_t count = test::number_of_cases(20'000, 5'000);
  for (const auto& world : test::box_worlds<N, T>(count, 11)) {
    if (world.name != "a few giants over dwarfs") continue;
    const std::vector<Pair> expected = overlapping_pairs(world.boxes, by_brute_force);
    EXPECT_GT(expected.size(), count);
    EXPECT_EQ(overlapping_pairs(world.boxes, by_tree), expected);
    EXPECT_EQ(overlapping_pairs(world.boxes, {.method = PairMethod::dense}), expected);
  }
}

TEST(Pairs, OfAFewGiantsOverManyDwarfs) {
  expect_giants_over_dwarfs_are_found<3, float>();
  expect_giants_over_dwarfs_are_found<2, double>();
}

TYPED_TEST(PairsTest, ALatticeOnlyTouchesHoweverLargeItIs) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  constexpr std::size_t side = N == 2 ? 50 : 12;
  constexpr std::size_t count = N == 2 ? side * side : side * side * side;
  // Along each axis 3 side - 2 ordered pairs of positions at most one apart; each pair of boxes is in both orders.
  constexpr std::size_t pairs = N == 2 ? (148 * 148 - count) / 2 : (34 * 34 * 34 - count) / 2;
  for (const auto& world : test::box_worlds<N, T>(count, 1)) {
    if (world.name != "a lattice that only touches") continue;
    EXPECT_EQ(overlapping_pairs(world.boxes, by_tree).size(), pairs);
  }
}

/// The message with which a call is rejected.
std::string refusal_of(const auto& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TYPED_TEST(PairsTest, NaNIsRefusedByEveryMethodWithTheIndexOfItsBoxAndItsSet) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const std::vector<Aabb<N, T>> good(200);
  const std::span<const Aabb<N, T>> all = good;
  const PairVisitor none = [](std::span<const Pair>) { return true; };
  const auto refused = [](const std::string& box) {
    return "overlapping_pairs: " + box + " has a coordinate that is NaN";
  };
  for (std::size_t k = 0; k < std::size_t{4} * N; ++k) {  // in few boxes and many, at each coordinate
    std::vector<Aabb<N, T>> boxes(k % 2 == 0 ? 5 : 500);
    (k / 2 % 2 == 0 ? boxes[3].max : boxes[3].min)[static_cast<Dim>(k / 4)] = std::numeric_limits<T>::quiet_NaN();
    const std::span<const Aabb<N, T>> bad = boxes;
    for (const PairMethod method : all_pair_methods()) {
      SCOPED_TRACE(name_of(method));
      const PairOptions options{.method = method};
      EXPECT_EQ(refusal_of([&] { overlapping_pairs(bad, options); }), refused("box 3"));
      EXPECT_EQ(refusal_of([&] { overlapping_pairs(bad, all, options); }), refused("box 3 of the first set"));
      EXPECT_EQ(refusal_of([&] { overlapping_pairs(all, bad, options); }), refused("box 3 of the second set"));
      EXPECT_EQ(refusal_of([&] { visit_overlapping_pairs(bad, none, options); }), refused("box 3"));
      EXPECT_EQ(refusal_of([&] { visit_overlapping_pairs(bad, all, none, options); }),
                refused("box 3 of the first set"));
      EXPECT_EQ(refusal_of([&] { visit_overlapping_pairs(all, bad, none, options); }),
                refused("box 3 of the second set"));
    }
  }
}

TEST(Pairs, MethodsAreKnownByName) {
  for (const PairMethod method : all_pair_methods()) EXPECT_EQ(pair_method_named(name_of(method)), method);
  EXPECT_FALSE(pair_method_named("guess").has_value());
  EXPECT_EQ(name_of(PairMethod::brute_force), "brute_force");
}

TEST(Pairs, AFinderSaysWhatItDidAndWhatItHolds) {
  PairFinder<2> finder;
  EXPECT_EQ(finder.method(), PairMethod::automatic);
  EXPECT_EQ(finder.bytes(), 0U);
  finder.find(std::vector<Rect<float>>(2));
  EXPECT_EQ(finder.method(), PairMethod::dense);
  finder.find(test::box_worlds<2, float>(20'000, 1).front().boxes);
  EXPECT_EQ(finder.method(), PairMethod::tree);
  EXPECT_GT(finder.bytes(), 20'000U * 20U);  // at least a copy of the boxes and their ids
  PairFinder<2, float> moved = std::move(finder);
  EXPECT_EQ(moved.method(), PairMethod::tree);
}

}  // namespace
}  // namespace graze::pairs_test
