// SPDX-License-Identifier: MIT
// Casts calculated by hand, for every pair of types, at the edge of touching, far and near, with user-defined shapes,
// and with invalid numbers.
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/tolerance.hpp>
#include <graze/query/shape_cast.hpp>

#include "parts_of.hpp"
#include "query/flush_prisms.hpp"
#include "query/numbers_of.hpp"
#include "query/placement.hpp"
#include "query/row_of_shapes.hpp"
#include "query/shape_casts.hpp"
#include "query/user_shapes.hpp"

namespace graze::test::shape_cast_test {
namespace {

using Point = Vec<3, double>;
using Ball = Sphere<3, double>;
using Box = Aabb<3, double>;
using Found = std::optional<Impact<3, double>>;

constexpr double infinity = std::numeric_limits<double>::infinity();

void expect_impact(const Found& found, double t, const Point& point, const Point& normal, const std::string& what) {
  ASSERT_TRUE(found.has_value()) << what;
  const double off = 1e-15 + 2 * found->error;
  EXPECT_NEAR(found->t, t, off) << what;
  for (Dim i = 0; i < 3; ++i) {
    EXPECT_NEAR(found->point[i], point[i], off) << what;
    EXPECT_NEAR(found->normal[i], normal[i], off) << what;
  }
  EXPECT_EQ(found->status, Status::converged) << what;
  EXPECT_LT(found->error, 1e-12) << what;
}

// ---- Every two types of shapes, from both sides

template <Dim N, class T>
void expect_every_pair_meets_after_three_units() {
  const Vec<N, T> way = unit_axis<N, T>(0) * T(6);
  for (std::size_t a = 0; a < row_types; ++a) {
    for (std::size_t b = 0; b < row_types; ++b) {
      const std::string what = std::to_string(a) + " against " + std::to_string(b);
      // They end at x = 1 and x = -1 initially; so a starts at -5 and reaches x = -2 at t = 1/2.
      const AnyShape<N, T> left = moved<N, T>(row_shape<N, T>(a, T(1)), unit_axis<N, T>(0) * T(-6));
      const AnyShape<N, T> right = moved<N, T>(row_shape<N, T>(b, T(-1)), unit_axis<N, T>(0) * T(-1));
      const auto found = impact_of<N, T>(left, way, right);
      ASSERT_TRUE(found.has_value()) << what;
      const double off = 1e-15 + 2 * found->error + static_cast<double>(std::numeric_limits<T>::epsilon());
      EXPECT_NEAR(static_cast<double>(found->t), 0.5, off) << what;
      EXPECT_NEAR(static_cast<double>(found->point.x), -2, off) << what;
      EXPECT_GT(found->normal.x, T(0.4)) << what;  // that of a corner may be tilted
      EXPECT_FALSE((impact_of<N, T>(left, way * T(0.49), right).has_value())) << what;
      EXPECT_FALSE((impact_of<N, T>(left, -way, right).has_value())) << what;
      EXPECT_TRUE((impact_of<N, T>(left, way * T(0.5), right).has_value())) << what << ", which ends there";
      const auto from_right = impact_of<N, T>(right, -way, left);
      ASSERT_TRUE(from_right.has_value()) << what;
      EXPECT_EQ(from_right->t, found->t) << what;
    }
  }
}

TEST(ShapeCast, FindsWhenEveryTwoShapesMeet) {
  expect_every_pair_meets_after_three_units<2, float>();
  expect_every_pair_meets_after_three_units<2, double>();
  expect_every_pair_meets_after_three_units<3, float>();
  expect_every_pair_meets_after_three_units<3, double>();
}

// ---- Closed forms

TEST(ShapeCast, FindsWhereABallTouchesABox) {
  const Box box{{0, 0, 0}, {2, 2, 2}};
  const Ball sphere{{-5, 1, 1}, 1};
  const double root = std::sqrt(0.5);
  const double third = std::sqrt(1.0 / 3);
  expect_impact(shape_cast(sphere, {8, 0, 0}, box), 0.5, {0, 1, 1}, {1, 0, 0}, "a face");
  // The center passes the edge along z at a height of 1/2 sqrt 2 above it: it hits 1/2 sqrt 2 before.
  expect_impact(shape_cast(Ball{{-5, 2 + root, 1}, 1}, {10, 0, 0}, box), (5 - root) / 10, {0, 2, 1}, {root, -root, 0},
                "an edge");
  expect_impact(shape_cast(Ball{{-5, 7, 7}, 1}, {10, -10, -10}, box), 0.5 - third / 10, {0, 2, 2},
                {third, -third, -third}, "a corner");
  EXPECT_FALSE(shape_cast(Ball{{-5, 3.0000001, 1}, 1}, {10, 0, 0}, box).has_value());
  EXPECT_FALSE(shape_cast(Ball{{-5, 2.9, 2.9}, 1}, {10, 0, 0}, box).has_value());  // past the rounded edge
}

TEST(ShapeCast, DoesNotTakeARoundedEdgeForACorner) {
  // Past the corner at (0, 2, 2), outside its sphere, and on to the edge along x.
  const Box box{{0, 0, 0}, {20, 2, 2}};
  const double root = std::sqrt(0.5);
  const double t = 0.95 - root;
  expect_impact(shape_cast(Ball{{-2, 2.95, 2.95}, 1}, {10, -1, -1}, box), t, {-2 + 10 * t, 2, 2}, {0, -root, -root},
                "the edge along x");
}

TEST(ShapeCast, FindsWhereBoxesAndCapsulesTouch) {
  expect_impact(shape_cast(Box{{-6, -1, -1}, {-5, 1, 1}}, {8, 2, 0}, Box{{-1, 1, 0}, {1, 3, 2}}), 0.5, {-1, 1.5, 0.5},
                {1, 0, 0}, "boxes");
  const Capsule<3, double> upright{{0, -3, 0}, {0, 3, 0}, 1};
  expect_impact(shape_cast(Ball{{-6, 2, 0}, 1}, {8, 0, 0}, upright), 0.5, {-1, 2, 0}, {1, 0, 0}, "ball and capsule");
  expect_impact(shape_cast(Capsule<3, double>{{-6, 0, -2}, {-6, 0, 2}, 1}, {8, 0, 0}, upright), 0.5, {-1, 0, 0},
                {1, 0, 0}, "crossed capsules");
  expect_impact(shape_cast(Segment<3, double>{{-5, 0, -2}, {-5, 0, 2}}, {8, 0, 0}, Ball{}), 0.5, {-1, 0, 0}, {1, 0, 0},
                "segment and ball");
}

TEST(ShapeCast, FindsWhereTwoRaysCross) {
  const Ray<3, double> up{{0, 0, 0}, {0, 2, 0}};
  const Ray<3, double> back{{3, 5, -7}, {0, 0, 3}};
  expect_impact(shape_cast(up, {6, 0, 0}, back), 0.5, {3, 5, 0}, {1, 0, 0}, "inner points");
  expect_impact(shape_cast(up, {6, 0, 0}, Ray<3, double>{{3, 5, 0}, {0, 0, 3}}), 0.5, {3, 5, 0}, {1, 0, 0},
                "an origin");
  expect_impact(shape_cast(up, {6, 0, 6}, Ray<3, double>{{3, -5, 3}, {0, 1, 0}}), 0.5, {3, 0, 3},
                {std::sqrt(0.5), 0, std::sqrt(0.5)}, "parallel ones");
  EXPECT_FALSE(shape_cast(up, {6, 0, 0}, Ray<3, double>{{3, -5, -7}, {0, 0, 3}}).has_value());
}

template <class T>
void expect_flush_prisms_to_touch() {
  std::size_t hits = 0;
  for (unsigned turn = 0; turn < 1000; ++turn) {
    const double gap = flush_gap(turn);
    const auto [a, b, normal] = flush_prisms<T>(turn, gap);
    const auto found = shape_cast(a, Vec<3, T>(normal * (2 * gap)), b);
    if (!found) continue;
    ++hits;
    EXPECT_EQ(found->status, Status::converged) << turn;
    EXPECT_LE(found->error, 1024 * tolerance::epsilon) << turn;
    const double slack = found->error + 8 * static_cast<double>(std::numeric_limits<T>::epsilon());
    EXPECT_NEAR(static_cast<double>(found->t) * 2 * gap, gap, 5e-6 + slack) << turn;
  }
  EXPECT_GT(hits, 500U);
}

TEST(ShapeCast, EndsWhereFacesAreNearlyParallel) {
  expect_flush_prisms_to_touch<double>();
  expect_flush_prisms_to_touch<float>();
}

// A box a few epsilon of its size from a face: GJK's bounds, off by as much, leave no plane between to move to.
TEST(ShapeCast, ConvergesWhereNoPlaneBetweenIsHigherThanRounding) {
  const std::vector<Point> corners{{5.648924447069362e-05, -0.5000000000000641, 5.664859560727348e-10},
                                   {5.649037757062296e-05, 5.664859560727348e-10, 0.499999999999936},
                                   {5.649233871402973e-05, 0.9638393266911052, 1.2669377710425545},
                                   {5.649094412058764e-05, 0.9999999999999359, -1.1331639379480987e-09},
                                   {0.6606757164966934, -0.5000000007486116, -1.8206164365217534e-10},
                                   {0.6606757176297933, -1.8206164365217534e-10, 0.4999999992513884},
                                   {0.6606757195909367, 0.9638393259425576, 1.266937770294007},
                                   {0.6606757181963433, 0.9999999992513884, -1.881711537673009e-09}};
  const auto found =
      shape_cast(Box{{-3, 1, -4}, {0, 3, 0}}, {0.95060113232356458, 0, 0}, convex_hull<3, double>(corners));
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->status, Status::converged);
  EXPECT_LE(found->error, 128 * tolerance::epsilon * 5);
  EXPECT_NEAR(found->t * 0.95060113232356458, 5.649e-05, 1e-8);
}

// ---- Touching

TEST(ShapeCast, TouchesWhatItGrazesAndNothingBesideIt) {
  // Sides that slide along each other in one plane touch as soon as they overlap along the motion.
  const Box box{{0, 0, 0}, {1, 1, 1}};
  for (const double gap : {0.0, 1e-9, 1e-3}) {
    const Box above{{-5, 1 + gap, 0}, {-4, 2 + gap, 1}};
    EXPECT_EQ(shape_cast(above, {8, 0, 0}, box).has_value(), gap == 0) << gap;
    const Ball sphere{{-5, 2 + gap, 0.5}, 1};
    EXPECT_EQ(shape_cast(sphere, {8, 0, 0}, box).has_value(), gap == 0) << gap;
    EXPECT_EQ(shape_cast(sphere, {8, 0, 0}, Ball{{0, 0, 0.5}, 1}).has_value(), gap == 0) << gap;
    EXPECT_FALSE(shape_cast(sphere, {8, 0, 0}, Plane<3, double>{{0, 1, 0}, 1 - 1e-9}).has_value()) << gap;
    const Obb<3, double> turned{{-5, 1.5 + gap, 0.5}, {0.5, 0.5, 0.5}};
    EXPECT_EQ(shape_cast(turned, {8, 0, 0}, box).has_value(), gap == 0) << gap;
  }
}

TEST(ShapeCast, CountsATouchAtTheEndAndNoneShortOfIt) {
  const Ball sphere{{0, 0, 0}, 1};
  expect_impact(shape_cast(sphere, {3, 0, 0}, Ball{{5, 0, 0}, 1}), 1, {4, 0, 0}, {1, 0, 0}, "balls");
  expect_impact(shape_cast(sphere, {3, 0, 0}, Plane<3, double>{{2, 0, 0}, 8}), 1, {4, 0, 0}, {1, 0, 0}, "a plane");
  expect_impact(shape_cast(sphere, {3, 0, 0}, Box{{4, -1, -1}, {5, 1, 1}}), 1, {4, 0, 0}, {1, 0, 0}, "a box");
  const double nearly = 3 - 1e-12;
  EXPECT_FALSE(shape_cast(sphere, {nearly, 0, 0}, Ball{{5, 0, 0}, 1}).has_value());
  EXPECT_FALSE(shape_cast(sphere, {nearly, 0, 0}, Plane<3, double>{{2, 0, 0}, 8}).has_value());
  EXPECT_FALSE(shape_cast(sphere, {nearly, 0, 0}, Box{{4, -1, -1}, {5, 1, 1}}).has_value());
}

TEST(ShapeCast, StartsWithTheContactOfShapesThatMeet) {
  const auto found = shape_cast(Ball{{0, 0, 0}, 2}, {0, 9, 0}, Ball{{3, 0, 0}, 2});
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->t, 0);
  EXPECT_EQ(found->normal, Point(1, 0, 0));
  EXPECT_EQ(found->point, Point(1.5, 0, 0));
  EXPECT_TRUE(shape_cast(Ball{}, {0, 0, 0}, Ball{{2, 0, 0}, 1}).has_value());
  EXPECT_FALSE(shape_cast(Ball{}, {0, 0, 0}, Ball{{2.1, 0, 0}, 1}).has_value());
}

