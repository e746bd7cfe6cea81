// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/math/platform/bit_cast.hpp>
#include <graze/query/bounds.hpp>

#include "catalogue.hpp"

namespace own {

/// An ellipse with axes along the coordinates, which calculates in its own number type.
template <class T>
struct Ellipse {
  graze::Vec<2, T> center;
  graze::Vec<2, T> radii;
};

template <class T>
graze::Vec<2, T> support(const Ellipse<T>& ellipse, const graze::Vec<2, T>& direction) {
  const graze::Vec<2, T> stretched = ellipse.radii * direction;
  return ellipse.center + ellipse.radii * stretched / std::sqrt(dot(stretched, stretched));
}

}  // namespace own

// A template with one parameter: the space follows from the support function.
static_assert(graze::Convex<own::Ellipse<float>> && graze::Convex<own::Ellipse<double>>);

namespace graze::bounds_test {
namespace {

using Rational = boost::multiprecision::cpp_rational;

template <class T>
constexpr T infinity = std::numeric_limits<T>::infinity();

/// The exact extent of a shape along a coordinate.
struct Extent {
  Rational low;
  Rational high;
};

Extent around(const Rational& a, const Rational& b, const Rational& radius) {
  return {std::min(a, b) - radius, std::max(a, b) + radius};
}

template <Dim N, class T>
Extent extent(const Vec<N, T>& point, Dim i) {
  return around(point[i], point[i], 0);
}
template <Dim N, class T>
Extent extent(const Segment<N, T>& segment, Dim i) {
  return around(segment.start[i], segment.end[i], 0);
}
template <Dim N, class T>
Extent extent(const Sphere<N, T>& sphere, Dim i) {
  return around(sphere.center[i], sphere.center[i], sphere.radius);
}
template <Dim N, class T>
Extent extent(const Aabb<N, T>& box, Dim i) {
  return around(box.min[i], box.max[i], 0);
}
template <Dim N, class T>
Extent extent(const Obb<N, T>& box, Dim i) {
  Rational reach = 0;
  for (Dim j = 0; j < N; ++j) reach += abs(Rational(box.axes[j][i])) * Rational(box.half_extents[j]);
  return around(box.center[i], box.center[i], reach);
}
template <Dim N, class T>
Extent extent(const Capsule<N, T>& capsule, Dim i) {
  return around(capsule.a[i], capsule.b[i], capsule.radius);
}
template <Dim N, class T>
Extent extent_of_points(const auto& points, Dim i) {
  Extent result = extent(points[0], i);
  for (const Vec<N, T>& point : points) {
    result = {std::min(result.low, Rational(point[i])), std::max(result.high, Rational(point[i]))};
  }
  return result;
}
template <Dim N, class T>
Extent extent(const Triangle<N, T>& triangle, Dim i) {
  return extent_of_points<N, T>(triangle.vertices(), i);
}
template <Dim N, class T>
Extent extent(const Polytope<N, T>& polytope, Dim i) {
  return extent_of_points<N, T>(polytope.vertices(), i);
}

/// The box contains the extent, but does not if a side is moved inward by one step of its type and `slack`.
template <class T>
void assert_tight(T low, T high, const Extent& exact, const Rational& slack) {
  RC_ASSERT(Rational(low) <= exact.low);
  RC_ASSERT(Rational(high) >= exact.high);
  RC_ASSERT(Rational(std::nextafter(low, infinity<T>)) > exact.low - slack);
  RC_ASSERT(Rational(std::nextafter(high, -infinity<T>)) < exact.high + slack);
}

template <class S>
class BoundsIn : public testing::Test {};
TYPED_TEST_SUITE(BoundsIn, test::Spaces);

TYPED_TEST(BoundsIn, OfEveryConvexShapeAreTheSmallestThatContainItExactly) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_every_type<N, T>([]<Convex S>(const S& shape) {
    const Aabb<N, T> box = bounds(shape);
    for (Dim i = 0; i < N; ++i) {
      const Extent exact = extent(shape, i);
      // An oriented box is a sum of N products, each of which may be rounded up; everything else is rounded once.
      const Rational size = std::max<Rational>(abs(exact.low), abs(exact.high)) + (exact.high - exact.low);
      const Rational slack =
          std::same_as<S, Obb<N, T>> ? Rational(Rational(4 * tolerance::epsilon) * size) : Rational(0);
      assert_tight(box.min[i], box.max[i], exact, slack);
    }
  });
}

TYPED_TEST(BoundsIn, OfARayAreInfiniteWhereItGoes) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    const Ray<N, T> ray = *test::any<Ray<N, T>>();
    const Aabb<N, T> box = bounds(ray);
    for (Dim i = 0; i < N; ++i) {
      RC_ASSERT(box.min[i] == (ray.direction[i] < T(0) ? -infinity<T> : ray.origin[i]));
      RC_ASSERT(box.max[i] == (ray.direction[i] > T(0) ? infinity<T> : ray.origin[i]));
    }
  });
}

