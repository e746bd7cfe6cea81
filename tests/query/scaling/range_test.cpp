// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

#include <gtest/gtest.h>

#include <graze/math/vec.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/distance.hpp>
#include <graze/query/mass_properties.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/scaling/range.hpp>
#include <graze/query/signed_distance.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze::test::range_test {
namespace {

using V3 = Vec<3, double>;
using Ball = Sphere<3, double>;

constexpr double least = std::numeric_limits<double>::denorm_min();
constexpr double most = std::numeric_limits<double>::max();

TEST(Range, PowersOfTwoMultiplyExactlyFromTheLeastNumberToTheLargest) {
  EXPECT_EQ(detail::PowerOfTwo(1074)(least), 1);
  EXPECT_EQ(detail::PowerOfTwo(-1074)(1.0), least);
  EXPECT_EQ(detail::PowerOfTwo(1500)(3 * least), std::ldexp(3.0, 1500 - 1074));
  EXPECT_EQ(detail::PowerOfTwo(-1023)(0x1p1023), 1);
  EXPECT_EQ(detail::PowerOfTwo(-2097)(0x1p1023), least);
  EXPECT_EQ(detail::PowerOfTwo(-7).inverse().exponent(), 7);
}

TEST(Range, ShapesOfUsualSizeStayAsTheyAre) {
  EXPECT_FALSE(detail::scale_for(Ball{{1, 2, 3}, 1e-20}, Ball{{1e20, 0, 0}, 0}));
  EXPECT_FALSE(detail::scale_for(Ball{{0, 0, 0}, 0}));
  EXPECT_FALSE(detail::scale_for(Sphere<3, float>{{0, 0, 0}, 1e-45F}));
  EXPECT_TRUE(detail::are_usual(Ball{{0, 0, 0}, 1}, Ball{{-0.0, 1, -1e-29}, 1e30}));
}

TEST(Range, OthersAreScaledSoThatTheLargestNumberIsNearOne) {
  const Ball sphere{{0x1p-1000, 0, 0}, 0x1p-1070};
  EXPECT_FALSE(detail::are_usual(sphere));
  const std::optional<detail::PowerOfTwo> power = detail::scale_for(sphere);
  ASSERT_TRUE(power);
  const Ball larger = detail::scaled(sphere, *power);
  EXPECT_EQ(larger.center.x, 1);
  EXPECT_EQ(larger.radius, 0x1p-70);
}

TEST(Range, TheLeastNumbersAreKeptLargeEnoughToSquareWhileTheLargestAllow) {
  const Ball sphere{{0x1p300, 0, 0}, 0x1p-300};
  const Ball scaled = detail::scaled(sphere, *detail::scale_for(sphere));
  EXPECT_EQ(scaled.center.x / scaled.radius, 0x1p600);
  EXPECT_GE(scaled.radius * scaled.radius, std::numeric_limits<double>::min());
  EXPECT_FALSE(detail::scale_for(scaled));  // once suffices
}

TEST(Range, NumbersThatAreTooFarApartCountAsZero) {
  const Ball sphere{{0x1p1000, 0, 0}, 0x1p-1000};
  const Ball scaled = detail::scaled(sphere, *detail::scale_for(sphere));
  EXPECT_EQ(scaled.center.x, 0x1p450);
  EXPECT_EQ(scaled.radius, 0);
}

TEST(Range, DirectionsAreScaledByThemselves) {
  const Plane<3, double> plane{{0, 0x1p-1000, 0}, 0x1p-999};  // y = 2
  const std::optional<detail::PowerOfTwo> power = detail::scale_for(plane);
  ASSERT_TRUE(power);
  const Plane<3, double> scaled = detail::scaled(plane, *power);
  EXPECT_EQ(scaled.normal, V3(0, 1, 0));
  EXPECT_EQ(scaled.offset, std::ldexp(2.0, power->exponent()));
}

/// A user-defined shape: a sphere that calculates in double.
struct Bubble {
  double radius;
};
V3 support(const Bubble& bubble, const V3& direction) {
  return direction * (bubble.radius / std::sqrt(dot(direction, direction)));
}

TEST(Range, ShapesOfOnesOwnAreScaledByTheirSupportPoints) {
  const Bubble bubble{0x1p900};
  const auto scaled = detail::scaled(bubble, *detail::scale_for(bubble));
  EXPECT_EQ(support(scaled, V3(0, 1, 0)), V3(0, 1, 0));
  static_assert(std::is_same_v<decltype(detail::scaled(scaled, detail::PowerOfTwo(1))), decltype(scaled) const> ||
                std::is_same_v<decltype(detail::scaled(scaled, detail::PowerOfTwo(1))), detail::Scaled<Bubble>>);
  for (const double size : {1e-300, 1.0, 1e300}) {
    const Posed<Bubble> far{{size}, {.position = {3 * size, 0, 0}}};
    EXPECT_EQ(relation(Bubble{size}, far), Relation::apart);
    EXPECT_NEAR(distance(Bubble{size}, far) / size, 1, 1e-12);
    EXPECT_EQ(relation(Bubble{2.5 * size}, far), Relation::overlapping);
    EXPECT_NEAR(contact(Bubble{2.5 * size}, far)->depth / size, 0.5, 1e-9);
    EXPECT_TRUE(contains(far, V3(3.5 * size, 0, 0)));
    EXPECT_NEAR(signed_distance(far, V3(5 * size, 0, 0)) / size, 1, 1e-12);
  }
}

struct DistanceRow {
  V3 a;
  V3 b;
  double distance;
};

TEST(Range, DistancesThatNoDoubleHoldsAreInfiniteOrTheLeastNumber) {
  const std::initializer_list<DistanceRow> rows = {
      {{least, 0, 0}, {0, 0, 0}, least},
      {{3 * least, 0, 0}, {0, 4 * least, 0}, 5 * least},
      {{most, 0, 0}, {most / 2, 0, 0}, most / 2},
      {{most, 0, 0}, {-most, 0, 0}, std::numeric_limits<double>::infinity()},
  };
  for (const DistanceRow& row : rows) {
    EXPECT_EQ(distance(row.a, row.b), row.distance);
    EXPECT_EQ(distance(Ball{row.a, 0}, Ball{row.b, 0}), row.distance);
    EXPECT_EQ(relation(row.a, row.b), Relation::apart);
  }
}

TEST(Range, RaysOfAnyLengthHitAtTheirT) {
  const Ball sphere{{1e-300, 0, 0}, 0x1p-1000};
  const auto hit = ray_cast(sphere, Ray<3, double>{{0, 0, 0}, {1e300, 0, 0}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->t, 0);  // below the least number
  const auto slow = ray_cast(sphere, Ray<3, double>{{0, 0, 0}, {1e-320, 0, 0}});
  ASSERT_TRUE(slow);
  EXPECT_NEAR(slow->t / ((1e-300 - 0x1p-1000) / 1e-320), 1, 1e-12);
  EXPECT_EQ(slow->normal, V3(-1, 0, 0));
}

TEST(Range, VolumesThatNoDoubleHoldsAreZeroOrInfinite) {
  EXPECT_EQ(mass_properties(Ball{{0, 0, 0}, 1e-150}).volume, 0);
  EXPECT_NEAR(mass_properties(Ball{{0, 0, 0}, 1e-100}).volume / 4.18879020478639e-300, 1, 1e-12);
  EXPECT_TRUE(std::isinf(mass_properties(Ball{{0, 0, 0}, 1e150}).volume));
  const auto flat = mass_properties(Aabb<3, double>{{0, 0, 0}, {1e300, 1e300, 0}});
  EXPECT_EQ(flat.volume, 0);
  EXPECT_EQ(flat.centroid, V3(5e299, 5e299, 0));
}

}  // namespace
}  // namespace graze::test::range_test
