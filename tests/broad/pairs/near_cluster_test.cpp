// SPDX-License-Identifier: MIT
#include <cstdint>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/pairs/near_cluster.hpp>

#include "broad/box_worlds.hpp"

namespace graze::detail::near_cluster_test {
namespace {

template <Dim N, class T>
struct FarCenters {
  const std::vector<Aabb<N, T>>& boxes;
  Vec<N, T> operator()(std::uint32_t i) const { return boxes[i].center(); }
  void prefetch(std::uint32_t /*i*/) const {}
};

/// Every third box of a set.
template <class Boxes>
std::vector<std::uint32_t> some_ids(const Boxes& boxes) {
  std::vector<std::uint32_t> ids;
  for (std::size_t k = 0; k < boxes.size(); k += 3) {
    if (is_finite(boxes[k].min) && is_finite(boxes[k].max) && !is_nothing(boxes[k])) {
      ids.push_back(static_cast<std::uint32_t>(k));
    }
  }
  return ids;
}

template <Dim N, class T>
void expect_sorted_as_from_afar(std::uint64_t seed) {
  NearCluster<N, T> cluster;
  for (const std::size_t count : {10U, 9'000U}) {
    for (const auto& world : test::box_worlds<N, T>(count, seed)) {
      SCOPED_TRACE(world.name);
      const std::vector<std::uint32_t> ids = some_ids(world.boxes);
      std::vector<std::uint16_t> cells(ids.size());
      std::vector<std::uint32_t> spare(ids.size());
      std::vector<std::uint32_t> expected = ids;
      sort_cluster<N, T>(expected.data(), ids.size(), 64, FarCenters<N, T>{world.boxes}, cells.data(), spare.data());
      std::vector<std::uint32_t> sorted = ids;
      cluster.sort(world.boxes, sorted.data(), ids.size(), 64, cells.data());
      EXPECT_EQ(sorted, expected);
    }
  }
  EXPECT_GE(cluster.bytes(), 3'000 * sizeof(Aabb<N, T>));
}

TEST(NearCluster, IsSortedAsIfItWereFarAway) {
  expect_sorted_as_from_afar<3, float>(1);
  expect_sorted_as_from_afar<2, double>(2);
}

TEST(NearCluster, OfNoneIsNone) {
  NearCluster<3, float> cluster;
  cluster.sort({}, nullptr, 0, 64, nullptr);
  EXPECT_EQ(cluster.bytes(), 0U);
}

}  // namespace
}  // namespace graze::detail::near_cluster_test
