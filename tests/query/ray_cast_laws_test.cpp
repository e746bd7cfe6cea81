// SPDX-License-Identifier: MIT
// Laws of ray_cast on random rays and shapes of every type: agreement with other queries, and invariances.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include <gtest/gtest.h>

#include <graze/math/tolerance.hpp>
#include <graze/query/transformed.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "parts_of.hpp"
#include "query/numbers_of.hpp"
#include "query/pairs.hpp"
#include "query/placement.hpp"
#include "query/ray_casts.hpp"

namespace graze::test::ray_cast_laws_test {
namespace {

constexpr RayOptions at_exit{RaySide::exit};

template <class SpaceType>
class RayCastLaw : public ::testing::Test {
 public:
  static constexpr Dim dimension = SpaceType::dimension;
  using Number = typename SpaceType::scalar;
  using Any = AnyShape<dimension, Number>;
  using Point = Vec<dimension, Number>;
  using Hit = std::optional<RayHit<dimension, Number>>;

  static constexpr double epsilon = static_cast<double>(std::numeric_limits<Number>::epsilon());
  static constexpr Number infinity = std::numeric_limits<Number>::infinity();

  struct Case {
    Any shape;
    Ray<dimension, Number> ray;
    Number t_max;
  };

  /// In half of the cases the ray starts at, or is aimed at, a point of the shape, often of an edge or a corner.
  static Case draw_case() {
    auto [shape, drawn] = *any_pair<Any, Ray<dimension, Number>>();
    Ray<dimension, Number> ray = drawn;
    const std::uint64_t seed = *choice(std::size_t{1} << 31U);
    rc::Random random(seed);
    const Point point(point_of(shape, random));
    if (seed % 4 == 0 && is_finite(point)) ray.origin = point;
    if (seed % 4 == 1 && is_finite(point) && point != ray.origin) ray.direction = point - ray.origin;
    if (max_abs(ray.direction) == Number(0)) ray.direction = drawn.direction;
    const Number t_max = seed % 3 == 0 ? infinity : static_cast<Number>(whole(random, 0, 8)) / Number(4);
    RC_LOG() << to_source<dimension, Number>(shape) << ", " << to_source(ray) << ", " << t_max << "\n";
    return {std::move(shape), ray, t_max};
  }

  static Hit cast(const Case& drawn, RayOptions options = {}) {
    return hit_of<dimension, Number>(drawn.shape, drawn.ray, drawn.t_max, options);
  }

  static Vec<dimension, double> point_at(const Case& drawn, double t) {
    return wide<dimension, Number>(drawn.ray.origin) + wide<dimension, Number>(drawn.ray.direction) * t;
  }

