// SPDX-License-Identifier: MIT
#include <cstdint>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include <graze/distributed/pairs/ghost_plan.hpp>

#include "../ranks.hpp"

namespace graze::ghost_plan_test {
namespace {

TEST(MergeRuns, MakesOneRunOfAnyNumber) {
  std::vector<int> values{5, 9, 1, 2, 3, 4, 8, 0};
  detail::merge_runs(values, {2, 0, 3, 2, 0, 1, 0}, std::less<>());
  EXPECT_EQ(values, (std::vector<int>{0, 1, 2, 3, 4, 5, 8, 9}));
  std::vector<int> none;
  detail::merge_runs(none, {0, 0}, std::less<>());
  detail::merge_runs(none, {}, std::less<>());
  EXPECT_TRUE(none.empty());
}

TEST(GhostPlan, HoldsWhileBoxesStayInTheirRegions) {
  const std::vector<Aabb<2, float>> boxes{{{0, 0}, {1, 1}}, Aabb<2, float>::nothing()};
  detail::GhostPlan<2, float> plan;
  plan.route(Partition<2>(), boxes, 0.5);
  EXPECT_TRUE(plan.holds(boxes));
  std::vector<Aabb<2, float>> moved = boxes;
  moved[0] = {{-0.5F, 0.5F}, {0.5F, 1.5F}};
  EXPECT_TRUE(plan.holds(moved));
  moved[0].max[1] = 1.75F;
  EXPECT_FALSE(plan.holds(moved));
  moved[0] = boxes[0];
  moved[1] = boxes[0];  // an empty box that is empty no more
  EXPECT_FALSE(plan.holds(moved));
}

TEST(GhostPlan, BringsEachBoxToEveryRankWhoseCellItMeetsAscendingById) {
  detail::Communicator comm(MPI_COMM_WORLD);
  const std::vector<Aabb<2, float>> boxes{Aabb<2, float>::everything(), Aabb<2, float>::nothing()};
  const auto rank = static_cast<std::uint64_t>(comm.rank());
  const auto ranks = static_cast<std::uint64_t>(comm.size());
  const std::vector<std::uint64_t> ids{1000 - rank, 5000 + rank};
  std::vector<Aabb<2, double>> cells(static_cast<std::size_t>(comm.size()), Aabb<2, double>::everything());
  for (std::size_t k = 1; k < cells.size(); ++k) {  // strips
    cells[k].min[0] = static_cast<double>(k);
    cells[k - 1].max[0] = static_cast<double>(k);
  }
  detail::GhostPlan<2, float> plan;
  detail::Traffic traffic;
  plan.route(Partition<2>(cells), boxes, 0);
  const std::span<const std::size_t> announced = plan.announced(comm);
  const std::vector<std::size_t> incoming(announced.begin(), announced.end());
  EXPECT_EQ(incoming, std::vector<std::size_t>(incoming.size(), 1));
  plan.exchange_ids(comm, ids, incoming, traffic);
  plan.exchange_boxes(comm, boxes, traffic);
  plan.arrange();
  ASSERT_EQ(plan.searched().size(), ranks);
  for (std::uint64_t k = 0; k < ranks; ++k) {
    EXPECT_EQ(plan.id(k), 1000 - ranks + 1 + k);
    EXPECT_EQ(plan.rank(k), static_cast<int>(ranks - 1 - k));
    EXPECT_EQ(plan.searched()[k], (Aabb<2, float>::everything()));
  }
  EXPECT_EQ(plan.from(comm.rank()), 1U);
}

}  // namespace
}  // namespace graze::ghost_plan_test
