// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <graze/shape/triangle.hpp>

#include "../catalogue/nasty.hpp"

namespace graze::triangle_test {
namespace {

template <class S>
class TriangleIn : public testing::Test {};
TYPED_TEST_SUITE(TriangleIn, test::Spaces);

TYPED_TEST(TriangleIn, NamesTheDefectOfEveryNumber) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const auto corner = test::finite("has a corner that is not finite");
  EXPECT_EQ(test::expect_defects(Triangle<N, T>{}, corner, corner, corner), 3 * N * 11);
}

TYPED_TEST(TriangleIn, ThatIsASegmentOrAPointIsValid) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const Vec<N, T> a(T(1));
  EXPECT_TRUE(is_valid(Triangle<N, T>{a, a, a}));
  EXPECT_TRUE(is_valid(Triangle<N, T>{a, a * T(2), a * T(3)}));
  EXPECT_EQ(support(Triangle<N, T>{a, a, a}, unit_axis<N>(1)), (Vec<N, double>(1)));
  EXPECT_EQ(support(Triangle<N, T>{a, a * T(3), a * T(2)}, unit_axis<N>(1)), (Vec<N, double>(3)));
}

TEST(Triangle, DefaultsToTheHalfOfTheUnitSquare) {
  const auto vertices = Triangle<2>{}.vertices();
  EXPECT_EQ(vertices[0], (Vec<2, float>(0, 0)));
  EXPECT_EQ(vertices[1], (Vec<2, float>(1, 0)));
  EXPECT_EQ(vertices[2], (Vec<2, float>(0, 1)));
}

TEST(Triangle, HasItsFarthestVertexAsSupport) {
  const Triangle<3, float> triangle{{1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
  EXPECT_EQ(support(triangle, {1, 0, 0}), (Vec<3, double>(1, 0, 0)));
  EXPECT_EQ(support(triangle, {1, 1, 0}), (Vec<3, double>(0, 2, 0)));
  EXPECT_EQ(support(triangle, {1e-9, 1e-9, 1e-9}), (Vec<3, double>(0, 0, 3)));
  EXPECT_EQ(support(triangle, {-2, -1, -0.5}), (Vec<3, double>(0, 0, 3)));
}

TEST(Triangle, MovesWithItsVertices) {
  const Pose<2, float> pose{Mat<2, float>(rotation_matrix(180)), {10, 0}};
  const Triangle<2, float> moved = transformed(Triangle<2, float>{{1, 1}, {2, 1}, {1, 3}}, pose);
  EXPECT_EQ(moved.a, (Vec<2, float>(9, -1)));
  EXPECT_EQ(moved.b, (Vec<2, float>(8, -1)));
  EXPECT_EQ(moved.c, (Vec<2, float>(9, -3)));
}

}  // namespace
}  // namespace graze::triangle_test
