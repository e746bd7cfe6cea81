// SPDX-License-Identifier: MIT
// The pairs of all ranks together are those of one machine, whatever the world, the ranks and the motion.
#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <mpi.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <graze/broad/brute_force_pairs.hpp>
#include <graze/broad/pairs.hpp>
#include <graze/distributed/distributed_pair_finder.hpp>

#include "broad/box_worlds.hpp"
#include "ranks.hpp"

namespace graze::distributed_pair_finder_test {
namespace {

/// The pairs of one machine whose lower id is among `mine`, ascending.
template <Dim N, class T>
std::vector<IdPair> expected_pairs(const std::vector<Aabb<N, T>>& world, const std::vector<std::uint64_t>& ids,
                                   std::vector<std::uint64_t> mine) {
  std::sort(mine.begin(), mine.end());
  std::vector<IdPair> pairs;
  for (const auto& [a, b] : overlapping_pairs(world, {.executor = &serial_executor()})) {
    const IdPair pair{std::min(ids[a], ids[b]), std::max(ids[a], ids[b])};
    if (std::binary_search(mine.begin(), mine.end(), pair.a)) pairs.push_back(pair);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// Ids that are in no order, some of them beyond 2^32.
std::vector<std::uint64_t> scattered_ids(std::size_t count) {
  std::vector<std::uint64_t> ids(count);
  for (std::size_t i = 0; i < count; ++i) ids[i] = (i + 1) * 0x9E3779B97F4A7C15U;
  return ids;
}

template <Dim N, class T>
bool finds_all(DistributedPairFinder<N, T>& finder, const std::vector<Aabb<N, T>>& world,
               const std::vector<std::uint64_t>& ids, const test::Share<N, T>& share) {
  const std::span<const IdPair> found = finder.find(share.boxes, share.ids);
  const std::vector<IdPair> expected = expected_pairs(world, ids, share.ids);
  return std::equal(found.begin(), found.end(), expected.begin(), expected.end());
}

template <Dim N, class T>
void expect_all_worlds(std::size_t turn) {
  const int ranks = test::world_ranks();
  for (const test::BoxWorld<N, T>& world : test::box_worlds<N, T>(400, 7)) {
    SCOPED_TRACE(world.name);
    const std::vector<std::uint64_t> ids = scattered_ids(world.boxes.size());
    const std::vector<std::function<int(std::size_t)>> shares{
        [ranks](std::size_t i) { return static_cast<int>(i) % ranks; }, [ranks](std::size_t) { return ranks - 1; },
        [ranks](std::size_t i) { return static_cast<int>(i / 57) % ((ranks + 1) / 2); }};
    const auto& rank_of = shares[turn++ % shares.size()];
    const auto share = test::share_of<N, T>(MPI_COMM_WORLD, world.boxes, ids, rank_of);
    DistributedPairFinder<N, T> finder(MPI_COMM_WORLD, {.executor = &serial_executor()});
    EXPECT_TRUE(finds_all(finder, world.boxes, ids, share));
  }
}

TEST(DistributedPairFinder, FindsThePairsOfDifficultWorlds) {
  expect_all_worlds<2, float>(0);
  expect_all_worlds<3, float>(1);
  expect_all_worlds<2, double>(2);
  expect_all_worlds<3, double>(0);
}

TEST(DistributedPairFinder, FindsAllPairsOfIdenticalBoxesAndOfFewerBoxesThanRanks) {
  const int ranks = test::world_ranks();
  for (const std::size_t count : {0U, 1U, 2U, 3U, 40U}) {
    const std::vector<Aabb<3, float>> world(count);
    const std::vector<std::uint64_t> ids = scattered_ids(count);
    const auto share = test::share_of<3, float>(MPI_COMM_WORLD, world, ids,
                                                [ranks](std::size_t i) { return static_cast<int>(i) % ranks; });
    DistributedPairFinder<3, float> finder(MPI_COMM_WORLD);
    EXPECT_TRUE(finds_all(finder, world, ids, share)) << count;
  }
}

/// A world of some dwarfs, giants that meet every cell, infinite, empty and equal boxes, drawn from a seed.
template <Dim N, class T>
std::vector<Aabb<N, T>> drawn_world(test::Numbers& numbers, std::size_t count) {
  constexpr T infinity = std::numeric_limits<T>::infinity();
  std::vector<Aabb<N, T>> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const double kind = numbers.between(0, 1);
    const double half = kind < 0.05 ? 50 : kind < 0.3 ? 2 : 0.5;
    auto center = numbers.point<N, T>(0, 30);
    if (kind > 0.8) {  // on a lattice, so that sides and cuts coincide
      for (Dim k = 0; k < N; ++k) center[k] = static_cast<T>(static_cast<int>(center[k]));
    }
    Aabb<N, T> box = Aabb<N, T>::from_center(center, Vec<N, T>(static_cast<T>(half)));
    if (kind > 0.97) box.max[0] = infinity;
    if (kind > 0.98) box = Aabb<N, T>::everything();
    if (kind > 0.99) box = Aabb<N, T>::nothing();
    if (kind > 0.6 && kind < 0.65 && !boxes.empty()) box = boxes.front();
    boxes.push_back(box);
  }
  return boxes;
}

/// Several frames in which boxes move, jump, change owners and ids, appear and disappear.
template <Dim N, class T>
bool is_right_in_every_frame(MPI_Comm comm, std::uint64_t seed, std::size_t count, double skin) {
  test::Numbers numbers(seed);
  std::vector<Aabb<N, T>> world = drawn_world<N, T>(numbers, count);
  std::vector<std::uint64_t> ids = scattered_ids(count);
  const int ranks = test::ranks_of(comm);
  std::vector<int> owners(count);
  const auto draw_owner = [&] { return static_cast<int>(numbers.between(0, ranks)); };
  for (int& one : owners) one = draw_owner();
  DistributedPairFinder<N, T> finder(comm, {.executor = &serial_executor(), .skin = skin});
  bool right = true;
  for (int frame = 0; frame < 6; ++frame) {
    const auto share = test::share_of<N, T>(comm, world, ids, [&](std::size_t i) { return owners[i]; });
    right = test::on_all(comm, finds_all(finder, world, ids, share)) && right;
    for (Aabb<N, T>& box : world) {
      const auto by = numbers.point<N, T>(-0.1, 0.1);
      if (!is_nothing(box)) box = {box.min + by, box.max + by};
    }
    if (world.empty()) continue;
    const auto chosen = static_cast<std::size_t>(numbers.between(0, static_cast<double>(world.size())));
    if (frame == 2) world[chosen] = drawn_world<N, T>(numbers, 1).front();
    if (frame == 3) owners[chosen] = draw_owner();
    if (frame == 4) {
      world.pop_back();
      ids.pop_back();
      for (Aabb<N, T>& box : world) box = {box.min + T(20), box.max + T(20)};
    }
  }
  return right;
}

RC_GTEST_PROP(DistributedPairFinderLaws, EqualsOneMachineForAnyWorldMotionAndNumberOfRanks, ()) {
  const int ranks = *rc::gen::inRange(1, test::world_ranks() + 1);
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const auto count = *rc::gen::inRange<std::size_t>(0, 300);
  const double skin = *rc::gen::element(0.0, 0.15, 1.0, 30.0);
  const int space = *rc::gen::inRange(0, 4);
  bool right = true;
  const test::FirstRanks some(ranks);
  if (some) {
    right = space == 0   ? is_right_in_every_frame<2, float>(some.comm(), seed, count, skin)
            : space == 1 ? is_right_in_every_frame<3, float>(some.comm(), seed, count, skin)
            : space == 2 ? is_right_in_every_frame<2, double>(some.comm(), seed, count, skin)
                         : is_right_in_every_frame<3, double>(some.comm(), seed, count, skin);
  }
  RC_ASSERT(test::on_all(MPI_COMM_WORLD, right));
}

/// A row of boxes, of which each rank passes an equal part.
test::Share<3, float> row_of_boxes(std::size_t per_rank) {
  test::Share<3, float> share;
  for (std::size_t i = 0; i < per_rank; ++i) {
    const std::size_t place = static_cast<std::size_t>(test::world_rank()) * per_rank + i;
    share.ids.push_back(place);
    share.boxes.push_back(Aabb<3, float>::from_center({static_cast<float>(place), 0, 0}, Vec<3, float>(0.6F)));
  }
  return share;
}

TEST(DistributedPairFinder, KeepsThePlanWhileBoxesStayWithinTheSkinAndTheCutsWhileBalanceLasts) {
  test::Share<3, float> row = row_of_boxes(100);
  DistributedPairFinder<3, float> finder(MPI_COMM_WORLD, {.skin = 0.25});
  finder.find(row.boxes, row.ids);
  EXPECT_TRUE(finder.frame().is_cut);
  EXPECT_TRUE(finder.frame().is_planned);
  const Partition<3> cuts = finder.partition();
  EXPECT_EQ(cuts.ranks(), test::world_ranks());
  for (Aabb<3, float>& box : row.boxes) box = {box.min + 0.125F, box.max + 0.125F};
  finder.find(row.boxes, row.ids);
  EXPECT_FALSE(finder.frame().is_planned);
  if (test::world_rank() == 0) row.boxes[0] = {row.boxes[0].min + 0.25F, row.boxes[0].max + 0.25F};
  finder.find(row.boxes, row.ids);
  EXPECT_TRUE(finder.frame().is_planned);  // on all ranks, because one box has left its skin
  EXPECT_FALSE(finder.frame().is_cut);
  EXPECT_EQ(finder.partition(), cuts);
  for (Aabb<3, float>& box : row.boxes) box = {box.min * 0.001F, box.max * 0.001F};
  finder.find(row.boxes, row.ids);
  EXPECT_EQ(finder.frame().is_cut, test::world_ranks() > 1);
  EXPECT_EQ(finder.frame().boxes, 100U);
}

TEST(DistributedPairFinder, CutsNotInEveryFrameWhatCannotBeBalanced) {
  const std::vector<Aabb<3, float>> boxes(20);
  std::vector<std::uint64_t> ids(20);
  std::iota(ids.begin(), ids.end(), static_cast<std::uint64_t>(test::world_rank()) * 20);
  DistributedPairFinder<3, float> finder(MPI_COMM_WORLD);
  finder.find(boxes, ids);
  EXPECT_TRUE(finder.frame().is_cut);
  std::vector<Aabb<3, float>> moved = boxes;
  for (Aabb<3, float>& box : moved) box.max[0] += 1;
  finder.find(moved, ids);
  EXPECT_TRUE(finder.frame().is_planned);
  EXPECT_FALSE(finder.frame().is_cut);
}

TEST(DistributedPairFinder, CountsGhostsMessagesAndBytes) {
  const test::Share<3, float> row = row_of_boxes(1000);
  DistributedPairFinder<3, float> finder(MPI_COMM_WORLD, {.skin = 1});
  finder.find(row.boxes, row.ids);
  finder.find(row.boxes, row.ids);  // boxes and pairs only
  const DistributedFrame& frame = finder.frame();
  const detail::Communicator comm(MPI_COMM_WORLD);
  EXPECT_EQ(comm.sum(std::uint64_t{frame.pairs}), static_cast<std::uint64_t>(test::world_ranks()) * 1000 - 1);
  if (test::world_ranks() == 1) {
    EXPECT_EQ(frame.ghosts, 0U);
    EXPECT_EQ(frame.messages, 0U);
    EXPECT_EQ(frame.bytes, 0U);
  } else {
    EXPECT_GT(frame.ghosts, 0U);
    EXPECT_GT(frame.messages, 0U);
  }
  // What was sent: each ghost's box, and few pairs, to the owners of their lower ids.
  const std::uint64_t pair_bytes = comm.sum(frame.bytes) - comm.sum(std::uint64_t{frame.ghosts}) * 24;
  EXPECT_EQ(pair_bytes % 16, 0U);
  EXPECT_LE(pair_bytes / 16, 3 * static_cast<std::uint64_t>(test::world_ranks()));
}

/// Runs tasks on the calling thread, and throws when asked to.
class FailingExecutor final : public Executor {
 public:
  bool fails = false;
  void parallel_for(std::size_t count, const std::function<void(std::size_t)>& task) const override {
    if (fails) throw std::domain_error("no threads left");
    serial_executor().parallel_for(count, task);
  }
  std::size_t concurrency() const override { return 1; }
};

TEST(DistributedPairFinderErrors, AppearOnAllRanksAndLeaveTheFinderUsable) {
  test::Share<3, float> row = row_of_boxes(3000);
  const int culprit = test::world_ranks() - 1;
  const bool is_culprit = test::world_rank() == culprit;
  FailingExecutor executor;
  DistributedPairFinder<3, float> finder(MPI_COMM_WORLD, {.executor = &executor});
  const auto find = [&] { finder.find(row.boxes, row.ids); };
  const std::string by = "rank " + std::to_string(culprit) + ": ";
  const float before = row.boxes[2].min[1];
  if (is_culprit) row.boxes[2].min[1] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(test::message_of<std::invalid_argument>(find), by + "overlapping_pairs: box 2, with the id " +
                                                               std::to_string(culprit * 3000 + 2) +
                                                               ", has a coordinate that is NaN");
  row.boxes[2].min[1] = before;
  if (is_culprit) row.ids.pop_back();
  EXPECT_EQ(test::message_of<std::invalid_argument>(find),
            by + "overlapping_pairs: there are 3000 boxes, but 2999 ids; give one for each box");
  if (is_culprit) row.ids.push_back(static_cast<std::uint64_t>(culprit) * 3000 + 2999);
  if (is_culprit) row.ids[0] = 1;  // rank 0 has it, too; on one rank box 1
  EXPECT_NE(test::message_of<std::invalid_argument>(find).find("the id 1 is used twice"), std::string::npos);
  if (is_culprit) row.ids[0] = static_cast<std::uint64_t>(culprit) * 3000;
  executor.fails = is_culprit;
  EXPECT_EQ(test::message_of<std::runtime_error>(find), by + "no threads left");
  executor.fails = false;
  find();
  const detail::Communicator comm(MPI_COMM_WORLD);
  EXPECT_EQ(comm.sum(std::uint64_t{finder.frame().pairs}), static_cast<std::uint64_t>(test::world_ranks()) * 3000 - 1);
}

TEST(DistributedPairFinderErrors, NameOptionsOutOfRange) {
  const auto make = [](const DistributedPairOptions& options) {
    return test::message_of<std::invalid_argument>([&] { DistributedPairFinder<2>(MPI_COMM_WORLD, options); });
  };
  EXPECT_NE(make({.skin = -1}).find("skin is -1.000000; it must be zero or more"), std::string::npos);
  EXPECT_NE(make({.skin = std::numeric_limits<double>::infinity()}).find("skin is inf"), std::string::npos);
  EXPECT_NE(make({.least_balance = 1.5}).find("least_balance is 1.5"), std::string::npos);
}

}  // namespace
}  // namespace graze::distributed_pair_finder_test
