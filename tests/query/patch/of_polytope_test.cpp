// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/patch/of_polytope.hpp>
#include <graze/shape/convex_mesh.hpp>

#include "catalogue.hpp"

namespace graze::detail::patch_polytope_test {
namespace {

using V2 = Vec<2, double>;
using V3 = Vec<3, double>;

const V3 zero(0.0);

Polytope<3, double> hull(const std::vector<V3>& points) { return convex_hull<3, double>(points); }

const auto house = hull({{0, 0, 0},
                         {4, 0, 0},
                         {4, 4, 0},
                         {0, 4, 0},
                         {0, 0, 3},
                         {4, 0, 3},
                         {4, 4, 3},
                         {0, 4, 3},
                         {2, 2, 5},
                         {2, 2, 0},
                         {2, 0, 0}});  // those inside the floor and on its rim are no corners

/// The corners of the patch, in any order.
std::set<std::vector<double>> corner_set(const Patch<3>& patch) {
  std::set<std::vector<double>> corners;
  for (std::size_t i = 0; i < patch.size; ++i) {
    corners.insert({patch.corners[i].x, patch.corners[i].y, patch.corners[i].z});
  }
  return corners;
}

TEST(PatchOfPolytope, IsTheWholeFaceWithoutPointsInsideOrOnItsRim) {
  const Patch<3> floor_patch = patch_of_polytope(house, zero, V3(0, 0, -1));
  EXPECT_EQ(floor_patch.normal, V3(0, 0, -1));
  EXPECT_EQ(corner_set(floor_patch), (std::set<std::vector<double>>{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}));
  const Patch<3> wall = patch_of_polytope(house, zero, V3(1, 0.01, -0.02));
  EXPECT_EQ(wall.normal, V3(1, 0, 0));
  EXPECT_EQ(wall.size, 4U);
}

TEST(PatchOfPolytope, NamesItsCornersByTheirPlaces) {
  const Patch<3> patch = patch_of_polytope(house, V3(1, 1, 1), V3(0, 0, -1));
  for (std::size_t i = 0; i < patch.size; ++i) {
    EXPECT_EQ(house.vertices()[patch.vertices[i]] - V3(1, 1, 1), patch.corners[i]);
  }
  EXPECT_EQ(std::set<std::uint32_t>(patch.edges.begin(), patch.edges.begin() + 4).size(), 4U);
}

/// The numbers of the face, its corners and its edges, in order.
std::vector<std::uint32_t> numbers_of(const Patch<3>& patch) {
  std::vector<std::uint32_t> numbers{patch.face};
  numbers.insert(numbers.end(), patch.vertices.begin(), patch.vertices.begin() + patch.size);
  numbers.insert(numbers.end(), patch.edges.begin(), patch.edges.begin() + patch.size);
  return numbers;
}

/// A hull of points of a small grid: many corners share coordinates, many faces have more than three.
Polytope<3, double> grid_hull() {
  std::vector<V3> points;
  const auto count = *test::choice(std::size_t{16});
  for (std::size_t i = 0; i < 4 + count; ++i) {
    const auto place = *test::choice(std::size_t{125});
    points.emplace_back(place % 5, place / 5 % 5, place / 25);
  }
  return hull(points);
}

/// Some rotation and translation.
Pose<3, double> some_pose() {
  const auto way = *test::any<Ray<3, double>>();
  const auto degrees = static_cast<double>(*test::choice(std::size_t{3600})) / 10;
  return {rotation_matrix(unit_or(way.direction, V3(0, 0, 1)), degrees), V3(3, -1, 2)};
}

// The corners of a mesh are those of the hull.
TEST(PatchOfPolytope, NamesEveryFaceByItsLeastCornerAndTheNextWhateverThePose) {
  test::check_property([] {
    const auto polytope = grid_hull();
    const auto count = static_cast<std::uint32_t>(polytope.vertices().size());
    const ConvexMesh<double> mesh = convex_mesh(polytope);
    const Pose<3, double> pose = some_pose();
    const auto moved = transformed(polytope, pose);
    std::set<std::uint32_t> names;
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
      const HalfEdge& first = mesh.half_edges[mesh.faces[face]];
      const V3 normal = face_plane(mesh, face).normal;
      const Patch<3> patch = patch_of_polytope(polytope, zero, normal);
      RC_ASSERT(patch.face == first.origin * count + mesh.half_edges[first.next].origin);
      const Patch<3> there = patch_of_polytope(moved, pose.position, pose.rotation * normal);
      RC_ASSERT(numbers_of(there) == numbers_of(patch));
      names.insert(patch.face);
    }
    RC_ASSERT(names.size() == mesh.faces.size());
  });
}

TEST(PatchOfPolytope, OfACornerThatHardlySticksOutIsTheSameWithoutIt) {
  const std::vector<V3> cube{{0, 0, 0}, {0, 0, 4}, {0, 4, 0}, {0, 4, 4}, {4, 0, 0}, {4, 0, 4}, {4, 4, 0}, {4, 4, 4}};
  for (const V3& extra : {V3(4, 4, 4 + 1e-9), V3(4 + 1e-9, 4 + 1e-9, 2), V3(4 + 1e-9, 1, 4)}) {
    std::vector<V3> points = cube;
    points.push_back(extra);
    const auto bumpy = hull(points);
    const Patch<3> patch = patch_of_polytope(bumpy, zero, V3(1, 0, 0));
    EXPECT_EQ(patch.size, 4U) << extra;
    EXPECT_EQ(patch.vertices[0], 4U) << extra;
  }
}

TEST(PatchOfPolytope, OfASlopeIsItsTriangle) {
  const Patch<3> roof = patch_of_polytope(house, zero, V3(0, -2, 2) / std::sqrt(8.0));
  EXPECT_NEAR(length(roof.normal - V3(0, -1, 1) * std::sqrt(0.5)), 0, 1e-15);
  EXPECT_EQ(corner_set(roof), (std::set<std::vector<double>>{{0, 0, 3}, {4, 0, 3}, {2, 2, 5}}));
}

TEST(PatchOfPolytope, IsAFaceOfTheHullWhateverTheDirection) {
  test::check_property([] {
    const auto polytope = *test::any<Polytope<3, double>>();
    const auto way = *test::any<Ray<3, double>>();
    const V3 direction = unit_or(way.direction, V3(0, 0, 1));
    const Patch<3> patch = patch_of_polytope(polytope, zero, direction);
    RC_ASSERT(patch.size > 0U);
    if (max_abs(patch.normal) == 0) return;
    RC_LOG() << test::to_source(polytope) << " along " << test::to_source(direction) << "\n";
    double size = 0;
    for (const V3& vertex : polytope.vertices()) size = std::max(size, sum_abs(vertex - patch.corners[0]));
    for (const V3& vertex : polytope.vertices()) {
      RC_ASSERT(dot(patch.normal, vertex - patch.corners[0]) <= 2 * tolerance::aligned * size);
    }
  });
}

TEST(PatchOfPolytope, OfFlatPolytopesIsWhatThereIs) {
  EXPECT_EQ(patch_of_polytope(hull({{1, 2, 3}}), zero, V3(1, 0, 0)).size, 1U);
  EXPECT_EQ(patch_of_polytope(hull({{1, 2, 3}, {4, 5, 6}, {2, 3, 4}}), zero, V3(1, 0, 0)).size, 2U);
  const Patch<3> flat = patch_of_polytope(hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), zero, V3(0, 0, 1));
  EXPECT_EQ(flat.size, 3U);
  EXPECT_EQ(flat.normal, V3(0, 0, 1));
}

