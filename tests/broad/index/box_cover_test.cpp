// SPDX-License-Identifier: MIT
#include <limits>

#include <gtest/gtest.h>

#include <graze/broad/index/box_cover.hpp>
#include <graze/shape/shape.hpp>

namespace graze::detail::box_cover_test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

TEST(BoxCover, CoversWhatTouchesItsSidesFromWithin) {
  const Aabb<2> square{{0, 0}, {4, 4}};
  EXPECT_TRUE(covers(square, square));
  EXPECT_TRUE(covers(square, Aabb<2>{{0, 1}, {1, 4}}));
  EXPECT_FALSE(covers(square, Aabb<2>{{0, 1}, {1, 4.0001F}}));
  EXPECT_FALSE(covers(square, Aabb<2>{{-1, 1}, {1, 2}}));
  EXPECT_TRUE(covers(square, Aabb<2>::nothing()));
  EXPECT_TRUE(covers(Aabb<2>::everything(), Aabb<2>{{-infinity, 0}, {0, 1}}));
}

TEST(BoxCover, TellsFiniteBoxesAsIsValidDoes) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float most = std::numeric_limits<float>::max();
  for (const float low : {-infinity, -most, -1.0F, 0.0F, 1.0F, most, infinity, nan}) {
    for (const float high : {-infinity, -most, -1.0F, 0.0F, 1.0F, most, infinity, nan}) {
      const Aabb<2> box{{0, low}, {1, high}};
      EXPECT_EQ(is_finite_box(box), is_valid(box)) << low << " to " << high;
    }
  }
}

TEST(BoxCover, GrowsToTheLeastBoxAround) {
  EXPECT_EQ(box_around(Aabb<2>{{0, 0}, {1, 1}}, Aabb<2>{{-2, 0.5F}, {0, 3}}), (Aabb<2>{{-2, 0}, {1, 3}}));
  EXPECT_EQ(box_around(Aabb<2>::nothing(), Aabb<2>{{5, 6}, {7, 8}}), (Aabb<2>{{5, 6}, {7, 8}}));
}

TEST(BoxCover, MeasuresHalfTheSurface) {
  EXPECT_EQ(surface_of(Aabb<2>{{1, 1}, {3, 6}}), 2 + 5);
  EXPECT_EQ(surface_of(Aabb<3>{{0, 0, 0}, {2, 3, 5}}), 6 + 15 + 10);
  EXPECT_EQ(surface_of(Aabb<3>{{0, 0, 0}, {2, 3, 0}}), 6);
  EXPECT_EQ(surface_of(Aabb<3>{{-1e38F, 0, 0}, {1e38F, 1, 0}}), 2 * static_cast<double>(1e38F));
}

}  // namespace
}  // namespace graze::detail::box_cover_test
