// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/fast_contact/oriented_box.hpp>

namespace graze::detail::oriented_box_test {
namespace {

using V3 = Vec<3, double>;

TEST(OrientedBox, FromABoxAlongTheAxesIsExactNearItsOwnSize) {
  const Aabb<3, double> box{{1e8 + 1, -3, 0.25}, {1e8 + 4, 5, 0.5}};
  const Obb<3, double> seen = oriented_box_from(V3(1e8, 1, 0), box);
  EXPECT_EQ(seen.center, V3(2.5, 0, 0.375));
  EXPECT_EQ(seen.half_extents, V3(1.5, 4, 0.125));
  EXPECT_EQ(seen.axes, (Mat<3, double>(1.0)));
}

TEST(OrientedBox, FromAnOrientedOneIsThatSeenFromElsewhere) {
  const Obb<3, float> box{{3, 4, 5}, {1, 2, 3}, Mat<3, float>(rotation_matrix(V3(0, 1, 0), 90))};
  const Obb<3, double> seen = oriented_box_from(V3(1, 1, 1), box);
  EXPECT_EQ(seen.center, V3(2, 3, 4));
  EXPECT_EQ(seen.half_extents, V3(1, 2, 3));
  EXPECT_EQ(seen.axes, (wide_matrix<3, float>(box.axes)));
}

}  // namespace
}  // namespace graze::detail::oriented_box_test
