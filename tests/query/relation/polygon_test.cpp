// SPDX-License-Identifier: MIT
// A point against 2D triangles and polytopes.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/contains.hpp>
#include <graze/query/relation.hpp>

#include "catalogue.hpp"
#include "exact.hpp"
#include "query/orders_of.hpp"

namespace graze::test::relation_polygon_test {
namespace {

using D2 = Vec<2, double>;
using T2 = Triangle<2, double>;

const T2 triangle{{0, 0}, {4, 0}, {0, 4}};

TEST(RelationPolygon, InsideIsExactToTheLastBit) {
  EXPECT_EQ(relation(D2(1, 1), triangle), Relation::overlapping);
  EXPECT_EQ(relation(D2(1, 0x1p-1000), triangle), Relation::overlapping);
  EXPECT_EQ(relation(D2(2, 2), triangle), Relation::touching);
  EXPECT_EQ(relation(D2(std::nextafter(2, 0), 2), triangle), Relation::overlapping);
  EXPECT_EQ(relation(D2(4, 0), triangle), Relation::touching);
}

TEST(RelationPolygon, OutsideAFewEpsilonAreForgiven) {
  EXPECT_EQ(relation(D2(1, -0x1p-1000), triangle), Relation::touching);
  EXPECT_EQ(relation(D2(std::nextafter(2, 3), 2), triangle), Relation::touching);
  EXPECT_EQ(relation(D2(2, 2 + 0x1p-46), triangle), Relation::apart);
  EXPECT_EQ(relation(D2(1, -0x1p-46), triangle), Relation::apart);
}

TEST(RelationPolygon, WithoutAnAreaIsOnlyTouched) {
  const T2 flat{{0, 0}, {1, 1}, {3, 3}};
  EXPECT_EQ(relation(D2(2, 2), flat), Relation::touching);
  EXPECT_EQ(relation(D2(4, 4), flat), Relation::apart);
  EXPECT_EQ(relation(D2(2, 2.25), flat), Relation::apart);
  EXPECT_EQ(relation(D2(1, 1), (T2{{1, 1}, {1, 1}, {1, 1}})), Relation::touching);
  EXPECT_EQ(relation(D2(1, 2), (T2{{1, 1}, {1, 1}, {1, 1}})), Relation::apart);
  const Polytope<2, double> point = convex_hull<2, double>(std::vector<D2>{{1, 1}});
  EXPECT_EQ(relation(point, D2(1, 1)), Relation::touching);
  EXPECT_EQ(relation(point, D2(1, 2)), Relation::apart);
}

TEST(RelationPolygon, OfManyCornersIsTheSame) {
  const Polytope<2, double> square = convex_hull<2, double>(std::vector<D2>{{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  EXPECT_EQ(relation(square, D2(4, 4)), Relation::touching);
  EXPECT_EQ(relation(square, D2(4, 3)), Relation::touching);
  EXPECT_EQ(relation(square, D2(3, 3)), Relation::overlapping);
  EXPECT_EQ(relation(square, D2(4, 5)), Relation::apart);
}

TEST(RelationPolygon, IsTrueForAnyOrderOfCornersAndAgreesWithContains) {
  check_property([] {
    const auto [any_triangle, point] = *any_pair<T2, D2>();
    const Relation verdict = relation(point, any_triangle);
    for (const T2& same : orders_of(any_triangle)) RC_ASSERT(relation(same, point) == verdict);
    const ExactVerdict truth = exact_verdict_of(point, any_triangle, Measure::depth);
    if (truth.relation == Relation::overlapping) RC_ASSERT(verdict == Relation::overlapping);
    if (truth.relation == Relation::touching) RC_ASSERT(verdict == Relation::touching);
    if (verdict != Relation::apart) RC_ASSERT(contains(any_triangle, point));
  });
}

}  // namespace
}  // namespace graze::test::relation_polygon_test
