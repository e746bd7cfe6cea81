// SPDX-License-Identifier: MIT
// Batches of questions to a mesh give the answers of single calls, with any executor, wherever the points are.
#include <vector>

#include <gtest/gtest.h>

#include <graze/broad/closest_points.hpp>
#include <graze/broad/ray_casts.hpp>
#include <graze/broad/signed_distances.hpp>
#include <graze/broad/winding_numbers.hpp>

#include "catalogue/numbers.hpp"
#include "meshes.hpp"

namespace graze::test::answers_test {
namespace {

using Mesh3 = Mesh<3, float>;
using Point = Vec<3, float>;

void expect_single_answers(const Mesh3& mesh, const std::vector<Point>& points) {
  for (const Executor* executor : {&serial_executor(), &default_executor()}) {
    const BatchOptions options{executor};
    const auto nearest = closest_points(mesh, points, options);
    const auto distances = signed_distances(mesh, points, options);
    const auto windings = winding_numbers(mesh, points, options);
    ASSERT_EQ(nearest.size(), points.size());
    ASSERT_EQ(distances.size(), points.size());
    ASSERT_EQ(windings.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_EQ(nearest[i], closest_point(mesh, points[i]));
      EXPECT_EQ(distances[i], signed_distance(mesh, points[i]));
      EXPECT_EQ(windings[i], winding_number(mesh, points[i]));
    }
  }
}

/// Of a ring: the same surface as a solid, turned, and with a hole.
std::vector<Mesh3> draw_meshes() {
  const Mesh3 ring = ring_mesh<float>(24, 12, MeshKind::surface);
  const Mesh3 solid = ring_mesh<float>(24, 12);
  const auto turn = Pose<3, float>::from_axis_angle({0.5F, 0, -0.25F}, {1, 2, 3}, 0.7);
  return {ring, solid, transformed(solid, turn),
          mesh_of<3, float>(solid.vertices(), solid.faces().subspan(5), MeshKind::solid)};
}

// So dense that many share a box that no face reaches into, and some lie on a face.
TEST(Answers, AreThoseOfSingleCallsForDensePoints) {
  rc::Random random(8);
  std::vector<Point> points;
  for (int i = 0; i < 6000; ++i) {
    points.emplace_back(Vec<3, double>(between(random, -3, 3), between(random, -3, 3), between(random, -0.6, 0.6)));
  }
  for (const Mesh3& mesh : draw_meshes()) {
    for (std::size_t i = 0; i < 50; ++i) points[100 * i] = mesh.vertices()[5 * i];
    expect_single_answers(mesh, points);
  }
}

TEST(Answers, AreThoseOfSingleCallsForPointsAtOnePlaceOrVeryFarAway) {
  constexpr float far = 1e30F;
  for (const Mesh3& mesh : draw_meshes()) {
    expect_single_answers(mesh, std::vector<Point>(100, mesh.vertices()[3]));
    expect_single_answers(mesh, {{far, far, far}, {-far, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {far, 0, 0}});
  }
}

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
