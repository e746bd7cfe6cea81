// SPDX-License-Identifier: MIT
#include <cstddef>
#include <optional>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/memory/pool.hpp>

namespace graze::detail::pool_test {
namespace {

TEST(Pool, LendsAsManyThingsAsAreNeededAtOnce) {
  Pool<std::vector<int>> pool;
  EXPECT_TRUE(pool.all().empty());
  for (int turn = 0; turn < 5; ++turn) {
    const Pool<std::vector<int>>::Loan loan(pool);
    loan->push_back(turn);
  }
  ASSERT_EQ(pool.all().size(), 1U);
  EXPECT_EQ(*pool.all().front(), std::vector<int>({0, 1, 2, 3, 4}));
  std::optional<Pool<std::vector<int>>::Loan> first(std::in_place, pool);
  const Pool<std::vector<int>>::Loan second(pool);
  EXPECT_NE(&**first, &*second);
  first.reset();
  const Pool<std::vector<int>>::Loan third(pool);
  EXPECT_NE(&*third, &*second);
  EXPECT_EQ(pool.all().size(), 2U);
}

TEST(Pool, LendsAThingToOneThreadAtATime) {
  Pool<std::size_t> pool;
  const auto work = [&pool] {
    for (int turn = 0; turn < 10'000; ++turn) ++*Pool<std::size_t>::Loan(pool);
  };
  std::thread first(work);
  std::thread second(work);
  first.join();
  second.join();
  std::size_t sum = 0;
  for (const auto& value : pool.all()) sum += *value;
  EXPECT_EQ(sum, 20'000U);
  EXPECT_LE(pool.all().size(), 2U);
}

}  // namespace
}  // namespace graze::detail::pool_test
