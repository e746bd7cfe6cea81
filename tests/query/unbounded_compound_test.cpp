// SPDX-License-Identifier: MIT
// Queries that skip parts of compounds by their boxes, if the box of the whole does not show how large the coordinates
// of a part are: the answer is that of the parts, in both orders.
#include "../unbounded_compound.hpp"

#include <algorithm>
#include <cstddef>
#include <type_traits>

#include <gtest/gtest.h>

#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/transformed.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "query/contacts.hpp"
#include "query/manifolds.hpp"
#include "query/pairs.hpp"
#include "query/point_answers.hpp"
#include "query/proximities.hpp"
#include "query/shape_casts.hpp"

namespace graze::test::unbounded_compound_test {
namespace {

template <class SpaceType>
class UnboundedCompound : public ::testing::Test {
 public:
  static constexpr Dim N = SpaceType::dimension;
  using T = typename SpaceType::scalar;
  using Any = AnyShape<N, T>;

  static Any ray() { return along_x<N, T>(); }

  /// Calls check(far, a, b) for each far shape: a is the shape and a plane, b the ray that it touches by rounding, each
  /// also as a nested part.
  static void for_each_case(const auto& check) {
    const Any ray_alone = compound_of<N, T>({ray()});
    for (const Any& far : far_shapes<N, T>()) {
      SCOPED_TRACE((to_source<N, T>(far)));
      const Any beside = beside_a_plane<N, T>(far);
      const Any nested = compound_of<N, T>({beside});
      const Any deep = compound_of<N, T>({nested, Compound<N, T>{}});
      for (const Any& a : {beside, nested, deep}) {
        for (const Any& b : {ray(), ray_alone, Any(compound_of<N, T>({ray_alone}))}) check(far, a, b);
      }
    }
  }

  static void expect_touch(const Any& far, const Any& a, const Any& b) {
    ASSERT_EQ((relation_of<N, T>(far, ray())), Relation::touching);
    EXPECT_EQ((relation_of<N, T>(a, b)), Relation::touching);
    EXPECT_EQ((relation_of<N, T>(b, a)), Relation::touching);
    EXPECT_EQ((closest_points_of<N, T>(a, b).relation), Relation::touching);
    EXPECT_EQ((closest_points_of<N, T>(b, a).relation), Relation::touching);
    EXPECT_EQ((distance_of<N, T>(a, b)), (distance_of<N, T>(far, ray())));
  }

  static void expect_contact(const Any& far, const Any& a, const Any& b) {
    const auto contact = contact_of<N, T>(far, ray());
    ASSERT_TRUE(contact.has_value());
    const auto there = contact_of<N, T>(a, b);
    const auto back = contact_of<N, T>(b, a);
    ASSERT_TRUE(there.has_value() && back.has_value());
    EXPECT_EQ(there->depth, contact->depth);
    EXPECT_EQ(back->depth, contact->depth);
    const std::size_t size = manifold_of<N, T>(far, ray()).size;
    EXPECT_EQ((manifold_of<N, T>(a, b).size), size);
    EXPECT_EQ((manifold_of<N, T>(b, a).size), size);
  }

  static void expect_points_held() {
    const double off = std::is_same_v<T, float> ? 1e26 : 1e17;
    const auto at = [off](double x, double y) { return in_plane<N, T>(x, y * off); };
    const Vec<N, T> origin = at(0, 0);
    for (const Any& wide :
         {Any(Segment<N, T>{at(-1e33, 1), at(1e33, 1)}), Any(Capsule<N, T>{at(-1e33, 1), at(1e33, 2), T(1)}),
          Any(Triangle<N, T>{at(-1e33, 1), at(1e33, 1), at(1e33, 2)})}) {
      SCOPED_TRACE((to_source<N, T>(wide)));
      ASSERT_TRUE((answers<N, T>(wide, origin).contained));
      const Any beside = compound_of<N, T>({wide, Plane<N, T>{in_plane<N, T>(0, 1), static_cast<T>(3 * off)}});
      const Any near = at(0, -0.125);
      const Any nested = compound_of<N, T>({near, beside});
      EXPECT_TRUE((answers<N, T>(nested, origin).contained));
      EXPECT_EQ((answers<N, T>(nested, origin).distance),
                std::min((answers<N, T>(near, origin).distance), (answers<N, T>(beside, origin).distance)));
    }
  }

  static void expect_impact(const Any& far, const Any& a, const Any& b) {
    const Vec<N, T> way = in_plane<N, T>(0, 1e20);
    const Any start = translated<N, T>(b, -way);
    const auto impact = impact_of<N, T>(translated<N, T>(ray(), -way), way, far);
    ASSERT_TRUE(impact.has_value());
    const auto there = impact_of<N, T>(start, way, a);
    const auto back = impact_of<N, T>(a, -way, start);
    ASSERT_TRUE(there.has_value() && back.has_value());
    EXPECT_EQ(there->t, impact->t);
    EXPECT_EQ(back->t, impact->t);
  }
};
TYPED_TEST_SUITE(UnboundedCompound, Spaces);

// The point must be within the rounding error of a part of that size: from x = -1e33 to 1e33, past the origin.
TYPED_TEST(UnboundedCompound, HoldsThePointsThatAPartOfPartsHolds) { TestFixture::expect_points_held(); }

TYPED_TEST(UnboundedCompound, TouchesWhatAFarPartTouches) { TestFixture::for_each_case(TestFixture::expect_touch); }

TYPED_TEST(UnboundedCompound, HasTheContactsOfAFarPart) { TestFixture::for_each_case(TestFixture::expect_contact); }

TYPED_TEST(UnboundedCompound, IsHitWhereAFarPartIs) { TestFixture::for_each_case(TestFixture::expect_impact); }

}  // namespace
}  // namespace graze::test::unbounded_compound_test
