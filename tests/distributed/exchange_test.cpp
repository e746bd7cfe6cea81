// SPDX-License-Identifier: MIT
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/distributed/exchange.hpp>

#include "ranks.hpp"

namespace graze::exchange_test {
namespace {

struct Motion {
  double speed = 0;
  int mesh = 0;
};

using Moved = Body<2, double, Motion>;

Moved body(std::uint64_t id) {
  const auto place = static_cast<double>(id % 100);
  return {{{place, 0}, {place + 1, 1}}, id, {place / 2, static_cast<int>(id % 7)}};
}

TEST(Exchange, BringsEachBodyToItsRankAscendingById) {
  const auto ranks = static_cast<std::uint64_t>(test::world_ranks());
  const auto rank = static_cast<std::uint64_t>(test::world_rank());
  std::vector<Moved> bodies;
  std::vector<int> to;
  for (std::uint64_t k = 100; k-- > 0;) {
    bodies.push_back(body((rank * 100 + k) << 32U));
    to.push_back(static_cast<int>((rank * 100 + k) * 5 % ranks));
  }
  const std::vector<Moved> here = exchange<2, double, Motion>(MPI_COMM_WORLD, bodies, to);
  std::size_t at = 0;
  for (std::uint64_t k = 0; k < 100 * ranks; ++k) {
    if (k * 5 % ranks != rank) continue;
    ASSERT_LT(at, here.size());
    const Moved expected = body(k << 32U);
    EXPECT_EQ(here[at].id, expected.id);
    EXPECT_EQ(here[at].box, expected.box);
    EXPECT_EQ(here[at].payload.speed, expected.payload.speed);
    EXPECT_EQ(here[at].payload.mesh, expected.payload.mesh);
    ++at;
  }
  EXPECT_EQ(at, here.size());
}

TEST(Exchange, BringsBoxesToTheRanksThatOwnThem) {
  std::vector<Body<3, float>> bodies;
  for (int k = 0; k < 50; ++k) {
    const auto place = static_cast<float>(k * test::world_ranks() + test::world_rank());
    bodies.push_back({{Vec<3, float>(place), Vec<3, float>(place + 1)}, static_cast<std::uint64_t>(place), {}});
  }
  std::vector<Aabb<3, float>> boxes;
  for (const auto& one : bodies) boxes.push_back(one.box);
  const Partition<3> cuts = partition(MPI_COMM_WORLD, std::span<const Aabb<3, float>>(boxes));
  const std::vector<Body<3, float>> here = exchange<3, float, NoPayload>(MPI_COMM_WORLD, bodies, cuts);
  for (const auto& one : here) EXPECT_EQ(owner(cuts, one.box), test::world_rank());
  const detail::Communicator comm(MPI_COMM_WORLD);
  EXPECT_EQ(comm.sum(std::uint64_t{here.size()}), static_cast<std::uint64_t>(50 * test::world_ranks()));
}

TEST(Exchange, NamesARankThatDoesNotExistOnAllRanks) {
  const int culprit = test::world_ranks() - 1;
  const std::vector<Moved> bodies{body(0), body(1)};
  std::vector<int> to{0, 0};
  if (test::world_rank() == culprit) to[1] = test::world_ranks();
  const std::string by = "rank " + std::to_string(culprit) + ": exchange: ";
  const auto exchanged = [&] { exchange<2, double, Motion>(MPI_COMM_WORLD, bodies, to); };
  EXPECT_EQ(test::message_of<std::invalid_argument>(exchanged), by + "rank " + std::to_string(test::world_ranks()) +
                                                                    " does not exist; there are " +
                                                                    std::to_string(test::world_ranks()));
  if (test::world_rank() == culprit) to.pop_back();
  EXPECT_EQ(test::message_of<std::invalid_argument>(exchanged), by + "there are 2 bodies, but 1 ranks");
}

}  // namespace
}  // namespace graze::exchange_test
