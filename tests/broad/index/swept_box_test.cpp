// SPDX-License-Identifier: MIT
// When boxes move into others: hand-computed, compared with many positions along the path, and with boxes around them.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include <graze/broad/index/swept_box.hpp>
#include <graze/math/motion.hpp>

#include "spaces.hpp"

namespace graze::detail::swept_box_test {
namespace {

using Box = Aabb<2, double>;
using Path = SweptBox<2>;
using V2 = Vec<2, double>;

constexpr double infinity = std::numeric_limits<double>::infinity();
const Box unit{{0, 0}, {1, 1}};

void expect_entry(const std::optional<double>& found, double expected) {
  ASSERT_TRUE(found);
  EXPECT_LE(*found, expected);
  EXPECT_NEAR(*found, expected, 1e-12);
}

TEST(SweptBox, EntersWhereTheFirstSidesMeet) {
  expect_entry(Path(unit, {4, 0}).entry(Box{{3, 0}, {5, 1}}), 0.5);
  expect_entry(Path(unit, {-4, 0}).entry(Box{{-3, 0}, {-1, 1}}), 0.25);
  expect_entry(Path(unit, {4, 2}).entry(Box{{2, 2}, {5, 9}}), 0.5);    // y decides
  expect_entry(Path(unit, {4, 0}).entry(Box{{0.5, 0.5}, {9, 9}}), 0);  // from the start
  expect_entry(Path(unit, {4, 0}).entry(Box{{5, 1}, {9, 9}}), 1);      // a corner, at the end
  expect_entry(Path(unit, {4, 0}).entry(Box{{-1, -1}, {0, 0}}), 0);    // a corner, at the start
  EXPECT_FALSE(Path(unit, {4, 0}).entry(Box{{5.1, 0}, {9, 9}}));       // too far
  EXPECT_FALSE(Path(unit, {4, 0}).entry(Box{{-3, 0}, {-0.1, 9}}));     // behind
  EXPECT_FALSE(Path(unit, {4, 0}).entry(Box{{2, 1.1}, {3, 9}}));       // beside
  EXPECT_FALSE(Path(unit, {4, 4}).entry(Box{{3, 0}, {4, 0.9}}));       // past a corner
}

TEST(SweptBox, ThatStaysEntersWhatItOverlaps) {
  expect_entry(Path(unit, {0, 0}).entry(Box{{1, 1}, {2, 2}}), 0);
  EXPECT_FALSE(Path(unit, {0, 0}).entry(Box{{1.1, 1}, {2, 2}}));
}

TEST(SweptBox, MayBeEndlessOrEmptyAndSoMayOthers) {
  expect_entry(Path({{-infinity, 0}, {infinity, 1}}, {0, 4}).entry(Box{{7, 3}, {8, 5}}), 0.5);
  expect_entry(Path(Box::everything(), {1, 2}).entry(Box{{7, 3}, {8, 5}}), 0);
  expect_entry(Path(unit, {1, 4}).entry(Box{{-infinity, 3}, {infinity, infinity}}), 0.5);
  expect_entry(Path(Box::everything(), {1, 2}).entry(Box::everything()), 0);
  EXPECT_FALSE(Path(Box::nothing(), {1, 2}).entry(unit));
  EXPECT_FALSE(Path(Box::nothing(), {0, 0}).entry(unit));
  EXPECT_NEAR(Path(unit, {1, 2}).reach<double>(0).max.y, 3, 1e-13);
  EXPECT_EQ(Path(Box::everything(), {1, 2}).reach<double>(0), Box::everything());
}

TEST(SweptBox, MayReachToTheEndOfTheNumbers) {
  constexpr double most = std::numeric_limits<double>::max();
  expect_entry(Path({{-most, 0}, {-most, 1}}, {most, 0}).entry(Box{{-1, 0}, {1, 1}}), 1);
  EXPECT_FALSE(Path({{-most, 0}, {-most, 1}}, {most, 0}).entry(Box{{most, 0}, {most, 1}}));
  EXPECT_FALSE(Path({{most, 0}, {most, 1}}, {most, 0}).entry(Box{{-most, 0}, {-most, 1}}));
  constexpr double least = std::numeric_limits<double>::denorm_min();
  expect_entry(Path({{0, 0}, {0, 0}}, {4 * least, 0}).entry(Box{{2 * least, 0}, {3 * least, 0}}), 0.5);
}

template <class SpaceType>
class SweptBoxIn : public ::testing::Test {
 public:
  static constexpr Dim dimension = SpaceType::dimension;
  using Number = typename SpaceType::scalar;

  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }

