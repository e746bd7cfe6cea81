// SPDX-License-Identifier: MIT
// Rays and segments that pass shapes of every type by a few ulp, near zero and far from it: all queries agree whether
// they hit, and a finite t_max hides exactly what is beyond it.
#include <cmath>
#include <limits>
#include <optional>

#include <gtest/gtest.h>

#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "query/contacts.hpp"
#include "query/grazing_rays.hpp"
#include "query/manifolds.hpp"
#include "query/pairs.hpp"
#include "query/proximities.hpp"
#include "query/ray_casts.hpp"
#include "query/shape_casts.hpp"

namespace graze::test::grazing_ray_test {
namespace {

constexpr RayOptions at_exit{RaySide::exit};

template <class SpaceType>
class GrazingRay : public ::testing::Test {
 public:
  static constexpr Dim dimension = SpaceType::dimension;
  using Number = typename SpaceType::scalar;
  using Any = AnyShape<dimension, Number>;
  using Way = Ray<dimension, Number>;
  using Hit = std::optional<RayHit<dimension, Number>>;
  static constexpr Number infinity = std::numeric_limits<Number>::infinity();

  template <class Check>
  static void for_rays_past_a_shape(const Check& check) {
    test::for_rays_past_a_shape<dimension, Number>(check);
  }

  static void log(const Any& shape, const Any& path) {
    RC_LOG() << to_source<dimension, Number>(shape) << ", " << to_source<dimension, Number>(path) << "\n";
  }

  /// Calls all queries on a shape and a ray or a segment.
  static void expect_agreement(const Any& shape, const Any& path, bool is_met) {
    RC_ASSERT((relation_of<dimension, Number>(path, shape) != Relation::apart) == is_met);
    for (const bool turns : {false, true}) {
      const Any& a = turns ? path : shape;
      const Any& b = turns ? shape : path;
      RC_ASSERT((distance_of<dimension, Number>(a, b) == Number(0)) == is_met);
      RC_ASSERT((proximity_of<dimension, Number>(a, b).relation != Relation::apart) == is_met);
      RC_ASSERT((contact_of<dimension, Number>(a, b).has_value()) == is_met);
      RC_ASSERT((manifold_of<dimension, Number>(a, b).size > 0) == is_met);
    }
  }

  static Hit cast(const Any& shape, const Way& ray, Number t_max, RayOptions options = {}) {
    return hit_of<dimension, Number>(shape, ray, t_max, options);
  }
};

TYPED_TEST_SUITE(GrazingRay, Spaces);

TYPED_TEST(GrazingRay, AllQueriesSayTheSameOfARay) {
  check_property([] {
    constexpr Dim N = TypeParam::dimension;
    using T = typename TypeParam::scalar;
    TestFixture::for_rays_past_a_shape([](const auto& shape, const auto& ray) {
      TestFixture::log(shape, ray);
      const bool is_met = relation_of<N, T>(shape, ray) != Relation::apart;
      TestFixture::expect_agreement(shape, ray, is_met);
      RC_ASSERT((meet_as_held<N, T>(shape, ray)) == is_met);
      RC_ASSERT((TestFixture::cast(shape, ray, TestFixture::infinity).has_value()) == is_met);
      const Compound<N, T> alone = compound_of<N, T>({shape});
      TestFixture::expect_agreement(alone, ray, is_met);
      RC_ASSERT((TestFixture::cast(alone, ray, TestFixture::infinity).has_value()) == is_met);
    });
  });
}

TYPED_TEST(GrazingRay, AllQueriesSayTheSameOfASegment) {
  check_property([] {
    constexpr Dim N = TypeParam::dimension;
    using T = typename TypeParam::scalar;
    TestFixture::for_rays_past_a_shape([](const auto& shape, const auto& ray) {
      const Segment<N, T> segment = beginning_of(ray);
      TestFixture::log(shape, segment);
      const bool is_met = relation_of<N, T>(shape, segment) != Relation::apart;
      TestFixture::expect_agreement(shape, segment, is_met);
      RC_ASSERT((hit_of<N, T>(shape, segment).has_value()) == is_met);
    });
  });
}

TYPED_TEST(GrazingRay, AFiniteTMaxHidesOnlyWhatIsBeyondIt) {
  check_property([] {
    constexpr Dim N = TypeParam::dimension;
    using T = typename TypeParam::scalar;
    TestFixture::for_rays_past_a_shape([](const auto& shape, const auto& ray) {
      TestFixture::log(shape, ray);
      const Compound<N, T> twice = compound_of<N, T>({shape, shape});
      for (const RayOptions options : {RayOptions{}, at_exit}) {
        const auto hit = TestFixture::cast(shape, ray, TestFixture::infinity, options);
        const T t = hit ? hit->t : T(1);
        const T next = std::nextafter(t, TestFixture::infinity);
        for (const T t_max : {T(0), t / 2, std::nextafter(t, T(0)), t, next, t * T(1.5), t * T(1000), t + T(1)}) {
          const auto expected = hit && hit->t <= t_max ? hit : std::nullopt;
          RC_LOG() << "up to " << t_max << "\n";
          RC_ASSERT((TestFixture::cast(shape, ray, t_max, options)) == expected);
          RC_ASSERT((TestFixture::cast(twice, ray, t_max, options)) == expected);
        }
      }
    });
  });
}

/// What a ray up to t = 1 hits, a point moving by its direction hits there; the cast may only hit more if it touches at
/// the start or the end.
TYPED_TEST(GrazingRay, AMovingPointHitsWhatTheRayDoes) {
  check_property([] {
    using T = typename TypeParam::scalar;
    TestFixture::for_rays_past_a_shape([](const auto& shape, const auto& ray) {
      TestFixture::log(shape, ray);
      const auto hit = TestFixture::cast(shape, ray, T(1));
      const auto impact = impact_of<TypeParam::dimension, T>(ray.origin, ray.direction, shape);
      if (hit) RC_ASSERT(impact.has_value());
      if (impact && impact->t > T(0) && impact->t < T(1)) RC_ASSERT(hit.has_value());
    });
  });
}

}  // namespace
}  // namespace graze::test::grazing_ray_test