TEST(ShapeCast, RoundsTheTimeDown) {
  const auto found = shape_cast(Sphere<2>{{0, 0}, 1}, {3, 0}, Sphere<2>{{3, 0}, 1});
  ASSERT_TRUE(found.has_value());
  EXPECT_LE(static_cast<double>(found->t), 1.0 / 3);
  EXPECT_GT(static_cast<double>(std::nextafter(found->t, 1.0F)), 1.0 / 3);
}

// ---- Sizes

TEST(ShapeCast, LosesNothingFarFromTheOrigin) {
  const Point far(1e9, -1e9, 1e9);
  const auto found = shape_cast(Ball{far, 1}, {8, 0, 0}, Box{far + Point(5, -1, -1), far + Point(6, 1, 1)});
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->t, 0.5, 1e-14);
  EXPECT_LT(found->error, 1e-12);
  const auto boxes =
      shape_cast(Obb<3, double>{far, {1, 1, 1}}, {8, 0, 0}, Obb<3, double>{far + Point(6, 0.5, 0), {1, 1, 1}});
  ASSERT_TRUE(boxes.has_value());
  EXPECT_NEAR(boxes->t, 0.5, 1e-12);
  EXPECT_LT(boxes->error, 1e-11);
}

TEST(ShapeCast, TakesMotionsOfAnySize) {
  const Ball sphere{};
  for (const double length : {1e3, 1e9, 1e100}) {
    const auto found = shape_cast(sphere, {length, 0, 0}, Ball{{12, 0, 0}, 1});
    ASSERT_TRUE(found.has_value()) << length;
    EXPECT_NEAR(found->t * length, 10, 1e-13) << length;
  }
  for (const double length : {1e-30, 1e-200, 1e-320}) {
    EXPECT_FALSE(shape_cast(sphere, {length, 0, 0}, Ball{{12, 0, 0}, 1}).has_value()) << length;
  }
  for (const double size : {1e-100, 1e-30, 1e30, 1e100}) {
    const auto found =
        shape_cast(Ball{{0, 0, 0}, size}, {8 * size, 0, 0}, Box{{5 * size, 0, 0}, {6 * size, size, size}});
    ASSERT_TRUE(found.has_value()) << size;
    EXPECT_NEAR(found->t, 0.5, 1e-13) << size;
  }
}

