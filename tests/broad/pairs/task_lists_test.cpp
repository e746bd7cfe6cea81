// SPDX-License-Identifier: MIT
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <numeric>
#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <graze/broad/pairs/pair_list.hpp>
#include <graze/broad/pairs/task_lists.hpp>

#include "broad/thread_executor.hpp"

namespace graze::detail::task_lists_test {
namespace {

/// A list that knows whether it still exists.
class List {
 public:
  List(std::vector<Pair> pairs, std::atomic<int>& held) : pairs_(std::move(pairs)), held_(held) { ++held_; }
  List(const List&) = delete;
  List& operator=(const List&) = delete;
  ~List() { --held_; }
  std::span<const Pair> all() const { return pairs_; }

 private:
  std::vector<Pair> pairs_;
  std::atomic<int>& held_;
};

/// Memory that loses its content when more is requested, and must be told how far it is written.
class Room final : public PairSink {
 public:
  std::span<Pair> ahead(std::size_t expected) override {
    pairs_.resize(expected);
    return pairs_;
  }
  Pair* all(std::size_t count) override {
    if (count > pairs_.size()) pairs_.assign(count, Pair{7, 7});
    return pairs_.data();
  }
  void reach(std::size_t end) override { reached_ = std::max(reached_, end); }
  bool appends() const override { return false; }
  const Pair* append(std::span<const Pair> /*pairs*/, std::size_t /*expected*/) override { return nullptr; }

  std::size_t reached() const { return reached_; }

 private:
  std::vector<Pair> pairs_;
  std::size_t reached_ = 0;
};

std::vector<Pair> pairs_of_task(std::size_t task, std::size_t count) {
  std::vector<Pair> pairs;
  for (std::uint32_t k = 0; k < count; ++k) pairs.push_back({static_cast<std::uint32_t>(task), k});
  return pairs;
}

TEST(TaskLists, ComeInTheOrderOfTasksHoweverTheseEndAndHoweverMuchWasExpected) {
  EXPECT_TRUE(rc::check([] {
    const auto counts = *rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(0, 200));
    std::vector<Pair> expected;
    for (std::size_t task = 0; task < counts.size(); ++task) {
      const std::vector<Pair> some = pairs_of_task(task, counts[task]);
      expected.insert(expected.end(), some.begin(), some.end());
    }
    std::vector<std::size_t> order(counts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), std::mt19937(*rc::gen::arbitrary<std::uint32_t>()));
    const std::size_t percent = *rc::gen::element<std::size_t>(0, 40, 100, 130);
    std::atomic<int> held = 0;
    Room room;
    {
      TaskLists<List> lists(counts.size(), room, room.ahead(expected.size() * percent / 100));
      for (const std::size_t task : order) {
        lists.add(task, std::make_unique<List>(pairs_of_task(task, counts[task]), held));
      }
      if (percent >= 100) {
        RC_ASSERT(held == 0);
        RC_ASSERT(room.reached() == expected.size());
      }
      const std::span<const Pair> all = lists.take();
      RC_ASSERT(std::equal(all.begin(), all.end(), expected.begin(), expected.end()));
    }
    RC_ASSERT(held == 0);
  }));
}

TEST(TaskLists, AreHeldNoLongerThanUntilThoseBeforeHaveEnded) {
  std::atomic<int> held = 0;
  Room room;
  TaskLists<List> lists(5, room, room.ahead(50));
  for (const std::size_t task : {0U, 2U, 3U}) lists.add(task, std::make_unique<List>(pairs_of_task(task, 10), held));
  EXPECT_EQ(held, 2);
  lists.add(1, std::make_unique<List>(pairs_of_task(1, 10), held));
  EXPECT_EQ(held, 0);
}

TEST(TaskLists, AreTakenFromManyThreads) {
  constexpr std::size_t tasks = 500;
  std::atomic<int> held = 0;
  for (const std::size_t expected : {std::size_t{300} * tasks, std::size_t{100} * tasks}) {
    Room room;
    TaskLists<List> lists(tasks, room, room.ahead(expected));
    test::ThreadExecutor(4).parallel_for(
        tasks, [&](std::size_t task) { lists.add(task, std::make_unique<List>(pairs_of_task(task, 300), held)); });
    const std::span<const Pair> all = lists.take();
    ASSERT_EQ(all.size(), 300 * tasks);
    EXPECT_TRUE(std::is_sorted(all.begin(), all.end()));
  }
}

/// Threads, which must not be requested from inside a task: one could receive a task that waits for this one.
class FlatExecutor final : public Executor {
 public:
  void parallel_for(std::size_t count, const std::function<void(std::size_t)>& task) const override {
    EXPECT_FALSE(is_in_task) << "requested by a task";
    threads_.parallel_for(count, [&task](std::size_t k) {
      is_in_task = true;
      task(k);
      is_in_task = false;
    });
  }
  std::size_t concurrency() const override { return threads_.concurrency(); }

 private:
  static inline thread_local bool is_in_task = false;
  test::ThreadExecutor threads_{3};
};

TEST(TaskLists, MakeAListReadyWithoutTheOtherThreads) {
  constexpr std::size_t tasks = 5;
  constexpr std::size_t of_each = 700'000;  // enough for all threads to prefault together
  const FlatExecutor executor;
  std::atomic<int> held = 0;
  PairList room(executor);
  const std::span<Pair> ahead = room.ahead(tasks * of_each);
  TaskLists<List> lists(tasks, room, ahead);
  executor.parallel_for(
      tasks, [&](std::size_t task) { lists.add(task, std::make_unique<List>(pairs_of_task(task, of_each), held)); });
  const std::span<const Pair> all = lists.take();
  ASSERT_EQ(all.size(), tasks * of_each);
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end()));
}

}  // namespace
}  // namespace graze::detail::task_lists_test
