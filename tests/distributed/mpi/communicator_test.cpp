// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/distributed/mpi/communicator.hpp>

#include "../ranks.hpp"

namespace graze::communicator_test {
namespace {

using detail::ByRank;
using detail::Communicator;
using detail::Traffic;

TEST(Communicator, ReducesAndGathers) {
  Communicator comm(MPI_COMM_WORLD);
  const auto ranks = static_cast<std::uint64_t>(comm.size());
  const auto rank = static_cast<std::uint64_t>(comm.rank());
  EXPECT_EQ(comm.any(rank == ranks - 1 ? 4U : 1U), ranks == 1 ? 4U : 5U);
  EXPECT_EQ(comm.sum((std::uint64_t{1} << 33U) + rank), (ranks << 33U) + ranks * (ranks - 1) / 2);
  std::vector<double> numbers{1, static_cast<double>(rank)};
  comm.add_up(numbers);
  EXPECT_EQ(numbers[0], static_cast<double>(ranks));
  EXPECT_EQ(numbers[1], static_cast<double>(ranks * (ranks - 1) / 2));
  const std::span<const std::uint64_t> all = comm.all(rank * 7);
  for (std::uint64_t r = 0; r < ranks; ++r) EXPECT_EQ(all[r], r * 7);
}

/// Rank a sends a * 3 + b numbers to rank b, except to rank 0, which gets none from odd ranks.
std::size_t amount(int a, int b) { return b == 0 && a % 2 == 1 ? 0 : static_cast<std::size_t>(a * 3 + b); }

TEST(Communicator, SwapsRecordsInTheOrderOfRanks) {
  Communicator comm(MPI_COMM_WORLD);
  ByRank<std::uint64_t> sent;
  std::uint64_t expected_messages = 0;
  for (int to = 0; to < comm.size(); ++to) {
    sent.counts.push_back(amount(comm.rank(), to));
    for (std::size_t k = 0; k < sent.counts.back(); ++k) {
      sent.records.push_back(static_cast<std::uint64_t>(comm.rank() * 10000 + to * 100) + k);
    }
    if (to != comm.rank() && sent.counts.back() > 0) ++expected_messages;
  }
  Traffic traffic;
  const ByRank<std::uint64_t> received = detail::swap(comm, sent, traffic);
  std::vector<std::uint64_t> expected;
  for (int from = 0; from < comm.size(); ++from) {
    EXPECT_EQ(received.counts[static_cast<std::size_t>(from)], amount(from, comm.rank()));
    for (std::size_t k = 0; k < amount(from, comm.rank()); ++k) {
      expected.push_back(static_cast<std::uint64_t>(from * 10000 + comm.rank() * 100) + k);
    }
  }
  EXPECT_EQ(received.records, expected);
  EXPECT_EQ(traffic.messages, expected_messages);
  EXPECT_EQ(traffic.bytes, (sent.records.size() - amount(comm.rank(), comm.rank())) * sizeof(std::uint64_t));
}

TEST(Communicator, SplitsWhatIsLongerThanTheLargestMessage) {
  Communicator comm(MPI_COMM_WORLD);
  const auto ranks = static_cast<std::size_t>(comm.size());
  const std::vector<std::size_t> bytes(ranks, 1000);
  std::vector<std::byte> out(ranks * 1000);
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = static_cast<std::byte>(i * 31 + static_cast<std::size_t>(comm.rank()) * 7 + i / 1000);
  }
  std::vector<std::byte> in(out.size());
  Traffic traffic;
  comm.prepare_swap(bytes, bytes, 7);
  comm.swap_bytes({out, bytes}, {in, bytes}, traffic, 7);
  const auto own = static_cast<std::size_t>(comm.rank());
  for (std::size_t from = 0; from < ranks; ++from) {
    for (std::size_t k = 0; k < 1000; ++k) {
      const std::size_t i = own * 1000 + k;
      ASSERT_EQ(in[from * 1000 + k], static_cast<std::byte>(i * 31 + from * 7 + own)) << from << ' ' << k;
    }
  }
  EXPECT_EQ(traffic.messages, (ranks - 1) * 143);
  EXPECT_EQ(traffic.bytes, (ranks - 1) * 1000);
}

TEST(Communicator, IsNotConfusedByTheMessagesOfItsUser) {
  // A message of the user with the same tag is under way while numbers are swapped.
  const int next = (test::world_rank() + 1) % test::world_ranks();
  const int previous = (test::world_rank() + test::world_ranks() - 1) % test::world_ranks();
  const int number = test::world_rank();
  int got = -1;
  std::vector<MPI_Request> requests(2);
  MPI_Irecv(&got, 1, MPI_INT, MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, requests.data());
  Communicator comm(MPI_COMM_WORLD);
  ByRank<int> sent;
  for (int to = 0; to < comm.size(); ++to) sent.records.push_back(100);
  sent.counts.assign(static_cast<std::size_t>(comm.size()), 1);
  Traffic traffic;
  EXPECT_EQ(detail::swap(comm, sent, traffic).records, sent.records);
  MPI_Isend(&number, 1, MPI_INT, next, 1, MPI_COMM_WORLD, &requests[1]);
  MPI_Waitall(2, requests.data(), MPI_STATUSES_IGNORE);
  EXPECT_EQ(got, previous);
}

TEST(Communicator, CanBeMoved) {
  Communicator first(MPI_COMM_WORLD);
  Communicator second(std::move(first));
  EXPECT_EQ(second.size(), test::world_ranks());
  EXPECT_EQ(second.sum(std::uint64_t{1}), static_cast<std::uint64_t>(test::world_ranks()));
}

TEST(Communicator, NamesTheCallThatFailed) {
  EXPECT_NO_THROW(detail::require_success(MPI_SUCCESS, "MPI_Bcast"));
  const std::string text =
      test::message_of<std::runtime_error>([] { detail::require_success(MPI_ERR_COUNT, "MPI_Bcast"); });
  EXPECT_EQ(text.find("MPI_Bcast failed: "), 0U) << text;
}

}  // namespace
}  // namespace graze::communicator_test
