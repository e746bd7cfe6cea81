// SPDX-License-Identifier: MIT
// Sixteen boxes at a time give what exact scalar code gives, or lean to the safe side by little.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/math/rounding.hpp>
#include <graze/shape/parts/box_block.hpp>

#include "catalogue.hpp"

namespace graze::test::box_block_test {
namespace {

template <class SpaceType>
class BoxBlockIn : public ::testing::Test {
 public:
  static constexpr Dim dimension = SpaceType::dimension;
  using Number = typename SpaceType::scalar;
  using Box = Aabb<dimension, Number>;
  using Block = detail::BoxBlock<dimension, Number>;

  /// On a coarse grid every other time, so that sides are often equal.
  static Vec<dimension, Number> draw_point(std::mt19937& random) {
    std::uniform_real_distribution<double> anywhere(-10, 10);
    Vec<dimension, Number> point;
    const bool is_on_grid = random() % 2 == 0;
    for (Dim i = 0; i < dimension; ++i) {
      const double coordinate = anywhere(random);
      point[i] = static_cast<Number>(is_on_grid ? std::round(coordinate) : coordinate);
    }
    return point;
  }
  static Box draw_box(std::mt19937& random) {
    Box box = Box::nothing();
    box.grow(draw_point(random));
    box.grow(draw_point(random));
    return box;
  }
  static Block draw_block(std::mt19937& random) {
    Block block = Block::nothing();
    for (std::size_t lane = 0; lane < detail::row_length; ++lane) block.set(lane, draw_box(random));
    return block;
  }

  static double exact_squared_distance(const Box& a, const Box& b) {
    double sum = 0;
    for (Dim i = 0; i < dimension; ++i) {
      const double gap = std::max({0.0, static_cast<double>(a.min[i]) - static_cast<double>(b.max[i]),
                                   static_cast<double>(b.min[i]) - static_cast<double>(a.max[i])});
      sum += gap * gap;
    }
    return sum;
  }

  static void expect_boxes() {
    std::mt19937 random(1);
    const Block nothing = Block::nothing();
    EXPECT_EQ(nothing.box(7), Box::nothing());
    EXPECT_EQ(nothing.around(), Box::nothing());
    Block block = Block::nothing();
    Box around = Box::nothing();
    for (std::size_t lane = 0; lane < 13; ++lane) {
      const Box box = draw_box(random);
      block.set(lane, box);
      around.grow(box);
      EXPECT_EQ(block.box(lane), box);
    }
    EXPECT_EQ(block.around(), around);
  }

  static void expect_overlaps() {
    std::mt19937 random(2);
    for (int round = 0; round < 500; ++round) {
      const Block block = draw_block(random);
      const Box box = draw_box(random);
      const detail::LaneMask lanes = detail::lanes_that_overlap(block, box);
      for (std::size_t lane = 0; lane < detail::row_length; ++lane) {
        EXPECT_EQ((lanes >> lane & 1U) != 0, boxes_overlap(block.box(lane), box));
      }
    }
  }

  static void expect_distances() {
    std::mt19937 random(3);
    for (int round = 0; round < 500; ++round) {
      const Block block = draw_block(random);
      const Box box = draw_box(random);
      const Number most = static_cast<Number>(random() % 60);
      alignas(64) detail::Row<Number> squared;
      const detail::LaneMask lanes = detail::squared_distances(block, box, most, squared);
      for (std::size_t lane = 0; lane < detail::row_length; ++lane) {
        const double exact = exact_squared_distance(block.box(lane), box);
        EXPECT_LE(static_cast<double>(squared[lane]), exact);
        EXPECT_GE(static_cast<double>(squared[lane]), exact * (1 - 32 * std::numeric_limits<Number>::epsilon()));
        EXPECT_EQ((lanes >> lane & 1U) != 0, squared[lane] <= most);
      }
    }
  }

