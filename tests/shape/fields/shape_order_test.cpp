// SPDX-License-Identifier: MIT
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/bounds.hpp>
#include <graze/shape/fields/shape_order.hpp>

#include "catalogue.hpp"
#include "query/row_of_shapes.hpp"

namespace graze::test::shape_order_test {
namespace {

using detail::compare;
using Any = AnyShape<2, float>;

TEST(ShapeOrder, GoesByTheFirstFieldThatDiffers) {
  const Segment<2, float> segment{{1, 2}, {3, 4}};
  EXPECT_EQ(compare(segment, segment), 0);
  EXPECT_EQ(compare(segment, Segment<2, float>{{1, 2}, {3, 5}}), -1);
  EXPECT_EQ(compare(segment, Segment<2, float>{{0, 2}, {9, 9}}), 1);
  EXPECT_EQ(compare(Sphere<2, float>{{1, 2}, 3}, Sphere<2, float>{{1, 2}, 4}), -1);
  EXPECT_EQ(compare(Obb<2, float>{}, Obb<2, float>{{0, 0}, {1, 1}, {{0, 1}, {-1, 0}}}), 1);
}

// The order of two stacked or adjacent shapes does not depend on rounding along another axis.
TEST(ShapeOrder, OfPlacesStaysWhereTheyAreNudged) {
  using V = Vec<3, double>;
  const V place(3, 5, 7);
  for (const V& way : {V(0, 0, 2), V(0, 2, 0), V(2, 0, 0), V(0, 1, -1), V(1, -1, 0), V(1, -1, -1), V(2, -1, -1)}) {
    for (Dim i = 0; i < 3; ++i) {
      for (const double nudge : {1e-3, -1e-3}) {
        const V nudged = place + way + unit_axis<3>(i) * nudge;
        EXPECT_EQ((compare<3, double>(place, nudged)), (compare<3, double>(place, place + way))) << way << ", " << i;
      }
    }
  }
}

TEST(ShapeOrder, TellsPlacesApartThatAreAsFarAlong) {
  using V = Vec<2, double>;
  EXPECT_EQ((compare<2, double>(V(0, 0), V(58, -97))), (-compare<2, double>(V(58, -97), V(0, 0))));
  EXPECT_NE((compare<2, double>(V(0, 0), V(58, -97))), 0);
  const double most = std::numeric_limits<double>::max();
  EXPECT_EQ((compare<2, double>(V(-most, most), V(most, -most))), -1);
  EXPECT_EQ((compare<2, double>(V(most, -most), V(-most, most))), 1);
}

TEST(ShapeOrder, GoesByThePlaceInAnyShapeForDifferentTypes) {
  for (std::size_t a = 0; a < row_types; ++a) {
    for (std::size_t b = 0; b < row_types; ++b) {
      const int expected = a < b ? -1 : a > b ? 1 : 0;
      EXPECT_EQ(compare(row_shape<2, float>(a, 1.0F), row_shape<2, float>(b, 1.0F)), expected) << a << ", " << b;
    }
  }
}

TEST(ShapeOrder, PutsFewerVerticesAndPartsFirst) {
  const auto hull = [](std::vector<Vec<2, float>> points) { return convex_hull<2, float>(points); };
  EXPECT_EQ(compare(hull({{5, 5}, {6, 6}}), hull({{0, 0}, {1, 0}, {0, 1}})), -1);
  EXPECT_EQ(compare(hull({{0, 0}, {1, 0}, {0, 1}}), hull({{0, 0}, {1, 0}, {0, 2}})), -1);
  const Any sphere = Sphere<2, float>{};
  const Any box = Aabb<2, float>{};
  const auto one = compound_of<2, float>({box});
  const auto two = compound_of<2, float>({sphere, box});
  EXPECT_EQ(compare(one, two), -1);
  EXPECT_EQ(compare(two, compound_of<2, float>({box, sphere})), -1);
  EXPECT_EQ(compare(two, two), 0);
  EXPECT_EQ(compare(compound_of<2, float>({Any(one)}), compound_of<2, float>({Any(two)})), -1);
}

TEST(ShapeOrder, IsReversedByExchangingTheShapes) {
  check_property([] {
    const auto [a, b] = *any_pair<AnyShape<3, double>, AnyShape<3, double>>();
    RC_ASSERT((compare<3, double>(a, b)) == -(compare<3, double>(b, a)));
    RC_ASSERT((compare<3, double>(a, a)) == 0);
  });
}

}  // namespace
}  // namespace graze::test::shape_order_test