/// A cone on its tip: `count` corners around its only face, the first of them along x.
Polytope<3, double> cone(std::size_t count) {
  std::vector<V3> points{{0, 0, -1}};
  for (std::size_t i = 0; i < count; ++i) {
    const V2 turn = cosine_sine_of_degrees(360.0 * static_cast<double>(i) / static_cast<double>(count));
    points.emplace_back(turn.x, turn.y, 0);
  }
  return hull(points);
}

double area_of(const Patch<3>& patch) {
  V3 twice(0.0);
  for (std::size_t i = 0; i < patch.size; ++i) {
    twice += cross(patch.corners[i], patch.corners[i + 1 < patch.size ? i + 1 : 0]);
  }
  return std::fabs(dot(twice, patch.normal)) / 2;
}

/// The corners of a regular octagon, or nearly so: 2 sqrt(2) is the largest area of eight corners in a circle.
TEST(PatchOfPolytope, OfMoreThanEightCornersKeepsEightAllAround) {
  for (const std::size_t count : {9U, 40U, 127U, 128U, 129U, 130U, 1000U}) {
    const auto polytope = cone(count);
    const Patch<3> patch = patch_of_polytope(polytope, zero, V3(0, 0, 1));
    EXPECT_EQ(patch.normal, V3(0, 0, 1)) << count;
    ASSERT_EQ(patch.size, 8U) << count;
    EXPECT_EQ(corner_set(patch).size(), 8U) << count;
    EXPECT_GT(area_of(patch), count == 9 ? 2.5 : 2.8) << count;
    for (std::size_t i = 0; i < patch.size; ++i) {
      EXPECT_EQ(polytope.vertices()[patch.vertices[i]], patch.corners[i]) << count;
    }
  }
}

