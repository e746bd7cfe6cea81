// SPDX-License-Identifier: MIT
// Laws of contact(a, b) on random pairs of every type: invariances, agreement with other queries, and invalid input.
// contact_agreement_test.cpp tests its correctness.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/tolerance.hpp>
#include <graze/query/transformed.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/visit.hpp>

#include "catalogue.hpp"
#include "query/contacts.hpp"
#include "query/numbers_of.hpp"
#include "query/orders_of.hpp"
#include "query/pairs.hpp"
#include "query/placement.hpp"
#include "query/point_answers.hpp"
#include "query/row_of_shapes.hpp"

namespace graze::test::contact_laws_test {
namespace {

template <class SpaceType>
class ContactLaw : public ::testing::Test {
 public:
  static constexpr Dim N = SpaceType::dimension;
  using T = typename SpaceType::scalar;
  using Any = AnyShape<N, T>;
  using Pair = AnyPair<N, T>;

  static constexpr double epsilon = static_cast<double>(std::numeric_limits<T>::epsilon());

  /// Two shapes, usually placed together.
  static Pair draw_two() {
    const Pair pair = *any_pair<Any, Any>();
    const std::uint64_t seed = *choice(std::size_t{1} << 31U);
    rc::Random random(seed);
    return seed % 4 == 0 ? pair : placed_together<N, T>(pair, random);
  }

  /// The contact before rounding; none if the shapes are apart.
  static std::optional<detail::Penetration<N>> found(const Pair& pair) {
    return penetration_of<N, T>(pair.first, pair.second);
  }

  /// Zero without a contact.
  static double depth(const Pair& pair) {
    const auto contact = found(pair);
    return contact ? contact->depth : 0.0;
  }

  /// Logs a pair as C++ source.
  static void log(const Pair& pair) {
    RC_LOG() << to_source<N, T>(pair.first) << ", " << to_source<N, T>(pair.second) << ": " << depth(pair) << "\n";
  }

  static bool is_bounded(const Any& shape) {
    return detail::visit([](const auto& held) { return Convex<std::decay_t<decltype(held)>>; }, shape);
  }

