// SPDX-License-Identifier: MIT
#include <cstdint>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/pairs.hpp>
#include <graze/broad/scene_generators.hpp>
#include <graze/distributed/overlapping_pairs.hpp>

#include "ranks.hpp"

namespace graze::distributed_overlapping_pairs_test {
namespace {

TEST(DistributedOverlappingPairs, ConcatenateToThoseOfOneMachine) {
  for (const World world : all_worlds()) {
    if (world == World::point) continue;  // all pairs: the next test
    const MovingBoxes<3, float> moving(world, 3000, 5);
    const std::span<const Aabb<3, float>> boxes = moving.boxes();
    const std::vector<Pair> expected = overlapping_pairs(boxes, {.executor = &serial_executor()});
    const std::size_t ranks = static_cast<std::size_t>(test::world_ranks());
    const std::size_t begin = boxes.size() * static_cast<std::size_t>(test::world_rank()) / ranks;
    const std::size_t end = boxes.size() * (static_cast<std::size_t>(test::world_rank()) + 1) / ranks;
    std::vector<std::uint64_t> ids;
    for (std::size_t i = begin; i < end; ++i) ids.push_back(i);
    const std::vector<IdPair> found = overlapping_pairs<3, float>(MPI_COMM_WORLD, boxes.subspan(begin, end - begin),
                                                                  ids, {.executor = &serial_executor()});
    std::vector<IdPair> mine;
    for (const auto& [a, b] : expected) {
      if (begin <= a && a < end) mine.push_back({a, b});
    }
    EXPECT_EQ(found, mine) << name_of(world);
  }
}

TEST(DistributedOverlappingPairs, AreOwnedByTheRankOfTheLowerId) {
  const std::vector<Aabb<2, double>> boxes{{{0, 0}, {1, 1}}};
  const std::vector<std::uint64_t> ids{static_cast<std::uint64_t>(test::world_ranks() - test::world_rank()) << 40U};
  const std::vector<IdPair> found = overlapping_pairs<2, double>(MPI_COMM_WORLD, boxes, ids);
  ASSERT_EQ(found.size(), static_cast<std::size_t>(test::world_rank()));
  for (std::size_t k = 0; k < found.size(); ++k) EXPECT_EQ(found[k], (IdPair{ids[0], ids[0] + ((k + 1) << 40U)}));
}

}  // namespace
}  // namespace graze::distributed_overlapping_pairs_test