TEST(PatchOfPolytope, OfManyCornersIsTheSameWhateverThePose) {
  for (const std::size_t count : {9U, 12U, 40U, 128U, 129U, 200U}) {
    const auto polytope = cone(count);
    const Patch<3> patch = patch_of_polytope(polytope, zero, V3(0, 0, 1));
    for (const double degrees : {1e-14, 1e-7, 10.0, 90.0, 180.0, 200.0}) {
      const Pose<3, double> pose{rotation_matrix(V3(0.3, -0.2, 0.9), degrees), V3(1, 2, 3)};
      const Patch<3> there = patch_of_polytope(transformed(polytope, pose), zero, pose.rotation * V3(0, 0, 1));
      EXPECT_EQ(numbers_of(there), numbers_of(patch)) << count << ", " << degrees;
    }
  }
}

/// A wedge's face with 200 corners on an arc of one degree and one far away: fewer than eight are extreme.
TEST(PatchOfPolytope, OfManyCornersKeepsNoneTwice) {
  std::vector<V3> wedge{{0, 0, -1}, {-2, 0, 0}};
  for (int i = 0; i < 200; ++i) {
    const V2 turn = cosine_sine_of_degrees(i / 200.0);
    wedge.emplace_back(turn.x, turn.y, 0);
  }
  const auto polytope = hull(wedge);
  ASSERT_EQ(polytope.vertices().size(), 202U);
  const Patch<3> patch = patch_of_polytope(polytope, zero, V3(0, 0, 1));
  EXPECT_EQ(patch.normal, V3(0, 0, 1));
  EXPECT_EQ(corner_set(patch).size(), patch.size);
  EXPECT_EQ(corner_set(patch).count({-2, 0, 0}), 1U);
  EXPECT_EQ(corner_set(patch).count({1, 0, 0}), 1U);
  EXPECT_GE(patch.size, 3U);
}

TEST(PatchOfPolytope, InThePlaneIsAnEdge) {
  const auto polygon = convex_hull<2, double>(std::vector<V2>{{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  const Patch<2> patch = patch_of_polytope(polygon, V2(1, 1), V2(1, 0.5));
  EXPECT_EQ(patch.normal, V2(1, 0));
  EXPECT_EQ(patch.corners[0], V2(3, -1));
  EXPECT_EQ(patch.corners[1], V2(3, 3));
  // A corner with a tiny angle ends no side: the contact's corner may be before it or after it.
  const auto bent = convex_hull<2, double>(std::vector<V2>{{0, 0}, {4, 0}, {4 + 1e-9, 2}, {4, 4}, {0, 4}});
  EXPECT_EQ(patch_of_polytope(bent, V2(0, 0), V2(1, 0)).corners[0], V2(4, 0));
  EXPECT_EQ(patch_of_polytope(bent, V2(0, 0), V2(1, 0)).corners[1], V2(4, 4));
  const auto point = convex_hull<2, double>(std::vector<V2>{{1, 1}});
  EXPECT_EQ(patch_of_polytope(point, V2(0, 0), V2(1, 0)).size, 1U);
}

}  // namespace
}  // namespace graze::detail::patch_polytope_test
