// SPDX-License-Identifier: MIT
// What the options of shape_cast stop at, calculated by hand: shapes that slide along others, leave them and meet the
// next, and shapes that stop before they touch.
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/cast_options.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/distance.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/query/transformed.hpp>

#include "query/placement.hpp"
#include "query/row_of_shapes.hpp"
#include "query/shape_casts.hpp"
#include "query/user_shapes.hpp"

namespace graze::test::cast_options_test {
namespace {

constexpr CastOptions past_touches{true, 0};

template <Dim N, class T>
Vec<N, T> vec(double x, double y) {
  Vec<N, T> v(T(0));
  v[0] = static_cast<T>(x);
  v[1] = static_cast<T>(y);
  return v;
}

/// The box with these corners; in 3D from -1 to 1 along z.
template <Dim N, class T>
Aabb<N, T> box(double x, double y, double to_x, double to_y) {
  Aabb<N, T> result{vec<N, T>(x, y), vec<N, T>(to_x, to_y)};
  if constexpr (N == 3) {
    result.min.z = -1;
    result.max.z = 1;
  }
  return result;
}

template <Dim N, class T>
Polytope<N, T> hull(const Aabb<N, T>& box) {
  std::vector<Vec<N, T>> corners;
  for (unsigned i = 0; i < (1U << static_cast<unsigned>(N)); ++i) {
    Vec<N, T> corner;
    for (Dim k = 0; k < N; ++k) corner[k] = (i >> static_cast<unsigned>(k) & 1U) != 0 ? box.max[k] : box.min[k];
    corners.push_back(corner);
  }
  return convex_hull<N, T>(corners);
}

template <Dim N, class T>
HalfSpace<N, T> ground() {
  return {vec<N, T>(0, 1), T(0)};
}

template <Dim N, class T>
void expect_slide_to_the_wall(const AnyShape<N, T>& shape, double reach) {
  const AnyShape<N, T> wall = box<N, T>(4, -1, 5, 8);
  std::vector<AnyShape<N, T>> tiles{wall};
  for (int i = -4; i < 4; ++i) tiles.push_back(box<N, T>(i, -1, i + 1, 0));
  const std::vector<AnyShape<N, T>> levels = {
      compound_of<N, T>({ground<N, T>(), wall}), compound_of<N, T>({box<N, T>(-4, -1, 4, 0), wall}),
      compound_of<N, T>({wall, Plane<N, T>{vec<N, T>(0, 1), T(0)}}), compound_of<N, T>(std::move(tiles))};
  for (const AnyShape<N, T>& level : levels) {
    const Vec<N, T> motion = vec<N, T>(8, 0);
    const auto stopped = shape_cast(shape, motion, level);
    ASSERT_TRUE(stopped.has_value());
    EXPECT_EQ(stopped->t, T(0));
    const auto found = shape_cast(shape, motion, level, past_touches);
    ASSERT_TRUE(found.has_value());
    EXPECT_NEAR(static_cast<double>(found->t), (4 - reach) / 8, 1e-6);
    EXPECT_NEAR(static_cast<double>(found->normal.x), 1, 1e-6);
    EXPECT_FALSE(shape_cast(shape, vec<N, T>(0, 8), level, past_touches).has_value()) << "straight up";
    EXPECT_FALSE(shape_cast(shape, vec<N, T>(-8, 8), level, past_touches).has_value()) << "up and away";
    const auto down = shape_cast(shape, vec<N, T>(8, -1), level, past_touches);
    ASSERT_TRUE(down.has_value());
    EXPECT_EQ(down->t, T(0));
    const auto touch = shape_cast(shape, vec<N, T>(0, 0), level, past_touches);
    EXPECT_FALSE(touch.has_value()) << "without motion nothing is approached";
  }
}

template <Dim N, class T>
void expect_slides() {
  expect_slide_to_the_wall<N, T>(box<N, T>(-1.5, 0, 0.5, 2), 0.5);
  expect_slide_to_the_wall<N, T>(box<N, T>(-1, 0, 0, 1), 0);  // its side is in the plane of a seam
  expect_slide_to_the_wall<N, T>(Sphere<N, T>{vec<N, T>(0, 1), T(1)}, 1);
  expect_slide_to_the_wall<N, T>(Capsule<N, T>{vec<N, T>(0, 1), vec<N, T>(0, 3), T(1)}, 1);
  expect_slide_to_the_wall<N, T>(Capsule<N, T>{vec<N, T>(-0.5, 0.5), vec<N, T>(0.25, 0.5), T(0.5)}, 0.75);
  expect_slide_to_the_wall<N, T>(Obb<N, T>{vec<N, T>(0, 1), Vec<N, T>(T(1)), Mat<N, T>(T(1))}, 1);
  expect_slide_to_the_wall<N, T>(hull<N, T>(box<N, T>(-1, 0, 0.25, 2)), 0.25);
  expect_slide_to_the_wall<N, T>(compound_of<N, T>({box<N, T>(-1, 0, 0, 1), Sphere<N, T>{vec<N, T>(0, 1), T(1)}}), 1);
}

TEST(CastOptions, WhatSlidesOnAFloorStopsAtTheWall) {
  expect_slides<2, float>();
  expect_slides<2, double>();
  expect_slides<3, float>();
  expect_slides<3, double>();
}

TEST(CastOptions, AFloorAtAnyAngleIsSlidAlongToTheWall) {
  const AnyShape<3, double> level = compound_of<3, double>({box<3, double>(-4, -1, 4, 0), box<3, double>(4, -1, 5, 8)});
  const Capsule<3, double> capsule{{0, 1, 0}, {0, 2, 0}, 1};
  for (int i = 1; i < 40; ++i) {
    const auto pose = Pose<3, double>::from_axis_angle(Vec<3, double>(1, 2, 3) * (0.25 * i),
                                                       Vec<3, double>(1, 0.3 * i, -0.5), 0.1 * i);
    const auto found = shape_cast(AnyShape<3, double>(transformed(capsule, pose)),
                                  pose.rotation * Vec<3, double>(8, 0, 0), transformed(level, pose), past_touches);
    ASSERT_TRUE(found.has_value()) << i;
    EXPECT_NEAR(found->t, 3.0 / 8, 1e-12) << i;
  }
}

// ---- Shapes that overlap at the start

TEST(CastOptions, WhatOverlapsMovesOutAndNotDeeper) {
  const Sphere<3, double> ball{{0, 0.75, 0}, 1};
  const HalfSpace<3, double> floor = ground<3, double>();
  EXPECT_FALSE(shape_cast(ball, Vec<3, double>(1, 1, 0), floor, past_touches).has_value());
  EXPECT_FALSE(shape_cast(ball, Vec<3, double>(1, 0, 0), floor, past_touches).has_value());
  const auto found = shape_cast(ball, Vec<3, double>(1, -1, 0), floor, past_touches);
  EXPECT_EQ(found, shape_cast(ball, Vec<3, double>(1, -1, 0), floor));
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->t, 0);
}

TEST(CastOptions, OfPartsThatOverlapTheDeepestApproachedOneCounts) {
  const Aabb<2, double> mover{{0, 0}, {2, 2}};
  const Aabb<2, double> below{{-5, -5}, {5, 0.75}};
  const Aabb<2, double> right{{1.875, -5}, {5, 5}};
  const Aabb<2, double> farther_left{{1.75, 1}, {5, 1.75}};
  const AnyShape<2, double> level = compound_of<2, double>({below, right, farther_left});
  const auto found = shape_cast(AnyShape<2, double>(mover), Vec<2, double>(1, 0.5), level, past_touches);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found, shape_cast(AnyShape<2, double>(mover), Vec<2, double>(1, 0.5), AnyShape<2, double>(farther_left)));
}

