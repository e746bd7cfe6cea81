// SPDX-License-Identifier: MIT
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/pair_list.hpp>
#include <graze/broad/pair_methods.hpp>
#include <graze/broad/worlds.hpp>

namespace graze::detail::pair_methods_test {
namespace {

std::vector<Aabb<3, float>> boxes_of(World world, std::size_t count) {
  const MovingBoxes<3, float> moving(world, count, 5);
  return {moving.boxes().begin(), moving.boxes().end()};
}

bool chooses_dense(const std::vector<Aabb<3, float>>& boxes) {
  return is_for_dense<3, float>(std::span<const Aabb<3, float>>(boxes), nullptr);
}

TEST(PairMethods, AFewBoxesAndBoxesThatMostlyOverlapAreForDense) {
  EXPECT_TRUE(chooses_dense({}));
  EXPECT_TRUE(chooses_dense(boxes_of(World::brownian, 1)));
  EXPECT_TRUE(chooses_dense(boxes_of(World::brownian, 100)));
  EXPECT_TRUE(chooses_dense(boxes_of(World::point, 1000)));
  EXPECT_TRUE(chooses_dense(boxes_of(World::point, 50'000)));
}

TEST(PairMethods, ManyBoxesOfWhichFewOverlapAreForTheTree) {
  for (const World world : {World::brownian, World::heavy, World::line, World::lattice, World::cluster}) {
    EXPECT_FALSE(chooses_dense(boxes_of(world, 1000))) << name_of(world);
    EXPECT_FALSE(chooses_dense(boxes_of(world, 20'000))) << name_of(world);
  }
}

TEST(PairMethods, OfTwoSetsBothCount) {
  const std::vector<Aabb<3, float>> few = boxes_of(World::brownian, 3);
  const std::vector<Aabb<3, float>> many = boxes_of(World::brownian, 5000);
  const std::span<const Aabb<3, float>> all = many;
  EXPECT_TRUE((is_for_dense<3, float>(few, &all))) << "15,000 comparisons take less time than sorting 5,000 boxes";
  EXPECT_FALSE((is_for_dense<3, float>(boxes_of(World::heavy, 4000), &all)));
  const std::vector<Aabb<3, float>> heap = boxes_of(World::point, 2000);
  const std::span<const Aabb<3, float>> same = heap;
  EXPECT_TRUE((is_for_dense<3, float>(heap, &same)));
}

TEST(PairMethods, RemembersWhatItChose) {
  PairMethods<3, float> methods;
  KeptPairRoom room;
  EXPECT_EQ(methods.last(), PairMethod::automatic);
  methods.find(boxes_of(World::point, 100), nullptr, {}, room);
  EXPECT_EQ(methods.last(), PairMethod::dense);
  methods.find(boxes_of(World::brownian, 3000), nullptr, {}, room);
  EXPECT_EQ(methods.last(), PairMethod::tree);
  methods.find(boxes_of(World::point, 100), nullptr, {.method = PairMethod::brute_force}, room);
  EXPECT_EQ(methods.last(), PairMethod::brute_force);
}

}  // namespace
}  // namespace graze::detail::pair_methods_test