// ---- User-defined shapes, and invalid ones

TEST(ShapeCast, CastsAShapeOfOnesOwn) {
  const user::Ellipsoid<double> egg{{0, 0, 0}, {1, 2, 3}};
  const auto on_box = shape_cast(egg, {8, 0, 0}, Box{{5, -9, -9}, {6, 9, 9}});
  const auto on_egg = shape_cast(Ball{{0, -7, 0}, 1}, {0, 8, 0}, egg);
  ASSERT_TRUE(on_box.has_value() && on_egg.has_value());
  EXPECT_NEAR(on_box->t, 0.5, on_box->error);
  EXPECT_NEAR(on_egg->t, 0.5, on_egg->error);
  for (Dim i = 0; i < 3; ++i) {  // GJK finds positions on a round surface up to the square root of its error
    EXPECT_NEAR(on_box->point[i], Point(5, 0, 0)[i], 1e-6);
    EXPECT_NEAR(on_egg->point[i], Point(0, -2, 0)[i], 1e-6);
  }
  const user::Ellipsoid<float> small{{0, 0, 0}, {1, 2, 3}};
  const auto found = shape_cast(small, {8, 0, 0}, Plane<3>{{-1, 0, 0}, -5});
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->t, 0.5F, 1e-5F);
  const auto on_can = shape_cast(small, {0, 0, 8}, user::Cylinder<float>{{0, 0, 8}, 1, 1});
  ASSERT_TRUE(on_can.has_value());
  EXPECT_NEAR(on_can->t, 0.5F, 1e-4F);
  EXPECT_LE(on_can->t, 0.5F);
}

