// SPDX-License-Identifier: MIT
#include <atomic>
#include <chrono>
#include <cstddef>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/executor.hpp>

namespace graze::executor_test {
namespace {

void expect_every_task_once(const Executor& executor) {
  for (const std::size_t count : {0U, 1U, 2U, 1000U}) {
    std::vector<std::atomic<int>> runs(count);
    executor.parallel_for(count, [&](std::size_t i) { ++runs[i]; });
    for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(runs[i], 1) << i << " of " << count;
  }
}

TEST(Executor, RunsEveryTaskOnce) {
  expect_every_task_once(serial_executor());
  expect_every_task_once(default_executor());
  for (const std::size_t threads : {1U, 2U, 7U}) expect_every_task_once(*limited_executor(threads));
}

TEST(Executor, SaysHowManyTasksMayRunAtOnce) {
  EXPECT_EQ(serial_executor().concurrency(), 1U);
  EXPECT_EQ(limited_executor(1)->concurrency(), 1U);
  EXPECT_LE(limited_executor(2)->concurrency(), 2U);
  EXPECT_LE(limited_executor(1'000'000)->concurrency(), default_executor().concurrency());
  EXPECT_GE(default_executor().concurrency(), 1U);
}

TEST(Executor, TheSerialOneRunsInOrderOnTheCallingThread) {
  std::vector<std::size_t> order;
  const std::thread::id caller = std::this_thread::get_id();
  serial_executor().parallel_for(5, [&](std::size_t i) {
    order.push_back(i);
    EXPECT_EQ(std::this_thread::get_id(), caller);
  });
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
}

TEST(Executor, TwoThreadsReallyRunAtTheSameTime) {
  if (default_executor().concurrency() < 2) GTEST_SKIP() << "a single core, or no oneTBB";
  // Each task waits for the other, so a single thread would never end. The wait times out, so that the test fails
  // instead.
  std::atomic<int> arrived = 0;
  std::atomic<int> met = 0;
  limited_executor(2)->parallel_for(2, [&](std::size_t /*i*/) {
    ++arrived;
    for (int patience = 0; arrived < 2 && patience < 5000; ++patience) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    if (arrived == 2) ++met;
  });
  EXPECT_EQ(met, 2);
}

TEST(Executor, GivesOnWhatATaskThrows) {
  const auto throwing = [](std::size_t i) {
    if (i == 3) throw std::runtime_error("three");
  };
  EXPECT_THROW(serial_executor().parallel_for(8, throwing), std::runtime_error);
  EXPECT_THROW(limited_executor(2)->parallel_for(8, throwing), std::runtime_error);
}

TEST(Executor, MayBeUsedFromWithinATask) {
  const auto executor = limited_executor(2);
  std::atomic<int> runs = 0;
  executor->parallel_for(4, [&](std::size_t /*i*/) { executor->parallel_for(4, [&](std::size_t /*j*/) { ++runs; }); });
  EXPECT_EQ(runs, 16);
}

TEST(Executor, RefusesNoThreads) { EXPECT_THROW(limited_executor(0), std::invalid_argument); }

}  // namespace
}  // namespace graze::executor_test
