// SPDX-License-Identifier: MIT
// A shape with a pose behaves like the transformed shape.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include <graze/math/rotation.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/distance.hpp>
#include <graze/query/intersects.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/transformed.hpp>
#include <graze/shape/obb.hpp>
#include <graze/shape/posed.hpp>

#include "../catalogue.hpp"
#include "../query/user_shapes.hpp"

namespace graze::posed_test {
namespace {

using D3 = Vec<3, double>;
using F2 = Vec<2, float>;

static_assert(Convex<Posed<Sphere<3, double>>> && dimension_of<Posed<Sphere<2>>> == 2);
static_assert(std::is_same_v<scalar_of<Posed<user::Cylinder<float>>>, float>);
static_assert(SupportsIn<Posed<user::Cylinder<float>>, 3, float> && SupportsIn<Posed<Aabb<3, float>>, 3, double>);

/// A quarter turn about x: z becomes -y.
const Pose<3, double> lying{rotation_matrix(D3(1, 0, 0), 90.0), {1, 2, 3}};

TEST(Posed, ACylinderOfOnesOwnLiesWhereItIsPut) {
  const Posed<user::Cylinder<double>> can{{{0, 0, 0}, 1, 2}, lying};
  EXPECT_TRUE(intersects(can, D3(1, 3.9, 3)));
  EXPECT_FALSE(intersects(can, D3(1, 4.1, 3)));
  EXPECT_TRUE(intersects(can, D3(1.9, 2, 3)));
  EXPECT_FALSE(intersects(can, D3(1, 2, 4.1)));
  EXPECT_NEAR(distance(can, D3(1, 6, 3)), 2, 1e-12);
  EXPECT_NEAR(closest_point(can, D3(1, 6, 3)).y, 4, 1e-6);
  const auto hit = ray_cast(can, Ray<3, double>{{1, 10, 3}, {0, -1, 0}});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->t, 6, 1e-12);
}

TEST(Posed, ABoxIsAsFarAndAsDeepAsTheOneThatWasMoved) {
  const Aabb<3, double> box{{-1, -2, -3}, {1, 2, 3}};
  const Pose<3, double> pose{rotation_matrix(D3(1, 2, 3) / std::sqrt(14.0), 50.0), {0.5, -0.25, 4}};
  const Posed<Aabb<3, double>> seen{box, pose};
  const Obb<3, double> moved = transformed(Obb<3, double>{{0, 0, 0}, {1, 2, 3}, Mat<3, double>(1.0)}, pose);
  for (const D3 center : {D3(0, 0, 0), D3(5, 1, 2), D3(-3, -3, 8), D3(1, 1, 6)}) {
    const Aabb<3, double> other{center - D3(1, 1, 1), center + D3(1, 1, 1)};
    EXPECT_EQ(intersects(seen, other), intersects(moved, other));
    EXPECT_NEAR(distance(seen, other), distance(moved, other), 1e-11);
    const auto one = contact(seen, other);
    const auto two = contact(moved, other);
    ASSERT_EQ(one.has_value(), two.has_value());
    if (one) {
      EXPECT_NEAR(one->depth, two->depth, 1e-11);
    }
  }
}

template <Dim N, class T>
double size_of(const Aabb<N, T>& box) {
  return std::max(static_cast<double>(max_abs(box.min)), static_cast<double>(max_abs(box.max)));
}

template <class Space>
class PosedShape : public testing::Test {};
TYPED_TEST_SUITE(PosedShape, test::Spaces);

/// The error of lengths of this size from `transformed`, which rounds to T, and from rotations in T, which are not
/// quite orthonormal.
template <class T>
double slack(double size) {
  return 1e4 * static_cast<double>(std::numeric_limits<T>::epsilon()) * size;
}

template <Convex S>
void agrees_with_the_moved_shape(const S& shape) {
  constexpr Dim N = dimension_of<S>;
  using T = scalar_of<S>;
  const Pose<N, T> pose = *test::any_pose<N, T>();
  const auto moved = transformed(shape, pose);
  const Posed<S> posed{shape, pose};
  const auto other = *test::any<Triangle<N, T>>();

  const Aabb<N, T> box = bounds(posed);
  const Aabb<N, T> moved_box = bounds(moved);
  const double size = std::max({size_of(box), size_of(bounds(other)), size_of(bounds(shape))});
  RC_ASSERT(static_cast<double>(max_abs(box.min - moved_box.min)) <= slack<T>(size));
  RC_ASSERT(static_cast<double>(max_abs(box.max - moved_box.max)) <= slack<T>(size));

  const double apart = static_cast<double>(distance(posed, other));
  RC_ASSERT(std::fabs(apart - static_cast<double>(distance(moved, other))) <= slack<T>(size));
  RC_ASSERT(apart == static_cast<double>(distance(other, posed)));
  const auto deep = contact(posed, other);
  const auto moved_deep = contact(moved, other);
  RC_ASSERT(deep.has_value() == intersects(posed, other));
  if (deep && moved_deep) RC_ASSERT(std::fabs(static_cast<double>(deep->depth - moved_deep->depth)) <= slack<T>(size));
}

TYPED_TEST(PosedShape, AgreesWithTheShapeThatIsMoved) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_every_type<N, T>([]<Convex S>(const S& shape) { agrees_with_the_moved_shape(shape); });
}