  /// One coordinate in four is zero.
  Vec<dimension, Number> vector(double size) {
    Vec<dimension, Number> v;
    for (Dim i = 0; i < dimension; ++i)
      v[i] = engine_() % 4 == 0 ? Number(0) : static_cast<Number>(number(-size, size));
    return v;
  }

  Aabb<dimension, Number> box() {
    const auto min = vector(4);
    return {min, min + abs(vector(2))};
  }

  std::mt19937 engine_{20261128};
};

TYPED_TEST_SUITE(SweptBoxIn, test::Spaces);

/// At the entry, and at no time before, the boxes share a point, up to rounding.
TYPED_TEST(SweptBoxIn, EntersWhenItFirstSharesAPoint) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  int entered = 0;
  for (int k = 0; k < 4000; ++k) {
    const Aabb<N, T> start = this->box();
    const Aabb<N, T> other = this->box();
    const Vec<N, T> motion = this->vector(6);
    const SweptBox<N> path = swept_box_of(start, motion);
    const std::optional<double> t = path.entry(other);
    const auto shares_a_point = [&](double at, double slack) {
      const Vec<N, double> way = wide<N, T>(motion) * at;
      const Aabb<N, double> moved{wide<N, T>(start.min) + way - slack, wide<N, T>(start.max) + way + slack};
      return boxes_overlap(moved, Aabb<N, double>{wide<N, T>(other.min), wide<N, T>(other.max)});
    };
    for (int step = 0; step <= 64; ++step) {
      const double at = step / 64.0;
      if (shares_a_point(at, 0)) {
        ASSERT_TRUE(t && *t <= at);
      }
    }
    if (!t) continue;
    ++entered;
    ASSERT_TRUE(shares_a_point(*t, 1e-11));
    ASSERT_TRUE(boxes_overlap(path.template reach<T>(4), other));
    Aabb<N, T> around = other;
    around.grow(this->box());
    const std::optional<double> sooner = path.entry(around);
    ASSERT_TRUE(sooner && *sooner <= *t);
  }
  EXPECT_GT(entered, 100);
}

/// The corners of a box that rotates stay in the swept box.
TYPED_TEST(SweptBoxIn, HoldsWhatRotates) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for (int k = 0; k < 2000; ++k) {
    const Aabb<N, T> start = this->box();
    Motion<N, T> motion{this->vector(6), Turn<N, T>(0), this->vector(4)};
    const double angle = k % 3 == 0 ? 0.1 : 7;
    if constexpr (N == 2) motion.angular = static_cast<T>(this->number(-angle, angle));
    if constexpr (N == 3) motion.angular = this->vector(angle);
    const SweptBox<N> path = swept_box_of(start, motion);
    for (int corner = 0; corner < 1 << N; ++corner) {
      Vec<N, double> point;
      for (Dim i = 0; i < N; ++i) point[i] = static_cast<double>((corner >> i) % 2 == 0 ? start.min[i] : start.max[i]);
      for (int step = 0; step <= 16; ++step) {
        const double at = step / 16.0;
        const Pose<N, double> pose = pose_at(motion, at);
        const Vec<N, double> moved = pose.rotation * point + pose.position;
        const std::optional<double> t = path.entry(Aabb<N, double>{moved, moved});
        ASSERT_TRUE(t && *t <= at);
      }
    }
  }
}

TEST(SweptBox, OfASmallRotationIsLittleLarger) {
  const Motion<2, double> motion{{0, 0}, 0.01, {-100, 0}};
  const Path path = swept_box_of(unit, motion);
  EXPECT_TRUE(path.entry(Box{{-0.5, 2}, {0, 3}}));  // moves up by about 1
  EXPECT_FALSE(path.entry(Box{{-0.5, 2.1}, {0, 3}}));
  const Path spin = swept_box_of(unit, Motion<2, double>{{0, 0}, 100, {0.5, 0.5}});
  EXPECT_TRUE(spin.entry(Box{{1.2, 0}, {2, 1}}));
  EXPECT_FALSE(spin.entry(Box{{1.21, 0}, {2, 1}}));  // outside the circle, of radius 0.7072
}

TEST(SweptBox, LengthsNeitherOverflowNorUnderflow) {
  EXPECT_NEAR(length_in_range(V2(3e200, 4e200)), 5e200, 1e186);
  EXPECT_NEAR(length_in_range(V2(3e-300, 4e-300)), 5e-300, 1e-314);
  EXPECT_EQ(length_in_range(V2(0, 0)), 0);
  EXPECT_EQ(length_in_range(V2(infinity, 1)), infinity);
}

}  // namespace
}  // namespace graze::detail::swept_box_test
