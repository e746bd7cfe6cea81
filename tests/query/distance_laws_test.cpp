// SPDX-License-Identifier: MIT
// Laws of distance(a, b) and closest_points(a, b) on random pairs of every type: invariances, agreement with other
// queries, and invalid input.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/tolerance.hpp>
#include <graze/query/convex/wide_support.hpp>
#include <graze/query/gjk.hpp>
#include <graze/query/transformed.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/visit.hpp>

#include "catalogue.hpp"
#include "query/numbers_of.hpp"
#include "query/orders_of.hpp"
#include "query/pairs.hpp"
#include "query/placement.hpp"
#include "query/proximities.hpp"
#include "query/row_of_shapes.hpp"

namespace graze::test::distance_laws_test {

/// The core of a shape with only a support function, so that no closed form is selected for it.
template <Dim N, class T>
struct Disguise {
  AnyShape<N, T> shape;
};

template <Dim N, class T>
Vec<N, double> support(const Disguise<N, T>& disguise, const Vec<N, double>& direction) {
  return detail::visit(
      [&direction](const auto& held) -> Vec<N, double> {
        if constexpr (Convex<std::decay_t<decltype(held)>>) {
          return detail::wide_support(detail::core(held), direction);
        } else {
          return Vec<N, double>(0.0);
        }
      },
      disguise.shape);
}

template <Dim N, class T>
double radius_of(const AnyShape<N, T>& shape) {
  if (const auto* sphere = std::get_if<Sphere<N, T>>(&shape)) return static_cast<double>(sphere->radius);
  if (const auto* capsule = std::get_if<Capsule<N, T>>(&shape)) return static_cast<double>(capsule->radius);
  return 0;
}

template <Dim N, class T>
bool is_convex(const AnyShape<N, T>& shape) {
  return detail::visit([](const auto& held) { return Convex<std::decay_t<decltype(held)>>; }, shape);
}

namespace {

template <class SpaceType>
class DistanceLaw : public ::testing::Test {
 public:
  static constexpr Dim N = SpaceType::dimension;
  using T = typename SpaceType::scalar;
  using Any = AnyShape<N, T>;
  using Pair = AnyPair<N, T>;

  static constexpr double epsilon = static_cast<double>(std::numeric_limits<T>::epsilon());

  static double of(const Pair& pair) { return static_cast<double>(distance_of<N, T>(pair.first, pair.second)); }
  static Proximity<N, T> closest(const Pair& pair) { return closest_points_of<N, T>(pair.first, pair.second); }

  /// Two shapes, in half of the cases placed together.
  static Pair draw_two() {
    const Pair pair = *any_pair<Any, Any>();
    const std::uint64_t seed = *choice(std::size_t{1} << 31U);
    rc::Random random(seed);
    return seed % 2 == 0 ? pair : placed_together<N, T>(pair, random);
  }

  /// The largest coordinate from which an answer is calculated.
  static double size_of_answer(const Pair& pair) {
    const Proximity<N, T> found = closest(pair);
    if (std::isinf(found.distance)) return 0;
    return std::max({size_of<N, T>(pair), static_cast<double>(max_abs(found.point_a)),
                     static_cast<double>(max_abs(found.point_b)), static_cast<double>(found.distance)});
  }

  /// Logs a pair as C++ source.
  static void log(const Pair& pair) {
    RC_LOG() << to_source<N, T>(pair.first) << ", " << to_source<N, T>(pair.second) << ": " << of(pair) << "\n";
  }