  static void expect_no_overflow() {
    Block block = Block::nothing();
    const Number far = std::numeric_limits<Number>::max() / 4;
    block.set(0, {Vec<dimension, Number>(far), Vec<dimension, Number>(far)});
    alignas(64) detail::Row<Number> squared;
    detail::squared_distances(block, Box{Vec<dimension, Number>(-far), Vec<dimension, Number>(-far)}, Number(1),
                              squared);
    EXPECT_EQ(squared[0], std::numeric_limits<Number>::max());
  }
};
TYPED_TEST_SUITE(BoxBlockIn, Spaces);

TYPED_TEST(BoxBlockIn, KeepsBoxesAndTheBoxAroundThem) { TestFixture::expect_boxes(); }
TYPED_TEST(BoxBlockIn, OverlapsWhereTheBoxesDo) { TestFixture::expect_overlaps(); }
TYPED_TEST(BoxBlockIn, IsAtMostAsFarAsTheBoxes) { TestFixture::expect_distances(); }
TYPED_TEST(BoxBlockIn, HasFiniteDistances) { TestFixture::expect_no_overflow(); }

#ifdef GRAZE_HAS_LANES

/// A path in double, its sides chosen by its direction, without slack.
template <Dim N, class T>
detail::LanePath<N, T> path_of(const Vec<N, T>& origin, const Vec<N, T>& direction) {
  detail::LanePath<N, T> path{origin, {}, Vec<N, T>(T(64) * std::numeric_limits<T>::epsilon()), {}, {}};
  for (Dim i = 0; i < N; ++i) {
    path.inverse[i] = 1 / direction[i];
    path.slack[i] *= 20 * std::fabs(path.inverse[i]);
    const auto k = static_cast<std::size_t>(i);
    path.near[k] = direction[i] < 0 ? k + static_cast<std::size_t>(N) : k;
    path.far[k] = direction[i] < 0 ? k : k + static_cast<std::size_t>(N);
  }
  return path;
}

TYPED_TEST(BoxBlockIn, IsEnteredWhereAPathMeetsABox) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  std::mt19937 random(4);
  std::size_t entered = 0;
  for (int round = 0; round < 500; ++round) {
    const auto block = TestFixture::draw_block(random);
    const Vec<N, T> origin = TestFixture::draw_point(random);
    Vec<N, T> direction = TestFixture::draw_point(random);
    for (Dim i = 0; i < N; ++i) direction[i] += direction[i] == 0 ? T(1) : T(0);
    alignas(64) detail::Row<T> entries;
    const detail::LaneMask lanes = detail::entered_lanes(block, path_of<N, T>(origin, direction), T(1), entries);
    for (std::size_t lane = 0; lane < detail::row_length; ++lane) {
      const Aabb<N, T> box = block.box(lane);
      double enter = 0;
      double leave = 1;
      for (Dim i = 0; i < N; ++i) {
        const double to_min =
            (static_cast<double>(box.min[i]) - static_cast<double>(origin[i])) / static_cast<double>(direction[i]);
        const double to_max =
            (static_cast<double>(box.max[i]) - static_cast<double>(origin[i])) / static_cast<double>(direction[i]);
        enter = std::max(enter, std::min(to_min, to_max));
        leave = std::min(leave, std::max(to_min, to_max));
      }
      const bool is_entered = (lanes >> lane & 1U) != 0;
      if (enter <= leave) {
        EXPECT_TRUE(is_entered);
        EXPECT_LE(static_cast<double>(entries[lane]), enter);
        ++entered;
      }
      if (enter > leave + 0.01 * (1 + std::fabs(leave))) {
        EXPECT_FALSE(is_entered);
      }
    }
  }
  EXPECT_GT(entered, 100U);
}

TYPED_TEST(BoxBlockIn, ContainsItsBoxesAtAnotherPlace) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  std::mt19937 random(5);
  for (int round = 0; round < 300; ++round) {
    const auto block = TestFixture::draw_block(random);
    const Vec<N, T> by = TestFixture::draw_point(random);
    Pose<N, T> pose{Mat<N, T>(T(1)), by};
    const T angle = TestFixture::draw_point(random)[0];
    pose.rotation[0][0] = pose.rotation[1][1] = std::cos(angle);
    pose.rotation[0][1] = std::sin(angle);
    pose.rotation[1][0] = -std::sin(angle);
    detail::BoxBlock<N, T> placed;
    detail::place_lanes(block, detail::lane_place<N, T>(pose.rotation, pose.position, block.around()), placed);
    for (std::size_t lane = 0; lane < detail::row_length; ++lane) {
      const Aabb<N, T> box = block.box(lane);
      const Aabb<N, T> moved = placed.box(lane);
      Vec<N, T> corner;
      for (Dim i = 0; i < N; ++i) corner[i] = random() % 2 == 0 ? box.min[i] : box.max[i];
      const Vec<N, double> there = wide_matrix<N, T>(pose.rotation) * wide<N, T>(corner) + wide<N, T>(pose.position);
      for (Dim i = 0; i < N; ++i) {
        EXPECT_LE(static_cast<double>(moved.min[i]), there[i]);
        EXPECT_GE(static_cast<double>(moved.max[i]), there[i]);
        EXPECT_LE(static_cast<double>(moved.max[i] - moved.min[i]),
                  2.01 * static_cast<double>(sum_abs(box.max - box.min)) + 0.01);
      }
    }
  }
}

#endif

}  // namespace
}  // namespace graze::test::box_block_test
