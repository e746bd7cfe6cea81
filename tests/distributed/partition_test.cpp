// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/distributed/partition.hpp>

#include "broad/box_worlds.hpp"
#include "ranks.hpp"

namespace graze::partition_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Left half; right half below and above y = 2.
Partition<2> three_cells() {
  return Partition<2>(
      {{{-infinity, -infinity}, {1, infinity}}, {{1, -infinity}, {infinity, 2}}, {{1, 2}, {infinity, infinity}}});
}

template <class T>
std::vector<int> ranks_of(const Partition<2>& partition, const Aabb<2, T>& box) {
  std::vector<int> ranks;
  partition.visit_ranks(box, [&](int rank) { ranks.push_back(rank); });
  return ranks;
}

TEST(Partition, GivesPointsOnACutToTheUpperSide) {
  const Partition<2> partition = three_cells();
  EXPECT_EQ(partition.ranks(), 3);
  EXPECT_EQ(partition.rank_at(Vec<2, float>(0, 5)), 0);
  EXPECT_EQ(partition.rank_at(Vec<2, float>(1, 1)), 1);
  EXPECT_EQ(partition.rank_at(Vec<2, float>(1, 2)), 2);
  EXPECT_EQ(partition.rank_at(Vec<2, double>(-infinity, infinity)), 0);
  EXPECT_EQ(partition.rank_at(Vec<2, double>(infinity, -infinity)), 1);
  EXPECT_EQ(partition.rank_at(Vec<2, double>(infinity, infinity)), 2);
}

TEST(Partition, FindsCutsWhateverTheNumbersOfTheCells) {
  const Partition<2> partition(
      {{{1, 2}, {infinity, infinity}}, {{-infinity, -infinity}, {1, infinity}}, {{1, -infinity}, {infinity, 2}}});
  EXPECT_EQ(partition.rank_at(Vec<2, float>(5, 5)), 0);
  EXPECT_EQ(partition.rank_at(Vec<2, float>(0, 5)), 1);
  EXPECT_EQ(partition.rank_at(Vec<2, float>(5, 0)), 2);
}

TEST(Partition, VisitsTheCellsThatABoxMeets) {
  const Partition<2> partition = three_cells();
  EXPECT_EQ(ranks_of(partition, Aabb<2, float>{{0, 0}, {0.5F, 9}}), (std::vector<int>{0}));
  EXPECT_EQ(ranks_of(partition, Aabb<2, float>{{0, 0}, {1, 1}}), (std::vector<int>{0, 1}));
  EXPECT_EQ(ranks_of(partition, Aabb<2, float>{{1, 0}, {3, 2}}), (std::vector<int>{1, 2}));
  EXPECT_EQ(ranks_of(partition, Aabb<2, float>::everything()), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(ranks_of(partition, Aabb<2, float>::nothing()), std::vector<int>{});
}

TEST(Partition, AcceptsEmptyCellsAndRefusesNone) {
  const Partition<2> partition({Aabb<2, double>::nothing(), Aabb<2, double>::everything(), {{1, 1}, {1, 5}}});
  EXPECT_EQ(partition.rank_at(Vec<2, float>(3, 3)), 1);
  EXPECT_TRUE(is_nothing(partition.cell(0)));
  EXPECT_EQ(partition.cell(1), (Aabb<2, double>::everything()));
  EXPECT_TRUE(is_nothing(partition.cell(2)));
  EXPECT_THROW(Partition<2>(std::vector<Aabb<2, double>>{}), std::invalid_argument);
  EXPECT_THROW(Partition<2>({Aabb<2, double>::nothing()}), std::invalid_argument);
  EXPECT_EQ(Partition<3>().rank_at(Vec<3, float>(1, 2, 3)), 0);
}

TEST(Partition, CellsThatNoCutPartsBelongToTheFirst) {
  const Partition<2> partition({{{0, 0}, {2, 2}}, {{1, 1}, {3, 3}}});
  EXPECT_EQ(partition.rank_at(Vec<2, float>(2.5F, 2.5F)), 0);
  EXPECT_EQ(ranks_of(partition, Aabb<2, float>::everything()), (std::vector<int>{0}));
}

TEST(Partition, AnchorsAreFinite) {
  EXPECT_EQ(anchor(Aabb<2, float>{{1, 2}, {3, 8}}), (Vec<2, double>(2, 5)));
  EXPECT_EQ(anchor(Aabb<2, double>{{-infinity, 2}, {3, infinity}}), (Vec<2, double>(3, 2)));
  EXPECT_EQ(anchor(Aabb<2, double>::everything()), (Vec<2, double>(0, 0)));
  const double huge = std::numeric_limits<double>::max();
  EXPECT_EQ(anchor(Aabb<2, double>{{-huge, huge}, {huge, huge}}), (Vec<2, double>(0, 1e150)));
}

/// Boxes of this rank, different on each.
std::vector<Aabb<3, float>> own_boxes(std::size_t count) {
  test::Numbers numbers(static_cast<std::uint64_t>(test::world_rank()) * 31 + 1);
  std::vector<Aabb<3, float>> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    boxes.push_back(Aabb<3, float>::from_center(numbers.point<3, float>(0, 50), Vec<3, float>(0.5F)));
  }
  return boxes;
}

