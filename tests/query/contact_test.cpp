// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/contact.hpp>

#include "query/contacts.hpp"
#include "query/placement.hpp"
#include "query/row_of_shapes.hpp"
#include "query/user_shapes.hpp"

namespace graze::test::contact_test {
namespace {

using V2 = Vec<2, double>;
using V3 = Vec<3, double>;
using Any3 = AnyShape<3, double>;

template <Dim N>
std::optional<Contact<N, double>> exchanged(std::optional<Contact<N, double>> contact) {
  if (!contact) return contact;
  std::swap(contact->point_a, contact->point_b);
  contact->normal = Vec<N, double>(0.0) - contact->normal;
  return contact;
}

/// The contact has a's surface point `on_a`, `depth` deep in b along `normal`; and the same in the other order.
template <Dim N>
void expect_contact(const AnyShape<N, double>& a, const AnyShape<N, double>& b, const Vec<N, double>& normal,
                    double depth, const Vec<N, double>& on_a) {
  const auto found = contact_of<N, double>(a, b);
  ASSERT_TRUE(found) << to_source<N, double>(a) << ", " << to_source<N, double>(b);
  EXPECT_NEAR(length(found->normal - normal), 0, 1e-14) << to_source<N, double>(a) << ", " << to_source<N, double>(b);
  EXPECT_NEAR(found->depth, depth, 1e-14);
  EXPECT_NEAR(length(found->point_a - on_a), 0, 1e-14) << to_source(found->point_a);
  EXPECT_NEAR(length(found->point_b - (on_a - normal * depth)), 0, 1e-14) << to_source(found->point_b);
  EXPECT_NEAR(length(found->point - (on_a - normal * (0.5 * depth))), 0, 1e-14);
  EXPECT_EQ(found->status, Status::converged);
  EXPECT_EQ((exchanged<N>(contact_of<N, double>(b, a))), found);
}

TEST(Contact, OfRoundShapesIsAlongTheirNearestPoints) {
  const Sphere<3, double> sphere{{0, 0, 0}, 2};
  expect_contact<3>(sphere, Sphere<3, double>{{3, 0, 0}, 2}, {1, 0, 0}, 1, {2, 0, 0});
  expect_contact<3>(sphere, Sphere<3, double>{{3, 4, 0}, 5}, {0.6, 0.8, 0}, 2, {1.2, 1.6, 0});
  expect_contact<3>(sphere, Capsule<3, double>{{-5, 0, 3}, {5, 0, 3}, 2}, {0, 0, 1}, 1, {0, 0, 2});
  expect_contact<3>(V3(0, 1, 0), sphere, {0, -1, 0}, 1, {0, 1, 0});
  expect_contact<3>(Capsule<3, double>{{-2, 0, 0}, {2, 0, 0}, 1}, Capsule<3, double>{{0, -2, 1}, {0, 2, 1}, 1},
                    {0, 0, 1}, 1, {0, 0, 1});
}

TEST(Contact, OfARoundShapeAndABoxIsOutOfTheNearestFaceWhereverTheCenterIs) {
  const Aabb<3, double> box{{-2, -2, -2}, {2, 2, 2}};
  expect_contact<3>(Sphere<3, double>{{0, 2.5, 0}, 1}, box, {0, -1, 0}, 0.5, {0, 1.5, 0});
  expect_contact<3>(Sphere<3, double>{{0, 2, 0}, 1}, box, {0, -1, 0}, 1, {0, 1, 0});
  expect_contact<3>(Sphere<3, double>{{0, 1.5, 0}, 1}, box, {0, -1, 0}, 1.5, {0, 0.5, 0});
  expect_contact<3>(Sphere<3, double>{{5, 6, 0}, 6}, box, {-0.6, -0.8, 0}, 1, {1.4, 1.2, 0});
  expect_contact<3>(box, Capsule<3, double>{{2.5, 9, 0}, {2.5, 0, 0}, 1}, {1, 0, 0}, 0.5, {2, 0, 0});
}

TEST(Contact, OfBoxesIsOutOfTheNearestFaceOrEdge) {
  const Obb<3, double> cube{{0, 0, 0}, {1, 1, 1}};
  const double half = std::sqrt(0.5);
  const Obb<3, double> on_edge{{0, 0, 2}, {1, 1, 1}, rotation_matrix(V3(1, 0, 0), 45)};
  const auto on_face = contact(cube, on_edge);  // the edge along x of the upper one is on the lower one's face
  ASSERT_TRUE(on_face);
  EXPECT_NEAR(on_face->depth, 2 * half + 1 - 2, 1e-15);
  EXPECT_NEAR(length(on_face->normal - V3(0, 0, 1)), 0, 1e-15);
  // Edges along x and y cross at z = 2 half and 1.3 + half - 2 half.
  const Obb<3, double> below{{0, 0, 0}, {1, 1, 1}, rotation_matrix(V3(0, 1, 0), 45)};
  const Obb<3, double> above{{0, 0, 2.5}, {1, 1, 1}, rotation_matrix(V3(1, 0, 0), 45)};
  expect_contact<3>(below, above, {0, 0, 1}, 4 * half - 2.5, {0, 0, 2 * half});
}

TEST(Contact, OfTrianglesIsOutOfTheirPlanesOrOverTheirEdges) {
  const Triangle<3, double> floor_triangle{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}};
  const Triangle<3, double> spike{{0, 0, -0.5}, {1, 0, 3}, {-1, 0, 3}};
  expect_contact<3>(floor_triangle, spike, {0, 0, 1}, 0.5, {0, 0, 0});
  expect_contact<3>(floor_triangle, Triangle<3, double>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 0, 1}, 0, {0, 0, 0});
  expect_contact<3>(Segment<3, double>{{0, 0, -0.25}, {0, 0, 4}}, floor_triangle, {0, 0, -1}, 0.25, {0, 0, -0.25});
}

