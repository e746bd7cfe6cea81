// SPDX-License-Identifier: MIT
// Laws of time_of_impact on random pairs and motions: the exact oracle's answers at the impact and at many times before
// it.
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>

#include <gtest/gtest.h>

#include <graze/math/motion.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "parts_of.hpp"
#include "query/impact_judgement.hpp"
#include "query/moving_gap.hpp"
#include "query/pairs.hpp"
#include "query/placement.hpp"
#include "query/times_of_impact.hpp"

namespace graze::test::time_of_impact_laws_test {
namespace {

/// Rotations of a few radians, about a center near the shapes.
inline double any_angle(rc::Random& random) { return between(random, -3, 3); }
template <Dim N, class T>
Turn<N, T> turn_about(rc::Random& random) {
  if constexpr (N == 2) {
    return static_cast<T>(any_angle(random));
  } else {
    const double x = any_angle(random);
    const double y = any_angle(random);
    return Vec<3, T>(Vec<3, double>(x, y, any_angle(random)));
  }
}

template <class SpaceType>
class TimeOfImpactLaw : public ::testing::Test {
 public:
  static constexpr Dim dimension = SpaceType::dimension;
  using Number = typename SpaceType::scalar;
  using Any = AnyShape<dimension, Number>;
  using Point = Vec<dimension, Number>;
  using Case = Moving<dimension, Number>;

  /// A point of a is aimed at one of b; in one case of four only one of the shapes moves, and in another nothing
  /// rotates.
  static Case draw_case() {
    auto [a, b] = *any_pair<Any, Any>();
    const std::uint64_t seed = *choice(std::size_t{1} << 31U);
    rc::Random random(seed);
    const auto on_a = point_of(a, random);
    const auto on_b = point_of(b, random);
    Case drawn{a, {}, b, {}};
    drawn.motion_a = {Point((on_b - on_a) * between(random, 0.5, 2)), turn_about<dimension, Number>(random),
                      Point(on_a)};
    if (seed % 4 != 0) {
      drawn.motion_b = {Point((on_a - on_b) * between(random, 0, 1)), turn_about<dimension, Number>(random),
                        Point(on_b)};
    }
    if (seed / 4 % 4 == 0) drawn.motion_a.angular = drawn.motion_b.angular = Turn<dimension, Number>(0);
    RC_PRE((relation_of<dimension, Number>(a, b) == Relation::apart));
    RC_LOG() << to_source<dimension, Number>(a) << ", " << source(drawn.motion_a) << ", "
             << to_source<dimension, Number>(b) << ", " << source(drawn.motion_b) << "\n";
    return drawn;
  }

  static std::string source(const Motion<dimension, Number>& motion) {
    return "{" + initializer(motion.linear) + ", " + initializer(motion.angular) + ", " + initializer(motion.center) +
           "}";
  }
};

TYPED_TEST_SUITE(TimeOfImpactLaw, test::Spaces);

TYPED_TEST(TimeOfImpactLaw, AtTheImpactTheShapesTouchAndBeforeItTheyAreApart) {
  check_property([] {
    const ImpactErrors errors = impact_errors(TestFixture::draw_case());
    RC_LOG() << errors.fault << ", gap " << errors.gap << ", error " << errors.claimed << "\n";
    RC_ASSERT(errors.judgement != Judgement::wrong);
  });
}

TYPED_TEST(TimeOfImpactLaw, SwappedShapesMeetAtTheSameTime) {
  check_property([] {
    const auto drawn = TestFixture::draw_case();
    const auto one = cast_hit_of(drawn);
    auto swapped = drawn;
    swapped.a = drawn.b;  // std::swap of two variants would be compiled for every two types
    swapped.b = drawn.a;
    std::swap(swapped.motion_a, swapped.motion_b);
    const auto other = cast_hit_of(swapped);
    RC_ASSERT(one.has_value() == other.has_value());
    if (!one) return;
    RC_ASSERT(one->t == other->t);
    RC_ASSERT(one->error == other->error);
    RC_ASSERT(one->normal == -other->normal);
    RC_ASSERT(one->point == other->point);
  });
}

TYPED_TEST(TimeOfImpactLaw, HalfTheMotionTakesTwiceTheTime) {
  check_property([] {
    using T = typename TypeParam::scalar;
    const auto drawn = TestFixture::draw_case();
    auto slower = drawn;
    for (auto* motion : {&slower.motion_a, &slower.motion_b}) {
      motion->linear *= T(0.5);
      motion->angular *= T(0.5);
    }
    const auto found = cast_hit_of(drawn);
    const auto later = cast_hit_of(slower);
    // The slower one's tolerance is smaller, so it may be beyond what the other one takes for contact.
    if (!found || !later || found->t > 0.499) return;
    // Both are within their errors of contact: at each one's time the other has touched, or is as close.
    RC_LOG() << literal(found->t) << " and " << literal(later->t) << "\n";
    const double rounding = rounding_of_way(drawn);
    RC_ASSERT(gap_at(drawn, later->t / 2) <= later->error + rounding);
    RC_ASSERT(gap_at(slower, found->t * 2) <= found->error + rounding);
  });
}

TYPED_TEST(TimeOfImpactLaw, ACompoundTouchesWhenItsFirstPartDoes) {
  check_property([] {
    constexpr Dim N = TypeParam::dimension;
    using T = typename TypeParam::scalar;
    const auto drawn = TestFixture::draw_case();
    auto other = drawn;
    other.b = *any_shape<N, T>();
    RC_PRE((relation_of<N, T>(other.a, other.b) == Relation::apart));
    auto both = drawn;
    both.b = compound_of<N, T>({drawn.b, other.b});
    const auto one = cast_hit_of(drawn);
    const auto two = cast_hit_of(other);
    const auto first = cast_hit_of(both);
    RC_ASSERT(first.has_value() == (one || two));
    if (!first) return;
    const bool is_one = one && (!two || one->t <= two->t);
    RC_ASSERT(first->t == (is_one ? one : two)->t);
    if (!is_union<N, T>(drawn.a)) RC_ASSERT(first->point == (is_one ? one : two)->point);
  });
}

}  // namespace
}  // namespace graze::test::time_of_impact_laws_test
