// SPDX-License-Identifier: MIT
// Laws of shape_cast on random pairs of every type and random motions: the exact oracle's answers during the motion,
// agreement with other queries, and invariances.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/tolerance.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/convex/wide_support.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/converted.hpp>
#include <graze/shape/fields/visit.hpp>

#include "catalogue.hpp"
#include "exact.hpp"
#include "query/cast_cases.hpp"
#include "query/cast_laws.hpp"
#include "query/contacts.hpp"
#include "query/numbers_of.hpp"
#include "query/pairs.hpp"
#include "query/placement.hpp"
#include "query/ray_casts.hpp"
#include "query/shape_casts.hpp"

namespace graze::test::shape_cast_laws_test {
namespace {

template <class SpaceType>
class ShapeCastLaw : public ::testing::Test, public CastCases<SpaceType> {
 public:
  using Cases = CastCases<SpaceType>;
  using Cases::dimension;
  using typename Cases::Any;
  using typename Cases::Case;
  using typename Cases::Number;

  static constexpr double epsilon = static_cast<double>(std::numeric_limits<Number>::epsilon());

  static std::optional<detail::CastHit<dimension>> cast_hit(const Case& drawn) {
    const auto found = cast_hit_of<dimension, Number>(drawn.a, drawn.motion, drawn.b);
    if (found) RC_LOG() << "t = " << literal(found->t) << ", error " << found->error << "\n";
    return found;
  }

  static bool is_level(const Any& shape) {
    return std::holds_alternative<Plane<dimension, Number>>(shape) ||
           std::holds_alternative<HalfSpace<dimension, Number>>(shape);
  }

  static bool has_normal(const Any& shape) {
    return detail::visit([](const auto& held) { return Convex<std::decay_t<decltype(held)>>; }, shape);
  }

  static double radius_of(const Any& shape) {
    return detail::visit(
        [](const auto& held) {
          if constexpr (Convex<std::decay_t<decltype(held)>>) {
            return detail::core_radius(held);
          } else {
            return 0.0;
          }
        },
        shape);
  }

