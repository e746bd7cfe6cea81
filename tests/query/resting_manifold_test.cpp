// SPDX-License-Identifier: MIT
// Boxes that rest on each other with a tiny tilt: the points of their manifold span the whole overlap with the other
// face, however much deeper one side of it is.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/query/manifold.hpp>

namespace graze::resting_manifold_test {
namespace {

using V2 = Vec<2, double>;
using V3 = Vec<3, double>;
using Box = Obb<3, double>;

constexpr double radian = 180 / 3.14159265358979323846;

/// From flush up to rounding to the largest tilt that is taken for flush.
constexpr std::array<double, 8> tilts = {0, 1e-15, 1e-12, 1e-10, 1e-8, 1e-7, 1e-6, 0.99e-5};

template <Dim N>
Polytope<N, double> polytope_of(const Obb<N, double>& box) {
  std::vector<Vec<N, double>> corners;
  for (unsigned bits = 0; bits < (1U << static_cast<unsigned>(N)); ++bits) {
    Vec<N, double> corner = box.center;
    for (Dim i = 0; i < N; ++i) {
      corner +=
          box.axes[i] * ((bits >> static_cast<unsigned>(i) & 1U) != 0 ? box.half_extents[i] : -box.half_extents[i]);
    }
    corners.push_back(corner);
  }
  return convex_hull<N, double>(corners);
}

template <Dim N>
Aabb<N, double> aabb_of(const Obb<N, double>& box) {
  return {box.center - box.half_extents, box.center + box.half_extents};
}

/// The largest quadrilateral, as seen along the normal.
double area_of(const Manifold<3, double>& manifold) {
  if (manifold.size < 4) return 0;
  const auto diagonals = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    const V3 first = manifold.points[b].point - manifold.points[a].point;
    const V3 second = manifold.points[d].point - manifold.points[c].point;
    return 0.5 * std::fabs(dot(cross(first, second), manifold.normal));
  };
  return std::max({diagonals(0, 1, 2, 3), diagonals(0, 2, 1, 3), diagonals(0, 3, 1, 2)});
}

double area_of(const Manifold<2, double>& manifold) {
  return manifold.size < 2 ? 0
                           : std::sqrt(dot(manifold.points[1].point - manifold.points[0].point,
                                           manifold.points[1].point - manifold.points[0].point));
}

/// Four points that span the face, each on both shapes up to 1e-5 of the face.
template <Dim N>
void expect_rest(const Manifold<N, double>& manifold, double area, double size, const char* what, double tilt) {
  SCOPED_TRACE(::testing::Message() << what << " tilted by " << tilt);
  ASSERT_EQ(manifold.size, static_cast<std::size_t>(Manifold<N, double>::most_points));
  EXPECT_GT(area_of(manifold), 0.99 * area);
  for (const ManifoldPoint<N, double>& point : manifold.contacts()) {
    const Vec<N, double> rest = point.point_a - point.point_b - manifold.normal * point.depth;
    EXPECT_GE(point.depth, 0);
    EXPECT_LE(max_abs(rest), 64 * tolerance::epsilon * (max_abs(point.point) + size));
    // Height above the lower one's upper side, which is at zero.
    EXPECT_LE(std::fabs(point.point_a[N - 1]), 4 * tolerance::aligned * size + manifold.error);
  }
}

class Stacks {
 public:
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

  /// A box above one whose upper side is at zero height, with this depth at its lowest corner.
  Box above(const V3& half, double yaw, double tilt, double depth) {
    const double around = number(0, 6.28);
    Box box{
        V3(0.0), half,
        rotation_matrix(V3(std::cos(around), std::sin(around), 0), tilt * radian) * rotation_matrix(V3(0, 0, 1), yaw)};
    double lowest = 0;
    for (Dim i = 0; i < 3; ++i) lowest += std::fabs(box.axes[i].z) * half[i];
    box.center.z = lowest - depth;
    return box;
  }

