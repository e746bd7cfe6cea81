// SPDX-License-Identifier: MIT
// A shape seen through a pose is the shape that was moved.
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