  static void expect_near(double one, double two, double allowed) {
    RC_ASSERT(one == two || std::fabs(one - two) <= allowed);  // both may be infinite
  }
};

TYPED_TEST_SUITE(ContactLaw, test::Spaces);

TYPED_TEST(ContactLaw, ThereIsOneIfAndOnlyIfTheShapesIntersect) {
  check_property([] {
    constexpr Dim dimension = TypeParam::dimension;
    using Number = typename TypeParam::scalar;
    const auto [a, b] = TestFixture::draw_two();
    const bool meets = relation_of<dimension, Number>(a, b) != Relation::apart;
    RC_ASSERT((contact_of<dimension, Number>(a, b).has_value()) == meets);
  });
}

TYPED_TEST(ContactLaw, TouchingShapesHaveHardlyAnyDepth) {
  check_property([] {
    constexpr Dim dimension = TypeParam::dimension;
    using Number = typename TypeParam::scalar;
    const auto pair = TestFixture::draw_two();
    const auto found = TestFixture::found(pair);
    RC_PRE((found.has_value() && relation_of<dimension, Number>(pair.first, pair.second) == Relation::touching));
    TestFixture::log(pair);
    RC_ASSERT((found->depth <= 512 * tolerance::epsilon * size_of<dimension, Number>(pair) + 4 * found->error));
  });
}

TYPED_TEST(ContactLaw, ScalingByAPowerOfTwoScalesItExactly) {
  check_property([] {
    constexpr Dim dimension = TypeParam::dimension;
    using Number = typename TypeParam::scalar;
    const auto pair = TestFixture::draw_two();
    const auto factor = std::ldexp(Number(1), *rc::gen::inRange(-30, 31));
    const AnyPair<dimension, Number> large(scaled<dimension, Number>(pair.first, factor),
                                           scaled<dimension, Number>(pair.second, factor));
    const auto before = TestFixture::found(pair);
    const auto after = TestFixture::found(large);
    RC_ASSERT(before.has_value() == after.has_value());
    RC_PRE(before.has_value());
    TestFixture::log(pair);
    TestFixture::log(large);
    RC_ASSERT(after->depth == before->depth * static_cast<double>(factor));
    RC_ASSERT(after->normal == before->normal);
  });
}

TYPED_TEST(ContactLaw, RigidMotionsChangeNoDepthBeyondRounding) {
  check_property([] {
    constexpr Dim dimension = TypeParam::dimension;
    using Number = typename TypeParam::scalar;
    const auto pair = TestFixture::draw_two();
    // Unbounded shapes may meet far away, or not at all if they are rotated by a rounding error.
    RC_PRE(TestFixture::is_bounded(pair.first) && TestFixture::is_bounded(pair.second));
    const auto pose = *any_pose<dimension, Number>();
    const AnyPair<dimension, Number> moved_pair(transformed(pair.first, pose), transformed(pair.second, pose));
    const double size = std::max(size_of<dimension, Number>(pair), size_of<dimension, Number>(moved_pair)) +
                        static_cast<double>(max_abs(pose.position));
    TestFixture::log(pair);
    TestFixture::log(moved_pair);
    TestFixture::expect_near(TestFixture::depth(pair), TestFixture::depth(moved_pair),
                             64 * TestFixture::epsilon * size);
  });
}

TYPED_TEST(ContactLaw, OfAPointIsAsDeepAsItsSignedDistance) {
  check_property([] {
    constexpr Dim dimension = TypeParam::dimension;
    using Number = typename TypeParam::scalar;
    const auto [first, shape] = TestFixture::draw_two();
    rc::Random random(*choice(std::size_t{1} << 31U));
    const Vec<dimension, Number> point(point_of<dimension, Number>(first, random));
    const AnyPair<dimension, Number> pair(point, shape);
    const auto found = TestFixture::found(pair);
    RC_PRE((found.has_value() && !std::holds_alternative<Plane<dimension, Number>>(shape)));
    TestFixture::log(pair);
    const double distance = static_cast<double>(answers<dimension, Number>(shape, point).distance);
    const double size = size_of<dimension, Number>(pair) + std::fabs(distance);
    TestFixture::expect_near(found->depth, std::max(0.0, -distance), found->error + 16 * TestFixture::epsilon * size);
  });
}

TYPED_TEST(ContactLaw, ACompoundIsAsDeepAsItsDeepestPart) {
  check_property([] {
    constexpr Dim dimension = TypeParam::dimension;
    using Number = typename TypeParam::scalar;
    const auto [a, b] = TestFixture::draw_two();
    const auto c = *any_shape<dimension, Number>();
    const AnyShape<dimension, Number> both = compound_of<dimension, Number>({a, b});
    RC_ASSERT(TestFixture::depth({both, c}) == std::max(TestFixture::depth({a, c}), TestFixture::depth({b, c})));
  });
}

TYPED_TEST(ContactLaw, TheOrderOfATrianglesCornersChangesNoDepthBeyondRounding) {
  check_property([] {
    constexpr Dim dimension = TypeParam::dimension;
    using Number = typename TypeParam::scalar;
    const auto [triangle, other] = *any_pair<Triangle<dimension, Number>, AnyShape<dimension, Number>>();
    const auto found = TestFixture::found({triangle, other});
    RC_PRE(found.has_value());
    for (const Triangle<dimension, Number>& same : orders_of(triangle)) {
      const auto again = TestFixture::found({same, other});
      if (again) TestFixture::expect_near(found->depth, again->depth, found->error + again->error);
    }
  });
}

// ---- Invalid input

TYPED_TEST(ContactLaw, NanAndExtremesGetAnAnswer) {
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
          const auto found = TestFixture::found({extreme, other});
          EXPECT_TRUE(!std::isnan(value) || !found) << "NaN in " << shape_type_names[a] << ", " << shape_type_names[b];
          EXPECT_FALSE(found && found->depth < 0) << value << " in " << shape_type_names[a];
        }
        x = before;
      });
    }
  }
}

}  // namespace
}  // namespace graze::test::contact_laws_test
