// SPDX-License-Identifier: MIT
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/pairs/pair_list.hpp>
#include <graze/broad/pairs/pair_methods.hpp>
#include <graze/broad/scene_generators.hpp>

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
  EXPECT_TRUE(chooses_dense(boxes_of(World::brownian, 20)));
  EXPECT_TRUE(chooses_dense(boxes_of(World::point, 1000)));
  EXPECT_TRUE(chooses_dense(boxes_of(World::point, 50'000)));
}

TEST(PairMethods, ManyBoxesOfWhichFewOverlapAreForTheTree) {
  EXPECT_FALSE(chooses_dense(boxes_of(World::brownian, 100)));
  for (const World world : {World::brownian, World::heavy, World::line, World::lattice, World::cluster}) {
    EXPECT_FALSE(chooses_dense(boxes_of(world, 1000))) << name_of(world);
    EXPECT_FALSE(chooses_dense(boxes_of(world, 20'000))) << name_of(world);
  }
}

TEST(PairMethods, OfTwoSetsBothCount) {
  const std::vector<Aabb<3, float>> few = boxes_of(World::brownian, 3);
  const std::vector<Aabb<3, float>> many = boxes_of(World::brownian, 5000);
  const std::span<const Aabb<3, float>> all = many;
  EXPECT_TRUE((is_for_dense<3, float>(few, &all))) << "15,000 comparisons take less time than a tree of 5,000 boxes";
  EXPECT_FALSE((is_for_dense<3, float>(boxes_of(World::heavy, 4000), &all)));
  const std::vector<Aabb<3, float>> heap = boxes_of(World::point, 2000);
  const std::span<const Aabb<3, float>> same = heap;
  EXPECT_TRUE((is_for_dense<3, float>(heap, &same)));
}

TEST(PairMethods, WithASetOfNoneThereIsNothingToFind) {
  const std::vector<Aabb<3, float>> boxes = boxes_of(World::brownian, 1000);
  const std::span<const Aabb<3, float>> many = boxes;
  const std::span<const Aabb<3, float>> none;
  EXPECT_TRUE((is_for_dense<3, float>(many, &none)));
  EXPECT_TRUE((is_for_dense<3, float>(none, &many)));
  EXPECT_TRUE(overlapping_pairs(many, none).empty());
  EXPECT_TRUE(overlapping_pairs(none, many).empty());
}

/// A region around each box, as in queries: the k-th box and the k-th region always overlap.
TEST(PairMethods, SetsThatFollowEachOtherAreNoCrowd) {
  const std::vector<Aabb<3, float>> boxes = boxes_of(World::brownian, 20'000);
  std::vector<Aabb<3, float>> regions;
  for (const Aabb<3, float>& box : boxes) regions.push_back({box.min - 1.0F, box.max + 1.0F});
  const std::span<const Aabb<3, float>> around = regions;
  EXPECT_FALSE((is_for_dense<3, float>(boxes, &around)));
  EXPECT_FALSE((is_for_dense<3, float>(boxes, &around, 0.5)));
}

/// Clusters in turn: boxes at any fixed stride may belong to one cluster.
TEST(PairMethods, BoxesInTurnAreNoCrowd) {
  for (std::size_t period = 200; period <= 1000; ++period) {
    std::vector<Aabb<3, float>> boxes;
    for (std::size_t k = 0; k < 10'000; ++k) {
      const Vec<3, float> at(10.0F * static_cast<float>(k % period));
      boxes.push_back({at, at + 1.0F});
    }
    EXPECT_FALSE(chooses_dense(boxes)) << period;
  }
}

/// Wherever the giants are: one that happens to be sampled counts for its own pairs only.
TEST(PairMethods, AFewGiantsAreNoCrowd) {
  const std::vector<Aabb<3, float>> dwarfs = boxes_of(World::brownian, 20'000);
  Aabb<3, float> all = Aabb<3, float>::nothing();
  for (const Aabb<3, float>& box : dwarfs) all.grow(box);
  for (std::size_t place = 0; place < dwarfs.size(); place += 97) {
    std::vector<Aabb<3, float>> boxes = dwarfs;
    for (std::size_t giant = 0; giant < 20; ++giant) boxes[(place + giant * 31) % boxes.size()] = all;
    EXPECT_FALSE(chooses_dense(boxes)) << place;
  }
}

TEST(PairMethods, AMarginMakesACrowd) {
  const std::vector<Aabb<3, float>> boxes = boxes_of(World::brownian, 20'000);
  const std::span<const Aabb<3, float>> all = boxes;
  EXPECT_FALSE((is_for_dense<3, float>(all, nullptr)));
  EXPECT_TRUE((is_for_dense<3, float>(all, nullptr, 1e6)));
}

TEST(PairMethods, RemembersWhatItChose) {
  PairMethods<3, float> methods;
  KeptPairSink room;
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
