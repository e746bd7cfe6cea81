// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/query/bounds.hpp>
#include <graze/query/intersects.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/shape.hpp>

#include "../catalogue.hpp"

namespace own {

/// A square of side 2 around a point, in float: only a support function.
struct Square {
  graze::Vec<2, float> center;
};
graze::Vec<2, float> support(const Square& square, const graze::Vec<2, float>& direction) {
  return square.center + graze::Vec<2, float>(direction.x > 0 ? 1 : -1, direction.y > 0 ? 1 : -1);
}

/// A stick along z, in double, with a `defect` function.
struct Stick {
  double half_length;
};
graze::Vec<3, double> support(const Stick& stick, const graze::Vec<3, double>& direction) {
  return {0, 0, direction.z > 0 ? stick.half_length : -stick.half_length};
}
std::string_view defect(const Stick& stick) { return stick.half_length >= 0 ? "" : "has a negative half length"; }

struct NotAShape {};

/// Its support returns a height, not a point.
struct Crooked {};
float support(const Crooked&, const graze::Vec<2, float>& direction) { return direction.x; }

}  // namespace own

namespace graze::shape_test {
namespace {

static_assert(Convex<own::Square> && dimension_of<own::Square> == 2 && std::is_same_v<scalar_of<own::Square>, float>);
static_assert(Convex<own::Stick> && dimension_of<own::Stick> == 3 && std::is_same_v<scalar_of<own::Stick>, double>);
static_assert(!Shape<own::NotAShape> && !Convex<own::NotAShape>);
static_assert(!Shape<own::Crooked> && !Convex<own::Crooked>);
static_assert(!Shape<int> && !Shape<std::string> && !Convex<Pose<2, float>>);

template <class S>
concept ConvexInItsSpace = Convex<S> && SupportsIn < S,
        dimension_of<S>,
double > ;
static_assert(ConvexInItsSpace<Vec<2, float>> && ConvexInItsSpace<Segment<3, float>>);
static_assert(ConvexInItsSpace<Sphere<3, double>> && ConvexInItsSpace<Aabb<2, double>>);
static_assert(ConvexInItsSpace<Obb<3, float>> && ConvexInItsSpace<Triangle<3, float>>);
static_assert(ConvexInItsSpace<Capsule<2, float>> && ConvexInItsSpace<Polytope<3, double>>);
// Unbounded shapes have no farthest point, and a compound is not convex.
static_assert(Shape<Ray<2, float>> && !Convex<Ray<2, float>>);
static_assert(Shape<Plane<3, double>> && !Convex<Plane<3, double>>);
static_assert(Shape<HalfSpace<3, double>> && !Convex<HalfSpace<3, double>>);
static_assert(Shape<Compound<2, float>> && !Convex<Compound<2, float>>);
static_assert(Shape<AnyShape<2, float>> && !Convex<AnyShape<2, float>>);

static_assert(SameDimension<Sphere<2, double>, Aabb<2, float>>);
static_assert(!SameDimension<Sphere<3, float>, Aabb<2, float>>);
static_assert(SameSpace<own::Square, Circle<float>> && !SameSpace<own::Square, Circle<double>>);
static_assert(!SameSpace<own::Square, Sphere<3, float>> && !SameSpace<own::NotAShape, Circle<float>>);

template <class A, class B>
concept Intersectable = requires(const A& a, const B& b) {
  intersects(a, b);
};
static_assert(Intersectable<Sphere<2>, Sphere<2>> && Intersectable<AnyShape<3, double>, Plane<3, double>>);
static_assert(Intersectable<own::Square, Circle<>> && Intersectable<Ray<3, double>, own::Stick>);
static_assert(!Intersectable<Sphere<2>, Sphere<3>> && !Intersectable<AnyShape<2, float>, AnyShape<3, float>>);
static_assert(!Intersectable<Sphere<2, float>, Sphere<2, double>>);
static_assert(!Intersectable<own::Square, own::Stick> && !Intersectable<own::NotAShape, Circle<>>);
static_assert(!Intersectable<Vec<2, float>, Aabb<3, float>> && !Intersectable<Vec<3, float>, Vec<2, float>>);

template <class S>
concept Bounded = requires(const S& shape) {
  bounds(shape);
};
static_assert(Bounded<own::Square> && Bounded<AnyShape<3, float>> && !Bounded<own::NotAShape> && !Bounded<int>);

template <class S, class P>
concept Movable = requires(const S& shape, const P& pose) {
  transformed(shape, pose);
};
static_assert(Movable<Sphere<2, float>, Pose<2, float>> && !Movable<Sphere<2, float>, Pose<3, float>>);
static_assert(!Movable<Sphere<2, float>, Pose<2, double>> && !Movable<own::NotAShape, Pose<2, float>>);

TEST(Shape, IsValidAsksTheDefectOfAUsersTypeToo) {
  EXPECT_TRUE(is_valid(own::Stick{0}));
  EXPECT_FALSE(is_valid(own::Stick{-1}));
}

/// The largest coordinate of a bounded shape: its rounding errors are relative to it.
template <class S>
double size_of(const S& shape) {
  const auto box = bounds(shape);
  return static_cast<double>(std::max(max_abs(box.min), max_abs(box.max)));
}

template <class S>
class EveryShape : public testing::Test {
 protected:
  static constexpr Dim N = S::dimension;
  using T = typename S::scalar;
  using Direction = Vec<N, double>;