TEST(Contact, InThePlaneIsOutOfTheNearestSide) {
  const Aabb<2, double> box{{0, 0}, {4, 2}};
  expect_contact<2>(box, Triangle<2, double>{{2, 1.5}, {3, 5}, {1, 5}}, {0, 1}, 0.5, {2, 2});
  expect_contact<2>(box, Sphere<2, double>{{7, 6}, 6}, {0.6, 0.8}, 1, {4, 2});
  expect_contact<2>(box, convex_hull<2, double>(std::vector<V2>{{3.5, 1}, {6, 0}, {6, 2}}), {1, 0}, 0.5, {4, 1});
  expect_contact<2>(Segment<2, double>{{0, 0}, {2, 0}}, Segment<2, double>{{1, -1}, {1, 0.5}}, {0, -1}, 0.5, {1, 0});
}

TEST(Contact, IsNoneForShapesThatAreApart) {
  EXPECT_FALSE(contact(Sphere<3, double>{{0, 0, 0}, 1}, Sphere<3, double>{{3, 0, 0}, 1}));
  EXPECT_FALSE(contact(Aabb<2>{{0, 0}, {1, 1}}, Vec<2>(2, 0)));
  EXPECT_FALSE((contact_of<3, double>(Compound<3, double>{}, V3(0, 0, 0))));
}

TEST(Contact, OfCentersInOnePlaceIsAlongTheFirstAxis) {
  expect_contact<3>(Sphere<3, double>{{0, 0, 0}, 1}, Sphere<3, double>{{0, 0, 0}, 2}, {1, 0, 0}, 3, {1, 0, 0});
  expect_contact<3>(V3(1, 2, 3), Sphere<3, double>{{1, 2, 3}, 2}, {1, 0, 0}, 2, {1, 2, 3});
  EXPECT_EQ(contact(V3(1, 2, 3), V3(1, 2, 3))->normal, V3(1, 0, 0));
  EXPECT_EQ(contact(V3(1, 2, 3), V3(1, 2, 3))->depth, 0);
  const auto along = contact(Capsule<3, double>{{0, 0, 0}, {0, 0, 4}, 1}, Capsule<3, double>{{0, 0, 1}, {0, 0, 9}, 1});
  EXPECT_EQ(along->normal.z, 0);
  EXPECT_NEAR(along->depth, 2, 1e-15);
}

