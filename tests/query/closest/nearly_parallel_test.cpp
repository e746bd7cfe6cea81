// SPDX-License-Identifier: MIT
// The nearest points of nearly parallel segments, against the same formula in rational numbers.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include <graze/math/vec.hpp>
#include <graze/query/closest/nearly_parallel.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/shape/capsule.hpp>
#include <graze/shape/segment.hpp>

#include "exact.hpp"
#include "exact/numbers.hpp"

namespace graze::test::nearly_parallel_test {
namespace {

using V3 = Vec<3, double>;
using Edge = Segment<3, double>;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// The parameter of a's line nearest to b's, in lengths of a.
Rational exact_place(const Edge& a, const Edge& b) {
  const RationalVec<3> v = exact(b.end) - exact(b.start);
  const RationalVec<3> normal = cross(exact(a.end) - exact(a.start), v);
  return dot(cross(exact(b.start) - exact(a.start), v), normal) / dot(normal, normal);
}

V3 point_at(const Edge& edge, const Rational& share) {
  const RationalVec<3> point = exact(edge.start) + (exact(edge.end) - exact(edge.start)) * share;
  return {to_double(point[0]), to_double(point[1]), to_double(point[2])};
}

struct Numbers {
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine() >> 11U) * 0x1p-53);
  }
  V3 vector() { return {between(-1, 1), between(-1, 1), between(-1, 1)}; }

  std::mt19937_64 engine{3};
};

struct Pair {
  Edge a;
  Edge b;
};

/// Edges of about length 1 that are up to 1 apart and cross with this sine, as seen along their common perpendicular.
Pair draw(Numbers& numbers, double sine) {
  const V3 way = numbers.vector();
  const V3 start = numbers.vector();
  const V3 across = cross(way, numbers.vector());
  const double gap = std::ldexp(numbers.between(0.5, 1), -static_cast<int>(numbers.between(0, 20)));
  const V3 other_way = way + cross(across, way) * sine;
  const V3 middle = start + way * numbers.between(0.1, 0.9) + across * gap;
  const V3 other_start = middle - other_way * numbers.between(0.1, 0.9);
  return {{start, start + way}, {other_start, other_start + other_way}};
}

TEST(NearlyParallel, ThePerpendicularIsWhereItIsInRationalNumbersDownToASineOf1e8) {
  Numbers numbers;
  double worst = 0;
  std::size_t found = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto [a, b] = draw(numbers, std::ldexp(1.0, -3 - i % 24));
    const Rational on_a = exact_place(a, b);
    const Rational on_b = exact_place(b, a);
    if (on_a < 0 || on_a > 1 || on_b < 0 || on_b > 1) continue;
    const auto nearest = closest_points(a, b);
    worst = std::max(worst, max_abs(nearest.point_a - point_at(a, on_a)));
    worst = std::max(worst, max_abs(nearest.point_b - point_at(b, on_b)));
    ++found;
  }
  EXPECT_GT(found, 1000U);
  EXPECT_LE(worst, 1e-13) << "of the least parallel, which use the other method; it was 0.3";
}

TEST(NearlyParallel, WhatIsCutOffAtEndsIsAsFarAsTheOracleSays) {
  Numbers numbers;
  for (int i = 0; i < 500; ++i) {
    auto [a, b] = draw(numbers, std::ldexp(1.0, -8 - i % 40));
    const V3 slide = (a.end - a.start) * numbers.between(-3, 3);
    b = {b.start + slide, b.end + slide};
    const auto nearest = closest_points(a, b);
    const auto turned = closest_points(b, a);
    EXPECT_EQ(nearest.point_a, turned.point_b);
    EXPECT_EQ(nearest.point_b, turned.point_a);
    EXPECT_EQ(nearest.distance, turned.distance);
    const double gap = std::max(0.0, exact_verdict_of(a, b).gap);
    EXPECT_NEAR(nearest.distance, gap, nearest.error + epsilon * gap);
  }
}

TEST(NearlyParallel, CapsulesAreNearestWhereTheirAxesAre) {
  const Capsule<3, double> a{{0, 0, 0}, {1, 0, 0}, 0.25};
  const Capsule<3, double> b{{0, -0x1p-24, 1}, {1, 0x1p-24, 1}, 0.25};
  const auto nearest = closest_points(a, b);
  EXPECT_EQ(nearest.point_a, V3(0.5, 0, 0.25));
  EXPECT_EQ(nearest.point_b, V3(0.5, 0, 0.75));
  EXPECT_EQ(nearest.distance, 0.5);
}

TEST(NearlyParallel, ParallelOnesAndThoseAcrossAreLeftToTheOthers) {
  const Edge a{{0, 0, 0}, {1, 0, 0}};
  EXPECT_FALSE(detail::closest_of_nearly_parallel(a, {{0, 1, 0}, {1, 1, 0}}, V3(0.0)));
  EXPECT_FALSE(detail::closest_of_nearly_parallel(a, {{0, 0, 1}, {0, 1, 1}}, V3(0.0)));
  EXPECT_FALSE(detail::closest_of_nearly_parallel(a, {{0, 0, 1}, {0, 0, 1}}, V3(0.0)));
  EXPECT_TRUE(detail::closest_of_nearly_parallel(a, {{0, 0, 1}, {1, 0.01, 1}}, V3(0.0)));
}

}  // namespace
}  // namespace graze::test::nearly_parallel_test
