// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include <graze/math/tolerance.hpp>
#include <graze/query/distance_squared.hpp>
#include <graze/query/relation/triangle.hpp>
#include <graze/query/relation/triangle_filter.hpp>

#include "catalogue.hpp"
#include "exact.hpp"
#include "query/orders_of.hpp"

namespace graze::test::triangle_filter_test {
namespace {

using V3 = Vec<3, double>;
using T3 = Triangle<3, double>;
using S3 = Segment<3, double>;

std::optional<Relation> filter(const T3& a, const T3& b) { return detail::filter_of_corners(a, b); }
std::optional<Relation> filter(const T3& a, const S3& b) { return detail::filter_of_corners(a, b); }
std::optional<Relation> filter(const T3& triangle, const Sphere<3, double>& sphere) {
  return detail::filter_of_triangle_and_sphere(triangle.a - sphere.center, triangle.b - triangle.a,
                                               triangle.c - triangle.a, sphere.radius);
}

const T3 floor_triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

TEST(TriangleFilter, KnowsTrianglesThatCrossOrMiss) {
  EXPECT_EQ(filter(floor_triangle, T3{{1, 1, -1}, {1, 1, 1}, {9, 5, 1}}), Relation::overlapping);
  EXPECT_EQ(filter(floor_triangle, T3{{-1, 1, -1}, {-1, 1, 1}, {9, 1, 0.5}}), Relation::overlapping);
  EXPECT_EQ(filter(floor_triangle, T3{{3, 3, -1}, {3, 3, 1}, {9, 5, 1}}), Relation::apart);
  EXPECT_EQ(filter(floor_triangle, T3{{1, 1, 1}, {2, 1, 2}, {1, 2, 3}}), Relation::apart);
  // Each crosses the other's plane, their boxes overlap, and the intervals on the common line are disjoint.
  EXPECT_EQ(filter(floor_triangle, T3{{5, 1, -1}, {5, 1, 1}, {3.5, 2, 0.5}}), Relation::apart);
}

TEST(TriangleFilter, KnowsSegmentsThatPierceOrPass) {
  EXPECT_EQ(filter(floor_triangle, S3{{1, 1, -1}, {1, 1, 1}}), Relation::overlapping);
  EXPECT_EQ(filter(floor_triangle, S3{{1, 1, 1}, {1, 1, -1}}), Relation::overlapping);
  EXPECT_EQ(filter(floor_triangle, S3{{3, 3, -1}, {3, 3, 1}}), Relation::apart);
  EXPECT_EQ(filter(floor_triangle, S3{{1, 1, 2}, {1, 1, 1}}), Relation::apart);
}

TEST(TriangleFilter, KnowsBallsByFaceEdgeAndCorner) {
  EXPECT_EQ(filter(floor_triangle, Sphere<3, double>{{1, 1, 2}, 2.1}), Relation::overlapping);
  EXPECT_EQ(filter(floor_triangle, Sphere<3, double>{{1, 1, 2}, 1.9}), Relation::apart);
  EXPECT_EQ(filter(floor_triangle, Sphere<3, double>{{2, -3, 4}, 5.1}), Relation::overlapping);
  EXPECT_EQ(filter(floor_triangle, Sphere<3, double>{{2, -3, 4}, 4.9}), Relation::apart);
  EXPECT_EQ(filter(floor_triangle, Sphere<3, double>{{4 + 3, 0, 4}, 5.1}), Relation::overlapping);
  EXPECT_EQ(filter(floor_triangle, Sphere<3, double>{{4 + 3, 0, 4}, 4.9}), Relation::apart);
}

TEST(TriangleFilter, LeavesTouchingFlatAndCoplanarOnesToTheCarefulForm) {
  EXPECT_FALSE(filter(floor_triangle, T3{{1, 1, 0}, {2, 1, 2}, {1, 2, 3}}));
  EXPECT_FALSE(filter(floor_triangle, T3{{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}));
  EXPECT_FALSE(filter(floor_triangle, T3{{2, 0, -1}, {2, 0, 1}, {3, -2, 0.5}}));
  EXPECT_FALSE(filter(floor_triangle, S3{{1, 1, 0}, {1, 1, 2}}));
  EXPECT_FALSE(filter(floor_triangle, S3{{2, 0, -1}, {2, 0, 1}}));
  EXPECT_FALSE(filter(floor_triangle, Sphere<3, double>{{1, 1, 2}, 2}));
  EXPECT_FALSE(filter(T3{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, Sphere<3, double>{{1, 1, 2}, 1}));
}

TEST(TriangleFilter, HasNoAnswerForNaN) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(filter(T3{{0, 0, 0}, {4, nan, 0}, {0, 4, 0}}, T3{{1, 1, -1}, {1, 1, 1}, {9, 9, 1}}), Relation::overlapping);
  EXPECT_NE(filter(floor_triangle, T3{{1, 1, -1}, {1, 1, 1}, {9, 9, nan}}), Relation::overlapping);
  EXPECT_NE(filter(floor_triangle, S3{{1, 1, -1}, {1, nan, 1}}), Relation::overlapping);
  EXPECT_FALSE(filter(floor_triangle, Sphere<3, double>{{1, 1, nan}, 2}));
  EXPECT_FALSE(filter(floor_triangle, Sphere<3, double>{{1, 1, 1}, nan}));
}

/// Verdicts are true, and the same for every order of corners.
template <class S>
void expect_true_verdicts() {
  check_property([] {
    const auto [a, b] = *any_pair<T3, S>();
    std::optional<Relation> verdict;
    for (const T3& same : orders_of(a)) {
      const std::optional<Relation> quick = filter(same, b);
      RC_ASSERT(!quick || !verdict || *quick == *verdict);
      if (quick) verdict = quick;
    }
    if (!verdict) return;
    const ExactVerdict truth = exact_verdict_of(b, a, Measure::depth);
    RC_ASSERT(*verdict == truth.relation);
  });
}

TEST(TriangleFilter, IsRightOrSilent) {
  expect_true_verdicts<T3>();
  expect_true_verdicts<S3>();
  expect_true_verdicts<Sphere<3, double>>();
}

TEST(TriangleFilter, SeldomLeavesPlainNumbersToTheCarefulForm) {
  std::mt19937 random(20261121);
  const auto number = [&random] { return static_cast<double>(random()) * 0x1p-32 * 8; };
  const auto corner = [&number] {
    const double x = number();
    const double y = number();
    return V3(x, y, number());
  };
  constexpr int cases = 1000;
  int answers = 0;
  for (int k = 0; k < cases; ++k) {
    const T3 triangle{corner(), corner(), corner()};
    answers += filter(triangle, T3{corner(), corner(), corner()}) ? 1 : 0;
    answers += filter(triangle, S3{corner(), corner()}) ? 1 : 0;
    answers += filter(triangle, Sphere<3, double>{corner(), number() / 8}) ? 1 : 0;
  }
  EXPECT_GT(answers, 3 * cases * 9 / 10);
}

/// a moved so that its corner is nearly on b's, then off by a few steps: verdicts depend on the last bits.
T3 nudged(const T3& a, const V3& onto, const V3& steps) {
  const V3 offset = (onto - a.a) + steps * (tolerance::epsilon * detail::extent_around_zero(a));
  return {a.a + offset, a.b + offset, a.c + offset};
}

/// Unless the boxes separate the two exactly, the filter and the exact verdict agree.
template <class S>
void expect_careful_agrees(const T3& triangle, const S& other, Relation careful) {
  if (!boxes_overlap(detail::box_around(triangle), detail::box_around(other))) return;
  const std::optional<Relation> quick = filter(triangle, other);
  RC_ASSERT(!quick || *quick == careful);
}

TEST(TriangleFilter, NeverContradictsTheCarefulForm) {
  check_property([] {
    const auto [first, second] = *any_pair<T3, T3>();
    const auto step = rc::gen::inRange(-300, 301);
    const V3 steps(*step, *step, *step);
    const T3 a = nudged(first, second.b, steps);
    const auto [other, segment] = *any_pair<T3, S3>();
    const T3 b = nudged(other, segment.end, steps);
    expect_careful_agrees(a, second, detail::careful_closed_form(a, second));
    expect_careful_agrees(b, segment, detail::careful_closed_form(segment, b));
  });
}

TEST(TriangleFilter, NeverContradictsTheCarefulFormOfBalls) {
  check_property([] {
    const auto [triangle, sphere] = *any_pair<T3, Sphere<3, double>>();
    const double distance = std::sqrt(distance_squared(sphere.center, triangle));
    const double size = distance + detail::extent_around_zero(triangle);
    const double off = *rc::gen::inRange(-4000, 4001) * tolerance::epsilon * size;
    const Sphere<3, double> near{sphere.center, std::max(0.0, distance + off)};
    const auto quick = filter(triangle, near);
    RC_ASSERT(!quick || *quick == detail::careful_closed_form(near, triangle));
  });
}

}  // namespace
}  // namespace graze::test::triangle_filter_test