TEST(Contact, OfAFlatBoxIsOutOfItsFlatSide) {
  const Aabb<3, double> plate{{-3, -3, 0}, {3, 3, 0}};
  expect_contact<3>(plate, Sphere<3, double>{{1, 1, 0.5}, 1}, {0, 0, 1}, 0.5, {1, 1, 0});
  expect_contact<3>(V3(1, 1, 0), plate, {0, 0, 1}, 0, {1, 1, 0});
}

// Shapes of the row extend from -1 to 1 on the x axis; unbounded ones from one side only.
TEST(Contact, OfEveryPairOfTypesInARowIsBetweenTheirEnds) {
  for (std::size_t a = 0; a < row_types; ++a) {
    for (std::size_t b = 0; b < row_types; ++b) {
      const Any3 left = row_shape<3, double>(a, 1.0);
      const Any3 right = moved<3, double>(row_shape<3, double>(b, -1.0), V3(2, 0, 0));
      const auto found = contact_of<3, double>(left, right);
      ASSERT_TRUE(found) << shape_type_names[a] << ", " << shape_type_names[b];
      EXPECT_NEAR(found->depth, 0, 1e-14) << shape_type_names[a] << ", " << shape_type_names[b];
      EXPECT_NEAR(found->point_a.x, 1, 1e-14) << shape_type_names[a] << ", " << shape_type_names[b];
      EXPECT_NEAR(found->point_b.x, 1, 1e-14) << shape_type_names[a] << ", " << shape_type_names[b];
    }
  }
}

TEST(Contact, OfACompoundIsThatOfItsDeepestPartTheFirstOfSeveral) {
  const Any3 shallow = Sphere<3, double>{{1.75, 0, 0}, 1};
  const Any3 deep = Sphere<3, double>{{-1.5, 0, 0}, 1};
  const Any3 as_deep = Sphere<3, double>{{0, 1.5, 0}, 1};
  const Any3 sphere = Sphere<3, double>{{0, 0, 0}, 1};
  expect_contact<3>(sphere, compound_of<3, double>({shallow, deep, as_deep}), {-1, 0, 0}, 0.5, {-1, 0, 0});
  expect_contact<3>(sphere, compound_of<3, double>({as_deep, shallow, deep}), {0, 1, 0}, 0.5, {0, 1, 0});
}

TEST(Contact, OfShapesThatNothingPartsIsInfinitelyDeepWithoutANormal) {
  const auto found = contact(Plane<3, double>{{0, 0, 1}, 2}, HalfSpace<3, double>{{1, 0, 0}, 0});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->depth, std::numeric_limits<double>::infinity());
  EXPECT_EQ(found->normal, V3(0, 0, 0));
  EXPECT_EQ(found->point, V3(0, 0, 2));
}

TEST(Contact, OfUsersShapesComesWithAnError) {
  const user::Cylinder<float> can{{0, 0, 0}, 1, 2};
  const auto on_ground = contact(can, HalfSpace<3, float>{{0, 0, 1}, -1.5F});
  ASSERT_TRUE(on_ground);
  EXPECT_FLOAT_EQ(on_ground->depth, 0.5F);
  EXPECT_EQ(on_ground->normal, (Vec<3, float>(0, 0, -1)));
  const auto beside = contact(can, Sphere<3, float>{{1.5F, 0, 0}, 1});
  ASSERT_TRUE(beside);
  EXPECT_NEAR(beside->depth, 0.5, beside->error);
  EXPECT_LE(beside->error, 1e-5);
}

// Far from the origin doubles are 1e-7 apart, but results calculated from them lose nothing.
TEST(Contact, FarFromTheOriginIsAsGoodAsNearIt) {
  const V3 far(0x1p30, -0x1p30, 0x1p30);
  const Capsule<3, double> along{far + V3(-1, 0, 0), far + V3(1, 0, 0), 3};
  const Obb<3, double> box{far + V3(0, 0, 4), {1, 1, 1}, Mat<3, double>(0.6, 0, 0.8, 0, 1, 0, -0.8, 0, 0.6)};
  const auto found = contact(along, box);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->depth, 3 - (4 - 1.4), 4e-15);
  EXPECT_LE(found->error, 1e-12);
}

}  // namespace
}  // namespace graze::test::contact_test
