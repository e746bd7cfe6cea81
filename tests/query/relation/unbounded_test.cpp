// SPDX-License-Identifier: MIT
// The closed forms of rays, planes and half-spaces. relation_test.cpp has every pair by hand, agreement_test.cpp every
// pair against the oracle; this tests cases where closed forms fail easily.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include <graze/query/relation.hpp>

#include "catalogue.hpp"
#include "exact.hpp"
#include "query/user_shapes.hpp"

namespace graze::test::relation_unbounded_test {
namespace {

template <class A, class B>
void expect(const A& a, const B& b, Relation expected) {
  EXPECT_EQ(name_of(relation(a, b)), name_of(expected)) << to_source(a) << ", " << to_source(b);
  EXPECT_EQ(name_of(relation(b, a)), name_of(expected)) << "swapped: " << to_source(a) << ", " << to_source(b);
  const ExactVerdict truth = exact_verdict_of(a, b, Measure::distance);
  EXPECT_EQ(name_of(truth.relation), name_of(expected)) << "oracle: " << to_source(a) << ", " << to_source(b);
}

// Reported touching once: the distance of the lines was compared without regard to the amplification by their small
// angle.
TEST(RelationUnbounded, RaysThatPassAtAlmostNoAngleAreApart) {
  const Ray<3, double> along{{0, 0, 0}, {1, 0, 0}};
  expect(along, Ray<3, double>{{0, -1, 1e-10}, {1, 1e-5, 0}}, Relation::apart);
  expect(along, Ray<3, double>{{0, -1, 0}, {1, 1e-5, 0}}, Relation::touching);
  expect(Ray<2, double>{{0, 0}, {1, 0}}, Ray<2, double>{{0, -1}, {1, 1e-9}}, Relation::overlapping);
  expect(Ray<2, double>{{0, 0}, {1, 0}}, Ray<2, double>{{0, -1}, {-1, 1e-9}}, Relation::apart);
}

// Two million from zero, the ray used to end at a rounded position; the pair itself is ten wide.
TEST(RelationUnbounded, ARayFarFromTheOriginIsAsExactAsNearIt) {
  const Ray<2, double> ray{{1e6, 2e6}, {4, 3}};
  expect(ray, Sphere<2, double>{{1e6 + 1, 2e6 + 7}, 5 - 0x1p-36}, Relation::apart);
  expect(ray, Sphere<2, double>{{1e6 + 1, 2e6 + 7}, 5}, Relation::touching);
  expect(ray, Sphere<2, double>{{1e6 + 1, 2e6 + 7}, 5 + 0x1p-36}, Relation::overlapping);
  expect(ray, Capsule<2, double>{{1e6 + 1, 2e6 + 7}, {1e6 + 9, 2e6 + 13}, 5 - 0x1p-36}, Relation::apart);
}

TEST(RelationUnbounded, ARayReachesAsFarAsTheShapeIs) {
  for (const double far : {1e3, 1e9, 1e12}) {
    expect(Ray<3, double>{{0, 0, 0}, {1, 0, 0}}, Sphere<3, double>{{far, 0, 0}, 1}, Relation::overlapping);
    expect(Ray<3, double>{{0, 0, 0}, {1e-9, 0, 0}}, Aabb<3, double>{{far, -1, -1}, {2 * far, 1, 1}},
           Relation::overlapping);
    expect(Ray<3, double>{{0, 0, 0}, {-1, 0, 0}}, Sphere<3, double>{{far, 0, 0}, 1}, Relation::apart);
    expect(Ray<3, double>{{0, 0, 0}, {1e9, 0, 0}}, Triangle<3, double>{{far, -1, -1}, {far, 1, -1}, {far, 0, 2}},
           Relation::overlapping);
  }
}

/// Each of its numbers once replaced by NaN.
template <class S, class Check>
void with_nan_in_turn(const S& shape, const Check& check) {
  constexpr std::size_t count = sizeof(S) / sizeof(double);
  for (std::size_t i = 0; i < count; ++i) {
    std::array<double, count> numbers;
    std::memcpy(numbers.data(), &shape, sizeof(shape));
    numbers[i] = std::numeric_limits<double>::quiet_NaN();
    S broken = shape;
    std::memcpy(reinterpret_cast<char*>(&broken), numbers.data(), sizeof(broken));
    check(broken, i);
  }
}

/// Comparisons of the corners' heights ignore NaN, but their sum does not.
TEST(RelationUnbounded, WhatHoldsNanIsApartFromPlanes) {
  const Plane<3, double> plane{{1, 2, 2}, 0.5};
  const HalfSpace<3, double> solid{{1, 2, 2}, 0.5};
  const auto expect_apart = [&](const auto& shape) {
    ASSERT_EQ(relation(shape, plane), Relation::overlapping);
    with_nan_in_turn(shape, [&](const auto& broken, std::size_t i) {
      EXPECT_EQ(detail::decide(broken, plane), Relation::apart) << i;
      EXPECT_EQ(detail::decide(solid, broken), Relation::apart) << i;
    });
    with_nan_in_turn(plane, [&](const auto& broken, std::size_t i) {
      EXPECT_EQ(detail::decide(shape, broken), Relation::apart) << i;
    });
  };
  expect_apart(Segment<3, double>{{-1, -1, -1}, {2, 2, 2}});
  expect_apart(Triangle<3, double>{{-1, -1, -1}, {2, 2, 2}, {0, 1, 0}});
  expect_apart(Capsule<3, double>{{-1, -1, -1}, {2, 2, 2}, 0.5});
}

TEST(RelationUnbounded, TheLengthOfDirectionsAndNormalsDoesNotMatter) {
  for (const double length : {1e-100, 1e-3, 7.0, 1e100}) {
    const Ray<3, double> ray{{-5, 0.5, 0.5}, {3 * length, 0, 0}};
    expect(ray, Aabb<3, double>{{0, 0, 0}, {1, 1, 1}}, Relation::overlapping);
    expect(ray, Ray<3, double>{{2, -3, 0.5}, {0, length, 0}}, Relation::touching);
    expect(Plane<3, double>{{0, 0, length}, length}, Sphere<3, double>{{0, 0, 3}, 2}, Relation::touching);
    expect(HalfSpace<3, double>{{0, 0, length}, length}, Plane<3, double>{{0, 0, -1}, -2}, Relation::apart);
    expect(HalfSpace<3, double>{{0, 0, length}, length}, HalfSpace<3, double>{{0, 0, -1}, -1}, Relation::touching);
  }
}

// Directions that are parallel up to rounding count as parallel: their intersection would be beyond all numbers.
TEST(RelationUnbounded, DirectionsThatAreParallelUpToRoundingAreParallel) {
  const Plane<2, double> line{{0.6, 0.8}, 1};
  const Ray<2, double> beside{{0, 0}, {0.8, -0.6}};
  EXPECT_EQ(relation(line, beside), Relation::apart);
  EXPECT_EQ(relation(line, Plane<2, double>{{0.6 * 3, 0.8 * 3}, 4}), Relation::apart);
  EXPECT_EQ(relation(beside, Ray<2, double>{{1, 1}, {-0.8 / 3, 0.6 / 3}}), Relation::apart);
}

TEST(RelationUnbounded, APlaneAndAUsersShapeAreDecidedByItsSupport) {
  const user::Cone<float> hat{{0, 0, 0}, 2, 4};
  EXPECT_EQ(relation(Plane<3, float>{{0, 0, 1}, 4.01F}, hat), Relation::apart);
  EXPECT_EQ(relation(Plane<3, float>{{0, 0, 1}, 4}, hat), Relation::touching);
  EXPECT_EQ(relation(hat, Plane<3, float>{{0, 0, 1}, 3}), Relation::overlapping);
  EXPECT_EQ(relation(hat, HalfSpace<3, float>{{0, 0, 1}, -0.01F}), Relation::apart);
  EXPECT_EQ(relation(hat, HalfSpace<3, float>{{0, 0, 1}, 9}), Relation::overlapping);
  EXPECT_EQ(relation(Ray<3, float>{{-9, 0, 1}, {1, 0, 0}}, hat), Relation::overlapping);
  EXPECT_EQ(relation(Ray<3, float>{{-9, 0, 5}, {1, 0, 0}}, hat), Relation::apart);
}

TEST(RelationUnbounded, LevelsOverlapUnlessTheyAreParallel) {
  check_property([] {
    const auto [a, b] = *any_pair<HalfSpace<3, double>, Plane<3, double>>();
    RC_ASSERT(relation(boundary(a), a) == Relation::touching);
    RC_ASSERT(relation(a, a) == Relation::overlapping);
    if (relation(a, b) != Relation::overlapping)
      RC_ASSERT(max_abs(cross(a.normal, b.normal)) <= 1e-12 * max_abs(a.normal) * max_abs(b.normal));
  });
}

}  // namespace
}  // namespace graze::test::relation_unbounded_test