TEST(CastOptions, WhatNothingSeparatesIsNotApproached) {
  const Ray<3, double> ray{{0, 1, 0}, {0, -1, 0}};
  const Vec<3, double> motion(0, -1, 0);
  EXPECT_TRUE(shape_cast(ray, motion, ground<3, double>()).has_value());
  EXPECT_FALSE(shape_cast(ray, motion, ground<3, double>(), past_touches).has_value());
}

TEST(CastOptions, ATouchAtACornerIsApproachedIfNoPlaneThroughItHoldsTheMotion) {
  const Aabb<2, double> mover{{0, 0}, {1, 1}};
  const Aabb<2, double> other{{1, 1}, {2, 2}};
  for (const Vec<2, double>& motion : {Vec<2, double>(1, 0), Vec<2, double>(0, 1), Vec<2, double>(1, -0.5)}) {
    EXPECT_FALSE(shape_cast(mover, motion, other, past_touches).has_value());
  }
  const auto found = shape_cast(mover, Vec<2, double>(1, 0.001), other, past_touches);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->t, 0);
}

// ---- Target distances

TEST(CastOptions, TheCastStopsBeforeTheShapesTouch) {
  const auto stop = [](const AnyShape<3, double>& a, const Vec<3, double>& motion, const AnyShape<3, double>& b,
                       double distance) {
    return shape_cast(a, motion, b, CastOptions{false, distance});
  };
  const Vec<3, double> right(8, 0, 0);
  const Sphere<3, double> ball{{0, 0, 0}, 1};
  const auto of_balls = stop(ball, right, Sphere<3, double>{{7, 0, 0}, 2}, 0.5);
  ASSERT_TRUE(of_balls.has_value());
  EXPECT_NEAR(of_balls->t, 3.5 / 8, 1e-15);
  EXPECT_NEAR(of_balls->point.x, 5, 1e-14);
  EXPECT_EQ(of_balls->normal, (Vec<3, double>(1, 0, 0)));
  const auto of_boxes = stop(box<3, double>(-1, -1, 0, 0), right, box<3, double>(4, 3, 6, 5), 5);
  ASSERT_TRUE(of_boxes.has_value());
  EXPECT_NEAR(of_boxes->t, 0, 1e-15) << "exactly as near at the start";
  const auto of_corners = stop(box<3, double>(-5, -1, -4, 0), right, box<3, double>(4, 3, 6, 5), 5);
  ASSERT_TRUE(of_corners.has_value());
  EXPECT_NEAR(of_corners->t, 0.5, 1e-15);
  EXPECT_NEAR(of_corners->normal.x, 0.8, 1e-14);
  EXPECT_NEAR(of_corners->normal.y, 0.6, 1e-14);
  EXPECT_NEAR(of_corners->point.x, 4, 1e-14);
  EXPECT_NEAR(of_corners->point.y, 3, 1e-14);
  const auto of_floor = stop(Vec<3, double>(0, 5, 0), Vec<3, double>(3, -4, 0), ground<3, double>(), 3);
  ASSERT_TRUE(of_floor.has_value());
  EXPECT_NEAR(of_floor->t, 0.5, 1e-15);
  EXPECT_NEAR(of_floor->point.x, 1.5, 1e-14);
  EXPECT_NEAR(of_floor->point.y, 0, 1e-14);
  const Ray<3, double> up{{4, -9, 1}, {0, 1, 0}};
  const Ray<3, double> deep{{0, 3, -9}, {0, 0, 1}};
  const auto of_rays = stop(deep, right, up, 0.5);
  ASSERT_TRUE(of_rays.has_value());
  EXPECT_NEAR(of_rays->t, 3.5 / 8, 1e-15);
  EXPECT_NEAR(of_rays->point.y, 3, 1e-13);
  EXPECT_FALSE(stop(ball, right, Sphere<3, double>{{4, 4, 0}, 1}, 1.99).has_value());
  EXPECT_TRUE(stop(ball, right, Sphere<3, double>{{4, 4, 0}, 1}, 2.01).has_value());
  EXPECT_TRUE(stop(ball, -right, Sphere<3, double>{{4, 4, 0}, 1}, 4).has_value()) << "as near at the start";
}