  /// The error from rounding to T and from `signed_distance` itself.
  static double slack_at(const Case& drawn, const RayHit<dimension, Number>& hit) {
    const auto far = static_cast<double>(max_abs(hit.point)) + size_of<dimension, Number>({drawn.shape, drawn.ray});
    return hit.error + 2 * epsilon * far;
  }
};

TYPED_TEST_SUITE(RayCastLaw, test::Spaces);

TYPED_TEST(RayCastLaw, ARayHitsWhatItIntersects) {
  check_property([] {
    auto drawn = TestFixture::draw_case();
    drawn.t_max = TestFixture::infinity;
    const Relation relation = relation_of<TypeParam::dimension, typename TypeParam::scalar>(drawn.shape, drawn.ray);
    RC_ASSERT(TestFixture::cast(drawn).has_value() == (relation != Relation::apart));
  });
}

TYPED_TEST(RayCastLaw, ASegmentHitsWhatItIntersects) {
  check_property([] {
    constexpr Dim N = TypeParam::dimension;
    using T = typename TypeParam::scalar;
    const auto drawn = TestFixture::draw_case();
    const T length = std::isinf(drawn.t_max) ? T(1) : drawn.t_max;
    const Segment<N, T> segment{drawn.ray.origin, drawn.ray.origin + drawn.ray.direction * length};
    RC_LOG() << to_source(segment) << "\n";
    const Relation relation = relation_of<N, T>(drawn.shape, segment);
    RC_ASSERT((hit_of<N, T>(drawn.shape, segment).has_value()) == (relation != Relation::apart));
  });
}

TYPED_TEST(RayCastLaw, APartOfARayHitsWhatTheSegmentIntersectsWhereThatIsTheSame) {
  check_property([] {
    constexpr Dim N = TypeParam::dimension;
    using T = typename TypeParam::scalar;
    const auto drawn = TestFixture::draw_case();
    RC_PRE(std::isfinite(drawn.t_max));
    const Segment<N, T> segment{drawn.ray.origin, drawn.ray.origin + drawn.ray.direction * drawn.t_max};
    const Relation relation = relation_of<N, T>(drawn.shape, segment);
    const auto verdict = true_verdict<N, T>(drawn.shape, segment, Relation::apart);
    const double size = size_of<N, T>({drawn.shape, segment}) + static_cast<double>(sum_abs(drawn.ray.origin));
    RC_PRE(std::fabs(verdict.gap) > 8 * TestFixture::epsilon * size);
    RC_ASSERT(TestFixture::cast(drawn).has_value() == (relation != Relation::apart));
  });
}

TYPED_TEST(RayCastLaw, AHitIsWithinTheRayAndOnTheShape) {
  check_property([] {
    constexpr Dim N = TypeParam::dimension;
    using T = typename TypeParam::scalar;
    const auto drawn = TestFixture::draw_case();
    for (const RayOptions options : {RayOptions{}, at_exit}) {
      const auto hit = TestFixture::cast(drawn, options);
      if (!hit) continue;
      RC_LOG() << hit->t << " at " << to_source<N, T>(AnyShape<N, T>(hit->point)) << "\n";
      RC_ASSERT(hit->t >= T(0));
      RC_ASSERT(hit->t <= drawn.t_max);
      // A ray in the plane of a flat shape may leave it by a rounding error of T: then the error says by how much.
      RC_ASSERT(hit->status == Status::converged || hit->error > 0);
      RC_ASSERT(std::fabs(length(wide<N, T>(hit->normal)) - 1) < 4 * TestFixture::epsilon);
      const double height = height_of<N, T>(drawn.shape, wide<N, T>(hit->point));
      const double slack = TestFixture::slack_at(drawn, *hit);
      RC_LOG() << height << " high, " << slack << " allowed\n";
      RC_ASSERT(height <= slack);
      if (hit->t > T(0)) RC_ASSERT(height >= -slack);
    }
  });
}

TYPED_TEST(RayCastLaw, TheRayIsNowhereInsideBeforeTheEntryOrAfterTheExit) {
  check_property([] {
    constexpr Dim N = TypeParam::dimension;
    using T = typename TypeParam::scalar;
    auto drawn = TestFixture::draw_case();
    const auto entry = TestFixture::cast(drawn);
    const double t_max = entry ? static_cast<double>(entry->t) : std::min(2.0, static_cast<double>(drawn.t_max));
    RC_PRE(!entry || std::isfinite(entry->t));
    const double slack = entry ? TestFixture::slack_at(drawn, *entry) : 1e-30;
    for (const double share : {0.0, 0.25, 0.5, 0.75, 0.999}) {
      const Vec<N, double> before = TestFixture::point_at(drawn, t_max * share);
      const double rounding = 64 * tolerance::epsilon * (max_abs(before) + size_of<N, T>({drawn.shape, drawn.ray}));
      if (t_max > 0) RC_ASSERT((height_of<N, T>(drawn.shape, before)) >= -(slack + rounding));
    }
    const auto exit = TestFixture::cast(drawn, at_exit);
    if (!exit || !std::isfinite(exit->t)) return;
    auto whole = drawn;
    whole.t_max = TestFixture::infinity;
    RC_ASSERT(TestFixture::cast(whole).has_value());  // a rounding error may move it past the exit
    const double past = TestFixture::slack_at(drawn, *exit);
    for (const double factor : {1.001, 1.5, 4.0}) {
      const double t = std::min(static_cast<double>(exit->t) * factor, static_cast<double>(drawn.t_max));
      const Vec<N, double> after = TestFixture::point_at(drawn, t);
      const double rounding = 64 * tolerance::epsilon * (max_abs(after) + size_of<N, T>({drawn.shape, drawn.ray}));
      RC_ASSERT((height_of<N, T>(drawn.shape, after)) >= -(past + rounding));
    }
  });
}

TYPED_TEST(RayCastLaw, TheNormalIsAgainstTheRayAtTheEntryAndWithItAtTheExit) {
  check_property([] {
    constexpr Dim N = TypeParam::dimension;
    using T = typename TypeParam::scalar;
    const auto drawn = TestFixture::draw_case();
    const Vec<N, double> direction = wide<N, T>(drawn.ray.direction) / length(wide<N, T>(drawn.ray.direction));
    const double slack = 8 * TestFixture::epsilon;
    if (const auto hit = TestFixture::cast(drawn)) RC_ASSERT(dot(wide<N, T>(hit->normal), direction) <= slack);
    if (const auto hit = TestFixture::cast(drawn, at_exit))
      RC_ASSERT(dot(wide<N, T>(hit->normal), direction) >= -slack);
  });
}

TYPED_TEST(RayCastLaw, AFiniteTMaxHidesOnlyWhatIsBeyondIt) {
  check_property([] {
    using T = typename TypeParam::scalar;
    auto drawn = TestFixture::draw_case();
    drawn.t_max = TestFixture::infinity;
    for (const RayOptions options : {RayOptions{}, at_exit}) {
      const auto hit = TestFixture::cast(drawn, options);
      const T t = hit ? hit->t : T(1);
      for (const T t_max :
           {T(0), t / 2, std::nextafter(t, T(0)), t, std::nextafter(t, TestFixture::infinity), t * T(2)}) {
        auto part = drawn;
        part.t_max = t_max;
        RC_LOG() << "up to " << t_max << "\n";
        RC_ASSERT((TestFixture::cast(part, options)) == (hit && t <= t_max ? hit : std::nullopt));
      }
    }
  });
}

TYPED_TEST(RayCastLaw, ScalingByAPowerOfTwoScalesItExactly) {
  check_property([] {
    constexpr Dim N = TypeParam::dimension;
    using T = typename TypeParam::scalar;
    auto drawn = TestFixture::draw_case();
    drawn.t_max = TestFixture::infinity;
    const auto factor = std::ldexp(T(1), *rc::gen::inRange(-20, 21));
    auto scaled_case = drawn;
    scaled_case.shape = scaled<N, T>(drawn.shape, factor);
    scaled_case.ray.origin *= factor;
    const auto hit = TestFixture::cast(drawn);
    const auto scaled_hit = TestFixture::cast(scaled_case);
    RC_ASSERT(hit.has_value() == scaled_hit.has_value());
    if (!hit || (hit->t != T(0) && hit->t < T(1e-30))) return;
    RC_LOG() << hit->t << " and " << scaled_hit->t << "\n";
    RC_ASSERT(scaled_hit->t == hit->t * factor);
    RC_ASSERT(scaled_hit->normal == hit->normal);
  });
}

TYPED_TEST(RayCastLaw, ALongerDirectionMakesTShorter) {
  check_property([] {
    using T = typename TypeParam::scalar;
    auto drawn = TestFixture::draw_case();
    const auto factor = std::ldexp(T(1), *rc::gen::inRange(-60, 61));
    auto longer = drawn;
    longer.ray.direction *= factor;
    longer.t_max /= factor;
    const auto hit = TestFixture::cast(drawn);
    const auto longer_hit = TestFixture::cast(longer);
    RC_ASSERT(hit.has_value() == longer_hit.has_value());
    if (!hit) return;
    RC_ASSERT(longer_hit->t == hit->t / factor);
    RC_ASSERT(longer_hit->point == hit->point);
    RC_ASSERT(longer_hit->normal == hit->normal);
  });
}

TYPED_TEST(RayCastLaw, TheExitIsTheEntryOfTheSegmentTurnedRound) {
  check_property([] {
    constexpr Dim N = TypeParam::dimension;
    using T = typename TypeParam::scalar;
    const auto drawn = TestFixture::draw_case();
    const Segment<N, T> segment{drawn.ray.origin, drawn.ray.origin + drawn.ray.direction};
    const auto exit = hit_of<N, T>(drawn.shape, segment, at_exit);
    const auto back = hit_of<N, T>(drawn.shape, Segment<N, T>{segment.end, segment.start});
    if (!exit || !back) return;
    RC_LOG() << exit->t << " and back " << back->t << "\n";
    // At a grazing angle they differ, but in between the surface is as close as the error says.
    const auto one = static_cast<double>(exit->t);
    const double other = 1 - static_cast<double>(back->t);
    const double slack = exit->error + back->error + 4 * TestFixture::epsilon * size_of<N, T>({drawn.shape, segment});
    for (const double share : {0.25, 0.5, 0.75}) {
      const double t = one + (other - one) * share;
      const Vec<N, double> between = wide<N, T>(segment.start) * (1 - t) + wide<N, T>(segment.end) * t;
      RC_ASSERT(std::fabs(height_of<N, T>(drawn.shape, between)) <= slack);
    }
  });
}

TYPED_TEST(RayCastLaw, ACompoundIsHitAtItsFirstPartAndLeftAtItsLast) {
  check_property([] {
    constexpr Dim N = TypeParam::dimension;
    using T = typename TypeParam::scalar;
    const auto drawn = TestFixture::draw_case();
    auto other = drawn;
    other.shape = *any_shape<N, T>();
    auto both = drawn;
    both.shape = compound_of<N, T>({drawn.shape, other.shape});
    const auto one = TestFixture::cast(drawn);
    const auto two = TestFixture::cast(other);
    const auto first = TestFixture::cast(both);
    RC_ASSERT(first.has_value() == (one || two));
    if (!first) return;
    const T nearest = std::min(one ? one->t : TestFixture::infinity, two ? two->t : TestFixture::infinity);
    RC_ASSERT(first->t == nearest);
    const auto one_exit = TestFixture::cast(drawn, at_exit);
    const auto two_exit = TestFixture::cast(other, at_exit);
    const auto last = TestFixture::cast(both, at_exit);
    if (last) {
      RC_ASSERT((one_exit && one_exit->t == last->t) || (two_exit && two_exit->t == last->t));
    }
  });
}

TYPED_TEST(RayCastLaw, RigidMotionsChangeNothingBeyondRounding) {
  check_property([] {
    constexpr Dim N = TypeParam::dimension;
    using T = typename TypeParam::scalar;
    const auto drawn = TestFixture::draw_case();
    const auto pose = *any_pose<N, T>();
    auto moved_case = drawn;
    moved_case.shape = transformed(drawn.shape, pose);
    moved_case.ray = transformed(drawn.ray, pose);
    // A bare touch may become a miss when rotated by a rounding error, and then another part is hit.
    RC_PRE((!is_union<N, T>(drawn.shape)));
    RC_PRE(N == 2 || (!std::holds_alternative<Polytope<N, T>>(drawn.shape)));
    RC_PRE((relation_of<N, T>(drawn.shape, drawn.ray) == Relation::overlapping));
    const auto hit = TestFixture::cast(drawn);
    const auto moved_hit = TestFixture::cast(moved_case);
    if (!hit || !moved_hit || hit->t == T(0) || moved_hit->t == T(0)) return;
    const Vec<N, double> way = wide<N, T>(drawn.ray.direction);
    const Vec<N, double> moved_way = wide<N, T>(moved_case.ray.direction);
    // The first-order change of t for a displacement of the surface along the normal.
    const double steepness = std::min(std::fabs(dot(wide<N, T>(hit->normal), way)),
                                      std::fabs(dot(wide<N, T>(moved_hit->normal), moved_way)));
    const double apart = std::fabs(static_cast<double>(hit->t) - static_cast<double>(moved_hit->t));
    const double size = size_of<N, T>({drawn.shape, drawn.ray}) + size_of<N, T>({moved_case.shape, moved_case.ray}) +
                        static_cast<double>(max_abs(hit->point)) + static_cast<double>(max_abs(moved_hit->point)) +
                        static_cast<double>(max_abs(pose.position));
    RC_LOG() << hit->t << " and " << moved_hit->t << "\n";
    RC_ASSERT(apart * steepness <= 64 * TestFixture::epsilon * size);
  });
}

}  // namespace
}  // namespace graze::test::ray_cast_laws_test