 private:
  std::mt19937 random_{20261129};
};

/// Smaller boxes with any rotation, and boxes of one size with their sides flush: the resting face is the area.
TEST(RestingManifold, OfBoxesSpansTheFace) {
  Stacks stacks;
  for (const double tilt : tilts) {
    for (int i = 0; i < 400; ++i) {
      const bool is_flush = i % 4 == 0;
      const V3 half(stacks.number(0.3, 1), stacks.number(0.3, 1), stacks.number(0.1, 2));
      const V3 half_below = is_flush ? half : V3(stacks.number(2, 9), stacks.number(2, 9), stacks.number(0.1, 2));
      const double depth = i % 3 == 0 ? 1e-13 : tilt * stacks.number(0, 1) + (i % 3 == 1 ? 0.0 : 1e-3);
      const Box below{V3(0, 0, -half_below.z), half_below, Mat<3, double>(1.0)};
      const Box above = stacks.above(half, is_flush ? 0 : stacks.number(0, 360), tilt, depth);
      const double area = 4 * half.x * half.y;
      const double size = max_abs(half);
      if (relation(below, above) == Relation::apart) continue;  // nearer than rounding
      expect_rest(manifold(below, above), area, size, "box on box", tilt);
      expect_rest(manifold(aabb_of(below), above), area, size, "box on an aabb", tilt);
      expect_rest(manifold(polytope_of(below), polytope_of(above)), area, size, "polytope on polytope", tilt);
      expect_rest(manifold(aabb_of(below), polytope_of(above)), area, size, "polytope on box", tilt);
      expect_rest(manifold(HalfSpace<3, double>{{0, 0, 1}, 0}, above), area, size, "box on half-space", tilt);
      const Manifold<3, double> swapped = manifold(above, below);
      EXPECT_EQ(swapped.size, 4U);
      EXPECT_GT(area_of(swapped), 0.99 * area);
      if (HasFailure()) return;
    }
  }
}

TEST(RestingManifold, InThePlaneSpansTheSide) {
  Stacks stacks;
  for (const double tilt : tilts) {
    for (int i = 0; i < 400; ++i) {
      const V2 half(stacks.number(0.3, 1), stacks.number(0.1, 2));
      const bool is_flush = i % 4 == 0;
      const V2 half_below(is_flush ? half.x : stacks.number(2, 9), 1);
      const Obb<2, double> below{V2(0, -half_below.y), half_below, Mat<2, double>(1.0)};
      Obb<2, double> above{V2(0.0), half, rotation_matrix((i % 2 == 0 ? tilt : -tilt) * radian)};
      const double depth = i % 3 == 0 ? 1e-13 : tilt * stacks.number(0, 1) + (i % 3 == 1 ? 0.0 : 1e-3);
      above.center.y = std::fabs(above.axes[0].y) * half.x + std::fabs(above.axes[1].y) * half.y - depth;
      if (relation(below, above) == Relation::apart) continue;
      const double size = max_abs(half);
      expect_rest(manifold(below, above), 2 * half.x, size, "box on box", tilt);
      expect_rest(manifold(aabb_of(below), above), 2 * half.x, size, "box on an aabb", tilt);
      expect_rest(manifold(polytope_of(below), polytope_of(above)), 2 * half.x, size, "polygon on polygon", tilt);
      expect_rest(manifold(HalfSpace<2, double>{{0, 1}, 0}, above), 2 * half.x, size, "box on half-space", tilt);
      if (HasFailure()) return;
    }
  }
}

/// Faces with a larger tilt are clipped where they separate, and the other face's size counts if it is smaller.
TEST(RestingManifold, EndsWhereMoreIsHidden) {
  Stacks stacks;
  const V3 half(1, 1, 1);
  const Box below{V3(0, 0, -1), V3(5, 5, 1), Mat<3, double>(1.0)};
  const Manifold<3, double> leaning = manifold(below, stacks.above(half, 0, 1e-3, 1e-13));
  EXPECT_LT(area_of(leaning), 0.1);
  // A pebble under the rim of a large plate: the pebble's size determines the permitted tilt of the plate.
  const Box plate = stacks.above(V3(1000, 1000, 1), 0, 1e-3, 0);
  V3 corner = plate.center;
  for (Dim i = 0; i < 3; ++i) corner -= plate.axes[i] * std::copysign(plate.half_extents[i], plate.axes[i].z);
  const Box pebble{corner - V3(0, 0, 0.1 - 1e-6), V3(0.5, 0.5, 0.1), Mat<3, double>(1.0)};
  const Manifold<3, double> under_the_rim = manifold(pebble, plate);
  EXPECT_GT(under_the_rim.size, 0U);
  for (const ManifoldPoint<3, double>& point : under_the_rim.contacts()) {
    EXPECT_LT(point.point_b.z, corner.z + 1e-5);
  }
}

}  // namespace
}  // namespace graze::resting_manifold_test
