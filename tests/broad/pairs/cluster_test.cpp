// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/pairs/cluster.hpp>

#include "broad/box_worlds.hpp"

namespace graze::detail::cluster_test {
namespace {

template <Dim N>
struct Points {
  const std::vector<Vec<N, double>>& points;
  Vec<N, double> operator()(std::uint32_t i) const { return points[i]; }
  void prefetch(std::uint32_t /*i*/) const {}
};

template <Dim N>
std::vector<std::uint32_t> sorted_cluster(const std::vector<Vec<N, double>>& points, std::size_t small) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::vector<std::uint16_t> cells(points.size());
  std::vector<std::uint32_t> spare(points.size());
  sort_cluster<N, double>(order.data(), order.size(), small, Points<N>{points}, cells.data(), spare.data());
  return order;
}

bool is_permutation_of_all(std::vector<std::uint32_t> order) {
  std::sort(order.begin(), order.end());
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    if (order[i] != i) return false;
  }
  return true;
}

/// The mean side of the boxes around every `piece` consecutive points.
template <Dim N>
double mean_side(const std::vector<Vec<N, double>>& points, const std::vector<std::uint32_t>& order,
                 std::size_t piece) {
  double sum = 0;
  int pieces = 0;
  for (std::size_t first = 0; first + piece <= order.size(); first += piece, ++pieces) {
    Aabb<N, double> box = Aabb<N, double>::nothing();
    for (std::size_t k = first; k < first + piece; ++k) box.grow(points[order[k]]);
    for (Dim i = 0; i < N; ++i) sum += (box.max[i] - box.min[i]) / N;
  }
  return sum / pieces;
}

TEST(PointCloud, OfEvenlySpreadPointsBecomesSmallPieces) {
  test::Numbers numbers(1);
  std::vector<Vec<3, double>> points;
  for (int i = 0; i < 20000; ++i) points.push_back(numbers.point<3, double>(0, 100));
  const auto order = sorted_cluster(points, 64);
  EXPECT_TRUE(is_permutation_of_all(order));
  // Cubes that contain 64 of the 20,000 points would have a side of 14.7; unsorted it is 97.
  EXPECT_LT(mean_side(points, order, 64), 30);
}

TEST(PointCloud, OfCloudsWithinCloudsBecomesSmallPiecesToo) {
  test::Numbers numbers(2);
  std::vector<Vec<3, double>> points;
  for (int i = 0; i < 20000; ++i) {
    // Three scales: a hundred clusters in a corner, and one point far away.
    points.push_back(Vec<3, double>(i % 100) * 1e-3 + numbers.point<3, double>(-1e-7, 1e-7));
  }
  points.push_back(Vec<3, double>(1e6));
  const auto order = sorted_cluster(points, 64);
  EXPECT_TRUE(is_permutation_of_all(order));
  EXPECT_LT(mean_side(points, order, 16), 1e-4);
}

TEST(PointCloud, OfEqualPointsKeepsItsOrder) {
  const std::vector<Vec<2, double>> points(5000, Vec<2, double>(3));
  const auto order = sorted_cluster(points, 16);
  EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
}

TEST(PointCloud, WhoseGridsNeverDivideItIsSortedAllTheSame) {
  // Each point is a thousand times nearer to the origin than the previous one: any grid has almost all in one cell.
  std::vector<Vec<2, double>> points;
  for (int i = 0; i < 90; ++i) points.push_back(Vec<2, double>(std::pow(10.0, -3 * i), 0));
  const auto order = sorted_cluster(points, 4);
  for (std::size_t k = 1; k < order.size(); ++k) EXPECT_EQ(order[k], order[k - 1] - 1);
}

TEST(PointCloud, OfAFewIsLeftAsItIs) {
  const std::vector<Vec<2, double>> points{{3, 3}, {1, 1}, {2, 2}};
  EXPECT_EQ(sorted_cluster(points, 3), (std::vector<std::uint32_t>{0, 1, 2}));
}

}  // namespace
}  // namespace graze::detail::cluster_test
