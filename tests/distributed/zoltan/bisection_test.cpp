// SPDX-License-Identifier: MIT
#include <vector>

#include <gtest/gtest.h>

#include <graze/distributed/zoltan/bisection.hpp>

#include "../ranks.hpp"
#include "broad/box_worlds.hpp"

namespace graze::bisection_test {
namespace {

template <Dim N>
int cells_with(const std::vector<Aabb<N, double>>& cells, const Vec<N, double>& point) {
  int found = 0;
  for (const Aabb<N, double>& cell : cells) {
    bool inside = true;
    for (Dim k = 0; k < N; ++k) inside = inside && cell.min[k] <= point[k] && point[k] < cell.max[k];
    if (inside) ++found;
  }
  return found;
}

template <Dim N>
void expect_balanced_cells() {
  const detail::Communicator comm(MPI_COMM_WORLD);
  test::Numbers numbers(static_cast<std::uint64_t>(comm.rank()) + 5);
  std::vector<detail::WeightedPoint<N>> points;
  for (int i = 0; i < 2000; ++i) points.push_back({numbers.point<N, double>(-3, 9), 1.0F});
  const std::vector<Aabb<N, double>> cells = detail::bisected<N>(comm, points);
  ASSERT_EQ(cells.size(), static_cast<std::size_t>(comm.size()));
  std::vector<double> loads(cells.size());
  for (const detail::WeightedPoint<N>& point : points) {
    EXPECT_EQ(cells_with(cells, point.at), 1);  // a cut is at a point, which is above it
    for (std::size_t rank = 0; rank < cells.size(); ++rank) {
      loads[rank] += cells_with<N>({cells[rank]}, point.at);
    }
  }
  comm.add_up(loads);
  for (const double load : loads) EXPECT_NEAR(load, 2000, 200);
  EXPECT_EQ(cells_with(cells, Vec<N, double>(1e200)), 1);
  EXPECT_EQ(cells_with(cells, Vec<N, double>(-1e200)), 1);
}

TEST(Bisection, BalancesPointsInCellsThatFillSpace) {
  expect_balanced_cells<2>();
  expect_balanced_cells<3>();
}

TEST(Bisection, WithoutPointsGivesAllToTheFirst) {
  const detail::Communicator comm(MPI_COMM_WORLD);
  const std::vector<Aabb<3, double>> cells = detail::bisected<3>(comm, {});
  EXPECT_EQ(cells.front(), (Aabb<3, double>::everything()));
  for (std::size_t rank = 1; rank < cells.size(); ++rank) EXPECT_TRUE(is_nothing(cells[rank]));
}

}  // namespace
}  // namespace graze::bisection_test
