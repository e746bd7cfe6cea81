// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/contact.hpp>
#include <graze/query/contact/convex.hpp>

#include "catalogue.hpp"
#include "query/flush_prisms.hpp"
#include "query/user_shapes.hpp"

namespace graze::detail::penetration_convex_test {
namespace {

using V3 = Vec<3, double>;

Polytope<3, double> hull(const std::vector<V3>& points) { return convex_hull<3, double>(points); }

const Polytope<3, double> octahedron = hull({{2, 0, 0}, {-2, 0, 0}, {0, 2, 0}, {0, -2, 0}, {0, 0, 2}, {0, 0, -2}});

TEST(Shifted, IsTheSameShapeElsewhereAndAsInaccurate) {
  const user::Ellipsoid<float> egg{{0, 0, 0}, {3, 2, 1}};
  const Shifted<user::Ellipsoid<float>> shifted{egg, V3(1, 1, 1)};
  EXPECT_EQ(support(shifted, V3(1, 0, 0)), V3(4, 1, 1));
  EXPECT_EQ(support_error<Shifted<user::Ellipsoid<float>>>, support_error<user::Ellipsoid<float>>);
}

TEST(PenetrationOfConvex, OfABallBesideAHullIsAlongTheirNearestPoints) {
  const double third = 1 / std::sqrt(3.0);
  const V3 diagonal(third, third, third);
  const Sphere<3, double> sphere{diagonal * 2.0, 1};  // the face is 2 / sqrt(3) away
  const Penetration<3> found = penetration_of_convex(sphere, octahedron);
  EXPECT_NEAR(found.depth, 1 - (2 - 2 * third), 1e-14);
  EXPECT_NEAR(length(found.normal + diagonal), 0, 1e-14);
  EXPECT_NEAR(length(found.point_b - diagonal * (2 * third)), 0, 1e-14);
  EXPECT_NEAR(length(found.point_a - diagonal), 0, 1e-14);
}

TEST(PenetrationOfConvex, OfABallInsideAHullIsOutOfTheNearestFace) {
  const double third = 1 / std::sqrt(3.0);
  const Penetration<3> found = penetration_of_convex(Sphere<3, double>{{0.1, 0.1, 0.1}, 1}, octahedron);
  EXPECT_NEAR(found.depth, 1 + (2 - 0.3) * third, 1e-13);
  EXPECT_NEAR(length(found.normal + V3(third, third, third)), 0, 1e-13);
  EXPECT_EQ(found.status, Status::converged);
}

TEST(PenetrationOfConvex, OfFlatHullsInOnePlaneIsZeroAlongItsNormal) {
  const auto flat = hull({{0, 0, 1}, {4, 0, 1}, {0, 4, 1}, {4, 4, 1}});
  const Penetration<3> found = penetration_of_convex(flat, hull({{1, 1, 1}, {5, 1, 1}, {1, 5, 1}}));
  EXPECT_NEAR(found.depth, 0, 1e-15);
  EXPECT_NEAR(std::fabs(found.normal.z), 1, 1e-15);
}

template <class T>
void expect_points_along_the_normal() {
  constexpr double noise = 2.5 * tolerance::epsilon;  // of coordinates up to 2.5
  for (unsigned turn = 0; turn < 1000; ++turn) {
    const auto [a, b, normal] = test::flush_prisms<T>(turn, -test::flush_gap(turn));
    const auto found = penetration_of_convex_if_met(a, b);
    if (!found) continue;
    EXPECT_EQ(found->status, Status::converged) << turn;
    const V3 rest = found->point_a - found->point_b - found->normal * found->depth;
    EXPECT_LE(length(rest), (found->depth > 0 ? 16 : 32) * noise) << turn;
    EXPECT_LE(found->error, 128 * noise) << turn;
  }
}

TEST(PenetrationOfConvex, WhereFacesAreNearlyParallelHasItsPointsAlongTheNormal) {
  expect_points_along_the_normal<double>();
  expect_points_along_the_normal<float>();
}

// A smooth shape has no last face: the bounds converge, and the error says how far.
TEST(PenetrationOfConvex, OfUsersShapesComesWithHonestBounds) {
  const user::Ellipsoid<double> egg{{0, 0, 0}, {3, 2, 1}};
  const Penetration<3> found = penetration_of_convex(egg, V3(0, 0, 0.5));
  EXPECT_NEAR(found.depth, 0.5, found.error);
  EXPECT_LE(found.error, 1e-6);
  const Penetration<3> beside = penetration_of_convex(egg, Sphere<3, double>{{0, 0, 2.5}, 2});
  EXPECT_NEAR(beside.depth, 0.5, beside.error);
  EXPECT_LE(beside.error, 1e-5);
  EXPECT_NEAR(length(beside.normal - V3(0, 0, 1)), 0, 1e-5);
}

template <class T>
Polytope<3, T> ball(const V3& center, double radius, unsigned corners) {
  std::vector<Vec<3, T>> points;
  for (unsigned i = 0; i < corners; ++i) {
    const double z = (2.0 * i + 1) / corners - 1;
    const double across = std::sqrt(1 - z * z) * radius;
    points.emplace_back(center + V3(across * std::cos(2.4 * i), across * std::sin(2.4 * i), z * radius));
  }
  return convex_hull<3, T>(points);
}

// The depth is as large as the shapes, and so would be what is left of a search that ends at a share of it.
TEST(PenetrationOfConvex, OfDeepHullsHasItsPointsOnBothSurfacesAlongTheNormal) {
  for (unsigned i = 0; i < 200; ++i) {
    const auto a = ball<double>(V3(0.0), 2, 20 + i);
    const auto b = ball<double>(V3(std::sin(i), std::sin(2.0 * i), std::sin(3.0 * i)), 1, 220 - i);
    const auto found = penetration_of_convex_if_met(a, b);
    ASSERT_TRUE(found) << i;
    EXPECT_EQ(found->status, Status::converged) << i;
    const V3& normal = found->normal;
    EXPECT_LE(length(found->point_a - found->point_b - normal * found->depth), 8 * tolerance::epsilon) << i;
    EXPECT_NEAR(dot(normal, found->point_a), dot(normal, support(a, normal)), 16 * tolerance::epsilon) << i;
    EXPECT_NEAR(dot(normal, found->point_b), dot(normal, support(b, -normal)), 16 * tolerance::epsilon) << i;
  }
}

TEST(PenetrationOfConvex, OfARayIsThatOfItsBeginning) {
  const Ray<3, double> ray{{0, 0, 1.5}, {0, 0, 1}};
  const Penetration<3> found = penetration_of_convex(ray, octahedron);
  EXPECT_NEAR(found.depth, 0.5 / std::sqrt(3.0), 1e-14);  // the faces around the tip
}

}  // namespace
}  // namespace graze::detail::penetration_convex_test
