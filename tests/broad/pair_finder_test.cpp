// SPDX-License-Identifier: MIT
// Data that a finder keeps between frames must not affect its answers.
#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <hwy/highway.h>

#include <graze/broad/brute_force_pairs.hpp>
#include <graze/broad/pairs.hpp>

#include "box_worlds.hpp"
#include "simd_targets.hpp"
#include "thread_executor.hpp"

namespace graze::pair_finder_test {
namespace {

template <Dim N, class T>
using Frames = std::vector<std::vector<Aabb<N, T>>>;

/// Frames in which all boxes move a little, with changes of every kind in between: some jump, all are replaced, some
/// become infinite or empty, are added or removed.
template <Dim N, class T>
Frames<N, T> living_world(const std::vector<Aabb<N, T>>& first) {
  test::Numbers numbers(31);
  Frames<N, T> frames{first};
  std::vector<Aabb<N, T>> boxes = first;
  const auto next = [&] {
    for (Aabb<N, T>& box : boxes) {
      const Vec<N, T> by = numbers.point<N, T>(-0.05, 0.05);
      if (!is_nothing(box)) box = {box.min + by, box.max + by};
    }
    frames.push_back(boxes);
  };
  for (int k = 0; k < 3; ++k) next();
  for (std::size_t k = 0; k < boxes.size(); k += 50) boxes[k] = boxes[boxes.size() - 1 - k];
  for (int k = 0; k < 2; ++k) next();
  std::reverse(boxes.begin(), boxes.end());
  for (int k = 0; k < 2; ++k) next();
  boxes[boxes.size() / 2].max[0] = std::numeric_limits<T>::infinity();
  for (int k = 0; k < 2; ++k) next();
  boxes[boxes.size() / 3] = Aabb<N, T>::nothing();
  for (int k = 0; k < 2; ++k) next();
  boxes[boxes.size() / 3] = first.front();
  for (int k = 0; k < 2; ++k) next();
  boxes.pop_back();
  for (int k = 0; k < 2; ++k) next();
  boxes.insert(boxes.begin(), first.back());
  for (int k = 0; k < 2; ++k) next();
  return frames;
}

template <Dim N, class T>
void expect_right_in_every_frame(const Frames<N, T>& frames) {
  PairFinder<N, T> alone;
  PairFinder<N, T> in_two;
  std::size_t frame = 0;
  for (const auto& boxes : frames) {
    SCOPED_TRACE(frame++);
    const std::span<const Aabb<N, T>> all = boxes;
    const std::vector<Pair> expected = brute_force_pairs(all);
    const std::span<const Pair> found = alone.find(all, {.method = PairMethod::tree});
    EXPECT_TRUE(std::equal(found.begin(), found.end(), expected.begin(), expected.end()));
    const std::size_t cut = all.size() / 3;
    const std::vector<Pair> between = brute_force_pairs(all.first(cut), all.subspan(cut));
    const std::span<const Pair> crossing = in_two.find(all.first(cut), all.subspan(cut), {.method = PairMethod::tree});
    EXPECT_TRUE(std::equal(crossing.begin(), crossing.end(), between.begin(), between.end()));
  }
}

TEST(PairFinder, IsRightInEveryFrameOfALivingWorld) {
  for (const auto& world : test::box_worlds<3, float>(900, 41)) {
    SCOPED_TRACE(world.name);
    expect_right_in_every_frame(living_world(world.boxes));
  }
  for (const auto& world : test::box_worlds<2, double>(400, 42)) {
    SCOPED_TRACE(world.name);
    expect_right_in_every_frame(living_world(world.boxes));
  }
}

/// All pairs of all frames, as found by one finder.
std::vector<Pair> as_found(const Frames<3, float>& frames, const Executor& executor) {
  PairFinder<3, float> finder;
  std::vector<Pair> pairs;
  for (const auto& boxes : frames) {
    const std::span<const Pair> found =
        finder.find(boxes, {.executor = &executor, .order = PairOrder::any, .method = PairMethod::tree});
    pairs.insert(pairs.end(), found.begin(), found.end());
  }
  return pairs;
}

TEST(PairFinder, FindsPairsInAnOrderThatDependsOnTheBoxesOfAllCallsAlone) {
  const Frames<3, float> frames = living_world(test::box_worlds<3, float>(9000, 43).front().boxes);
  const std::vector<Pair> expected = as_found(frames, serial_executor());
  for (const std::size_t threads : {2U, 7U}) {
    EXPECT_EQ(as_found(frames, test::ThreadExecutor(threads)), expected) << threads << " threads";
  }
  for (const std::int64_t target : test::simd_targets()) {
    const test::ForcedTarget forced(target);
    EXPECT_EQ(as_found(frames, serial_executor()), expected) << hwy::TargetName(target);
  }
}

/// Boxes of side `side` at the points of a lattice, rotated so that the first is that many from the end.
std::vector<Aabb<3, float>> lattice(std::uint32_t points, float side, std::uint32_t turned_by) {
  std::vector<Aabb<3, float>> boxes;
  for (std::uint32_t k = 0; k < points * points * points; ++k) {
    const Vec<3, float> min(static_cast<float>(k % points), static_cast<float>(k / points % points),
                            static_cast<float>(k / points / points));
    boxes.push_back({min, min + Vec<3, float>(side)});
  }
  std::rotate(boxes.begin(), boxes.begin() + turned_by, boxes.end());
  return boxes;
}

/// Most pairs are stored in the memory of the previous frame's pairs, according to their number and distribution: too
/// few, too many, others.
TEST(PairFinder, IsRightWhateverManyPairsOfTheLastFrameWere) {
  Frames<3, float> frames;
  std::map<std::pair<float, std::uint32_t>, std::vector<Pair>> expected_of;  // each lattice is there several times
  std::vector<const std::vector<Pair>*> expected;
  for (const float side : {1.0F, 1.0F, 2.0F, 1.0F, 0.5F, 1.0F, 2.0F, 2.0F}) {
    for (const std::uint32_t turned_by : {0U, 5'000U}) {
      frames.push_back(lattice(20, side, turned_by));
      std::vector<Pair>& pairs = expected_of[{side, turned_by}];
      if (pairs.empty()) pairs = brute_force_pairs(std::span<const Aabb<3, float>>(frames.back()));
      expected.push_back(&pairs);
    }
  }
  const test::ThreadExecutor three(3);
  for (const Executor* executor : {&serial_executor(), static_cast<const Executor*>(&three)}) {
    PairFinder<3, float> finder;
    for (std::size_t frame = 0; frame < frames.size(); ++frame) {
      const std::span<const Pair> found =
          finder.find(frames[frame], {.executor = executor, .method = PairMethod::tree});
      EXPECT_TRUE(std::equal(found.begin(), found.end(), expected[frame]->begin(), expected[frame]->end())) << frame;
    }
  }
}

/// Several threads concatenate their results while others are searching, in memory whose size is predicted from the
/// previous frame.
TEST(PairFinder, FindsManyPairsInTheSameOrderWithAnyNumberOfThreads) {
  Frames<3, float> frames;
  for (const float side : {1.0F, 1.0F, 2.0F, 0.5F, 1.0F}) frames.push_back(lattice(32, side, 0));
  const std::vector<Pair> expected = as_found(frames, serial_executor());
  for (const std::size_t threads : {2U, 7U}) {
    EXPECT_EQ(as_found(frames, test::ThreadExecutor(threads)), expected) << threads << " threads";
  }
}

TEST(PairFinder, RefusesNaNInAnyFrameAndGoesOn) {
  std::vector<Aabb<3, float>> boxes = test::box_worlds<3, float>(500, 44).front().boxes;
  PairFinder<3, float> finder;
  const std::vector<Pair> expected = brute_force_pairs(std::span<const Aabb<3, float>>(boxes));
  for (int frame = 0; frame < 3; ++frame) {
    const std::span<const Pair> found = finder.find(boxes);
    EXPECT_TRUE(std::equal(found.begin(), found.end(), expected.begin(), expected.end()));
    const Aabb<3, float> good = boxes[123];
    boxes[123].min.z = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(finder.find(boxes), std::invalid_argument);
    boxes[123] = good;
  }
}

TEST(PairFinder, FindsAndVisitsInTurns) {
  const Frames<3, float> frames = living_world(test::box_worlds<3, float>(700, 47).front().boxes);
  for (const PairMethod method : {PairMethod::tree, PairMethod::dense, PairMethod::brute_force}) {
    SCOPED_TRACE(name_of(method));
    PairFinder<3, float> finder;
    std::size_t frame = 0;
    for (const auto& boxes : frames) {
      SCOPED_TRACE(frame++);
      const std::span<const Aabb<3, float>> all = boxes;
      const std::vector<Pair> expected = brute_force_pairs(all);
      std::vector<Pair> pairs;
      const PairVisitor add = [&pairs](std::span<const Pair> some) {
        pairs.insert(pairs.end(), some.begin(), some.end());
        return true;
      };
      finder.visit(all, add, {.method = method});
      std::sort(pairs.begin(), pairs.end());
      EXPECT_EQ(pairs, expected);
      if (frame % 3 == 0) continue;  // also two visits in a row
      const std::span<const Pair> found = finder.find(all, {.method = method});
      EXPECT_TRUE(std::equal(found.begin(), found.end(), expected.begin(), expected.end()));
      pairs.clear();
      finder.visit(all.first(200), all.subspan(200), add, {.method = method});
      std::sort(pairs.begin(), pairs.end());
      EXPECT_EQ(pairs, brute_force_pairs(all.first(200), all.subspan(200)));
    }
  }
}

TEST(PairFinder, TakesAnotherMarginInEveryFrame) {
  const std::vector<Aabb<3, float>> boxes = test::box_worlds<3, float>(500, 45).front().boxes;
  PairFinder<3, float> finder;
  for (const double margin : {0.0, 0.5, 0.0, 0.125}) {
    const std::span<const Pair> found = finder.find(boxes, {.margin = margin});
    const std::vector<Pair> expected = overlapping_pairs(boxes, {.margin = margin, .method = PairMethod::brute_force});
    EXPECT_TRUE(std::equal(found.begin(), found.end(), expected.begin(), expected.end()));
  }
}

}  // namespace
}  // namespace graze::pair_finder_test
