// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <graze/query/closest_points.hpp>
#include <graze/query/cores/closest.hpp>
#include <graze/query/distance_squared.hpp>

#include "catalogue.hpp"

namespace graze::detail::closest_cores_test {
namespace {

using V3 = Vec<3, double>;
using S3 = Segment<3, double>;
using B3 = Aabb<3, double>;
using T3 = Triangle<3, double>;

/// An AABB as an oriented box.
Obb<3, double> as_obb(const B3& box) { return {box.center(), box.half_extents(), Mat<3, double>(1.0)}; }

template <class A, class B>
void expect_closest(const A& a, const B& b, const V3& on_a, const V3& on_b) {
  const ClosestPair<3> pair = closest_of_apart(a, b, size_around_zero(a) + size_around_zero(b));
  EXPECT_NEAR(length(pair.on_a - on_a), 0, 1e-15);
  EXPECT_NEAR(length(pair.on_b - on_b), 0, 1e-15);
  EXPECT_NEAR(length(pair.between - (on_b - on_a)), 0, 1e-15);
  EXPECT_EQ(pair.squared, dot(pair.between, pair.between));
}

TEST(ClosestPair, KeepsTheFirstOfSeveralNearestOnes) {
  ClosestPair<3> best;
  best.offer_from_a(V3(0, 0, 0), {{0, 0, 2}, {0, 0, -2}});
  EXPECT_EQ(best.between, V3(0, 0, 2));
  best.offer_from_b(V3(2, 0, 0), {{0, 0, 0}, {2, 0, 0}});
  EXPECT_EQ(best.on_b, V3(0, 0, 2));
  best.offer_from_b(V3(1, 0, 0), {{0, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(best.on_b, V3(1, 0, 0));
  EXPECT_EQ(best.squared, 1);
}

TEST(ClosestOfApart, IsAsComputedByHand) {
  const S3 along{{-1, 0, 0}, {1, 0, 0}};
  expect_closest(V3(5, 4, 0), along, {5, 4, 0}, {1, 0, 0});
  expect_closest(along, V3(0.5, 4, 0), {0.5, 0, 0}, {0.5, 4, 0});
  expect_closest(along, S3{{0.25, -1, 2}, {0.25, 1, 2}}, {0.25, 0, 0}, {0.25, 0, 2});
  expect_closest(along, S3{{4, 4, 0}, {4, 4, 0}}, {1, 0, 0}, {4, 4, 0});
  const B3 box{{2, 2, 2}, {4, 4, 4}};
  expect_closest(S3{{0, 3, 2}, {3, 0, 2}}, box, {1.5, 1.5, 2}, {2, 2, 2});
  expect_closest(S3{{0, 3, 2}, {3, 0, 2}}, as_obb(box), {1.5, 1.5, 2}, {2, 2, 2});
  const T3 roof{{1, -1, 3}, {-1, 1, 3}, {0, 0, 9}};
  expect_closest(roof, T3{{-2, -2, 1}, {2, 2, 1}, {0, 0, -4}}, {0, 0, 3}, {0, 0, 1});
  EXPECT_EQ(closest_of_apart(roof, B3{{-1, -1, -1}, {1, 1, 1}}, 20).squared, 4);  // along an edge
}

// The edges x and y of two boxes, each rotated by 45 degrees about it.
TEST(ClosestOfApart, FindsTwoEdgesThatCross) {
  const double h = std::sqrt(0.5);
  const Obb<3, double> lower{{0, 0, 0}, {5, 1, 1}, Mat<3, double>(1, 0, 0, 0, h, h, 0, -h, h)};
  const Obb<3, double> upper{{0, 0, 4}, {1, 5, 1}, Mat<3, double>(h, 0, h, 0, 1, 0, -h, 0, h)};
  const ClosestPair<3> pair = closest_of_apart(lower, upper, 20);
  EXPECT_NEAR(std::sqrt(pair.squared), 4 - 2 * std::sqrt(2.0), 4e-15);
  EXPECT_NEAR(length(pair.on_a - V3(0, 0, std::sqrt(2.0))), 0, 4e-15);
}

// The edges are parallel to faces of the other, which they cross without a corner above or below it: the nearest points
// may be anywhere along the crossing, and rounding must not decide that no edge is foremost.
TEST(ClosestOfApart, FindsEdgesThatLieAboveFaces) {
  const B3 bar{{-5, -1, -1}, {5, 1, 1}};
  const B3 beam{{-1, -5, 3}, {1, 5, 5}};
  EXPECT_EQ(closest_of_apart(bar, beam, 20).squared, 4);
  EXPECT_EQ(closest_of_apart(as_obb(bar), as_obb(beam), 20).squared, 4);
  EXPECT_EQ(closest_of_apart(T3{{-9, 0.5, 3}, {9, 0.5, 3}, {0, 0.5, 9}}, bar, 20).squared, 4);
  EXPECT_EQ(closest_of_apart(S3{{-9, 0.5, 3}, {9, 0.5, 3}}, bar, 20).squared, 4);
}

TEST(ClosestOfApart, AgreesWithTheSquaredDistance) {
  test::check_property([] {
    const auto [a, b] = *test::any_pair<S3, S3>();
    const V3 start = a.start;
    const S3 local_a{a.start - start, a.end - start};
    const S3 local_b{b.start - start, b.end - start};
    const double size = size_around_zero(local_a) + size_around_zero(local_b);
    const double found = std::sqrt(closest_of_apart(local_a, local_b, size).squared);
    RC_ASSERT(std::fabs(found - std::sqrt(distance_squared(a, b))) <= tolerance::rounding * size);
  });
}

TEST(Perpendicular, IsNoneOfParallelSegmentsAndPoints) {
  const S3 along{{-1, 0, 0}, {1, 0, 0}};
  EXPECT_FALSE(Perpendicular(along, S3{{5, 1, 0}, {9, 1, 0}}).is_any());
  EXPECT_FALSE(Perpendicular(along, S3{{5, 1, 0}, {5, 1, 0}}).is_any());
  const Perpendicular<3> perpendicular(along, S3{{0.5, -1, 2}, {0.5, 3, 2}});
  ASSERT_TRUE(perpendicular.is_any());
  EXPECT_EQ(perpendicular.on_a(), 0.75);
  EXPECT_EQ(perpendicular.on_b(), 0.25);
}

TEST(ClosestOfBoxes, IsInTheMiddleOfWhatTheyShare) {
  const B3 box{{0, 0, 0}, {4, 4, 4}};
  const ClosestPair<3> apart = closest_of_boxes(box, B3{{7, -2, 5}, {9, 2, 6}});
  EXPECT_EQ(apart.on_a, V3(4, 1, 4));
  EXPECT_EQ(apart.on_b, V3(7, 1, 5));
  EXPECT_EQ(apart.squared, 10);
  const ClosestPair<3> before = closest_of_boxes(box, B3{{-3, -2, -2}, {-1, -1, -1}});
  EXPECT_EQ(before.on_a, V3(0, 0, 0));
  EXPECT_EQ(before.on_b, V3(-1, -1, -1));
  EXPECT_EQ(closest_of_boxes(box, B3{{2, 2, 4}, {8, 8, 8}}).on_a, V3(3, 3, 4));
}

template <class A, class B>
void expect_meeting(const A& a, const B& b) {
  const ClosestPair<3> pair = closest_of_meeting(a, b, size_around_zero(a) + size_around_zero(b));
  EXPECT_LE(pair.squared, 1e-30);
  EXPECT_LE(length(pair.on_b - pair.on_a), 1e-15);
}

TEST(ClosestOfMeeting, FindsAPointOfBoth) {
  const B3 bar{{-5, -1, -1}, {5, 1, 1}};
  expect_meeting(bar, as_obb(B3{{-1, -5, -0.5}, {1, 5, 0.5}}));         // crosswise: no corner in the other
  expect_meeting(S3{{-9, 0.3, 0.2}, {9, 0.3, 0.2}}, bar);               // along it
  expect_meeting(S3{{-9, 1, 1}, {9, 1, 1}}, bar);                       // along its edge
  expect_meeting(T3{{0, -9, -9}, {0, 9, -9}, {0, 0, 9}}, as_obb(bar));  // through it
  expect_meeting(T3{{-9, -9, 1}, {9, -9, 1}, {0, 9, 1}}, as_obb(bar));  // on its face
  expect_meeting(T3{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, T3{{1, 1, -1}, {1, 1, 1}, {9, 9, 0}});
  expect_meeting(T3{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, T3{{3, 3, 0}, {-1, 3, 0}, {3, -1, 0}});  // in one plane
  expect_meeting(S3{{1, 1, -1}, {1, 1, 1}}, T3{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}});
  expect_meeting(S3{{-1, -1, 0}, {1, 1, 0}}, S3{{-1, 1, 0}, {1, -1, 0}});
  expect_meeting(V3(1, 1, 0), T3{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}});
}

}  // namespace
}  // namespace graze::detail::closest_cores_test
