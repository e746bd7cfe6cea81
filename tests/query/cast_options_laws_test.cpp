// SPDX-License-Identifier: MIT
// Laws of shape_cast with options, on random pairs of every type and random motions: the exact oracle's answers, and
// agreement with the cast without options.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <variant>

#include <gtest/gtest.h>

#include <graze/math/tolerance.hpp>
#include <graze/query/cast_options.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "parts_of.hpp"
#include "query/cast_cases.hpp"
#include "query/cast_laws.hpp"
#include "query/shape_casts.hpp"

namespace graze::test::cast_options_laws_test {
namespace {

template <class SpaceType>
class CastOptionsLaw : public ::testing::Test, public CastCases<SpaceType> {
 public:
  using Cases = CastCases<SpaceType>;
  using Cases::dimension;
  using typename Cases::Any;
  using typename Cases::Case;
  using typename Cases::Number;
  using Found = std::optional<detail::CastHit<dimension>>;

  static Found cast_hit(const Case& drawn, const CastOptions& options) {
    if (!options.ignore_initial_touch) {
      const auto start = detail::penetration_within(drawn.a, drawn.b, options.target_distance);
      if (start) return detail::cast_hit_at_start(*start);
    }
    if (max_abs(drawn.motion) == Number(0)) return std::nullopt;
    const Found found = detail::cast_hit(drawn.a, wide<dimension, Number>(drawn.motion), drawn.b, options);
    if (found) RC_LOG() << "t = " << literal(found->t) << ", error " << found->error << "\n";
    return found;
  }

  /// Often the gap at some time of the cast.
  static double draw_target(const Case& drawn) {
    const double share = static_cast<double>(*rc::gen::inRange(0, 5)) / 4;
    const double gap = *rc::gen::inRange(0, 3) == 0 ? 0 : Cases::gap_at(drawn, share);
    const double target = gap > 0 && std::isfinite(gap) ? gap : Cases::size(drawn) * share + 0.5;
    RC_LOG() << "target " << literal(target) << "\n";
    return target;
  }

  static bool has_parts(const Any& shape) { return is_union<dimension, Number>(shape); }