TYPED_TEST(BoundsIn, OfAPlaneAcrossAnAxisEncloseItsCrossingInAFewUlp) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    const auto from = test::draw_source<N, T>();
    const Dim axis = static_cast<Dim>(*test::choice(N));
    const T slope = *rc::gen::suchThat(
        test::drawn<T>([](rc::Random& random) { return test::draw_coordinate<T>(test::Kind::scales, random); }),
        [](T x) { return x != T(0); });
    const Plane<N, T> plane{unit_axis<N, T>(axis) * slope, (*from.point)[0]};
    const Aabb<N, T> box = bounds(plane);
    const Rational crossing = Rational(plane.offset) / Rational(slope);
    const Rational slack = abs(crossing) * Rational(2 * tolerance::epsilon);
    for (Dim i = 0; i < N; ++i) {
      if (i == axis) {
        assert_tight(box.min[i], box.max[i], {crossing, crossing}, slack);
      } else {
        RC_ASSERT(box.min[i] == -infinity<T>);
        RC_ASSERT(box.max[i] == infinity<T>);
      }
    }
    // The half-space has the plane's box on the side its normal points to, and is unbounded on the other.
    Aabb<N, T> solid = box;
    (slope > T(0) ? solid.min : solid.max)[axis] = slope > T(0) ? -infinity<T> : infinity<T>;
    RC_ASSERT(bounds(HalfSpace<N, T>{plane.normal, plane.offset}) == solid);
  });
}

TYPED_TEST(BoundsIn, OfASlopingPlaneAreEverything) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  Vec<N, T> normal = unit_axis<N, T>(0);
  normal[1] = std::numeric_limits<T>::denorm_min();
  EXPECT_EQ(bounds(Plane<N, T>{normal, 3}), (Aabb<N, T>::everything()));
  EXPECT_EQ(bounds(HalfSpace<N, T>{normal, 3}), (Aabb<N, T>::everything()));
}

TYPED_TEST(BoundsIn, OfTouchingContainTheBounds) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    const AnyShape<N, T> shape = *test::any<AnyShape<N, T>>();
    const Aabb<N, T> box = bounds(shape);
    const Aabb<N, T> grown = touching_bounds(box);
    double size = 0;
    for (Dim i = 0; i < N; ++i) {
      for (const T side : {box.min[i], box.max[i]}) {
        if (std::isfinite(side)) size = std::max(size, std::fabs(static_cast<double>(side)));
      }
    }
    for (Dim i = 0; i < N; ++i) {
      RC_ASSERT(grown.min[i] <= box.min[i]);
      RC_ASSERT(grown.max[i] >= box.max[i]);
      if (std::isfinite(box.min[i])) {
        RC_ASSERT(Rational(box.min[i]) - Rational(grown.min[i]) >= Rational(tolerance::box_slack / 2 * size));
      }
      if (std::isfinite(box.max[i])) {
        RC_ASSERT(Rational(grown.max[i]) - Rational(box.max[i]) >= Rational(tolerance::box_slack / 2 * size));
      }
    }
  });
}