TEST(Partitioning, BalancesAndIsTheSameOnEveryRankAndEveryTime) {
  const std::vector<Aabb<3, float>> boxes = own_boxes(5000);
  const std::span<const Aabb<3, float>> all = boxes;
  const Partition<3> cuts = partition(MPI_COMM_WORLD, all);
  EXPECT_EQ(cuts.ranks(), test::world_ranks());
  EXPECT_EQ(cuts, partition(MPI_COMM_WORLD, all));
  EXPECT_GT(balance(MPI_COMM_WORLD, cuts, all), 0.95);
  Aabb<3, double> first = cuts.cell(0);
  MPI_Bcast(&first, sizeof first, MPI_BYTE, 0, MPI_COMM_WORLD);
  EXPECT_EQ(first, cuts.cell(0));
  for (const Aabb<3, float>& box : boxes) {
    int ranks = 0;
    cuts.visit_ranks(box, [&](int rank) { ranks += rank == owner(cuts, box) ? 1 : 0; });
    EXPECT_EQ(ranks, 1);
  }
}

TEST(Partitioning, SamplesManyBoxesWell) {
  const std::vector<Aabb<3, float>> boxes = own_boxes(200'000);
  const std::span<const Aabb<3, float>> all = boxes;
  EXPECT_GT(balance(MPI_COMM_WORLD, partition(MPI_COMM_WORLD, all), all), 0.95);
}

TEST(Partitioning, WeighsBoxes) {
  const std::vector<Aabb<3, float>> boxes = own_boxes(4000);
  const std::span<const Aabb<3, float>> all = boxes;
  std::vector<float> weights;
  for (const Aabb<3, float>& box : boxes) weights.push_back(box.min[0] < 10 ? 20.0F : 1.0F);
  const Partition<3> cuts = partition(MPI_COMM_WORLD, all, {.weights = weights});
  EXPECT_GT(balance(MPI_COMM_WORLD, cuts, all, weights), 0.9);
  EXPECT_EQ(balance(MPI_COMM_WORLD, cuts, all) < 0.9, test::world_ranks() > 1);
}

TEST(Partitioning, KeepsCutsWhileTheirBalanceLasts) {
  std::vector<Aabb<3, float>> boxes = own_boxes(3000);
  const Partition<3> before = partition(MPI_COMM_WORLD, std::span<const Aabb<3, float>>(boxes));
  for (Aabb<3, float>& box : boxes) box = {box.min + 0.5F, box.max + 0.5F};
  const std::span<const Aabb<3, float>> all = boxes;
  EXPECT_EQ(partition(MPI_COMM_WORLD, all, before), before);
  for (Aabb<3, float>& box : boxes) box = {box.min * 0.01F, box.max * 0.01F};
  EXPECT_EQ(partition(MPI_COMM_WORLD, all, before, {.least_balance = 0}), before);
  EXPECT_EQ(partition(MPI_COMM_WORLD, all, before) == before, test::world_ranks() == 1);
}

TEST(PartitioningErrors, AppearOnAllRanks) {
  std::vector<Aabb<3, float>> boxes = own_boxes(3);
  const bool is_culprit = test::world_rank() == test::world_ranks() - 1;
  const auto told = [&](const PartitionOptions& options) {
    return test::message_of<std::invalid_argument>(
        [&] { partition(MPI_COMM_WORLD, std::span<const Aabb<3, float>>(boxes), options); });
  };
  const std::string by = "rank " + std::to_string(test::world_ranks() - 1) + ": partition: ";
  const std::vector<float> two(2, 1.0F);
  const std::vector<float> negative{1, 1, -1};
  EXPECT_EQ(told({.weights = is_culprit ? std::span<const float>(two) : std::span<const float>()}),
            by + "there are 2 weights for 3 boxes; give one for each, or none");
  EXPECT_EQ(told({.weights = is_culprit ? std::span<const float>(negative) : std::span<const float>()}),
            by + "weight 2 is -1.000000; it must be finite and at least 0");
  if (is_culprit) boxes[1].max[2] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(told({}), by + "box 1 has a coordinate that is NaN");
}

}  // namespace
}  // namespace graze::partition_test
