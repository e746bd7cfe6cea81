// SPDX-License-Identifier: MIT
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/distributed/pairs/unique_ids.hpp>

#include "../ranks.hpp"

namespace graze::unique_ids_test {
namespace {

std::string told(const std::vector<std::uint64_t>& ids, detail::Traffic& traffic) {
  detail::Communicator comm(MPI_COMM_WORLD);
  return test::message_of<std::invalid_argument>([&] { detail::require_unique(comm, ids, traffic); });
}

TEST(UniqueIds, AreAcceptedInAnyOrder) {
  const auto ranks = static_cast<std::uint64_t>(test::world_ranks());
  const auto rank = static_cast<std::uint64_t>(test::world_rank());
  std::vector<std::uint64_t> ranges;
  std::vector<std::uint64_t> interleaved;
  for (std::uint64_t k = 500; k-- > 0;) {
    ranges.push_back(rank * 500 + k);
    interleaved.push_back(std::numeric_limits<std::uint64_t>::max() - k * ranks - rank);
  }
  detail::Traffic traffic;
  EXPECT_EQ(told(ranges, traffic), "none");
  EXPECT_EQ(traffic.messages, 0U);  // disjoint ranges need not be compared
  EXPECT_EQ(told(interleaved, traffic), "none");
  EXPECT_EQ(traffic.messages, ranks - 1);
  EXPECT_EQ(told({}, traffic), "none");
}

TEST(UniqueIds, AreRefusedOnAllRanksIfTheyAreNot) {
  const int last = test::world_ranks() - 1;
  const auto rank = static_cast<std::uint64_t>(test::world_rank());
  detail::Traffic traffic;
  std::vector<std::uint64_t> ids{rank * 10, rank * 10 + 1};
  if (test::world_rank() == last) ids.push_back(ids.front());
  EXPECT_NE(told(ids, traffic).find("the id " + std::to_string(last * 10) + " is used twice"), std::string::npos);
  if (last == 0) return;
  ids.resize(2);
  if (test::world_rank() == last) ids.push_back(0);  // that of rank 0
  EXPECT_NE(told(ids, traffic).find("the id 0 is used twice; each box of the world needs an id of its own"),
            std::string::npos);
}

}  // namespace
}  // namespace graze::unique_ids_test
