// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

#include <graze/math/tolerance.hpp>
#include <graze/query/separation.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/shape_order.hpp>

#include "catalogue.hpp"
#include "parts_of.hpp"
#include "query/contacts.hpp"
#include "query/pairs.hpp"
#include "query/placement.hpp"
#include "query/proximities.hpp"
#include "query/user_shapes.hpp"

namespace graze::test::separation_test {
namespace {

using V3 = Vec<3, double>;
using Ball = Sphere<3, double>;
using Box = Aabb<3, double>;

// ---- As computed by hand

TEST(Separation, GoesOnThroughTouchingIntoDepth) {
  const Ball sphere{{0, 0, 0}, 1};
  for (const double x : {4.0, 3.5, 3.0, 2.5, 1.25}) {
    const auto found = separation(sphere, Ball{{x, 0, 0}, 2});
    EXPECT_EQ(found.distance, x - 3) << x;
    EXPECT_EQ(found.point_a, V3(1, 0, 0)) << x;
    EXPECT_EQ(found.point_b, V3(x - 2, 0, 0)) << x;
    EXPECT_EQ(found.normal, V3(1, 0, 0)) << x;
    EXPECT_EQ(found.relation, x > 3 ? Relation::apart : x < 3 ? Relation::overlapping : Relation::touching);
    EXPECT_EQ(found.status, Status::converged);
  }
}

TEST(Separation, OfBoxesIsTheShortestWayOut) {
  const Box box{{0, 0, 0}, {4, 4, 4}};
  const auto found = separation(box, Box{{1, 3.5, 1}, {2, 9, 2}});
  EXPECT_EQ(found.distance, -0.5);
  EXPECT_EQ(found.normal, V3(0, 1, 0));
  EXPECT_EQ(found.point_a.y, 4);
  EXPECT_EQ(found.point_b.y, 3.5);
  EXPECT_EQ(separation(box, Box{{1, 4, 1}, {2, 9, 2}}).distance, 0);
  EXPECT_EQ(separation(box, Box{{1, 4.5, 1}, {2, 9, 2}}).distance, 0.5);
}

TEST(Separation, IsWithoutEndWhereNothingPartsThem) {
  const Plane<3, double> level{{0, 1, 0}, 0};
  const auto found = separation(level, Plane<3, double>{{1, 0, 0}, 0});
  EXPECT_EQ(found.distance, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(found.normal, V3(0.0));
  EXPECT_EQ(separation(level, Plane<3, double>{{0, -1, 0}, 3}).distance, 3);
}

TEST(Separation, OfCompoundsIsThatOfTheNearestOrTheDeepestPart) {
  const AnyShape<3, double> two = compound_of<3, double>({Ball{{0, 0, 0}, 1}, Ball{{10, 0, 0}, 2}});
  EXPECT_EQ(separation(two, Ball{{5, 0, 0}, 1}).distance, 2);
  EXPECT_EQ(separation(two, Ball{{5, 0, 0}, 4.5}).distance, -1.5);
  const AnyShape<3, double> none = compound_of<3, double>({});
  EXPECT_EQ(separation(none, two).distance, std::numeric_limits<double>::infinity());
}

TEST(Separation, OfUsersShapesIsThatOfTheirSupports) {
  const user::Ellipsoid<double> egg{{0, 0, 0}, {1, 2, 3}};
  const Ball sphere{{0, 0, 7}, 2};
  const auto apart = separation(egg, sphere);
  EXPECT_NEAR(apart.distance, 2, 1e-9);
  const auto met = separation(egg, Ball{{0, 0, 4.5}, 2});
  EXPECT_NEAR(met.distance, -0.5, 1e-9);
  EXPECT_NEAR(met.normal.z, 1, 1e-6);
}

// ---- Laws

template <class SpaceType>
class SeparationLaw : public ::testing::Test {
 public:
  static constexpr Dim N = SpaceType::dimension;
  using T = typename SpaceType::scalar;
  using Any = AnyShape<N, T>;

  /// Two shapes, usually placed together.
  static AnyPair<N, T> draw_two() {
    const AnyPair<N, T> pair = *any_pair<Any, Any>();
    const std::uint64_t seed = *choice(std::size_t{1} << 31U);
    rc::Random random(seed);
    return seed % 4 == 0 ? pair : placed_together<N, T>(pair, random);
  }
};

TYPED_TEST_SUITE(SeparationLaw, test::Spaces);

TYPED_TEST(SeparationLaw, ItIsTheDistanceOrMinusTheDepth) {
  check_property([] {
    constexpr Dim dimension = TypeParam::dimension;
    using Number = typename TypeParam::scalar;
    const auto [a, b] = TestFixture::draw_two();
    const auto found = separation(a, b);
    const auto near = closest_points_of<dimension, Number>(a, b);
    const auto met = contact_of<dimension, Number>(a, b);
    RC_ASSERT((found.relation == relation_of<dimension, Number>(a, b)));
    RC_ASSERT((found.distance > 0) == (found.relation == Relation::apart));
    RC_ASSERT(met.has_value() == (found.relation != Relation::apart));
    if (met) {
      RC_ASSERT(found.distance == -met->depth);
      RC_ASSERT(!std::signbit(found.distance) || met->depth > 0);
      RC_ASSERT((found.point_a == met->point_a && found.point_b == met->point_b));
      RC_ASSERT((found.normal == met->normal && found.error == met->error && found.status == met->status));
    } else {
      RC_ASSERT((found == near || found.distance == std::numeric_limits<Number>::infinity()));
    }
  });
}

TYPED_TEST(SeparationLaw, MovingByItLeavesBothTouching) {
  check_property([] {
    constexpr Dim dimension = TypeParam::dimension;
    using Number = typename TypeParam::scalar;
    const auto pair = TestFixture::draw_two();
    const auto found = separation(pair.first, pair.second);
    RC_PRE((std::isfinite(found.distance) && found.normal != Vec<dimension, Number>(Number(0))));
    const Vec<dimension, Number> way = found.normal * -found.distance;
    const AnyShape<dimension, Number> other = moved<dimension, Number>(pair.second, way);
    const double size = size_of<dimension, Number>(pair) + static_cast<double>(max_abs(way));
    constexpr double rounding = 64 * static_cast<double>(std::numeric_limits<Number>::epsilon());
    const double left = static_cast<double>(separation(pair.first, other).distance);
    RC_LOG() << to_source<dimension, Number>(pair.first) << ", " << to_source<dimension, Number>(pair.second) << ": "
             << found.distance << ", then " << left << "\n";
    // Another part may be in the way.
    const bool has_parts = is_union<dimension, Number>(pair.first) || is_union<dimension, Number>(pair.second);
    RC_ASSERT(left <= rounding * size + 4 * found.error);
    RC_ASSERT(has_parts || left >= -rounding * size - 4 * found.error);
  });
}

TYPED_TEST(SeparationLaw, SwappedItIsTheSameTheOtherWayRound) {
  check_property([] {
    const auto [a, b] = TestFixture::draw_two();
    RC_PRE(detail::compare(a, b) != 0);  // of two equal shapes, none is the first
    const auto found = separation(a, b);
    // otherwise its points are NaN
    RC_PRE(found.distance < std::numeric_limits<typename TypeParam::scalar>::infinity());
    RC_ASSERT(separation(b, a) == detail::exchanged(found));
  });
}

}  // namespace
}  // namespace graze::test::separation_test