TEST(CastOptions, WhatIsNearAtTheStartIsTheNearestPoint) {
  const Sphere<2, double> ball{{0, 0}, 1};
  const Aabb<2, double> wall{{2, -1}, {3, 1}};
  const auto found = shape_cast(ball, Vec<2, double>(-1, 0), wall, CastOptions{false, 1.5});
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->t, 0);
  EXPECT_EQ(found->point, (Vec<2, double>(2, 0)));
  EXPECT_EQ(found->normal, (Vec<2, double>(1, 0)));
  EXPECT_FALSE(shape_cast(ball, Vec<2, double>(-1, 0), wall, CastOptions{true, 1.5}).has_value());
  EXPECT_FALSE(shape_cast(ball, Vec<2, double>(0, 1), wall, CastOptions{true, 1.5}).has_value());
  EXPECT_EQ(shape_cast(ball, Vec<2, double>(1, 0), wall, CastOptions{true, 1.5}), found);
  EXPECT_TRUE(shape_cast(ball, Vec<2, double>(-1, 0), wall, CastOptions{false, 1e300}).has_value());
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(shape_cast(ball, Vec<2, double>(-1, 0), wall, CastOptions{false, infinity}).has_value());
  EXPECT_FALSE(
      shape_cast(ball, Vec<2, double>(-1, 0), Compound<2, double>{}, CastOptions{false, infinity}).has_value());
}

