// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <graze/query/scaling/wide_manifold.hpp>

namespace graze::detail::wide_manifold_test {
namespace {

using V = Vec<3, double>;

WideManifold<3> of_one_point() {
  Penetration<3> found;
  found.depth = 2;
  found.normal = {0, 0, 1};
  found.point_a = {1, 2, 3};
  found.point_b = {1, 2, 1};
  return manifold_of_one_point(found);
}

TEST(WideManifold, OfOnePointHasTheContactsPoints) {
  const WideManifold<3> manifold = of_one_point();
  ASSERT_EQ(manifold.size, 1U);
  EXPECT_EQ(manifold.pairs[0].point_a, (V{1, 2, 3}));
  EXPECT_EQ(manifold.pairs[0].point_b, (V{1, 2, 1}));
  EXPECT_EQ(manifold.pairs[0].depth, 2);
}

TEST(WideManifold, IsExchangedWithItsPartsAndTwiceIsItself) {
  WideManifold<3> manifold = of_one_point();
  manifold.part_a = 7;
  exchange(manifold);
  EXPECT_EQ(manifold.found.normal, (V{0, 0, -1}));
  EXPECT_EQ(manifold.pairs[0].point_a, (V{1, 2, 1}));
  EXPECT_EQ(manifold.part_a, 0U);
  EXPECT_EQ(manifold.part_b, 7U);
  exchange(manifold);
  EXPECT_EQ(manifold.found.normal, (V{0, 0, 1}));
  EXPECT_EQ(manifold.pairs[0].point_a, (V{1, 2, 3}));
  EXPECT_EQ(manifold.part_a, 7U);
}

TEST(WideManifold, IsResizedInAllItsLengths) {
  WideManifold<3> manifold = of_one_point();
  resize(manifold, PowerOfTwo(3));
  EXPECT_EQ(manifold.found.depth, 16);
  EXPECT_EQ(manifold.found.normal, (V{0, 0, 1}));
  EXPECT_EQ(manifold.pairs[0].point_a, (V{8, 16, 24}));
  EXPECT_EQ(manifold.pairs[0].depth, 16);
}

TEST(WideManifold, KeepsFourPointsOfMoreAndMovesThem) {
  WideManifold<3> manifold = of_one_point();
  SurfacePairs<3> pairs;
  for (const V& corner : {V{0, 0, 0}, V{4, 0, 0}, V{4, 4, 0}, V{2, 2, 0}, V{0, 4, 0}}) {
    pairs.push_back({corner, corner, 0, {}, {}});
  }
  choose_points(pairs, manifold);
  move_points(manifold, V{1, 1, 1});
  ASSERT_EQ(manifold.size, 4U);
  EXPECT_EQ(manifold.pairs[0].point_a, (V{1, 1, 1}));
  EXPECT_EQ(manifold.pairs[3].point_b, (V{1, 5, 1}));
}

}  // namespace
}  // namespace graze::detail::wide_manifold_test
