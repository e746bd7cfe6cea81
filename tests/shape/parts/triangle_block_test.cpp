// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/shape/parts/triangle_block.hpp>

#include "catalogue.hpp"

namespace graze::test::triangle_block_test {
namespace {

template <class SpaceType>
class TriangleBlockIn : public ::testing::Test {
 public:
  static constexpr Dim dimension = SpaceType::dimension;
  using Number = typename SpaceType::scalar;

  static Triangle<dimension, Number> draw_triangle(std::mt19937& random, Number size) {
    std::uniform_real_distribution<double> anywhere(-1, 1);
    Triangle<dimension, Number> triangle;
    for (Vec<dimension, Number>* const corner : {&triangle.a, &triangle.b, &triangle.c}) {
      for (Dim i = 0; i < dimension; ++i) (*corner)[i] = size * static_cast<Number>(anywhere(random));
    }
    return triangle;
  }

  static detail::TriangleBlock<dimension, Number> draw_block(std::mt19937& random, Number size) {
    detail::TriangleBlock<dimension, Number> block;
    for (std::size_t lane = 0; lane < detail::row_length; ++lane) block.set(lane, draw_triangle(random, size));
    return block;
  }
};
TYPED_TEST_SUITE(TriangleBlockIn, Spaces);

TYPED_TEST(TriangleBlockIn, KeepsTriangles) {
  std::mt19937 random(1);
  auto block = TestFixture::draw_block(random, 1);
  for (std::size_t lane = 0; lane < detail::row_length; ++lane) {
    const auto triangle = TestFixture::draw_triangle(random, 1);
    block.set(lane, triangle);
    EXPECT_EQ(block.triangle(lane).vertices(), triangle.vertices());
  }
}

// The boxes contain those that scalar code grows, and are larger by rounding only; numbers near zero included.
TYPED_TEST(TriangleBlockIn, HasBoxesAroundTheGrownOnes) {
  using T = typename TypeParam::scalar;
  std::mt19937 random(2);
  for (const T size : {T(1), T(1e5), T(1e-30), std::numeric_limits<T>::denorm_min()}) {
    for (int round = 0; round < 100; ++round) {
      const auto block = TestFixture::draw_block(random, size);
      detail::BoxBlock<TypeParam::dimension, T> boxes;
      detail::set_boxes_around(block, boxes);
      const T most = 4 * std::numeric_limits<T>::epsilon() + 4 * static_cast<T>(tolerance::box_slack);
      for (std::size_t lane = 0; lane < detail::row_length; ++lane) {
        const auto grown = detail::grown_box_of(block.triangle(lane));
        const auto box = boxes.box(lane);
        for (Dim i = 0; i < TypeParam::dimension; ++i) {
          EXPECT_LE(box.min[i], grown.min[i]);
          EXPECT_GE(box.max[i], grown.max[i]);
          EXPECT_LE(box.max[i] - grown.max[i], most * size + 4 * std::numeric_limits<T>::denorm_min());
        }
      }
    }
  }
}

#ifdef GRAZE_HAS_LANES

TYPED_TEST(TriangleBlockIn, IsMovedUpToTheSlackOfThePlace) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  std::mt19937 random(3);
  for (int round = 0; round < 200; ++round) {
    const auto block = TestFixture::draw_block(random, T(10));
    Pose<N, T> pose{Mat<N, T>(T(1)), TestFixture::draw_triangle(random, T(1000)).a};
    const T angle = TestFixture::draw_triangle(random, T(4)).a[0];
    pose.rotation[0][0] = pose.rotation[1][1] = std::cos(angle);
    pose.rotation[0][1] = std::sin(angle);
    pose.rotation[1][0] = -std::sin(angle);
    const Aabb<N, T> around{Vec<N, T>(T(-10)), Vec<N, T>(T(10))};
    const detail::LanePlace<N, T> place = detail::lane_place<N, T>(pose.rotation, pose.position, around);
    EXPECT_LT(place.slack, T(5e6) * std::numeric_limits<T>::epsilon());
    detail::TriangleBlock<N, T> placed;
    detail::place_triangles(block, place, placed);
    for (std::size_t lane = 0; lane < detail::row_length; ++lane) {
      const Vec<N, double> corner = wide<N, T>(block.triangle(lane).c);
      const Vec<N, double> there = wide_matrix<N, T>(pose.rotation) * corner + wide<N, T>(pose.position);
      EXPECT_LE(max_abs(wide<N, T>(placed.triangle(lane).c) - there), static_cast<double>(place.slack) / 4);
    }
  }
}

#endif

}  // namespace
}  // namespace graze::test::triangle_block_test
