// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>
#include <hwy/highway.h>

#include <graze/broad/brute_force_pairs.hpp>
#include <graze/broad/pairs/dense_search.hpp>

#include "broad/box_worlds.hpp"
#include "broad/simd_targets.hpp"
#include "broad/thread_executor.hpp"

namespace graze::detail::dense_search_test {
namespace {

/// Output memory that is larger than it claims, with guard values.
class MarkedRoom final : public PairSink {
 public:
  static constexpr Pair mark = {~0U, ~0U};

  Pair* all(std::size_t count) override {
    memory.assign(count + 32, mark);
    return memory.data();
  }
  bool appends() const override { return true; }
  const Pair* append(std::span<const Pair> /*pairs*/, std::size_t /*expected*/) override {
    ADD_FAILURE() << "it counts first";
    return nullptr;
  }

  std::vector<Pair> memory;
};

/// Counts the tasks that it runs.
class CountingExecutor final : public Executor {
 public:
  explicit CountingExecutor(std::size_t threads) : threads_(threads) {}

  void parallel_for(std::size_t count, const std::function<void(std::size_t)>& task) const override {
    tasks_ += count;
    threads_.parallel_for(count, task);
  }
  std::size_t concurrency() const override { return threads_.concurrency(); }

  std::size_t tasks() const { return tasks_; }

 private:
  test::ThreadExecutor threads_;
  mutable std::size_t tasks_ = 0;
};

template <Dim N, class T>
std::vector<Pair> found_by(DenseSearch<N, T>& search, std::type_identity_t<std::span<const Aabb<N, T>>> boxes_a,
                           const std::type_identity_t<std::span<const Aabb<N, T>>>* boxes_b,
                           const PairOptions& options = {}) {
  MarkedRoom room;
  const std::span<const Pair> found = search.find(boxes_a, boxes_b, options, room);
  EXPECT_EQ(found.data(), room.memory.data());
  EXPECT_EQ(found.size() + 32, room.memory.size());
  return {found.begin(), found.end()};
}

template <Dim N, class T>
void expect_as_brute_force(std::size_t count) {
  DenseSearch<N, T> search;
  for (const auto& world : test::box_worlds<N, T>(count, 61)) {
    SCOPED_TRACE(world.name + ", " + std::to_string(count));
    const std::span<const Aabb<N, T>> all = world.boxes;
    const std::span<const Aabb<N, T>> some = all.first(count / 3);
    const std::span<const Aabb<N, T>> rest = all.subspan(count / 3);
    for (const std::int64_t target : test::simd_targets()) {
      const test::ForcedTarget forced(target);
      EXPECT_EQ(found_by(search, all, nullptr), brute_force_pairs(all)) << hwy::TargetName(target);
      EXPECT_EQ(found_by(search, some, &rest), brute_force_pairs(some, rest)) << hwy::TargetName(target);
      EXPECT_EQ(found_by(search, rest, &some), brute_force_pairs(rest, some)) << hwy::TargetName(target);
    }
  }
}

TEST(DenseSearch, FindsWhatBruteForceFindsInItsOrder) {
  for (const std::size_t count : {0U, 1U, 2U, 15U, 16U, 17U, 33U, 150U}) {
    expect_as_brute_force<2, float>(count);
    expect_as_brute_force<3, float>(count);
    expect_as_brute_force<2, double>(count);
    expect_as_brute_force<3, double>(count);
  }
}

TEST(DenseSearch, WritesNothingBeyondItsRoom) {
  const std::vector<Aabb<3, float>> boxes(70, Aabb<3, float>{{0, 0, 0}, {1, 1, 1}});
  MarkedRoom room;
  DenseSearch<3, float> search;
  const std::span<const Pair> found = search.find(boxes, nullptr, {}, room);
  EXPECT_EQ(found.size(), 70U * 69U / 2U);
  EXPECT_TRUE(std::all_of(room.memory.begin() + 70 * 69 / 2, room.memory.end(),
                          [](Pair pair) { return pair == MarkedRoom::mark; }));
}

TEST(DenseSearch, InManyTasksFindsTheSame) {
  const auto world = test::box_worlds<3, float>(3000, 62)[7];  // of zero size on a grid: many coincide
  const std::span<const Aabb<3, float>> boxes = world.boxes;
  const std::vector<Pair> expected = brute_force_pairs(boxes);
  DenseSearch<3, float> search;
  for (const std::size_t threads : {1U, 2U, 7U}) {
    const test::ThreadExecutor executor(threads);
    EXPECT_EQ(found_by(search, boxes, nullptr, {.executor = &executor}), expected) << threads;
  }
}

TEST(DenseSearch, GivesPairsToAVisitorUntilItSaysNo) {
  const std::vector<Aabb<2, float>> boxes(2000, Aabb<2, float>{{0, 0}, {1, 1}});
  const std::span<const Aabb<2, float>> all = boxes;
  DenseSearch<2, float> search;
  std::vector<Pair> pairs;
  search.visit(all, nullptr, {}, [&pairs](std::span<const Pair> some) {
    pairs.insert(pairs.end(), some.begin(), some.end());
    return true;
  });
  EXPECT_EQ(pairs, brute_force_pairs(all));
  int calls = 0;
  search.visit(all, nullptr, {}, [&calls](std::span<const Pair>) { return ++calls < 3; });
  EXPECT_EQ(calls, 3);
}

TEST(DenseSearch, HasItsVisitsRunByTheExecutorToo) {
  const auto world = test::box_worlds<3, float>(2000, 63)[7];
  const std::span<const Aabb<3, float>> all = world.boxes;
  DenseSearch<3, float> search;
  const auto visits_by = [&](const Executor& executor) {
    std::vector<std::vector<Pair>> visits;
    search.visit(all, nullptr, {.executor = &executor}, [&visits](std::span<const Pair> pairs) {
      visits.emplace_back(pairs.begin(), pairs.end());
      return true;
    });
    return visits;
  };
  const std::vector<std::vector<Pair>> expected = visits_by(serial_executor());
  for (const std::size_t threads : {2U, 7U}) {
    const CountingExecutor executor(threads);
    EXPECT_EQ(visits_by(executor), expected) << threads << " threads";
    EXPECT_GT(executor.tasks(), 16U);
  }
}

TEST(DenseSearch, GrowsBoxesThatContainSomethingByTheMargin) {
  const std::vector<Rect<float>> boxes{{{0, 0}, {1, 1}}, {{1.5F, 0}, {2, 1}}, {{1, 1}, {0.75F, 1}}};
  DenseSearch<2, float> search;
  EXPECT_TRUE((found_by<2, float>(search, boxes, nullptr).empty()));
  EXPECT_EQ((found_by<2, float>(search, boxes, nullptr, {.margin = 0.25})), (std::vector<Pair>{{0, 1}}));
}

TEST(DenseSearch, RefusesNaN) {
  std::vector<Rect<float>> boxes(40, Rect<float>{{0, 0}, {1, 1}});
  boxes[21].max.y = std::numeric_limits<float>::quiet_NaN();
  DenseSearch<2, float> search;
  try {
    found_by<2, float>(search, boxes, nullptr);
    FAIL() << "NaN was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("box 21 has a coordinate that is NaN"), std::string::npos);
  }
}

}  // namespace
}  // namespace graze::detail::dense_search_test