  static void expect_near(double one, double two, double allowed) {
    RC_ASSERT(one == two || std::fabs(one - two) <= allowed);  // both may be infinite
  }
};

TYPED_TEST_SUITE(DistanceLaw, test::Spaces);

TYPED_TEST(DistanceLaw, SwappingTheShapesExchangesThePoints) {
  check_property([] {
    const auto [a, b] = TestFixture::draw_two();
    const auto found = TestFixture::closest({a, b});
    const auto swapped = TestFixture::closest({b, a});
    RC_ASSERT(swapped.distance == found.distance);
    if (std::isfinite(found.distance)) RC_ASSERT(detail::exchanged(swapped) == found);
  });
}

TYPED_TEST(DistanceLaw, ZeroIsForShapesThatIntersect) {
  check_property([] {
    const auto [a, b] = TestFixture::draw_two();
    const Relation relation = relation_of<TestFixture::N, typename TestFixture::T>(a, b);
    RC_ASSERT((TestFixture::of({a, b}) == 0) == (relation != Relation::apart));
    RC_ASSERT(TestFixture::closest({a, b}).relation == relation);
  });
}

TYPED_TEST(DistanceLaw, AShapeIsNotApartFromItself) {
  check_property([] {
    constexpr Dim dimension = TypeParam::dimension;
    const auto shape = *any_shape<dimension, typename TypeParam::scalar>();
    const auto found = TestFixture::closest({shape, shape});
    RC_PRE(std::isfinite(found.distance));  // there are parts
    RC_ASSERT(found.distance == 0);
    RC_ASSERT(found.point_a == found.point_b);
    RC_ASSERT(max_abs(found.normal) == 0);
  });
}

TYPED_TEST(DistanceLaw, ScalingByAPowerOfTwoScalesItExactly) {
  check_property([] {
    constexpr Dim dimension = TypeParam::dimension;
    using Number = typename TypeParam::scalar;
    const auto pair = TestFixture::draw_two();
    const auto factor = std::ldexp(Number(1), *rc::gen::inRange(-30, 31));
    const double before = TestFixture::of(pair);
    const double after = TestFixture::of(
        {scaled<dimension, Number>(pair.first, factor), scaled<dimension, Number>(pair.second, factor)});
    RC_PRE(before == 0 || std::min(before, after) > 1e-30);  // smaller floats lose bits
    TestFixture::log(pair);
    RC_ASSERT(after == before * static_cast<double>(factor));
  });
}

TYPED_TEST(DistanceLaw, RigidMotionsChangeNothingBeyondRounding) {
  check_property([] {
    constexpr Dim dimension = TypeParam::dimension;
    using Number = typename TypeParam::scalar;
    const auto pair = TestFixture::draw_two();
    const auto pose = *any_pose<dimension, Number>();
    const AnyPair<dimension, Number> moved_pair(transformed(pair.first, pose), transformed(pair.second, pose));
    const double size = std::max(TestFixture::size_of_answer(pair), TestFixture::size_of_answer(moved_pair)) +
                        static_cast<double>(max_abs(pose.position));
    const Relation moved_relation = relation_of<dimension, Number>(moved_pair.first, moved_pair.second);
    const Relation relation = relation_of<dimension, Number>(pair.first, pair.second);
    // Unbounded shapes may meet far away, or not at all if they are rotated by a rounding error.
    const bool is_bounded = is_convex<dimension, Number>(pair.first) && is_convex<dimension, Number>(pair.second);
    RC_PRE(is_bounded || (relation == Relation::apart && moved_relation == Relation::apart));
    TestFixture::log(pair);
    TestFixture::log(moved_pair);
    TestFixture::expect_near(TestFixture::of(pair), TestFixture::of(moved_pair), 64 * TestFixture::epsilon * size);
  });
}

TYPED_TEST(DistanceLaw, ACompoundIsAsFarAsItsNearestPart) {
  check_property([] {
    constexpr Dim dimension = TypeParam::dimension;
    using Number = typename TypeParam::scalar;
    const auto [a, b] = TestFixture::draw_two();
    const auto c = *any_shape<dimension, Number>();
    const AnyShape<dimension, Number> both = compound_of<dimension, Number>({a, b});
    RC_ASSERT(TestFixture::of({both, c}) == std::min(TestFixture::of({a, c}), TestFixture::of({b, c})));
  });
}

TYPED_TEST(DistanceLaw, GjkAgreesWithTheClosedForms) {
  check_property([] {
    constexpr Dim dimension = TypeParam::dimension;
    using Number = typename TypeParam::scalar;
    const auto [a, b] = TestFixture::draw_two();
    RC_PRE((is_convex<dimension, Number>(a) && is_convex<dimension, Number>(b)));
    const auto cores = gjk(Disguise<dimension, Number>{a}, Disguise<dimension, Number>{b});
    const double reach = radius_of<dimension, Number>(a) + radius_of<dimension, Number>(b);
    const Proximity<dimension, double> found = proximity_of<dimension, Number>(a, b);
    const double slack = found.error + cores.resolution + tolerance::rounding * reach;
    TestFixture::log({a, b});
    RC_ASSERT(found.distance >= cores.lower - reach - slack);
    if (found.relation == Relation::apart) RC_ASSERT(found.distance <= cores.upper - reach + slack);
  });
}

TYPED_TEST(DistanceLaw, DegenerateShapesAreWhatTheyLookLike) {
  check_property([] {
    constexpr Dim dimension = TypeParam::dimension;
    using Number = typename TypeParam::scalar;
    using Shape = AnyShape<dimension, Number>;
    using Point = Vec<dimension, Number>;
    const auto [point, segment] = *any_pair<Point, Segment<dimension, Number>>();
    const auto other = *any_shape<dimension, Number>();
    Mat<dimension, Number> axes(Number(1));
    const std::vector<Shape> points{Segment<dimension, Number>{point, point},
                                    Sphere<dimension, Number>{point, 0},
                                    Capsule<dimension, Number>{point, point, 0},
                                    Aabb<dimension, Number>{point, point},
                                    Obb<dimension, Number>{point, Point(Number(0)), axes},
                                    Triangle<dimension, Number>{point, point, point},
                                    convex_hull<dimension, Number>(std::vector<Point>{point})};
    const std::vector<Shape> segments{Capsule<dimension, Number>{segment.start, segment.end, 0},
                                      Triangle<dimension, Number>{segment.start, segment.end, segment.start},
                                      convex_hull<dimension, Number>(std::vector<Point>{segment.start, segment.end})};
    const auto expect_alike = [&](const Shape& one, const Shape& two) {
      TestFixture::log({one, other});
      TestFixture::log({two, other});
      const double error =
          proximity_of<dimension, Number>(one, other).error + proximity_of<dimension, Number>(two, other).error;
      const double one_distance = TestFixture::of({one, other});
      TestFixture::expect_near(one_distance, TestFixture::of({two, other}),
                               error + TestFixture::epsilon * one_distance);
    };
    for (const Shape& shape : points) expect_alike(point, shape);
    for (const Shape& shape : segments) expect_alike(segment, shape);
  });
}

TYPED_TEST(DistanceLaw, TheOrderOfATrianglesCornersChangesNothingBeyondRounding) {
  check_property([] {
    constexpr Dim dimension = TypeParam::dimension;
    using Number = typename TypeParam::scalar;
    const auto [triangle, other] = *any_pair<Triangle<dimension, Number>, AnyShape<dimension, Number>>();
    const Proximity<dimension, double> found = proximity_of<dimension, Number>(triangle, other);
    for (const Triangle<dimension, Number>& same : orders_of(triangle)) {
      const Proximity<dimension, double> again = proximity_of<dimension, Number>(same, other);
      TestFixture::expect_near(found.distance, again.distance, found.error + again.error + 1e-12 * found.distance);
    }
  });
}

// ---- Invalid input

TYPED_TEST(DistanceLaw, NanAndExtremesGetAnAnswer) {
  constexpr Dim dimension = TypeParam::dimension;
  using Number = typename TypeParam::scalar;
  using Limits = std::numeric_limits<Number>;
  const std::array values = {Limits::quiet_NaN(), Limits::infinity(),   -Limits::infinity(), Limits::max(),
                             Limits::lowest(),    Limits::denorm_min(), Number(0),           Number(-1),
                             Number(1e30),        Number(-1e-30)};
  for (std::size_t a = 0; a < row_types; ++a) {
    for (std::size_t b = 0; b < row_types; ++b) {
      auto extreme = row_shape<dimension, Number>(a, Number(1));
      const auto other = row_shape<dimension, Number>(b, Number(-1));
      for_each_number<dimension, Number>(extreme, [&](Number& x) {
        const Number before = x;
        for (const Number value : values) {
          x = value;
          const auto found = proximity_of<dimension, Number>(extreme, other);
          EXPECT_FALSE(found.distance < 0) << value << " in " << shape_type_names[a] << ", " << shape_type_names[b];
          EXPECT_TRUE(!std::isnan(value) || found.relation == Relation::apart);
        }
        x = before;
      });
    }
  }
}

}  // namespace
}  // namespace graze::test::distance_laws_test