  static Direction any_direction() { return wide<N, T>(*test::draw_source<N, T>().direction); }
};
TYPED_TEST_SUITE(EveryShape, test::Spaces);

TYPED_TEST(EveryShape, OfTheCatalogueIsValid) {
  test::check_every_type<TypeParam::dimension, typename TypeParam::scalar>(
      [](const auto& shape) { RC_ASSERT(std::string(defect(shape)) == ""); });
}

TYPED_TEST(EveryShape, HasItsSupportPointInItsBounds) {
  test::check_every_type<TypeParam::dimension, typename TypeParam::scalar>([]<Convex S>(const S& shape) {
    const auto direction = TestFixture::any_direction();
    const auto point = support(shape, direction);
    const auto box = bounds(shape);
    const double band = 4 * tolerance::epsilon * size_of(shape);
    for (Dim i = 0; i < TestFixture::N; ++i) {
      RC_ASSERT(point[i] >= static_cast<double>(box.min[i]) - band);
      RC_ASSERT(point[i] <= static_cast<double>(box.max[i]) + band);
    }
  });
}

TYPED_TEST(EveryShape, HasItsFarthestPointAsSupport) {
  test::check_every_type<TypeParam::dimension, typename TypeParam::scalar>([]<Convex S>(const S& shape) {
    const auto direction = TestFixture::any_direction();
    const auto w = *test::vector_of<TestFixture::N, double>(
        test::drawn<double>([](rc::Random& random) { return test::between(random, -1, 1); }));
    const auto point = test::Entry<S>::point_in(shape, w);
    const double band = 16 * tolerance::epsilon * size_of(shape) * sum_abs(direction);
    RC_ASSERT(dot(support(shape, direction), direction) >= dot(point, direction) - band);
  });
}

TYPED_TEST(EveryShape, HasTheSameSupportForADirectionOfAnyLength) {
  test::check_every_type<TypeParam::dimension, typename TypeParam::scalar>([]<Convex S>(const S& shape) {
    const auto direction = TestFixture::any_direction();
    const int exponent = *test::drawn<int>([](rc::Random& random) { return test::whole(random, -400, 400); });
    // A power of two changes no significand, so the answers are the same to the last bit.
    RC_ASSERT(support(shape, direction * std::ldexp(1.0, exponent)) == support(shape, direction));
  });
}

TYPED_TEST(EveryShape, HasSupportsOnOppositeSides) {
  test::check_every_type<TypeParam::dimension, typename TypeParam::scalar>([]<Convex S>(const S& shape) {
    const auto direction = TestFixture::any_direction();
    const double high = dot(support(shape, direction), direction);
    const double low = dot(support(shape, -direction), direction);
    RC_ASSERT(high >= low - 8 * tolerance::epsilon * size_of(shape) * sum_abs(direction));
  });
}

}  // namespace
}  // namespace graze::shape_test
