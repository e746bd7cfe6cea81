// SPDX-License-Identifier: MIT
// Batches of questions to a mesh give the answers of single calls, with any executor.
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/closest_points.hpp>
#include <graze/broad/ray_casts.hpp>
#include <graze/broad/signed_distances.hpp>
#include <graze/broad/winding_numbers.hpp>

#include "meshes.hpp"

namespace graze::test::answers_test {
namespace {

TEST(Answers, AreThoseOfSingleCallsInOrder) {
  const Mesh<3, float> ring = ring_mesh<float>(24, 12);
  std::vector<Vec<3, float>> points;
  std::vector<Ray<3, float>> rays;
  rc::Random random(7);
  const auto number = [&random] { return static_cast<float>(random.next() % 6001) / 1000 - 3; };
  for (int i = 0; i < 1000; ++i) {
    points.push_back({number(), number(), number() / 4});
    rays.push_back({points.back(), {number(), number() + 0.0005F, number()}});
  }
  for (const Executor* executor : {&serial_executor(), &default_executor()}) {
    const BatchOptions options{executor};
    const auto hits = ray_casts(ring, rays, options);
    const auto nearest = closest_points(ring, points, options);
    const auto distances = signed_distances(ring, points, options);
    const auto windings = winding_numbers(ring, points, options);
    ASSERT_EQ(hits.size(), rays.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_EQ(hits[i], ray_cast(ring, rays[i]));
      EXPECT_EQ(nearest[i], closest_point(ring, points[i]));
      EXPECT_EQ(distances[i], signed_distance(ring, points[i]));
      EXPECT_EQ(windings[i], winding_number(ring, points[i]));
    }
  }
  EXPECT_TRUE(ray_casts(ring, {}).empty());
}

}  // namespace
}  // namespace graze::test::answers_test
