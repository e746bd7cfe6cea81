// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/batch/tasks.hpp>
#include <graze/broad/executor.hpp>

namespace graze::detail {
namespace {

constexpr std::size_t task_size = 8;

TEST(InTasks, CoversTheCountWithRangesOfOneSize) {
  for (const std::size_t count : {0U, 1U, 8U, 9U, 800U}) {
    std::vector<std::pair<std::size_t, std::size_t>> ranges;
    std::mutex one_at_a_time;
    in_tasks(count, task_size, default_executor(), [&](std::size_t first, std::size_t last) {
      const std::lock_guard<std::mutex> lock(one_at_a_time);
      ranges.emplace_back(first, last);
    });
    std::sort(ranges.begin(), ranges.end());
    std::size_t end = 0;
    for (const auto& [first, last] : ranges) {
      EXPECT_EQ(first, end);
      EXPECT_EQ(last, std::min(count, first + task_size));
      end = last;
    }
    EXPECT_EQ(end, count);
  }
}

// Up to and beyond what is initialised at a time.
TEST(WrittenByTasks, AreTheResultsInOrder) {
  for (const std::size_t count : {0U, 1U, 7U, 8U, 255U, 256U, 257U, 5000U}) {
    const auto results = written_by_tasks<std::size_t>(count, task_size, default_executor(),
                                                       [&](std::size_t first, std::size_t last, std::size_t* out) {
                                                         EXPECT_LE(last, count);
                                                         for (std::size_t i = first; i < last; ++i) *out++ = i * i;
                                                       });
    ASSERT_EQ(results.size(), count);
    for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(results[i], i * i);
  }
}

TEST(WrittenByTasks, AreInitialisedBefore) {
  const auto results = written_by_tasks<int>(1000, task_size, default_executor(),
                                             [](std::size_t first, std::size_t, int* out) { out[0] += first == 0; });
  EXPECT_EQ(std::count(results.begin(), results.end(), 0), 999);
}

}  // namespace
}  // namespace graze::detail
