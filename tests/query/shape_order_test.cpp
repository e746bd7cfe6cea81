// SPDX-License-Identifier: MIT
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/bounds.hpp>
#include <graze/query/shape_order.hpp>

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
  EXPECT_EQ(compare(segment, Segment<2, float>{{0, 9}, {9, 9}}), 1);
  EXPECT_EQ(compare(Sphere<2, float>{{1, 2}, 3}, Sphere<2, float>{{1, 2}, 4}), -1);
  EXPECT_EQ(compare(Obb<2, float>{}, Obb<2, float>{{0, 0}, {1, 1}, {{0, 1}, {-1, 0}}}), 1);
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
