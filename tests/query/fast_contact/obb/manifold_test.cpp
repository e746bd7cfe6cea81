// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include <graze/query/fast_contact/obb/manifold.hpp>
#include <graze/query/manifold.hpp>
#include <graze/shape/obb.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail::obb_manifold_test {
namespace {

using V3 = Vec<3, double>;

constexpr Feature corner{FeatureKind::vertex, 3};
constexpr Feature side{FeatureKind::face, 5};

template <class T>
void expect_point(const ManifoldPoint<3, T>& point, const V3& a, const V3& b, const ContactId& id) {
  EXPECT_EQ(point.point_a, (Vec<3, T>(a)));
  EXPECT_EQ(point.point_b, (Vec<3, T>(b)));
  EXPECT_EQ(point.point, (Vec<3, T>(a * 0.5 + b * 0.5)));
  EXPECT_EQ(point.depth, static_cast<T>(0.1));
  EXPECT_EQ(point.id, id);
}

template <class T>
void expect_points_in_either_order() {
  using Point = ManifoldPoint<3, T>;
  const V3 origin(10, 20, 30);
  const V3 a(0.1, 0.2, 0.3);
  const V3 b(0.7, -0.5, 0.9);
  const PairedPoints pair{PairedVec(a), PairedVec(b), 0.1, corner, side};
  expect_point<T>(ObbPoints<Point>(PairedVec(origin), false).rounded(pair), a + origin, b + origin, {corner, side});
  expect_point<T>(ObbPoints<Point>(PairedVec(origin), true).rounded(pair), b + origin, a + origin, {side, corner});
}

TEST(ObbPoints, AreRoundedAndExchanged) {
  expect_points_in_either_order<float>();
  expect_points_in_either_order<double>();
}

TEST(ObbPoints, AreNeverMinusZero) {
  using Point = ManifoldPoint<3, float>;
  const PairedVec zero(LanePair{-0.0, -0.0}, -0.0);
  const Point point = ObbPoints<Point>(zero, true).rounded({zero, zero, 0, corner, side});
  for (Dim i = 0; i < 3; ++i) {
    EXPECT_FALSE(std::signbit(point.point[i]));
    EXPECT_FALSE(std::signbit(point.point_a[i]));
    EXPECT_FALSE(std::signbit(point.point_b[i]));
  }
}

TEST(CornersInTurn, AreTheChosenOnesAndThenEmpty) {
  using Point = ManifoldPoint<3, double>;
  const auto face = [](const V3& low, const V3& high, bool is_far) {
    const Obb<3, double> box = oriented(Aabb<3, double>{low, high});
    return face_of_box(paired_box(box, box.center), {2, is_far});
  };
  const PairedVec up(V3(0, 0, 1));
  FaceOverFace over(face({1, 1, -0.5}, {2, 2, 1}, false), face({0, 0, -1}, {4, 4, 0}, true), up, up, 1e-14, 0);
  ASSERT_TRUE(over.run());
  ASSERT_EQ(over.left(), 0b1111U);
  const ObbPoints<Point> points(PairedVec(V3(0, 0, 0)), false);
  CornersInTurn<Point> corners(over, 0b1010U, points);
  EXPECT_EQ(corners.next().point_b, V3(2, 1, -0.5));
  EXPECT_EQ(corners.next().point_b, V3(1, 2, -0.5));
  EXPECT_EQ(corners.count(), 2U);
  EXPECT_EQ(corners.next(), Point{});
  EXPECT_EQ(corners.next(), no_point<Point>());
  EXPECT_EQ(corners.count(), 2U);
}

}  // namespace
}  // namespace graze::detail::obb_manifold_test

#endif