/// A coordinate with any number of trailing zero bits: among them zeros, the smallest and the largest, and infinity.
float drawn_side() {
  const float side = bit_cast<float>(*rc::gen::arbitrary<std::uint32_t>() & (~0U << *rc::gen::inRange(0U, 32U)));
  return std::isnan(side) ? 0 : side;
}

/// A coordinate about this many powers of two below 1, with or without one step of its bits.
float side_below(int powers) {
  const float side = std::ldexp(*rc::gen::arbitrary<bool>() ? 1.0F : -1.5F, -powers);
  return std::nextafter(side, *rc::gen::element(0.0F, side, 9.0F));
}

template <Dim N>
void require_the_same_growth(const Aabb<N, float>& box) {
  Aabb<N, float> quickly = box;
  Aabb<N, float> plainly = box;
  RC_ASSERT(detail::grow_for_touching(quickly) == detail::grow_by_slack(plainly));
  for (Dim i = 0; i < N; ++i) {
    RC_ASSERT(bit_cast<std::uint32_t>(quickly.min[i]) == bit_cast<std::uint32_t>(plainly.min[i]));
    RC_ASSERT(bit_cast<std::uint32_t>(quickly.max[i]) == bit_cast<std::uint32_t>(plainly.max[i]));
  }
}

TEST(Bounds, OfTouchingAreTheSameByStepsOfBits) {
  test::check_property([] {
    Aabb<3, float> box;
    for (Dim i = 0; i < 3; ++i) {
      box.min[i] = drawn_side();
      box.max[i] = drawn_side();
    }
    require_the_same_growth(box);
    require_the_same_growth(Aabb<2, float>{{box.min.x, box.min.y}, {box.max.x, box.max.y}});
  });
}

TEST(Bounds, OfTouchingAreTheSameWhereStepAndSlackAreAlike) {
  test::check_property([] {
    const int lowest = *rc::gen::element(0, 60, 110);
    Aabb<3, float> box;
    for (Dim i = 0; i < 3; ++i) {
      box.min[i] = side_below(lowest + *rc::gen::element(0, 1, 19, 20, 21, 22));
      box.max[i] = side_below(lowest + *rc::gen::element(0, 1, 19, 20, 21, 22));
    }
    require_the_same_growth(box);
    require_the_same_growth(Aabb<2, float>{{box.min.x, box.min.y}, {box.max.x, box.max.y}});
  });
}

TEST(Bounds, OfTheUnitSphereAreExact) {
  EXPECT_EQ(bounds(Sphere<3>{}), (Aabb<3>{{-1, -1, -1}, {1, 1, 1}}));
  EXPECT_EQ(bounds(Circle<double>{{2, -1}, 0.5}), (Rect<double>{{1.5, -1.5}, {2.5, -0.5}}));
}

TEST(Bounds, RoundOutwardInFloat) {
  // 16777216 +- 1: the lower one is a float, the upper one is between 16777216 and 16777218.
  EXPECT_EQ(bounds(Circle<>{{16777216, 0}, 1}), (Rect<>{{16777215, -1}, {16777218, 1}}));
}

TEST(Bounds, OfATurnedBoxReachToItsCorners) {
  const Obb<2, double> box{{10, 20}, {5, 10}, Mat<2, double>({0.6, 0.8}, {-0.8, 0.6})};  // half edges (3, 4), (-8, 6)
  const Aabb<2, double> result = bounds(box);
  EXPECT_NEAR(result.min.x, -1, 1e-14);
  EXPECT_NEAR(result.max.x, 21, 1e-14);
  EXPECT_NEAR(result.min.y, 10, 1e-14);
  EXPECT_NEAR(result.max.y, 30, 1e-14);
}

TEST(Bounds, OfABoxAfterAQuarterTurnAreExact) {
  EXPECT_EQ(bounds(Obb<2, double>{{10, 20}, {5, 10}, rotation_matrix(90)}), (Rect<double>{{0, 15}, {20, 25}}));
  EXPECT_EQ(bounds(Obb<3, float>{}), (Aabb<3>{{-1, -1, -1}, {1, 1, 1}}));
}

