// SPDX-License-Identifier: MIT
// Pairs and their order are the same for every compiler, machine and instruction set.
#include <cstdint>
#include <span>
#include <string>

#include <gtest/gtest.h>

#include <graze/broad/pairs.hpp>
#include <graze/broad/scene_generators.hpp>

namespace graze::pair_hashes_test {
namespace {

/// FNV-1a of all indices.
std::uint64_t hash_of(std::span<const Pair> pairs) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const Pair& pair : pairs) {
    hash = (hash ^ pair.a) * 0x100000001b3U;
    hash = (hash ^ pair.b) * 0x100000001b3U;
  }
  return hash;
}

struct Golden {
  World world;
  std::uint64_t sorted_hash;
  std::uint64_t any_hash;
};

class PairHashes : public testing::TestWithParam<Golden> {};

/// Frames of a finder, so that boxes are sorted and refitted.
template <Dim N, class T>
std::uint64_t hash_of_frames(World world, PairOrder order) {
  MovingBoxes<N, T> boxes(world, 20'000, 7);
  PairFinder<N, T> finder;
  std::uint64_t hash = 0;
  for (int frame = 0; frame < 3; ++frame, boxes.step()) {
    hash = hash * 31 + hash_of(finder.find(boxes.boxes(), {.order = order, .method = PairMethod::tree}));
  }
  return hash;
}

std::uint64_t hash_in_all_spaces(World world, PairOrder order) {
  return hash_of_frames<2, float>(world, order) ^ (3 * hash_of_frames<2, double>(world, order)) ^
         (5 * hash_of_frames<3, float>(world, order)) ^ (7 * hash_of_frames<3, double>(world, order));
}

TEST_P(PairHashes, AreTheSameOnEveryMachineInEitherOrder) {
  EXPECT_EQ(hash_in_all_spaces(GetParam().world, PairOrder::sorted), GetParam().sorted_hash);
  EXPECT_EQ(hash_in_all_spaces(GetParam().world, PairOrder::any), GetParam().any_hash);
}

INSTANTIATE_TEST_SUITE_P(ManyWorlds, PairHashes,
                         testing::Values(Golden{World::brownian, 0xad8a44ce5a237440U, 0x5698a45880d757c8U},
                                         Golden{World::heavy, 0xc26c3b21a02bfef4U, 0xf4e378c9c4981a4cU},
                                         Golden{World::cluster, 0x4c75638e464f187aU, 0xc2a0cb4bf84a579eU},
                                         Golden{World::line, 0x4f01dc64ba940afaU, 0xc4b09b1d927c6066U},
                                         Golden{World::plane, 0xb1cafdf610196915U, 0xb7ef34f03ab1698dU},
                                         Golden{World::lattice, 0x1be838c1fd0f902U, 0x40838d67d9b124c2U},
                                         Golden{World::giants, 0x87be72ab6bfe3ecU, 0x6ca681b9b9b21988U}),
                         [](const testing::TestParamInfo<Golden>& test) {
                           return std::string(name_of(test.param.world));
                         });

}  // namespace
}  // namespace graze::pair_hashes_test