template <Dim N, class T>
void expect_every_pair_stops_before() {
  const Vec<N, T> way = unit_axis<N, T>(0) * T(6);
  const T d = T(0.75);
  for (std::size_t a = 0; a < row_types; ++a) {
    for (std::size_t b = 0; b < row_types; ++b) {
      const AnyShape<N, T> left = moved<N, T>(row_shape<N, T>(a, T(1)), unit_axis<N, T>(0) * T(-6));
      const AnyShape<N, T> right = moved<N, T>(row_shape<N, T>(b, T(-1)), unit_axis<N, T>(0) * T(-1));
      const auto found = shape_cast(left, way, right, CastOptions{false, d});
      ASSERT_TRUE(found.has_value()) << a << " against " << b;
      const AnyShape<N, T> there = moved<N, T>(left, way * found->t);
      const auto near = closest_points(there, right);
      const double off = 1e-14 + 2 * found->error + 16 * static_cast<double>(std::numeric_limits<T>::epsilon());
      EXPECT_NEAR(static_cast<double>(near.distance), 0.75, off) << a << " against " << b;
      for (Dim i = 0; i < N; ++i) EXPECT_NEAR(near.normal[i], found->normal[i], 1e-5) << a << " against " << b;
      EXPECT_NEAR(static_cast<double>(distance(right, found->point)), 0, off) << a << " against " << b;
      EXPECT_NEAR(static_cast<double>(distance(there, found->point)), 0.75, off) << a << " against " << b;
      const auto from_right = shape_cast(right, -way, left, CastOptions{false, d});
      ASSERT_TRUE(from_right.has_value());
      EXPECT_EQ(from_right->t, found->t) << a << " against " << b;
      EXPECT_FALSE(shape_cast(left, -way, right, CastOptions{false, d}).has_value()) << a << " against " << b;
      EXPECT_EQ(shape_cast(left, way, right, CastOptions{true, d}), found) << a << " against " << b;
    }
  }
}

TEST(CastOptions, EveryTwoShapesStopAtTheTargetDistance) {
  expect_every_pair_stops_before<2, float>();
  expect_every_pair_stops_before<2, double>();
  expect_every_pair_stops_before<3, float>();
  expect_every_pair_stops_before<3, double>();
}

// ---- Users' shapes and unusual numbers