TEST(Bounds, OfPlanesAndHalfSpacesAcrossAnAxis) {
  constexpr float inf = infinity<float>;
  EXPECT_EQ(bounds(Plane<2>{{0, 2}, 6}), (Rect<>{{-inf, 3}, {inf, 3}}));
  EXPECT_EQ(bounds(Plane<2>{{-4, 0}, 6}), (Rect<>{{-1.5F, -inf}, {-1.5F, inf}}));
  EXPECT_EQ(bounds(HalfSpace<2>{{0, 2}, 6}), (Rect<>{{-inf, -inf}, {inf, 3}}));
  EXPECT_EQ(bounds(HalfSpace<2>{{0, -2}, 6}), (Rect<>{{-inf, -3}, {inf, inf}}));
  EXPECT_EQ(bounds(HalfSpace<3>{}), (Aabb<3>{{-inf, -inf, -inf}, {inf, 0, inf}}));
  EXPECT_EQ(bounds(Plane<2>{{1, 1}, 0}), Rect<>::everything());
}

TEST(Bounds, OfAPlaneWhoseCrossingIsNoNumberEncloseIt) {
  // 1/3 is between two neighbouring doubles.
  const Rect<double> third = bounds(Plane<2, double>{{3, 0}, 1});
  EXPECT_LT(Rational(third.min.x), Rational(1, 3));
  EXPECT_GT(Rational(third.max.x), Rational(1, 3));
  EXPECT_LE(third.max.x - third.min.x, 4 * tolerance::epsilon);
  // Too large and too small for a float, and for a double.
  const Rect<> far = bounds(Plane<2>{{1e-30F, 0}, 1e30F});
  EXPECT_EQ(far.min.x, std::numeric_limits<float>::max());
  EXPECT_EQ(far.max.x, infinity<float>);
  const Rect<double> near = bounds(Plane<2, double>{{0, 1e300}, 1e-300});
  EXPECT_LE(near.min.y, 0);
  EXPECT_EQ(near.max.y, std::numeric_limits<double>::denorm_min());
}

TEST(Bounds, OfAPlaneWithTinyNumbersEncloseItsCrossing) {
  // The remainder of these divisions is below the smallest double.
  for (int k = 1; k < 200; ++k) {
    const Plane<2, double> plane{{(1 + k * 0x1p-52) * 0x1p-60, 0}, (1 + 3 * k * 0x1p-40) * 0x1p-1030};
    const Rational crossing = Rational(plane.offset) / Rational(plane.normal.x);
    const Rect<double> box = bounds(plane);
    EXPECT_LE(Rational(box.min.x), crossing) << plane;
    EXPECT_GE(Rational(box.max.x), crossing) << plane;
  }
}

TEST(Bounds, OfShapesThatReachBeyondTheLargestNumberAreInfiniteThere) {
  const float huge = std::numeric_limits<float>::max();
  EXPECT_EQ(bounds(Circle<>{{huge, 0}, huge}), (Rect<>{{0, -huge}, {infinity<float>, huge}}));
  const double large = std::numeric_limits<double>::max();
  EXPECT_EQ(bounds(Circle<double>{{-large, 0}, large}), (Rect<double>{{-infinity<double>, -large}, {0, large}}));
  EXPECT_EQ(bounds(Obb<2, double>{{large, 0}, {large, 1}, Mat<2, double>(1.0)}),
            (Rect<double>{{0, -1}, {infinity<double>, 1}}));
}

TEST(Bounds, OfACompoundAreThoseOfItsParts) {
  EXPECT_EQ(bounds(Compound<2>{}), Rect<>::nothing());
  EXPECT_EQ(bounds(compound_of<2, float>({Circle<>{{0, 0}, 1}, Vec<2, float>(5, -7)})), (Rect<>{{-1, -7}, {5, 1}}));
  EXPECT_EQ(bounds(compound_of<2, float>({Plane<2>{{1, 1}, 0}, Circle<>{}})), Rect<>::everything());
}