  /// By how much the shapes may get nearer although the motion does not approach them.
  static double slack(const Case& drawn) {
    return Cases::place_error(drawn) + 2 * tolerance::approach<Number> * static_cast<double>(sum_abs(drawn.motion));
  }
};

TYPED_TEST_SUITE(CastOptionsLaw, Spaces);

TYPED_TEST(CastOptionsLaw, WithoutOptionsSetNothingChanges) {
  check_property([] {
    constexpr Dim N = TypeParam::dimension;
    using T = typename TypeParam::scalar;
    const auto drawn = TestFixture::draw_case();
    RC_ASSERT((detail::impact_of(drawn.a, drawn.motion, drawn.b, CastOptions{}) ==
               impact_of<N, T>(drawn.a, drawn.motion, drawn.b)));
  });
}

TYPED_TEST(CastOptionsLaw, TheShapesAreAsNearAsTheTargetAtTheImpactAndNotBefore) {
  check_property([] {
    const auto drawn = TestFixture::draw_case();
    const double target = TestFixture::draw_target(drawn);
    const auto found = TestFixture::cast_hit(drawn, {false, target});
    if (TestFixture::verdict_at(drawn, 0).is_nearly_parallel) return;  // they meet, too far away to be noticed
    check_gaps<TestFixture>(drawn, target, found);
  });
}

TYPED_TEST(CastOptionsLaw, ThePointIsOnTheSecondShapeAndTheTargetAwayFromTheFirst) {
  check_property([] {
    const auto drawn = TestFixture::draw_case();
    const double target = TestFixture::draw_target(drawn);
    check_point<TestFixture>(drawn, target, TestFixture::cast_hit(drawn, {false, target}));
  });
}

TYPED_TEST(CastOptionsLaw, SwappedShapesStopAtTheSameTime) {
  check_property([] {
    constexpr Dim N = TypeParam::dimension;
    using T = typename TypeParam::scalar;
    const auto drawn = TestFixture::draw_case();
    const double target = TestFixture::draw_target(drawn);
    const bool may_be_equal = TestFixture::has_parts(drawn.a) || TestFixture::has_parts(drawn.b) ||
                              to_source<N, T>(drawn.a) == to_source<N, T>(drawn.b);
    for (const bool ignores : {false, true}) {
      if (ignores && may_be_equal) continue;  // the normal of the contact of equal shapes is that of the swapped ones
      const auto one = TestFixture::cast_hit(drawn, {ignores, target});
      const auto other = TestFixture::cast_hit({drawn.b, -drawn.motion, drawn.a}, {ignores, target});
      RC_ASSERT(one.has_value() == other.has_value());
      if (one) RC_ASSERT(one->t == other->t);
    }
  });
}

TYPED_TEST(CastOptionsLaw, ATargetDistanceIsARadiusMore) {
  check_property([] {
    constexpr Dim N = TypeParam::dimension;
    using T = typename TypeParam::scalar;
    auto drawn = TestFixture::draw_case();
    const auto ball = *any<Sphere<N, T>>();
    const T more = std::fabs((*any<Sphere<N, T>>()).radius);
    drawn.a = ball;
    const auto near = TestFixture::cast_hit(drawn, {false, static_cast<double>(more)});
    drawn.a = Sphere<N, T>{ball.center, ball.radius + more};
    const auto touch = TestFixture::cast_hit(drawn, {});
    const double rounding = static_cast<double>(std::numeric_limits<T>::epsilon()) * TestFixture::size(drawn);
    if (!near || !touch) {
      const auto& found = near ? near : touch;
      if (found) RC_ASSERT(TestFixture::gap_at(drawn, found->t) >= -(rounding + found->error));
      return;
    }
    const double between = std::fabs(near->t - touch->t) * static_cast<double>(sum_abs(drawn.motion));
    const double error = rounding + near->error + touch->error + TestFixture::place_error(drawn);
    const bool is_near = std::fabs(TestFixture::gap_at(drawn, std::max(near->t, touch->t))) <= 2 * error ||
                         std::max(near->t, touch->t) == 0;
    RC_ASSERT(between <= error || is_near);
  });
}

// ---- Touches that are not approached

TYPED_TEST(CastOptionsLaw, WhatStopsTheCastIsApproached) {
  check_property([] {
    const auto drawn = TestFixture::draw_case();
    const auto found = TestFixture::cast_hit(drawn, {true, 0});
    if (!found) return;
    const auto plain = TestFixture::cast_hit(drawn, {});
    RC_ASSERT(plain.has_value());
    RC_ASSERT(plain->t <= found->t);
    RC_ASSERT(dot(found->normal, wide<TypeParam::dimension, typename TypeParam::scalar>(drawn.motion)) > 0);
    if (TestFixture::has_parts(drawn.a) || TestFixture::has_parts(drawn.b)) return;
    RC_ASSERT(plain->t == found->t);
    RC_ASSERT(plain->normal == found->normal);
    RC_ASSERT(plain->point == found->point);
  });
}

/// As a convex shape passes another, their signed distance falls and then rises.
TYPED_TEST(CastOptionsLaw, WhatDoesNotStopTheCastNeverGoesDeeper) {
  check_property([] {
    const auto drawn = TestFixture::draw_case();
    RC_PRE(!TestFixture::has_parts(drawn.a) && !TestFixture::has_parts(drawn.b));
    if (TestFixture::cast_hit(drawn, {true, 0})) return;
    const double start = std::min(0.0, TestFixture::gap_at(drawn, 0));
    const auto contact = detail::penetration(drawn.a, drawn.b);
    const double error = TestFixture::slack(drawn) + (contact ? 2 * contact->error : 0.0);
    for (const double t : {0.001, 0.25, 0.5, 0.75, 1.0}) {
      const double gap = TestFixture::gap_at(drawn, t);
      RC_LOG() << "gap " << start << ", at " << t << " " << gap << ", allowed " << error << "\n";
      RC_ASSERT(gap >= start - error || std::isinf(start));
    }
  });
}

TYPED_TEST(CastOptionsLaw, ACompoundStopsWhenItsFirstPartDoes) {
  check_property([] {
    const auto drawn = TestFixture::draw_case();
    const double target = *rc::gen::inRange(0, 2) == 0 ? 0.0 : TestFixture::draw_target(drawn);
    const CastOptions options{*rc::gen::inRange(0, 2) == 0, target};
    check_first_part<TestFixture>(drawn, [&](const auto& each) { return TestFixture::cast_hit(each, options); });
  });
}

}  // namespace
}  // namespace graze::test::cast_options_laws_test
