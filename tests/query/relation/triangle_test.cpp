// SPDX-License-Identifier: MIT
// The closed forms of triangles. relation_test.cpp has every pair by hand, agreement_test.cpp every pair against the
// oracle, relation_triangle_laws_test.cpp the laws; this tests cases where closed forms of triangles fail easily.
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/relation.hpp>

#include "catalogue.hpp"
#include "exact.hpp"
#include "query/orders_of.hpp"

namespace graze::test::relation_triangle_test {
namespace {

using V3 = Vec<3, double>;
using T3 = Triangle<3, double>;
using S3 = Segment<3, double>;

/// graze's verdict, for all orders of arguments and corners, and the oracle's.
template <class A, class B>
void expect(const A& a, const B& b, Relation expected) {
  for (const A& same_a : orders_of(a)) {
    for (const B& same_b : orders_of(b)) {
      EXPECT_EQ(name_of(relation(same_a, same_b)), name_of(expected)) << to_source(same_a) << ", " << to_source(same_b);
      EXPECT_EQ(name_of(relation(same_b, same_a)), name_of(expected)) << to_source(same_b) << ", " << to_source(same_a);
    }
  }
  const ExactVerdict truth = exact_verdict_of(a, b, Measure::distance);
  EXPECT_EQ(name_of(truth.relation), name_of(expected)) << "oracle: " << to_source(a) << ", " << to_source(b);
}

const T3 floor_triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
constexpr double little = 0x1p-40;

TEST(RelationTriangle, ASegmentOverlapsItOnlyStraightThroughTheFace) {
  expect(floor_triangle, S3{{1, 1, -1}, {1, 1, 1}}, Relation::overlapping);
  expect(floor_triangle, S3{{1, 1, 0}, {1, 1, 3}}, Relation::touching);
  expect(floor_triangle, S3{{1, 1, little}, {1, 1, 3}}, Relation::apart);
  expect(floor_triangle, S3{{1, 1, -little}, {1, 1, 3}}, Relation::overlapping);
  expect(floor_triangle, S3{{2, 0, -1}, {2, 0, 1}}, Relation::touching);
  expect(floor_triangle, S3{{2, -little, -1}, {2, -little, 1}}, Relation::apart);
  expect(floor_triangle, S3{{2, 2, -1}, {2, 2, 1}}, Relation::touching);
  expect(floor_triangle, S3{{0, 0, -1}, {0, 0, 1}}, Relation::touching);
  expect(floor_triangle, S3{{3, 3, -1}, {3, 3, 1}}, Relation::apart);
}

TEST(RelationTriangle, ASegmentInItsPlaneTouchesItAtMost) {
  expect(floor_triangle, S3{{1, 1, 0}, {1, 2, 0}}, Relation::touching);
  expect(floor_triangle, S3{{-1, 1, 0}, {9, 1, 0}}, Relation::touching);
  expect(floor_triangle, S3{{-9, 0, 0}, {9, 0, 0}}, Relation::touching);
  expect(floor_triangle, S3{{4, 0, 0}, {9, 0, 0}}, Relation::touching);
  expect(floor_triangle, S3{{4 + little, 0, 0}, {9, 0, 0}}, Relation::apart);
  expect(floor_triangle, S3{{5, 0, 0}, {0, 5, 0}}, Relation::apart);
  expect(floor_triangle, S3{{1, 1, 0}, {1, 1, 0}}, Relation::touching);
}

TEST(RelationTriangle, InThePlaneItIsSolid) {
  const Triangle<2, float> triangle{{0, 0}, {4, 0}, {0, 4}};
  expect(triangle, Segment<2, float>{{1, 1}, {2, 1}}, Relation::overlapping);
  expect(triangle, Segment<2, float>{{-1, -1}, {5, 5}}, Relation::overlapping);
  expect(triangle, Segment<2, float>{{0, 0}, {-3, 3}}, Relation::touching);
  expect(triangle, Segment<2, float>{{5, 0}, {0, 5}}, Relation::apart);
  expect(triangle, Vec<2, float>(1, 1), Relation::overlapping);
  expect(triangle, Vec<2, float>(2, 2), Relation::touching);
  expect(triangle, Vec<2, float>(2, 2.001F), Relation::apart);
  expect(triangle, Sphere<2, float>{{5, 5}, 1}, Relation::apart);
  expect(triangle, Sphere<2, float>{{-3, -4}, 5}, Relation::touching);
  expect(triangle, Sphere<2, float>{{1, 1}, 0.25F}, Relation::overlapping);
  expect(triangle, Capsule<2, float>{{5, -3}, {5, 3}, 1}, Relation::touching);
  expect(triangle, Capsule<2, float>{{-1, 1}, {5, 1}, 0}, Relation::overlapping);
  expect(triangle, Triangle<2, float>{{2, 2}, {4, 4}, {1, 4}}, Relation::touching);
  expect(triangle, triangle, Relation::overlapping);
}

TEST(RelationTriangle, ASphereMeetsItsFaceItsEdgesAndItsCorners) {
  const double next = std::nextafter(5.0, 6.0);
  for (const V3& center : {V3(1, 1, 5), V3(1, 1, -5), V3(1, -3, 4), V3(4, -3, 4), V3(-3, -4, 0), V3(0, 8, 3)}) {
    expect(floor_triangle, Sphere<3, double>{center, 5 - little}, Relation::apart);
    expect(floor_triangle, Sphere<3, double>{center, 5}, Relation::touching);
    expect(floor_triangle, Sphere<3, double>{center, 5 + little}, Relation::overlapping);
    EXPECT_EQ(relation(floor_triangle, Sphere<3, double>{center, next}), Relation::touching) << center;
  }
  expect(floor_triangle, V3(1, 1, 0), Relation::touching);
  expect(floor_triangle, V3(1, 1, little), Relation::apart);
}

TEST(RelationTriangle, ACapsuleMeetsItWithItsEndsAndItsSide) {
  expect(floor_triangle, Capsule<3, double>{{1, 1, 3}, {1, 1, 9}, 3}, Relation::touching);
  expect(floor_triangle, Capsule<3, double>{{1, 1, 3}, {1, 1, 9}, 3 - little}, Relation::apart);
  expect(floor_triangle, Capsule<3, double>{{1, -3, -5}, {1, -3, 5}, 3}, Relation::touching);
  expect(floor_triangle, Capsule<3, double>{{1, -3, -5}, {1, -3, 5}, 3 + little}, Relation::overlapping);
  expect(floor_triangle, Capsule<3, double>{{-9, 1, 2}, {9, 1, 2}, 2}, Relation::touching);
  expect(floor_triangle, Capsule<3, double>{{1, 1, -1}, {1, 1, 1}, 0}, Relation::overlapping);
  expect(floor_triangle, Capsule<3, double>{{1, 1, 0}, {1, 2, 0}, 0}, Relation::touching);
  expect(floor_triangle, Capsule<3, double>{{5, 5, 5}, {5, 5, 5}, 5}, Relation::apart);
}

TEST(RelationTriangle, ABoxMeetsItsFaceAndItsEdges) {
  expect(floor_triangle, Aabb<3, double>{{1, 1, 0}, {2, 2, 1}}, Relation::touching);
  expect(floor_triangle, Aabb<3, double>{{1, 1, -1}, {2, 2, 1}}, Relation::overlapping);
  expect(floor_triangle, Aabb<3, double>{{2, 2, -1}, {3, 3, 1}}, Relation::touching);
  expect(floor_triangle, Aabb<3, double>{{3, 3, -1}, {4, 4, 1}}, Relation::apart);
  expect(floor_triangle, Aabb<3, double>{{-9, -9, -9}, {9, 9, 9}}, Relation::overlapping);
  expect(floor_triangle, Aabb<3, double>{{1, 1, 0}, {9, 9, 0}}, Relation::touching);  // of no thickness
  expect(floor_triangle, Aabb<3, double>{{3, 3, 0}, {9, 9, 0}}, Relation::apart);
  expect(floor_triangle, Aabb<3, double>{{1, 1, -1}, {1, 1, 1}}, Relation::overlapping);
}

// The triangle's edge through (at, at, 0) passes the box's edge x = y = 1; neither the box's faces nor the triangle
// separate the two, only the cross product of these edges does.
TEST(RelationTriangle, ABoxBesideAnEdgeIsPartedByTheCrossProductOfEdges) {
  const Aabb<3, double> box{{-1, -1, -1}, {1, 1, 1}};
  const Obb<3, double> turned{{0, 0, 0}, {1, 1, 1}, Mat<3, double>(0, 1, 0, -1, 0, 0, 0, 0, 1)};
  const auto triangle_at = [](double at) {
    return T3{{at + 2, at - 2, 2}, {at - 2, at + 2, -2}, {at + 2, at + 2, -6}};
  };
  for (const auto& [at, expected] : {std::pair(1 + little, Relation::apart), std::pair(1.0, Relation::touching),
                                     std::pair(1 - little, Relation::overlapping)}) {
    expect(triangle_at(at), box, expected);
    expect(triangle_at(at), turned, expected);
  }
}

TEST(RelationTriangle, ATriangleThatSharesACornerOrAnEdgeTouchesUnlessItGoesThrough) {
  expect(floor_triangle, T3{{0, 0, 0}, {-1, 0, 5}, {0, -1, 5}}, Relation::touching);
  expect(floor_triangle, T3{{0, 0, 0}, {1, 1, 1}, {1, 1, -1}}, Relation::overlapping);
  expect(floor_triangle, T3{{0, 0, 0}, {4, 0, 0}, {1, 1, 5}}, Relation::touching);
  expect(floor_triangle, T3{{0, 0, 0}, {4, 0, 0}, {1, -1, 0}}, Relation::touching);
  expect(floor_triangle, T3{{1, 1, 0}, {1, 2, 4}, {2, 1, 4}}, Relation::touching);
  expect(floor_triangle, T3{{1, 1, -little}, {1, 2, 4}, {2, 1, 4}}, Relation::overlapping);
  expect(floor_triangle, T3{{2, 0, 2}, {2, 0, -2}, {2, -9, 0}}, Relation::touching);
  expect(floor_triangle, T3{{2, little, 2}, {2, little, -2}, {2, -9, 0}}, Relation::overlapping);
  expect(floor_triangle, T3{{2, -little, 2}, {2, -little, -2}, {2, -9, 0}}, Relation::apart);
}

TEST(RelationTriangle, ATriangleInItsPlaneTouchesItAtMost) {
  expect(floor_triangle, floor_triangle, Relation::touching);
  expect(floor_triangle, T3{{1, 1, 0}, {1, 2, 0}, {2, 1, 0}}, Relation::touching);
  expect(floor_triangle, T3{{-1, -1, 0}, {9, -1, 0}, {-1, 9, 0}}, Relation::touching);
  expect(floor_triangle, T3{{2, 2, 0}, {4, 4, 0}, {4, 3, 0}}, Relation::touching);
  expect(floor_triangle, T3{{3, 3, 0}, {9, 9, 0}, {9, 8, 0}}, Relation::apart);
  expect(floor_triangle, T3{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}, Relation::apart);
  // The same in a plane whose normal is rounded.
  const V3 u(0.1, 0.7, 0.2);
  const V3 v(0.3, -0.4, 0.9);
  expect(T3{V3(0.0), u, v}, T3{V3(0.0), 2.0 * u, 2.0 * v}, Relation::touching);
  expect(T3{V3(0.0), u, v}, T3{2.0 * u, 4.0 * u, 2.0 * v}, Relation::apart);
}

// Far beyond its tip, a needle is within rounding of every plane along it.
TEST(RelationTriangle, ANeedleEndsAtItsTip) {
  for (const double half_width : {1e-6, 1e-11, 1e-14, 1e-18, 0.0}) {
    const T3 needle{{0, 0, 0}, {1, half_width, 0}, {1, -half_width, 0}};
    for (const double beyond : {1e-3, 1e-9, 1e-13}) {
      expect(needle, V3(-beyond, 0, 0), Relation::apart);
      expect(needle, S3{{-beyond, -1, 0}, {-beyond, 1, 0}}, Relation::apart);
      expect(needle, S3{{-beyond, 0, -1}, {-beyond, 0, 1}}, Relation::apart);
      expect(needle, Aabb<3, double>{{-1, -1, -1}, {-beyond, 1, 1}}, Relation::apart);
      expect(needle, T3{{-beyond, 0, 0}, {-1, 1e-12, 0}, {-1, -1e-12, 0}}, Relation::apart);
      expect(needle, T3{{-beyond, 0, -1}, {-beyond, 0, 1}, {-beyond, 1, 0}}, Relation::apart);
    }
    expect(needle, V3(0, 0, 0), Relation::touching);
    expect(needle, V3(0.5, 0, 0), Relation::touching);
    expect(needle, S3{{0, 0, -1}, {0, 0, 1}}, Relation::touching);
    expect(needle, S3{{0.5, -1, 0}, {0.5, 1, 0}}, Relation::touching);
  }
  const T3 needle{{0, 0, 0}, {1, 1e-12, 0}, {1, -1e-12, 0}};
  expect(needle, S3{{0.5, 0, -1}, {0.5, 0, 1}}, Relation::overlapping);
  expect(needle, T3{{0.5, 0, -1}, {0.5, 0, 1}, {0.5, 1, 0}}, Relation::overlapping);
}

TEST(RelationTriangle, CornersThatCoincideMakeItASegmentOrAPoint) {
  const T3 segment{{-1, 0, 0}, {1, 0, 0}, {1, 0, 0}};
  const T3 on_one_line{{-1, 0, 0}, {0.25, 0, 0}, {1, 0, 0}};
  for (const T3& flat : {segment, on_one_line}) {
    expect(flat, V3(0.5, 0, 0), Relation::touching);
    expect(flat, V3(1.5, 0, 0), Relation::apart);
    expect(flat, S3{{0, 0, 0}, {9, 0, 0}}, Relation::touching);
    expect(flat, S3{{2, 0, 0}, {9, 0, 0}}, Relation::apart);
    expect(flat, S3{{0, -1, 0}, {0, 1, 0}}, Relation::touching);
    expect(flat, Aabb<3, double>{{0, -1, -1}, {3, 1, 1}}, Relation::overlapping);
    expect(flat, Aabb<3, double>{{1, -1, -1}, {3, 1, 1}}, Relation::touching);
    expect(flat, T3{{0, -1, -1}, {0, 1, -1}, {0, 0, 1}}, Relation::overlapping);
    expect(flat, T3{{1, -1, -1}, {1, 1, -1}, {1, 0, 1}}, Relation::touching);
    expect(flat, flat, Relation::touching);
    expect(flat, Capsule<3, double>{{0, 2, 0}, {0, 9, 0}, 2}, Relation::touching);
  }
  const T3 point{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
  expect(point, point, Relation::touching);
  expect(point, V3(1, 1, 1), Relation::touching);
  expect(point, V3(1, 1, 2), Relation::apart);
  expect(point, S3{{0, 0, 0}, {2, 2, 2}}, Relation::touching);
  expect(point, Aabb<3, double>{{0, 0, 0}, {2, 2, 2}}, Relation::overlapping);
  expect(point, T3{{0, 0, 1}, {3, 0, 1}, {0, 3, 1}}, Relation::touching);
}

TEST(RelationTriangle, ARayMeetsItFarAwayAndNotBehind) {
  const T3 target{{1e9, -1, -1}, {1e9, 1, -1}, {1e9, 0, 2}};
  expect(target, Ray<3, double>{{0, 0, 0}, {1e-9, 0, 0}}, Relation::overlapping);
  expect(target, Ray<3, double>{{0, 0, 0}, {-1, 0, 0}}, Relation::apart);
  expect(target, Ray<3, double>{{0, 0, 3}, {1, 0, 0}}, Relation::apart);
  expect(floor_triangle, Ray<3, double>{{1, 1, 1}, {0, 0, -1}}, Relation::overlapping);
  expect(floor_triangle, Ray<3, double>{{1, 1, 0}, {0, 0, -1}}, Relation::touching);
  expect(floor_triangle, Ray<3, double>{{9, 0, 0}, {-1, 0, 0}}, Relation::touching);
}

// Products of four sizes leave the range of double long before the guaranteed sizes do.
TEST(RelationTriangle, EverySizeWithinThePromiseWillDo) {
  for (const double size : {0x1p-460, 0x1p-230, 1.0, 0x1p230, 0x1p460}) {
    const T3 triangle{floor_triangle.a * size, floor_triangle.b * size, floor_triangle.c * size};
    const auto at = [&](double x, double y, double z) { return V3(x, y, z) * size; };
    expect(triangle, S3{at(1, 1, -1), at(1, 1, 1)}, Relation::overlapping);
    expect(triangle, S3{at(1, 1, 0), at(1, 1, 1)}, Relation::touching);
    expect(triangle, S3{at(3, 3, -1), at(3, 3, 1)}, Relation::apart);
    expect(triangle, T3{at(1, 1, -1), at(1, 1, 1), at(5, 5, 0)}, Relation::overlapping);
    expect(triangle, T3{at(3, 3, -1), at(3, 3, 1), at(5, 5, 0)}, Relation::apart);
    expect(triangle, Aabb<3, double>{at(3, 3, -1), at(5, 5, 1)}, Relation::apart);
    expect(triangle, Aabb<3, double>{at(1, 1, -1), at(5, 5, 1)}, Relation::overlapping);
    expect(triangle, Sphere<3, double>{at(1, 1, 2), 2 * size}, Relation::touching);
    expect(triangle, Sphere<3, double>{at(1, 1, 2), 1.5 * size}, Relation::apart);
    expect(triangle, Capsule<3, double>{at(1, 1, -1), at(1, 1, 1), 0}, Relation::overlapping);
    expect(triangle, Capsule<3, double>{at(3, 3, -1), at(3, 3, 1), size}, Relation::apart);
  }
}

}  // namespace
}  // namespace graze::test::relation_triangle_test
