// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <graze/math/rotation.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/cores/separating_axis.hpp>
#include <graze/query/cores/touching_points.hpp>

#include "catalogue.hpp"

namespace graze::detail::touching_points_test {
namespace {

using V2 = Vec<2, double>;
using V3 = Vec<3, double>;
using S3 = Segment<3, double>;
using B3 = Aabb<3, double>;
using O3 = Obb<3, double>;
using T3 = Triangle<3, double>;

constexpr double margin = 1e-12;

template <class Core, Dim N>
void expect_feature(const Core& core, const Vec<N, double>& direction, std::initializer_list<Vec<N, double>> corners) {
  const ForemostFeature<N> feature = foremost_feature(core, direction, margin);
  ASSERT_EQ(feature.count, static_cast<int>(corners.size()));
  std::size_t k = 0;
  for (const Vec<N, double>& corner : corners) EXPECT_EQ(feature.corners[k++], corner);
}

TEST(ForemostFeature, IsACornerOrAnEdgeOrCannotBeTold) {
  const S3 segment{{1, 0, 0}, {3, 1, 0}};
  expect_feature(segment, V3(1, 0, 0), {segment.end});
  expect_feature(segment, V3(-1, 0, 0), {segment.start});
  expect_feature(segment, V3(0, 0, 1), {segment.start, segment.end});
  const T3 triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 1}};
  expect_feature(triangle, V3(0, 0, 1), {triangle.c});
  expect_feature(triangle, V3(0, 0, -1), {triangle.a, triangle.b});
  expect_feature(triangle, V3(0, -1, 0), {triangle.a, triangle.b});
  expect_feature(triangle, V3(0, -1, 4), {});
  const BoxFrame<3> box = frame_of(B3{{-1, -2, -3}, {1, 2, 3}});
  expect_feature(box, V3(1, -1, 1), {V3(1, -2, 3)});
  expect_feature(box, V3(1, 0, 1), {V3(1, -2, 3), V3(1, 2, 3)});
  expect_feature(box, V3(0, 0, 1), {});
  const BoxFrame<2> flat = frame_of(Aabb<2, double>{{-1, 0}, {1, 0}});
  expect_feature(flat, V2(1, 1), {V2(1, 0), V2(1, 0)});  // no height: an edge that is a point
}

TEST(ClosestOfCrossing, IsNoneOfEdgesThatAreNearlyParallel) {
  const ClosestPair<3> pair = closest_of_crossing({{-1, 0, 0}, {1, 0, 0}}, {{0.5, -1, 0}, {0.5, 3, 0}});
  EXPECT_EQ(pair.squared, 0);
  EXPECT_EQ(pair.on_a, V3(0.5, 0, 0));
  EXPECT_FALSE(std::isfinite(closest_of_crossing({{-1, 0, 0}, {1, 0, 0}}, {{-1, -0.1, 0}, {1, 0.1, 0}}).squared));
  EXPECT_FALSE(std::isfinite(closest_of_crossing({{-1, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}).squared));
}

/// Two cores moved so that they touch along their separating axis, and slightly too far: the points found are as close
/// to each other as those of an exhaustive search, up to rounding, and are on both.
template <class A, class B>
void expect_as_near_as_the_search() {
  test::check_property([] {
    const auto [first, second] = *test::any_pair<A, B>();
    const V3 origin = reference(first);
    const A a = relative_to(origin, first);
    const B b = relative_to(origin, second);
    const double size = size_around_zero(a) + size_around_zero(b);
    SeparatingAxisSearch<A, B> search(a, b, size);
    offer_faces(a, b, search);
    for (const double too_far : {0.0, 1e-15, 1e-3}) {
      const B moved = moved_by(b, search.best().normal * (too_far * size - search.best().gap));
      const ClosestPair<3> quick = closest_of_touching(a, moved, search.best().normal, size);
      const ClosestPair<3> careful = closest_of_meeting(a, moved, size);
      const double near = tolerance::coarse * size;
      RC_ASSERT(std::sqrt(quick.squared) <= std::sqrt(careful.squared) + near);
      const V3 off_a = closest_on(a, quick.on_a).off;
      const V3 off_b = closest_on(moved, quick.on_b).off;
      RC_ASSERT(length(off_a) <= near);
      RC_ASSERT(length(off_b) <= near);
      RC_ASSERT(length(quick.on_b - quick.on_a - quick.between) <= near);
    }
  });
}

TEST(ClosestOfTouching, IsAsNearAsThatOfMeeting) {
  expect_as_near_as_the_search<S3, S3>();
  expect_as_near_as_the_search<S3, O3>();
  expect_as_near_as_the_search<B3, T3>();
  expect_as_near_as_the_search<O3, T3>();
  expect_as_near_as_the_search<S3, T3>();
  expect_as_near_as_the_search<T3, T3>();
  expect_as_near_as_the_search<V3, T3>();
}

/// If only a corner is near the other core, it is the point, not one beside it.
TEST(ClosestOfTouching, IsTheCornerThatTouches) {
  const O3 box{{0, 0, 2}, {1, 1, 1}, rotation_matrix(V3(1, 2, 0.5), 40)};
  const T3 ground{{-40, -30, 0}, {50, -30, 0}, {0, 60, 0}};
  SeparatingAxisSearch<T3, O3> search(ground, box, 100);
  search.offer({0, 0, 1});
  const O3 moved = moved_by(box, search.best().normal * -search.best().gap);
  const ClosestPair<3> pair = closest_of_touching(ground, moved, search.best().normal, 100);
  const ForemostFeature<3> corner = foremost_feature(frame_of(moved), V3(0, 0, -1), margin);
  ASSERT_EQ(corner.count, 1);
  EXPECT_EQ(pair.on_b, corner.corners[0]);
}

}  // namespace
}  // namespace graze::detail::touching_points_test
