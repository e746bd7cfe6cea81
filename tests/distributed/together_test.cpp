// SPDX-License-Identifier: MIT
#include <new>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <graze/distributed/together.hpp>

#include "ranks.hpp"

namespace graze::together_test {
namespace {

TEST(Together, RunsTheWorkOnEachRank) {
  int runs = 0;
  together(MPI_COMM_WORLD, [&] { ++runs; });
  EXPECT_EQ(runs, 1);
}

/// The message on this rank, if only one rank throws.
template <class Thrown, class Caught>
std::string told(int culprit, const Thrown& error) {
  return test::message_of<Caught>([&] {
    together(MPI_COMM_WORLD, [&] {
      if (test::world_rank() == culprit) throw error;
    });
  });
}

TEST(Together, ThrowsOnAllRanksWhatOneThrows) {
  for (int culprit = 0; culprit < test::world_ranks(); ++culprit) {
    const std::string by = "rank " + std::to_string(culprit) + ": ";
    EXPECT_EQ((told<std::invalid_argument, std::invalid_argument>(culprit, std::invalid_argument("no"))), by + "no");
    EXPECT_EQ((told<std::length_error, std::length_error>(culprit, std::length_error("long"))), by + "long");
    EXPECT_EQ((told<std::domain_error, std::runtime_error>(culprit, std::domain_error("where"))), by + "where");
    EXPECT_NE((told<std::bad_alloc, std::bad_alloc>(culprit, std::bad_alloc())), "another");
    EXPECT_EQ((told<int, std::runtime_error>(culprit, 7)),
              by + "an exception of a type that is not derived from std::exception");
  }
}

TEST(Together, TellsTheErrorOfTheLowestRankAndCutsLongMessages) {
  const std::string text = test::message_of<std::runtime_error>([] {
    together(MPI_COMM_WORLD,
             [] { throw std::runtime_error(std::to_string(test::world_rank()) + std::string(5000, 'x')); });
  });
  EXPECT_EQ(text.substr(0, 10), "rank 0: 0x");
  EXPECT_EQ(text.size(), std::string("rank 0: ").size() + 999);
}

}  // namespace
}  // namespace graze::together_test
