// SPDX-License-Identifier: MIT
// Laws of relation(a, b) on random pairs of every type: invariances, and invalid input.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include <graze/query/bounds.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "query/numbers_of.hpp"
#include "query/pairs.hpp"
#include "query/placement.hpp"
#include "query/row_of_shapes.hpp"

namespace graze::test::relation_laws_test {
namespace {

template <class SpaceType>
class RelationLaw : public ::testing::Test {
 public:
  static constexpr Dim N = SpaceType::dimension;
  using T = typename SpaceType::scalar;
  using Any = AnyShape<N, T>;
  using Pair = AnyPair<N, T>;

  static Relation of(const Pair& pair) { return relation_of<N, T>(pair.first, pair.second); }

  /// Two shapes, in half of the cases placed together.
  static Pair draw_two() {
    const Pair pair = *any_pair<Any, Any>();
    const std::uint64_t seed = *choice(std::size_t{1} << 31U);
    rc::Random random(seed);
    return seed % 2 == 0 ? pair : placed_together<N, T>(pair, random);
  }

  /// Whether the true gap or depth is so small that either verdict is permitted.
  static bool is_within_the_band(const Pair& pair, Relation claim) {
    const ExactVerdict truth = true_verdict<N, T>(pair.first, pair.second, claim);
    const double size = std::max(truth.own_size, truth.largest);
    return truth.is_nearly_parallel || std::fabs(truth.gap) <= 128 * std::numeric_limits<double>::epsilon() * size;
  }

  /// The same verdict, or one that the band permits.
  static void expect_same(const Pair& pair, const Pair& changed) {
    const Relation before = of(pair);
    const Relation after = of(changed);
    if (before == after) return;
    RC_LOG() << to_source<N, T>(pair.first) << ", " << to_source<N, T>(pair.second) << ": " << name_of(before) << "\n"
             << to_source<N, T>(changed.first) << ", " << to_source<N, T>(changed.second) << ": " << name_of(after)
             << "\n";
    const Relation not_before = before == Relation::touching ? Relation::apart : Relation::touching;
    const Relation not_after = after == Relation::touching ? Relation::apart : Relation::touching;
    RC_ASSERT(is_within_the_band(pair, not_before) || is_within_the_band(changed, not_after));
  }
};

TYPED_TEST_SUITE(RelationLaw, test::Spaces);

TYPED_TEST(RelationLaw, SwappingTheShapesChangesNothing) {
  check_property([] {
    const auto [a, b] = TestFixture::draw_two();
    RC_TAG(std::string(name_of(TestFixture::of({a, b}))));
    RC_ASSERT(TestFixture::of({a, b}) == TestFixture::of({b, a}));
  });
}

TYPED_TEST(RelationLaw, ScalingByAPowerOfTwoChangesNothing) {
  check_property([] {
    using Number = typename TypeParam::scalar;
    const auto [a, b] = TestFixture::draw_two();
    const auto factor = std::ldexp(Number(1), *rc::gen::inRange(-30, 31));
    constexpr Dim dimension = TypeParam::dimension;
    RC_ASSERT(TestFixture::of({scaled<dimension, Number>(a, factor), scaled<dimension, Number>(b, factor)}) ==
              TestFixture::of({a, b}));
  });
}

TYPED_TEST(RelationLaw, MirroringAndQuarterTurnsChangeNothingBeyondRounding) {
  check_property([] {
    const auto pair = TestFixture::draw_two();
    const auto motion = [](const auto& shape) {
      auto result = shape;
      for_each_vector<TestFixture::N, typename TestFixture::T>(result, [](auto& v) {
        std::swap(v[0], v[1]);
        v[0] = -v[0];
      });
      return result;
    };
    TestFixture::expect_same(pair, {motion(pair.first), motion(pair.second)});
  });
}

TYPED_TEST(RelationLaw, ExactTranslationsChangeNothingBeyondRounding) {
  check_property([] {
    constexpr Dim dimension = TypeParam::dimension;
    using Number = typename TypeParam::scalar;
    // Small integers stay exact, however far they are moved by integers.
    const Source<dimension, Number> source = source_of<dimension, Number>(Kind::grid);
    const auto any = any_shape_from<dimension, Number>(source);
    const auto first = *any;
    const AnyPair<dimension, Number> pair(first, *any);
    const Vec<dimension, Number> offset = *source.point * Number(1024);
    TestFixture::expect_same(
        pair, {moved<dimension, Number>(pair.first, offset), moved<dimension, Number>(pair.second, offset)});
  });
}

TYPED_TEST(RelationLaw, ACompoundIsItsClosestPart) {
  check_property([] {
    constexpr Dim dimension = TypeParam::dimension;
    using Number = typename TypeParam::scalar;
    const auto [a, b] = TestFixture::draw_two();
    const auto c = *any_shape<dimension, Number>();
    const AnyShape<dimension, Number> both = compound_of<dimension, Number>({a, b});
    RC_ASSERT(TestFixture::of({both, c}) == std::max(TestFixture::of({a, c}), TestFixture::of({b, c})));
  });
}

// ---- Invalid input

TYPED_TEST(RelationLaw, NanTouchesNothing) {
  constexpr Dim dimension = TypeParam::dimension;
  using Number = typename TypeParam::scalar;
  for (std::size_t a = 0; a < row_types; ++a) {
    for (std::size_t b = 0; b < row_types; ++b) {
      auto broken = row_shape<dimension, Number>(a, Number(1));
      const auto other = row_shape<dimension, Number>(b, Number(-1));
      for_each_number<dimension, Number>(broken, [&](Number& x) {
        const Number before = std::exchange(x, std::numeric_limits<Number>::quiet_NaN());
        EXPECT_EQ(name_of(TestFixture::of({broken, other})), "apart")
            << shape_type_names[a] << ", " << shape_type_names[b];
        EXPECT_EQ(name_of(TestFixture::of({other, broken})), "apart")
            << shape_type_names[a] << ", " << shape_type_names[b];
        x = before;
      });
    }
  }
}

TYPED_TEST(RelationLaw, InfinitiesAndExtremesGetAVerdict) {
  constexpr Dim dimension = TypeParam::dimension;
  using Number = typename TypeParam::scalar;
  using Limits = std::numeric_limits<Number>;
  const std::array values = {Limits::infinity(), -Limits::infinity(),  Limits::max(),         Limits::lowest(),
                             Limits::min(),      Limits::denorm_min(), -Limits::denorm_min(), Number(0),
                             Number(-1),         Number(1e30),         Number(-1e-30)};
  // Valid shapes within the guaranteed range satisfy the symmetry law, too.
  const auto is_promised = [](const auto& shape, Number value) {
    const double size = std::fabs(static_cast<double>(value));
    return is_valid(shape) && (size == 0 || (size >= 1e-140 && size <= 1e140));
  };
  for (std::size_t a = 0; a < row_types; ++a) {
    for (std::size_t b = 0; b < row_types; ++b) {
      auto extreme = row_shape<dimension, Number>(a, Number(1));
      const auto other = row_shape<dimension, Number>(b, Number(-1));
      for_each_number<dimension, Number>(extreme, [&](Number& x) {
        const Number before = x;
        for (const Number value : values) {
          x = value;
          const Relation one = TestFixture::of({extreme, other});
          const Relation two = TestFixture::of({other, extreme});
          if (!is_promised(extreme, value)) continue;
          EXPECT_EQ(name_of(one), name_of(two))
              << value << " in " << shape_type_names[a] << ", " << shape_type_names[b];
        }
        x = before;
      });
    }
  }
}

}  // namespace
}  // namespace graze::test::relation_laws_test
