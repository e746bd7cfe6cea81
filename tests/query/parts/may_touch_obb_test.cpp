// SPDX-License-Identifier: MIT
// Whatever touches an oriented box is between its sides, and little else is.
#include <cmath>
#include <cstddef>
#include <limits>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/intersects.hpp>
#include <graze/query/parts/may_touch_obb.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/triangle.hpp>

#include "catalogue.hpp"
#include "catalogue/numbers.hpp"
#include "spaces.hpp"

#ifdef GRAZE_HAS_LANES

namespace graze::test::may_touch_obb_test {
namespace {

using detail::LaneMask;
using detail::row_length;

template <class SpaceType>
class BetweenSides : public ::testing::Test {
 public:
  static constexpr Dim N = SpaceType::dimension;
  using T = typename SpaceType::scalar;
  using Point = Vec<N, T>;
  static constexpr T reach = 4;  // of everything

  static Point draw_point(rc::Random& random, double size) {
    Vec<N, double> point;
    for (Dim i = 0; i < N; ++i) point[i] = between(random, -size, size);
    return Point(point);
  }

  /// Of any shape, its axes not quite orthonormal.
  static Obb<N, T> draw_obb(rc::Random& random) {
    Obb<N, T> obb{draw_point(random, 1), {}, {}};
    for (Dim i = 0; i < N; ++i) obb.half_extents[i] = static_cast<T>(between(random, 0, 1));
    const double angle = between(random, -3, 3);
    if constexpr (N == 2) {
      obb.axes = Pose<2, T>::from_angle({}, angle).rotation;
    } else {
      obb.axes = Pose<3, T>::from_axis_angle({}, draw_point(random, 1) + Point(T(2), T(0), T(0)), angle).rotation;
    }
    for (Dim i = 0; i < N; ++i) obb.axes[i] += draw_point(random, 1e-5);
    return obb;
  }

  /// A small one anywhere, or one whose corner is at a point of the box.
  static Triangle<N, T> draw_triangle(rc::Random& random, const Obb<N, T>& obb) {
    const double size = between(random, 0, 1) < 0.5 ? 0.05 : 1;
    Point corner = draw_point(random, 2);
    if (between(random, 0, 1) < 0.3) {
      corner = obb.center;
      for (Dim i = 0; i < N; ++i) {
        const double share = between(random, 0, 1) < 0.5 ? 1 : between(random, -1, 1);
        corner += obb.axes[i] * (static_cast<T>(share) * obb.half_extents[i]);
      }
    }
    return {corner, corner + draw_point(random, size), corner + draw_point(random, size)};
  }

  struct Counts {
    std::size_t touching = 0;
    std::size_t apart = 0;
    std::size_t faces_beyond = 0;  ///< A side, of those apart.
    std::size_t boxes_beyond = 0;
  };

  /// With everything multiplied by a scale.
  static void check_block(rc::Random& random, T scale, Counts& counts) {
    const Obb<N, T> unscaled = draw_obb(random);
    const Obb<N, T> obb{unscaled.center * scale, unscaled.half_extents * scale, unscaled.axes};
    detail::TriangleBlock<N, T> faces;
    detail::BoxBlock<N, T> boxes;
    LaneMask touching = 0;
    for (std::size_t lane = 0; lane < row_length; ++lane) {
      const Triangle<N, T> drawn = draw_triangle(random, unscaled);
      const Triangle<N, T> triangle{drawn.a * scale, drawn.b * scale, drawn.c * scale};
      faces.set(lane, triangle);
      boxes.set(lane, touching_bounds(triangle));
      touching |= (intersects(triangle, obb) ? LaneMask{1} : LaneMask{0}) << lane;
    }
    const auto inside = detail::may_touch(obb).inside(Aabb<N, T>{Point(-reach * scale), Point(reach * scale)}, 0);
    const LaneMask found_faces = inside.lanes(faces);
    const LaneMask found_boxes = inside.lanes(boxes);
    EXPECT_EQ(touching & ~found_faces, 0U);
    EXPECT_EQ(touching & ~found_boxes, 0U);
    for (std::size_t lane = 0; lane < row_length; ++lane) {
      const bool touches = (touching >> lane & 1U) != 0;
      counts.touching += touches ? 1 : 0;
      counts.apart += touches ? 0 : 1;
      counts.faces_beyond += (found_faces >> lane & 1U) == 0 ? 1 : 0;
      counts.boxes_beyond += (found_boxes >> lane & 1U) == 0 ? 1 : 0;
    }
  }

  static void expect_sides() {
    rc::Random random(5);
    Counts counts;
    for (int round = 0; round < 500; ++round) check_block(random, T(1), counts);
    EXPECT_GT(counts.touching, 1000U);
    EXPECT_GT(counts.faces_beyond, counts.apart * 8 / 10);
    EXPECT_GT(counts.boxes_beyond, counts.apart * 8 / 10);
  }

  static void expect_sides_at_any_size() {
    rc::Random random(7);
    Counts counts;
    const T least = std::numeric_limits<T>::denorm_min();
    const T most = std::numeric_limits<T>::max();
    for (const T scale : {T(1e-20), T(100) * least, std::sqrt(least), T(1e20), std::sqrt(most), most / 256}) {
      for (int round = 0; round < 200; ++round) check_block(random, scale, counts);
    }
    EXPECT_GT(counts.touching, 1000U);
  }

  static void expect_nothing_of_nan() {
    rc::Random random(6);
    const auto inside = detail::may_touch(draw_obb(random)).inside(Aabb<N, T>{Point(-reach), Point(reach)}, 0);
    detail::TriangleBlock<N, T> faces;
    const Point nan(std::numeric_limits<T>::quiet_NaN());
    for (std::size_t lane = 0; lane < row_length; ++lane) faces.set(lane, {nan, nan, nan});
    EXPECT_EQ(inside.lanes(faces), detail::first_lanes(row_length));  // is left to the exact test
  }
};
TYPED_TEST_SUITE(BetweenSides, Spaces);

TYPED_TEST(BetweenSides, IsWhatTouches) { TestFixture::expect_sides(); }

TYPED_TEST(BetweenSides, IsWhatTouchesAtAnySize) { TestFixture::expect_sides_at_any_size(); }

TYPED_TEST(BetweenSides, IsWhatHasNaN) { TestFixture::expect_nothing_of_nan(); }

}  // namespace
}  // namespace graze::test::may_touch_obb_test

#endif