TEST(Bounds, OfTouchingLeaveInfiniteAndEmptyBoxes) {
  EXPECT_EQ(touching_bounds(Rect<>::nothing()), Rect<>::nothing());
  EXPECT_EQ(touching_bounds(Rect<double>::everything()), Rect<double>::everything());
  EXPECT_EQ(touching_bounds(Rect<double>{{0, 0}, {0, 0}}), (Rect<double>{{0, 0}, {0, 0}}));
}

TEST(Bounds, OfTouchingGrowByTheSlackOfTheLargestCoordinate) {
  const double slack = 100 * tolerance::box_slack;
  EXPECT_EQ(touching_bounds(Rect<double>{{0, 1}, {2, -100}}),
            (Rect<double>{{-slack, 1 - slack}, {2 + slack, -100 + slack}}));
  // In float the slack is far below one step, but the box still grows by a step.
  const Rect<> grown = touching_bounds(Rect<>{{1, 1}, {2, 2}});
  EXPECT_EQ(grown.min.x, std::nextafter(1.0F, 0.0F));
  EXPECT_EQ(grown.max.x, std::nextafter(2.0F, 3.0F));
}

TEST(Bounds, OfTouchingGrowByTheCoordinatesOfPartsThatAnInfiniteBoxHides) {
  using Box = Rect<double>;
  const Circle<double> far{{1e33, 1e17}, 0};
  const auto beside = compound_of<2, double>({far, Plane<2, double>{{0, 1}, 3e17}});
  EXPECT_EQ(bounds(beside), (Box{{-infinity<double>, 1e17}, {infinity<double>, 3e17}}));
  const Box grown = touching_bounds(bounds(far));
  ASSERT_LT(grown.min.y, -1e19);
  for (const Compound<2, double>& shape : {beside, compound_of<2, double>({beside, Compound<2, double>{}})}) {
    const Box box = touching_bounds(shape);
    EXPECT_LE(box.min.y, grown.min.y);
    EXPECT_GE(box.max.y, grown.max.y);
    EXPECT_GE(box.min.y, 2 * grown.min.y);  // and not unlimited
    EXPECT_EQ(touching_bounds(AnyShape<2, double>(shape)), box);
  }
}

TEST(Bounds, OfTouchingAreTheGrownBoxOfAnyOtherShape) {
  const auto bounded = compound_of<2, float>({Circle<>{{3, 0}, 1}, Vec<2, float>(5, -7), Compound<2>{}});
  EXPECT_EQ(touching_bounds(bounded), touching_bounds(bounds(bounded)));
  EXPECT_EQ(touching_bounds(Compound<2>{}), Rect<>::nothing());
  EXPECT_EQ(touching_bounds(Circle<>{{3, 0}, 1}), touching_bounds(Rect<>{{2, -1}, {4, 1}}));
  EXPECT_EQ(touching_bounds(AnyShape<2>(Plane<2>{{0, 1}, 2})), touching_bounds(bounds(Plane<2>{{0, 1}, 2})));
}

template <class T>
class BoundsOfOwnShape : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(BoundsOfOwnShape, Scalars);

TYPED_TEST(BoundsOfOwnShape, ContainItWithinItsTolerance) {
  using T = TypeParam;
  test::check_property([] {
    const auto from = test::draw_source<2, T>();
    const Vec<2, T> radii = *rc::gen::suchThat(test::vector_of<2, T>(from.size),
                                               [](const Vec<2, T>& sizes) { return sizes.x > 0 && sizes.y > 0; });
    const own::Ellipse<T> ellipse{*from.point, radii};
    const Aabb<2, T> box = bounds(ellipse);
    for (Dim i = 0; i < 2; ++i) {
      const Extent exact = around(ellipse.center[i], ellipse.center[i], ellipse.radii[i]);
      const Rational size = std::max<Rational>(abs(exact.low), abs(exact.high));
      assert_tight(box.min[i], box.max[i], exact, Rational(2 * tolerance::convex_in<T>) * size);
    }
  });
}

}  // namespace
}  // namespace graze::bounds_test
