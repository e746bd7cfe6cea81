// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <graze/distributed/distributed_index.hpp>
#include <graze/query/distance_squared.hpp>
#include <graze/query/intersects.hpp>

#include "broad/box_worlds.hpp"
#include "ranks.hpp"

namespace graze::distributed_index_test {
namespace {

template <Dim N, class T>
std::vector<NearId> nearest_of_all(const std::vector<Aabb<N, T>>& world, const std::vector<std::uint64_t>& ids,
                                   const Vec<N, T>& point, std::size_t count) {
  std::vector<NearId> all;
  for (std::size_t i = 0; i < world.size(); ++i) all.push_back({distance_squared(point, world[i]), ids[i]});
  std::sort(all.begin(), all.end());
  all.resize(std::min(all.size(), count));
  return all;
}

template <class R, Dim N, class T>
std::vector<std::uint64_t> met(const std::vector<Aabb<N, T>>& world, const std::vector<std::uint64_t>& ids,
                               const R& region) {
  std::vector<std::uint64_t> found;
  for (std::size_t i = 0; i < world.size(); ++i) {
    if (intersects(region, world[i])) found.push_back(ids[i]);
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// A world of boxes on a lattice, with many equal distances, and questions that differ from rank to rank.
template <Dim N, class T>
bool answers_all(MPI_Comm comm, std::uint64_t seed, std::size_t size, std::size_t count) {
  test::Numbers numbers(seed);
  std::vector<Aabb<N, T>> world;
  std::vector<std::uint64_t> ids;
  std::vector<int> owners;
  for (std::size_t i = 0; i < size; ++i) {
    Vec<N, T> center = numbers.point<N, T>(0, 8);
    for (Dim k = 0; k < N; ++k) center[k] = static_cast<T>(static_cast<int>(center[k]));
    world.push_back(Aabb<N, T>::from_center(center, Vec<N, T>(static_cast<T>(numbers.between(0.1, 0.6)))));
    ids.push_back(~static_cast<std::uint64_t>(i * 977));
    owners.push_back(static_cast<int>(numbers.between(0, test::ranks_of(comm))));
  }
  if (size > 5) world[3].max[0] = T(1000);  // meets many questions
  const auto share = test::share_of<N, T>(comm, world, ids, [&](std::size_t i) { return owners[i]; });
  DistributedIndex<N, T> index(comm, share.boxes, share.ids, serial_executor());
  test::Numbers own(seed + static_cast<std::uint64_t>(test::rank_in(comm)));
  std::vector<Vec<N, T>> points;
  std::vector<Aabb<N, T>> boxes;
  std::vector<Sphere<N, T>> spheres;
  for (int k = 0; k < 3 * test::rank_in(comm) + 2; ++k) {
    points.push_back(own.point<N, T>(-2, 10));
    if (k % 2 == 0) points.back() = Vec<N, T>(static_cast<T>(k % 9));
    boxes.push_back(Aabb<N, T>::from_corners(own.point<N, T>(-2, 10), own.point<N, T>(-2, 10)));
    spheres.push_back({own.point<N, T>(-2, 10), static_cast<T>(own.between(0, 4))});
  }
  const auto near = index.nearest(points, count);
  const auto in_boxes = index.query(boxes);
  const auto in_spheres = index.query(spheres);
  bool right = true;
  for (std::size_t i = 0; i < points.size(); ++i) {
    right = right && near[i] == nearest_of_all(world, ids, points[i], count);
    right = right && in_boxes[i] == met(world, ids, boxes[i]) && in_spheres[i] == met(world, ids, spheres[i]);
  }
  return right;
}

RC_GTEST_PROP(DistributedIndexLaws, EqualsATestOfEveryBoxForAnyNumberOfRanks, ()) {
  const test::FirstRanks some(*rc::gen::inRange(1, test::world_ranks() + 1));
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const auto size = *rc::gen::inRange<std::size_t>(0, 150);
  const auto count = *rc::gen::element<std::size_t>(0, 1, 3, 40, 1000);
  const bool is_flat = *rc::gen::arbitrary<bool>();
  bool right = true;
  if (some) {
    right = is_flat ? answers_all<2, float>(some.comm(), seed, size, count)
                    : answers_all<3, double>(some.comm(), seed, size, count);
  }
  RC_ASSERT(test::on_all(MPI_COMM_WORLD, right));
}

TEST(DistributedIndexErrors, AppearOnAllRanks) {
  const bool is_culprit = test::world_rank() == test::world_ranks() - 1;
  const auto own = static_cast<std::uint64_t>(test::world_rank());
  std::vector<Aabb<3, float>> boxes(1);
  std::vector<std::uint64_t> ids{own};
  const auto make = [&] { return DistributedIndex<3, float>(MPI_COMM_WORLD, boxes, ids); };
  const auto told = [&] { return test::message_of<std::invalid_argument>([&] { make(); }); };
  if (is_culprit) boxes[0].min[0] = 7;
  EXPECT_NE(told().find("has a min above its max"), std::string::npos);
  boxes[0].min[0] = -1;
  if (is_culprit) ids.push_back(own + 1);
  EXPECT_NE(told().find("there are 1 boxes, but 2 ids"), std::string::npos);
  if (is_culprit) ids.pop_back();
  DistributedIndex<3, float> index = make();
  std::vector<Vec<3, float>> points{Vec<3, float>(0.0F)};
  if (is_culprit) points[0][1] = std::numeric_limits<float>::infinity();
  EXPECT_NE(test::message_of<std::invalid_argument>([&] { index.nearest(points, 1); }).find("not finite"),
            std::string::npos);
  std::vector<Sphere<3, float>> spheres{{Vec<3, float>(0.0F), is_culprit ? -1.0F : 1.0F}};
  EXPECT_NE(test::message_of<std::invalid_argument>([&] { index.query(spheres); }), "none");
  spheres[0].radius = 1;
  EXPECT_EQ(index.query(spheres)[0].size(), static_cast<std::size_t>(test::world_ranks()));
}

}  // namespace
}  // namespace graze::distributed_index_test
