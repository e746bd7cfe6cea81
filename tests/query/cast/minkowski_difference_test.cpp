// SPDX-License-Identifier: MIT
// The Minkowski differences that shape_cast.hpp casts rays at: closed forms against those from support points.
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/shape_cast.hpp>

#include "catalogue.hpp"

namespace graze::test::obstacle_test {
namespace {

using Point = Vec<3, double>;
using Box = Aabb<3, double>;

/// The difference of any two cores, relative to the origin.
template <class A, class B>
detail::MinkowskiDifference<3, double> generic(const A& a, const B& b, double radius) {
  return {detail::ConvexView<3>(a), detail::ConvexView<3>(b), Point(0.0), radius};
}

/// Checks that both reach equally far in some directions.
template <class Closed, class Generic>
void expect_same_set(const Closed& closed, const Generic& other) {
  for (const Point& direction : {Point(1, 0, 0), Point(0, -1, 0), Point(1, 2, -3), Point(-5, 1, 0.25)}) {
    const double reach = dot(direction, detail::wide_support(closed, direction));
    const double expected = dot(direction, detail::wide_support(other, direction));
    EXPECT_NEAR(reach, expected, 1e-14 * std::fabs(expected) + 1e-14);
  }
}

TEST(MinkowskiDifference, ClosedFormsAreTheSetsOfDifferences) {
  const Point p(1, 2, 3);
  const Point q(4, -2, 7);
  const Segment<3, double> s{{1, 0, 0}, {2, 5, -1}};
  const Box box{{-1, 0, 2}, {3, 1, 4}};
  const Box other{{5, 6, 7}, {6, 8, 10}};
  expect_same_set(detail::minkowski_difference_of(p, q, 0.5), generic(p, q, 0.5));
  expect_same_set(detail::minkowski_difference_of(s, q, 0.5), generic(s, q, 0.5));
  expect_same_set(detail::minkowski_difference_of(p, s, 0.5), generic(p, s, 0.5));
  expect_same_set(detail::minkowski_difference_of(p, box, 0.5), generic(p, box, 0.5));
  expect_same_set(detail::minkowski_difference_of(box, other, 0.0), generic(box, other, 0.0));
}

TEST(MinkowskiDifference, IsKnownFromItsPlace) {
  const Point p(1, 2, 3);
  const Box box{{4, 4, 4}, {5, 5, 5}};
  const detail::MinkowskiDifference<3, double> difference{detail::ConvexView<3>(p), detail::ConvexView<3>(box), p, 2};
  EXPECT_EQ(support(difference, Point(3, 0, 0)), Point(7, 4, 4));  // of the box itself, 2 farther out
  EXPECT_EQ(detail::wide_support(detail::core(difference), Point(3, 0, 0)), Point(5, 4, 4));
  EXPECT_EQ(detail::core_radius(difference), 2);
}

TEST(MinkowskiDifference, RoundingIsThatOfTheNumbersThatSupportsAreCalculatedIn) {
  EXPECT_EQ((detail::support_error<detail::MinkowskiDifference<3, double>>), tolerance::convex);
  EXPECT_EQ((detail::support_error<detail::MinkowskiDifference<3, float>>), tolerance::convex_in<float>);
  EXPECT_EQ((detail::support_error<detail::DifferenceCore<2, float>>), tolerance::convex_in<float>);
}

TEST(MinkowskiDifference, APathCrossesTheSidesOfABoxInOrder) {
  const Aabb<2, double> box{{1, -3}, {2, -2}};
  const auto times = [&box](const Vec<2, double>& direction) {
    const detail::SideCrossings<2> crossings(box, direction, 1);
    return std::vector<double>(crossings.begin(), crossings.end());
  };
  EXPECT_EQ(times({4, -8}), (std::vector<double>{0.25, 0.25, 0.375, 0.5, 1}));
  EXPECT_EQ(times({0, -8}), (std::vector<double>{0.25, 0.375, 1}));
  EXPECT_EQ(times({-1, 1}), (std::vector<double>{1}));
}

/// GJK and the closed form agree about a rounded box, from wherever a sphere comes.
TEST(MinkowskiDifference, RaysMeetARoundedBoxWhereGjkFindsIt) {
  check_property([] {
    const std::uint64_t seed = *choice(std::size_t{1} << 31U);
    rc::Random random(seed);
    const auto any_point = [&random](double size) {
      Point point;
      for (Dim i = 0; i < 3; ++i) point[i] = between(random, -size, size);
      return point;
    };
    const Box box = Box::from_corners(any_point(1), any_point(1));
    const Point start = any_point(8);
    const Point motion = any_point(1) - start + any_point(1.5);
    const double radius = between(random, 0.01, 1.5);
    RC_LOG() << "box " << to_source(box) << ", from " << to_source(start) << " along " << to_source(motion) << ", "
             << literal(radius) << "\n";
    const Ray<3, double> ray{Point(0.0), motion};
    const auto closed = detail::hit_in_double(detail::minkowski_difference_of(start, box, radius), ray);
    const auto by_gjk = detail::hit_in_double(generic(start, box, radius), ray);
    RC_ASSERT(closed.has_value() == by_gjk.has_value());
    if (!closed) return;
    // Along the normal they are as close as their errors say; t is less accurate at a grazing angle.
    const double steepness = std::fabs(dot(closed->normal, motion));
    RC_ASSERT(std::fabs(closed->t - by_gjk->t) * steepness <= 2 * (closed->error + by_gjk->error));
  });
}

}  // namespace
}  // namespace graze::test::obstacle_test