// GJK once took the origin for a point between faces of a needle, which rounding had rotated: they seemed to touch.
TEST(Posed, ASegmentFarFromANeedleIsFarFromIt) {
  const Posed<Segment<3, double>> seen{
      {{15101.34518096205, -0.016841509800271912, -27390.31435282771},
       {-0.026850470392788796, -73.12194529526221, -1749.120208703738}},
      {{{-0.46876806596487114, 0, 0.883321289413741}, {0, -1, 0}, {0.883321289413741, 0, 0.46876806596487114}},
       {-1, 0.5, -2}}};
  const Triangle<3, double> needle{{-1989574.3115055058, 701.4571859700668, 0.0018834827012249183},
                                   {0.00024504637300534174, -656.9068372814036, -605.7618441104806},
                                   {-994787.1580072581, 350.7235929850334, 0.0009503390981533156}};
  EXPECT_NEAR(distance(seen, needle), 709.514232875828, 1e-9);
}

TEST(Posed, MovesAgain) {
  const Posed<Segment<3, double>> twice = transformed(Posed<Segment<3, double>>{{{0, 0, 0}, {0, 0, 1}}, lying}, lying);
  EXPECT_NEAR(max_abs(support(twice, D3(0, 0, -1)) - D3(2, -1, 4)), 0, 1e-15);
}

TEST(Posed, HasBoundsThatHoldItWhereverItWasWritten) {
  test::check_property([] {
    const auto box = *test::any<Obb<3, double>>();
    const auto pose = *test::any_pose<3, double>();
    const Posed<Obb<3, double>> seen{box, pose};
    const Aabb<3, double> around = bounds(seen);
    const double size = max_abs(box.center) + max_abs(box.half_extents) + max_abs(pose.position);
    for (const double x : {-1.0, 1.0}) {
      for (const double y : {-1.0, 1.0}) {
        for (const double z : {-1.0, 1.0}) {
          const D3 corner = pose.rotation * (box.center + half_edges(box) * D3(x, y, z)) + pose.position;
          const double rounding = 16 * std::numeric_limits<double>::epsilon() * size;
          RC_ASSERT(contains(Aabb<3, double>{around.min - rounding, around.max + rounding}, corner));
        }
      }
    }
  });
}

TEST(Posed, SaysWhatIsWrongWithTheShapeOrThePose) {
  EXPECT_TRUE(is_valid(Posed<Sphere<2>>{}));
  EXPECT_EQ(std::string(defect(Posed<Sphere<2>>{{{0, 0}, -1}, {}})), std::string(defect(Sphere<2>{{0, 0}, -1})));
  Posed<Sphere<2>> lost;
  lost.pose.position.x = std::numeric_limits<float>::infinity();
  EXPECT_EQ(defect(lost), "has a position that is not finite");
  Posed<user::Cylinder<float>> stretched{};
  stretched.pose.rotation[1] *= 2.0F;
  EXPECT_EQ(defect(stretched), "has a rotation whose columns are not orthonormal");
}

}  // namespace
}  // namespace graze::posed_test
