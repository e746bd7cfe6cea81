// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include <graze/broad/bvh/node.hpp>

namespace graze::detail::bvh_node_test {
namespace {

TEST(BvhLink, TellsLeafNodesFromOthersByTheirCode) {
  EXPECT_TRUE(BvhLink().is_none());
  for (const std::uint32_t index : {0U, 1U, 77U, bvh_most / 5}) {
    for (const BvhLink link : {BvhLink::inner(index), BvhLink::leaf(index)}) {
      EXPECT_FALSE(link.is_none());
      EXPECT_EQ(link.index(), index);
      EXPECT_EQ(BvhLink::of_code(link.code()), link);
    }
    EXPECT_TRUE(BvhLink::leaf(index).is_leaf());
    EXPECT_FALSE(BvhLink::inner(index).is_leaf());
  }
}

TEST(BvhNode, KeepsBoxesInLanes) {
  BvhNode<2, float> node;
  clear_lanes(node, 0);
  const Aabb<2> box{{1, 2}, {3, 4}};
  put_box(node.boxes, 5, box);
  node.entries[5] = 9;
  EXPECT_EQ(box_in(node.boxes, 5), box);
  EXPECT_TRUE(std::isnan(box_in(node.boxes, 4).min[0]) && std::isnan(box_in(node.boxes, 6).max[1]));
  clear_lane(node, 5);
  EXPECT_TRUE(std::isnan(box_in(node.boxes, 5).min[1]));
  EXPECT_EQ(node.entries[5], no_box);
}

TEST(BvhNode, GrownBoxesContainTheBoxAndStayFinite) {
  EXPECT_EQ(grown_by(Aabb<2>{{1, 2}, {3, 4}}, 0.5), (Aabb<2>{{0.5F, 1.5F}, {3.5F, 4.5F}}));
  EXPECT_EQ(grown_by(Aabb<2>{{1, 2}, {3, 4}}, 0), (Aabb<2>{{1, 2}, {3, 4}}));
  EXPECT_EQ(grown_by(Aabb<2>{{1, 1}, {3, 3}}, 1e-30), (Aabb<2>{{1, 1}, {3, 3}}));
  constexpr float most = std::numeric_limits<float>::max();
  EXPECT_EQ(grown_by(Aabb<2>{{1, -most}, {3, most}}, 1e300), (Aabb<2>{{-most, -most}, {most, most}}));
  constexpr double largest = std::numeric_limits<double>::max();
  EXPECT_EQ(grown_by(Aabb<2, double>{{0, 0}, {1, 1}}, largest).max, (Vec<2, double>(largest, largest)));
}

/// The tallest tree has a root with two entries and six in each node below.
TEST(BvhNode, AsManyBoxesAsThereMayBeDoNotMakeATallerTree) {
  std::size_t height = 1;
  for (std::uint64_t boxes = 2; boxes * bvh_least <= bvh_most; boxes *= bvh_least) ++height;
  EXPECT_EQ(height, bvh_height_limit);
}

}  // namespace
}  // namespace graze::detail::bvh_node_test