  static double height(const Any& shape, const Vec<dimension, double>& direction) {
    return detail::visit(
        [&direction](const auto& held) {
          if constexpr (Convex<std::decay_t<decltype(held)>>) {
            return dot(direction, detail::wide_support(held, direction));
          } else {
            return 0.0;
          }
        },
        shape);
  }
};

TYPED_TEST_SUITE(ShapeCastLaw, test::Spaces);

TYPED_TEST(ShapeCastLaw, ShapesThatMeetHaveTheirContactAndOthersNone) {
  check_property([] {
    constexpr Dim N = TypeParam::dimension;
    using T = typename TypeParam::scalar;
    const auto drawn = TestFixture::draw_case();
    const auto contact = contact_of<N, T>(drawn.a, drawn.b);
    const auto impact = impact_of<N, T>(drawn.a, drawn.motion, drawn.b);
    if (contact) {
      RC_ASSERT(impact.has_value());
      RC_ASSERT(*impact == (Impact<N, T>{T(0), contact->point, contact->normal, contact->status, contact->error}));
    }
    const auto resting = impact_of<N, T>(drawn.a, Vec<N, T>(T(0)), drawn.b);
    RC_ASSERT(resting.has_value() == contact.has_value());
  });
}

TYPED_TEST(ShapeCastLaw, AtTheImpactTheShapesTouchAndBeforeItTheyAreApart) {
  check_property([] {
    const auto drawn = TestFixture::draw_case();
    check_gaps<TestFixture>(drawn, 0, TestFixture::cast_hit(drawn));
  });
}

TYPED_TEST(ShapeCastLaw, TheNormalPartsTheShapesAtTheImpactAndIsNotAgainstTheMotion) {
  check_property([] {
    constexpr Dim N = TypeParam::dimension;
    using T = typename TypeParam::scalar;
    const auto drawn = TestFixture::draw_case();
    const auto found = TestFixture::cast_hit(drawn);
    if (!found || found->t == 0) return;
    const Vec<N, double> motion = wide<N, T>(drawn.motion);
    RC_LOG() << "normal " << to_source<N, double>(AnyShape<N, double>(found->normal)) << "\n";
    RC_ASSERT(std::fabs(length(found->normal) - 1) <= 8 * tolerance::epsilon);
    RC_ASSERT(dot(found->normal, motion) >= -8 * tolerance::epsilon * sum_abs(motion));
    if (!TestFixture::has_normal(drawn.a) || !TestFixture::has_normal(drawn.b)) return;
    const double from_a = TestFixture::height(drawn.a, found->normal) + dot(motion, found->normal) * found->t;
    const double to_b = -TestFixture::height(drawn.b, -found->normal);
    RC_LOG() << "gap along it " << to_b - from_a << "\n";
    // If the cores are as far apart as their radii, rounding of their positions rotates the normal.
    const double rounding = found->error + TestFixture::place_error(drawn);
    const double radius = TestFixture::radius_of(drawn.a) + TestFixture::radius_of(drawn.b);
    const double turn = radius > 0 ? std::min(1.0, rounding / radius) : 0.0;
    RC_ASSERT(to_b - from_a >= -(rounding + turn * TestFixture::size(drawn)));
  });
}

TYPED_TEST(ShapeCastLaw, ThePointIsOnBothShapes) {
  check_property([] {
    const auto drawn = TestFixture::draw_case();
    check_point<TestFixture>(drawn, 0, TestFixture::cast_hit(drawn));
  });
}

TYPED_TEST(ShapeCastLaw, SwappedShapesMoveTheOtherWayAndMeetAtTheSameTime) {
  check_property([] {
    constexpr Dim N = TypeParam::dimension;
    using T = typename TypeParam::scalar;
    const auto drawn = TestFixture::draw_case();
    const auto one = TestFixture::cast_hit(drawn);
    const auto other = TestFixture::cast_hit({drawn.b, -drawn.motion, drawn.a});
    RC_ASSERT(one.has_value() == other.has_value());
    if (!one) return;
    RC_ASSERT(one->t == other->t);
    RC_ASSERT(one->error == other->error);
    if (to_source<N, T>(drawn.a) == to_source<N, T>(drawn.b)) return;  // none of them is the first
    RC_ASSERT(one->normal == -other->normal);
    const Vec<N, double> way = wide<N, T>(drawn.motion) * one->t;
    RC_ASSERT(max_abs(one->point - way - other->point) <= TestFixture::place_error(drawn));
  });
}

/// In double it equals the ray's hit. Rays in float are decided by filters with error bounds of their own, based on
/// local sizes instead of the largest coordinates, so there the two hits agree within their errors, measured across the
/// surface, because along it a grazing ray has a longer distance. What the point only reaches at t = 1 by rounding the
/// cast counts as a touch, while a finite t_max hides the hit just beyond it.
TYPED_TEST(ShapeCastLaw, APointIsCastAsARay) {
  check_property([] {
    constexpr Dim N = TypeParam::dimension;
    using T = typename TypeParam::scalar;
    const auto drawn = TestFixture::draw_case();
    const Vec<N, T> point = *any<Vec<N, T>>();
    RC_PRE(max_abs(drawn.motion) > T(0));
    RC_PRE((relation_of<N, T>(point, drawn.b) == Relation::apart));
    const auto hit = hit_of<N, T>(drawn.b, Ray<N, T>{point, drawn.motion}, T(1));
    const auto impact = impact_of<N, T>(point, drawn.motion, drawn.b);
    if (impact && !hit) {
      RC_ASSERT(impact->t == T(1));
      const auto cast = typename TestFixture::Case{point, drawn.motion, drawn.b};
      RC_ASSERT(TestFixture::gap_at(cast, 1) <= impact->error + TestFixture::place_error(cast));
      return;
    }
    RC_ASSERT(hit.has_value() == impact.has_value());
    if (!hit) return;
    RC_ASSERT(impact->t <= hit->t);
    if (std::is_same_v<T, double>) {
      RC_ASSERT(impact->t == hit->t);
      RC_ASSERT(impact->error == hit->error);
      return;
    }
    const double across = std::fabs(dot(wide<N, T>(drawn.motion), wide<N, T>(impact->normal)));
    const double rounding = TestFixture::epsilon * static_cast<double>(sum_abs(drawn.motion));
    const double between = static_cast<double>(hit->t - impact->t) * across;
    RC_LOG() << between << " between, errors " << impact->error << " and " << hit->error << "\n";
    RC_ASSERT(between <= impact->error + hit->error + rounding);
    const double largest = TestFixture::size({point, drawn.motion, drawn.b});
    RC_ASSERT(impact->error <= 4096 * tolerance::epsilon * largest);
    RC_ASSERT(hit->error <= 4096 * tolerance::epsilon * largest);
  });
}

TYPED_TEST(ShapeCastLaw, ScalingByAPowerOfTwoChangesNoTime) {
  check_property([] {
    constexpr Dim N = TypeParam::dimension;
    using T = typename TypeParam::scalar;
    const auto drawn = TestFixture::draw_case();
    const auto factor = std::ldexp(T(1), *rc::gen::inRange(-20, 21));
    const auto one = TestFixture::cast_hit(drawn);
    const auto other =
        TestFixture::cast_hit({scaled<N, T>(drawn.a, factor), drawn.motion * factor, scaled<N, T>(drawn.b, factor)});
    RC_ASSERT(one.has_value() == other.has_value());
    if (!one) return;
    RC_ASSERT(one->t == other->t);
    RC_ASSERT(one->normal == other->normal);
  });
}

TYPED_TEST(ShapeCastLaw, ACompoundTouchesWhenItsFirstPartDoes) {
  check_property([] { check_first_part<TestFixture>(TestFixture::draw_case(), TestFixture::cast_hit); });
}

}  // namespace
}  // namespace graze::test::shape_cast_laws_test