/// Shapes that are as near as the target up to rounding, from where another cast has stopped.
template <Dim N, class T>
void expect_every_pair_leaves_its_stop() {
  const Vec<N, T> way = unit_axis<N, T>(0) * T(6);
  for (std::size_t a = 0; a < row_types; ++a) {
    for (std::size_t b = 0; b < row_types; ++b) {
      const AnyShape<N, T> left = moved<N, T>(row_shape<N, T>(a, T(1)), unit_axis<N, T>(0) * T(-6));
      const AnyShape<N, T> right = moved<N, T>(row_shape<N, T>(b, T(-1)), unit_axis<N, T>(0) * T(-1));
      const auto stop = shape_cast(left, way, right, CastOptions{false, 0.01});
      ASSERT_TRUE(stop.has_value()) << a << " against " << b;
      const AnyShape<N, T> there = moved<N, T>(left, way * stop->t);
      const auto gap = static_cast<double>(distance(there, right));
      for (int i = -32; i <= 32; i += 4) {
        const CastOptions options{true, gap + i * 0x1p-53};
        EXPECT_FALSE(shape_cast(there, -way, right, options).has_value()) << a << " against " << b << ", " << i;
        EXPECT_TRUE(shape_cast(there, way, right, options).has_value()) << a << " against " << b << ", " << i;
      }
    }
  }
}

TEST(CastOptions, EveryTwoShapesLeaveEachOtherFromTheTargetDistance) {
  expect_every_pair_leaves_its_stop<2, float>();
  expect_every_pair_leaves_its_stop<2, double>();
  expect_every_pair_leaves_its_stop<3, float>();
  expect_every_pair_leaves_its_stop<3, double>();
}

TEST(CastOptions, UsersShapesSlideAndStopToo) {
  const user::Ellipsoid<double> egg{{0, 2, 0}, {1, 2, 1}};
  const Aabb<3, double> floor = box<3, double>(-9, -1, 9, 0);
  const Vec<3, double> right(8, 0, 0);
  EXPECT_FALSE(shape_cast(egg, right, floor, past_touches).has_value());
  EXPECT_TRUE(shape_cast(egg, Vec<3, double>(8, -1, 0), floor, past_touches).has_value());
  const auto found = shape_cast(egg, right, user::Ellipsoid<double>{{6, 2, 0}, {2, 1, 1}}, CastOptions{false, 0.5});
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->t, 2.5 / 8, 1e-6);
  const user::Ellipsoid<float> small{{0, 2, 0}, {1, 2, 1}};
  EXPECT_FALSE(shape_cast(small, Vec<3>(8, 0, 0), box<3, float>(-9, -1, 9, 0), past_touches).has_value());
}

TEST(CastOptions, SizesDoNotMatter) {
  for (const double size : {1e-200, 1e-30, 1e30, 1e200}) {
    const Aabb<3, double> mover{Vec<3, double>(-1, 0, -1) * size, Vec<3, double>(1, 2, 1) * size};
    const Aabb<3, double> wall{Vec<3, double>(4, -1, -9) * size, Vec<3, double>(5, 8, 9) * size};
    const Aabb<3, double> floor{Vec<3, double>(-9, -1, -9) * size, Vec<3, double>(9, 0, 9) * size};
    const AnyShape<3, double> level = compound_of<3, double>({floor, wall});
    const auto found = shape_cast(AnyShape<3, double>(mover), Vec<3, double>(8, 0, 0) * size, level, past_touches);
    ASSERT_TRUE(found.has_value()) << size;
    EXPECT_NEAR(found->t, 3.0 / 8, 1e-14) << size;
    const Sphere<3, double> ball{Vec<3, double>(0, 1, 0) * size, size / 2};
    const auto near = shape_cast(ball, Vec<3, double>(8, 0, 0) * size, wall, CastOptions{true, size});
    ASSERT_TRUE(near.has_value()) << size;
    EXPECT_NEAR(near->t, 2.5 / 8, 1e-14) << size;
  }
}

TEST(CastOptions, NaNTouchesNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const AnyShape<2, double> ball = Sphere<2, double>{{0, nan}, 1};
  const AnyShape<2, double> wall = Aabb<2, double>{{2, -1}, {3, 1}};
  for (const bool ignores : {false, true}) {
    const CastOptions options{ignores, 0.5};
    EXPECT_FALSE(detail::impact_of(ball, Vec<2, double>(4, 0), wall, options).has_value());
    EXPECT_FALSE(detail::impact_of(wall, Vec<2, double>(-4, nan), wall, options).has_value());
  }
}

}  // namespace
}  // namespace graze::test::cast_options_test