TEST(ShapeCast, TouchesNothingWithoutParts) {
  const Compound<3, double> nothing;
  EXPECT_FALSE(shape_cast(nothing, {1, 0, 0}, Ball{}).has_value());
  EXPECT_FALSE(shape_cast(Ball{}, {1, 0, 0}, nothing).has_value());
}

TEST(ShapeCast, AMotionThatIsNotFiniteTouchesNothing) {
  for (const double nonsense : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_FALSE(shape_cast(Ball{}, {nonsense, 0, 0}, Ball{{5, 0, 0}, 1}).has_value());
  }
}

TEST(ShapeCast, NonsenseEnds) {
  constexpr std::array<double, 4> nonsense{std::numeric_limits<double>::quiet_NaN(), infinity, -infinity, -1.0};
  for (std::size_t a = 0; a < row_types; ++a) {
    for (std::size_t b = 0; b < row_types; ++b) {
      for (const double number : nonsense) {
        AnyShape<3, double> wrong = row_shape<3, double>(a, 1);
        for_each_number<3, double>(wrong, [number](double& x) { x = number; });
        const AnyShape<3, double> right = moved<3, double>(row_shape<3, double>(b, -1), Point(9, 0, 0));
        const auto found = impact_of<3, double>(wrong, Point(20, 1, 0), right);
        const bool is_replaced = !std::holds_alternative<Polytope<3, double>>(wrong) && !is_union<3, double>(wrong);
        EXPECT_FALSE(found.has_value() && std::isnan(number) && is_replaced) << a << " " << b;
      }
    }
  }
}

}  // namespace
}  // namespace graze::test::shape_cast_test
