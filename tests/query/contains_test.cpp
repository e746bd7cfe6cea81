// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/contains.hpp>

#include "catalogue.hpp"
#include "query/row_of_shapes.hpp"
#include "query/user_shapes.hpp"

namespace graze::test::contains_test {
namespace {

using V2 = Vec<2, float>;
using V3 = Vec<3, float>;
using D2 = Vec<2, double>;
using D3 = Vec<3, double>;

template <class S, class P>
struct Points {
  S shape;
  std::vector<P> inside;
  std::vector<P> outside;

  void check() const {
    for (const P& point : inside) EXPECT_TRUE(contains(shape, point)) << to_source(shape) << ", " << to_source(point);
    for (const P& point : outside) EXPECT_FALSE(contains(shape, point)) << to_source(shape) << ", " << to_source(point);
  }
};

template <class S, class P>
void expect(const S& shape, const std::vector<P>& inside, const std::vector<P>& outside) {
  Points<S, P>{shape, inside, outside}.check();
}

// ---- By hand

TEST(Contains, ForBoundedShapesIsAsComputedByHand) {
  expect<V2, V2>({1, 2}, {{1, 2}}, {{1, std::nextafter(2.0F, 3.0F)}, {2, 1}});
  expect<Segment<2>, V2>({{0, 0}, {4, 2}}, {{0, 0}, {4, 2}, {2, 1}}, {{2, 1.001F}, {-2, -1}, {6, 3}});
  expect<Segment<3>, V3>({{1, 1, 1}, {1, 1, 1}}, {{1, 1, 1}}, {{1, 1, 2}});
  expect<Sphere<2>, V2>({{1, 0}, 5}, {{1, 0}, {4, 4}, {-4, 0}}, {{4, 5}, {6.001F, 0}});
  expect<Aabb<3>, V3>({{0, 0, 0}, {1, 2, 3}}, {{0, 0, 0}, {1, 2, 3}, {0.5F, 1, 0}}, {{0.5F, 1, 4}, {-1, 1, 1}});
  expect<Obb<2>, V2>({{1, 1}, {2, 1}, {{0, 1}, {-1, 0}}}, {{0, 3}, {2, -1}, {1, 1}}, {{3, 1}, {1, 3.5F}});
  expect<Triangle<2>, V2>({{0, 0}, {4, 0}, {0, 4}}, {{2, 2}, {1, 1}, {0, 4}, {3, 0}}, {{2.001F, 2}, {-1, 1}, {5, 0}});
  expect<Triangle<2>, V2>({{0, 0}, {0, 4}, {4, 0}}, {{2, 2}, {1, 1}, {0, 4}, {3, 0}}, {{2.001F, 2}, {-1, 1}, {5, 0}});
  expect<Triangle<3>, V3>({{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}, {{1, 1, 1}, {2, 2, 1}}, {{1, 1, 1.001F}, {3, 3, 1}});
  expect<Capsule<2>, V2>({{0, 0}, {4, 0}, 1}, {{2, 1}, {-1, 0}, {5, 0}, {2, 0}}, {{5, 1}, {2, 1.001F}});
  expect<Polytope<2>, V2>(convex_hull<2, float>(std::array{V2(0, 0), V2(4, 0), V2(4, 4), V2(0, 4)}),
                          {{2, 2}, {4, 4}, {0, 1}}, {{4.001F, 1}, {-1, -1}});
  expect<Polytope<3>, V3>(convex_hull<3, float>(std::array{V3(0, 0, 0), V3(3, 0, 0), V3(0, 3, 0), V3(0, 0, 3)}),
                          {{1, 1, 1}, {0.5F, 0.5F, 0.5F}, {0, 0, 3}, {1, 1, 0}}, {{1, 1, 1.001F}, {1, 1, -0.001F}});
}

TEST(Contains, ForUnboundedShapesIsAsComputedByHand) {
  expect<Ray<2>, V2>({{1, 1}, {3, 0}}, {{1, 1}, {1e6F, 1}}, {{0.5F, 1}, {2, 1.001F}});
  expect<Plane<3>, V3>({{0, 0, 2}, 4}, {{7, -5, 2}}, {{0, 0, 4}, {0, 0, 2.001F}});
  expect<HalfSpace<3>, V3>({{0, 0, 2}, 4}, {{7, -5, 2}, {0, 0, -100}}, {{0, 0, 2.001F}});
}

TEST(Contains, ForACompoundIsWhetherAnyPartDoes) {
  const auto pair = compound_of<2, float>({Circle<>{{0, 0}, 1}, compound_of<2, float>({Rect<>{{4, 0}, {5, 1}}})});
  expect<Compound<2, float>, V2>(pair, {{1, 0}, {5, 1}, {4.5F, 0.5F}}, {{2, 0}, {6, 1}});
  expect<AnyShape<2, float>, V2>(pair, {{1, 0}, {5, 1}}, {{2, 0}});
  EXPECT_FALSE(contains(Compound<2, float>(), V2(0, 0)));
}

TEST(Contains, TakesAPointInBraces) { EXPECT_TRUE(contains(Sphere<3, double>{}, {0, 0, 1})); }

// ---- Errors of the usual methods

TEST(Contains, CountsTheSurfaceOfASphere) {
  EXPECT_TRUE(contains(Sphere<3>{{1, 2, 3}, 2}, V3(1, 2, 5)));  // length < radius is false
  EXPECT_TRUE(contains(Sphere<3>{{1, 2, 3}, 3}, V3(2, 4, 5)));
  EXPECT_TRUE(contains(Sphere<3>{{1, 2, 3}, 0}, V3(1, 2, 3)));
}

TEST(Contains, FindsPointsOnAPlaneThoughRoundingPutsThemBesideIt) {
  // 0.1 + 0.2 + 0.3, each rounded: dot(normal, p) == offset is false.
  const Plane<3> plane{{0.1F, 0.2F, 0.3F}, 0.6F};
  const V3 point(1, 1, 1);
  ASSERT_NE(dot(D3(plane.normal), D3(point)), static_cast<double>(plane.offset));
  EXPECT_TRUE(contains(plane, point));
  EXPECT_FALSE(contains(plane, V3(1, 1, 1.00001F)));
}

TEST(Contains, FindsPointsOnASegmentThoughRoundingPutsThemBesideIt) {
  const Segment<2> segment{{0.1F, 0.7F}, {0.9F, 0.3F}};
  for (int i = 0; i <= 100; ++i) {
    const float share = static_cast<float>(i) / 100;
    EXPECT_TRUE(contains(segment, segment.start * (1 - share) + segment.end * share)) << share;
  }
  EXPECT_FALSE(contains(segment, V2(0.5F, 0.50001F)));
}

TEST(Contains, SeesAnglesToARayThatACosineInFloatCannot) {
  // The cosine of 1e-4 is 1 in float: comparing the dot product of unit vectors with 1 accepts the point.
  const Ray<2> ray{{0, 0}, {1, 0}};
  const V2 beside(1, 1e-4F);
  ASSERT_EQ(dot(normalize(beside), ray.direction), 1.0F);
  EXPECT_FALSE(contains(ray, beside));
  EXPECT_TRUE(contains(ray, V2(1, 1e-7F)));
  // If the dot product of two rounded unit vectors is below 1, the point may be on the ray nevertheless.
  const Ray<3> orthonormality_error{{0, 0, 0}, {0.3F, 0.5F, 0.7F}};
  for (int i = 1; i <= 20; ++i)
    EXPECT_TRUE(contains(orthonormality_error, orthonormality_error.direction * static_cast<float>(i)));
}

TEST(Contains, ToleranceOfThinSetsGrowsWithTheCoordinates) {
  for (const float size : {1e-3F, 1.0F, 1e3F, 1e6F}) {
    const Plane<2> plane{{0, 1}, size};
    const float ulp = std::nextafter(size, 2 * size) - size;
    EXPECT_TRUE(contains(plane, V2(0, size + 2 * ulp))) << size;
    EXPECT_FALSE(contains(plane, V2(0, size + 32 * ulp))) << size;
  }
}

// ---- Accuracy

/// The surface of each solid crosses the x axis at (1, 0).
template <class T, class S>
void expect_border_at_one(const S& solid) {
  Vec<dimension_of<S>, T> point(T(0));
  point[0] = 1;
  EXPECT_TRUE(contains(solid, point)) << to_source(solid);
  point[0] = std::nextafter(T(1), T(2));
  EXPECT_FALSE(contains(solid, point)) << to_source(solid);
}

TEST(Contains, TellsOneUlpOutsideFromTheSurfaceInFloat) {
  expect_border_at_one<float>(Sphere<3>{});
  expect_border_at_one<float>(Aabb<3>{});
  expect_border_at_one<float>(Obb<3>{});
  expect_border_at_one<float>(HalfSpace<2>{{3, 0}, 3});
  expect_border_at_one<float>(Capsule<3>{});
  expect_border_at_one<float>(Triangle<2>{{1, -1}, {1, 1}, {-1, 0}});
  expect_border_at_one<float>(Triangle<2>{{1, 0}, {-1, -1}, {-1, 1}});
  expect_border_at_one<float>(convex_hull<2, float>(std::array{V2(1, -1), V2(1, 1), V2(-1, 0)}));
  expect_border_at_one<float>(
      convex_hull<3, float>(std::array{V3(1, -1, -1), V3(1, 1, -1), V3(1, 0, 1), V3(-1, 0, 0)}));
}

TEST(Contains, DecidesBoxesAndPointsExactlyInDouble) {
  expect_border_at_one<double>(Aabb<3, double>{});
  expect_border_at_one<double>(D3(1, 0, 0));
}

TEST(Contains, TakesASolidThinnerThanTheNumbersResolveAsASurface) {
  // The only floats in this capsule are near its ends.
  const Capsule<2> hair{{1, 1}, {2, 4.0F / 3}, 1e-9F};
  EXPECT_TRUE(contains(hair, V2(1.3F, 1.1F)));
  EXPECT_FALSE(contains(hair, V2(1.3F, 1.10001F)));
  const Obb<3> card{{1, 1, 1}, {1, 1, 0}, Mat<3, float>(rotation_matrix(D3(1, 2, 3), 25))};
  EXPECT_TRUE(contains(card, card.center + 0.3F * card.axes[0] - 0.7F * card.axes[1]));
  EXPECT_FALSE(contains(card, card.center + 0.3F * card.axes[0] + 0.00001F * card.axes[2]));
  const Triangle<2> needle{{1, 1}, {2, 4.0F / 3}, {1.5F, 7.0F / 6}};
  EXPECT_TRUE(contains(needle, V2(1.3F, 1.1F)));
  EXPECT_FALSE(contains(needle, V2(1.3F, 1.10001F)));
  const auto flat = convex_hull<3, float>(std::array{V3(0.1F, 0, 0), V3(0, 0.3F, 0), V3(0, 0, 0.7F)});
  EXPECT_TRUE(contains(flat, V3(0.1F, 0.3F, 0.7F) / 3.0F));
  EXPECT_FALSE(contains(flat, V3(0.1F, 0.3F, 0.7F) / 2.9999F));
}

TEST(Contains, ToleratesNothingBesideTheSharpCornersOfSolids) {
  // At its tip the triangle is arbitrarily thin, but it is not a thin triangle.
  const Triangle<2> sharp{{1, 0}, {0, 0.01F}, {0, -0.01F}};
  EXPECT_TRUE(contains(sharp, V2(1, 0)));
  EXPECT_FALSE(contains(sharp, V2(std::nextafter(1.0F, 2.0F), 0)));
  EXPECT_FALSE(contains(sharp, V2(1, 1e-7F)));
}

// ---- User-defined shapes, invalid input, what does not compile

TEST(Contains, WorksForAUsersShape) {
  const user::Cylinder<double> can{{0, 0, 0}, 1, 2};
  EXPECT_TRUE(contains(can, D3(0, 0, 0)));
  EXPECT_TRUE(contains(can, D3(0.6, 0.8, 2)));
  EXPECT_TRUE(contains(can, D3(1, 0, 0)));
  EXPECT_FALSE(contains(can, D3(1.0001, 0, 0)));
  EXPECT_FALSE(contains(can, D3(0, 0, 2.0001)));
  const user::Ellipsoid<float> egg{{0, 0, 0}, {1, 2, 3}};
  EXPECT_TRUE(contains(egg, V3(0, 0, 2.99F)));
  EXPECT_FALSE(contains(egg, V3(0, 0, 3.01F)));
}

template <class S>
class ContainsIn : public ::testing::Test {};
TYPED_TEST_SUITE(ContainsIn, Spaces);

TYPED_TEST(ContainsIn, NanIsInNothing) {
  constexpr Dim dimension = TypeParam::dimension;
  using Number = typename TypeParam::scalar;
  for (std::size_t type = 0; type < row_types; ++type) {
    const auto shape = row_shape<dimension, Number>(type, Number(1));
    for (Dim i = 0; i < dimension; ++i) {
      Vec<dimension, Number> point(Number(0));
      point[i] = std::numeric_limits<Number>::quiet_NaN();
      EXPECT_FALSE(contains(shape, point)) << shape_type_names[type];
    }
  }
}

TYPED_TEST(ContainsIn, EveryShapeHoldsWhereItReachesOnTheAxis) {
  constexpr Dim dimension = TypeParam::dimension;
  using Number = typename TypeParam::scalar;
  for (std::size_t type = 0; type < row_types; ++type) {
    const auto shape = row_shape<dimension, Number>(type, Number(1));
    EXPECT_TRUE(contains(shape, unit_axis<dimension, Number>(0))) << shape_type_names[type];
    EXPECT_FALSE(contains(shape, unit_axis<dimension, Number>(0) * Number(1.01))) << shape_type_names[type];
  }
}

template <class S, class P>
concept CanAsk = requires(const S& shape, const P& point) {
  contains(shape, point);
};

static_assert(CanAsk<Sphere<3, float>, V3>);
static_assert(!CanAsk<Sphere<3, float>, V2>);
static_assert(!CanAsk<Sphere<3, float>, D3>);
static_assert(!CanAsk<Sphere<3, double>, V3>);
static_assert(!CanAsk<Triangle<2, double>, D3>);

}  // namespace
}  // namespace graze::test::contains_test
