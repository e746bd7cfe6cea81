// SPDX-License-Identifier: MIT
// Contacts with solid meshes: there are some with just what they meet, and they push outward.
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/query/bounds.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/distance.hpp>
#include <graze/query/intersects.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/separation.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "meshes.hpp"
#include "query/every_pair.hpp"

namespace graze::test::solid_contact_laws_test {
namespace {

template <class T>
class SolidContact : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(SolidContact, Scalars);

/// A ball is pushed out of a solid box as out of the box itself, wherever its center is.
TYPED_TEST(SolidContact, PushesABallOutOfABoxAsTheBoxDoes) {
  using T = TypeParam;
  const Aabb<3, T> box{Vec<3, T>(T(-1), T(-2), T(-1)), Vec<3, T>(T(1), T(2), T(3))};
  const Mesh<3, T> mesh = box_mesh(box);
  check_property([&] {
    rc::Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Sphere<3, T> ball{point_in_cube(random, T(3)), static_cast<T>(between(random, 0, 1))};
    const auto expected = contact(box, ball);
    const auto found = contact(mesh, ball);
    RC_LOG() << to_source(ball) << "\n";
    RC_ASSERT(found.has_value() == expected.has_value());
    RC_ASSERT(contact(ball, mesh).has_value() == found.has_value());
    RC_ASSERT((manifold(mesh, ball).size > 0) == found.has_value());
    if (!found) return;
    RC_ASSERT(std::fabs(static_cast<double>(found->depth - expected->depth)) < 1e-5);
    const Sphere<3, T> moved{ball.center + found->normal * found->depth, ball.radius};
    RC_ASSERT(std::fabs(static_cast<double>(distance(box, moved))) < 1e-5);
    RC_ASSERT(relation(box, Sphere<3, T>{moved.center, moved.radius - T(1e-4)}) == Relation::apart ||
              moved.radius < T(1e-4));
  });
}

/// Without the rule for solids, the ground would push what is more than half behind it through to the other side.
TYPED_TEST(SolidContact, PushesWhatIsDeepInItOutward) {
  using T = TypeParam;
  const Mesh<3, T> ground = box_mesh(Aabb<3, T>{Vec<3, T>(T(-9), T(-9), T(-9)), Vec<3, T>(T(9), T(9), T(0))});
  const auto crate_at = [](T z) { return Aabb<3, T>{Vec<3, T>(T(-1), T(-1), z - 1), Vec<3, T>(T(1), T(1), z + 1)}; };
  for (const T z : {T(0.5), T(0), T(-0.5), T(-3)}) {
    const auto found = contact(ground, crate_at(z));
    ASSERT_TRUE(found) << z;
    EXPECT_NEAR(static_cast<double>(found->depth), static_cast<double>(1 - z), 1e-6) << z;
    EXPECT_NEAR(static_cast<double>(found->normal.z), 1, 1e-6) << z;
    EXPECT_GE(manifold(ground, crate_at(z)).size, 3U) << z;
  }
}

/// The mesh with one more face.
template <class T>
Mesh<3, T> with_face(const Mesh<3, T>& mesh, const Triangle<3, T>& face) {
  std::vector<Vec<3, T>> vertices(mesh.vertices().begin(), mesh.vertices().end());
  std::vector<MeshFace> faces(mesh.faces().begin(), mesh.faces().end());
  const auto first = static_cast<std::uint32_t>(vertices.size());
  vertices.insert(vertices.end(), {face.a, face.b, face.c});
  faces.push_back({first, first + 1, first + 2});
  return mesh_of<3, T>(vertices, faces, mesh.kind());
}

/// One face nearby is turned around, so that the shape is before it, or flat.
TYPED_TEST(SolidContact, HasAContactWithWhatIsInsideWhateverTheNearestFace) {
  using T = TypeParam;
  const Mesh<3, T> cube = box_mesh(Aabb<3, T>{Vec<3, T>(T(-1)), Vec<3, T>(T(1))});
  const Vec<3, T> corner(T(0), T(0), T(0.25));
  const Vec<3, T> along_x(T(0.125), T(0), T(0.25));
  const Vec<3, T> along_y(T(0), T(0.125), T(0.25));
  const Sphere<3, T> ball{Vec<3, T>(T(0)), T(0.125)};
  for (const Triangle<3, T>& face : {Triangle<3, T>{corner, along_y, along_x}, {corner, corner, along_x}}) {
    const Mesh<3, T> mesh = with_face(cube, face);
    ASSERT_EQ(relation(mesh, ball), Relation::overlapping);
    const auto found = contact(mesh, ball);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->normal, (Vec<3, T>(T(0), T(0), T(1))));
    EXPECT_EQ(found->depth, T(0.375));
    EXPECT_EQ(contact(ball, mesh)->depth, found->depth);
    EXPECT_EQ(separation(mesh, ball).distance, -found->depth);
    EXPECT_EQ(manifold(mesh, ball).size, 1U);
  }
}

/// Where dot(normal, point) of the plane of a face would overflow.
TYPED_TEST(SolidContact, PushesWhatIsInsideOutOfTheLargestNumbers) {
  using T = TypeParam;
  const T unit = std::numeric_limits<T>::max() / 4;
  const Mesh<3, T> cube = box_mesh(Aabb<3, T>{Vec<3, T>(-3 * unit), Vec<3, T>(3 * unit)});
  const Vec<3, T> corner(T(2.5) * unit);
  const Mesh<3, T> mesh = with_face(cube, Triangle<3, T>{corner, corner, corner - Vec<3, T>(T(0), T(0), unit / 4)});
  for (const AnyShape<3, T>& shape : {AnyShape<3, T>(Vec<3, T>(T(2.375) * unit)),
                                      AnyShape<3, T>(Sphere<3, T>{Vec<3, T>(T(2.25) * unit), unit / 16})}) {
    ASSERT_EQ(relation(AnyShape<3, T>(mesh), shape), Relation::overlapping);
    const auto found = contact(AnyShape<3, T>(mesh), shape);
    ASSERT_TRUE(found);
    EXPECT_TRUE(std::isfinite(found->depth) && is_finite(found->point));
    EXPECT_GT(found->depth, T(0));
    EXPECT_LT(found->depth, unit);
  }
}

TYPED_TEST(SolidContact, HoldsNothingThatIsNotANumber) {
  using T = TypeParam;
  constexpr T nan = std::numeric_limits<T>::quiet_NaN();
  const Mesh<3, T> cube = box_mesh(Aabb<3, T>{Vec<3, T>(T(-1)), Vec<3, T>(T(1))});
  EXPECT_EQ(detail::decide(cube, Sphere<3, T>{Vec<3, T>(T(0)), nan}), Relation::apart);
  EXPECT_EQ(detail::decide(cube, Aabb<3, T>{Vec<3, T>(T(0)), Vec<3, T>(nan)}), Relation::apart);
  EXPECT_EQ(detail::decide(Ray<3, T>{Vec<3, T>(T(0)), Vec<3, T>(nan)}, cube), Relation::apart);
}

/// The center of the shape's box is in the solid, but the shape is around it.
TYPED_TEST(SolidContact, HasNoContactWithWhatIsAroundIt) {
  using T = TypeParam;
  const Mesh<3, T> small = box_mesh(Aabb<3, T>{Vec<3, T>(T(-0.125)), Vec<3, T>(T(0.125))});
  const Mesh<3, T> around = box_mesh(Aabb<3, T>{Vec<3, T>(T(-1)), Vec<3, T>(T(1))}, MeshKind::surface);
  const Triangle<3, T> triangle{{T(-1), T(-1), T(0)}, {T(1), T(-1), T(1)}, {T(1), T(1), T(-1)}};
  for (const AnyShape<3, T>& other : {AnyShape<3, T>(around), AnyShape<3, T>(triangle)}) {
    ASSERT_TRUE(contains(small, bounds(other).center()));
    EXPECT_EQ(relation(AnyShape<3, T>(small), other), Relation::apart);
    EXPECT_FALSE(contact(AnyShape<3, T>(small), other));
    EXPECT_FALSE(contact(other, AnyShape<3, T>(small)));
    const auto near = contact(AnyShape<3, T>(small), other, ContactOptions{.margin = 9});
    ASSERT_TRUE(near);
    EXPECT_EQ(near->depth, -distance(AnyShape<3, T>(small), other));
    EXPECT_EQ(manifold(AnyShape<3, T>(small), other).size, 0U);
    const auto gap = manifold(AnyShape<3, T>(small), other, ContactOptions{.margin = 9});
    ASSERT_GT(gap.size, 0U);
    for (const auto& point : gap.contacts()) {
      EXPECT_LT(point.depth, T(0));
    }
  }
}

/// Of faces at random, open and turned any way, and shapes that lie among them or not.
TYPED_TEST(SolidContact, HasAContactWithJustWhatItMeets) {
  using T = TypeParam;
  check_property([] {
    rc::Random random(*rc::gen::arbitrary<std::uint64_t>());
    std::vector<Vec<3, T>> vertices(4 + random.next() % 8);
    for (Vec<3, T>& vertex : vertices) vertex = point_in_cube(random, T(1));
    std::vector<MeshFace> faces(1 + random.next() % 12);
    for (MeshFace& face : faces) {
      for (std::uint32_t& vertex : face) vertex = static_cast<std::uint32_t>(random.next() % vertices.size());
    }
    const AnyShape<3, T> mesh = mesh_of<3, T>(vertices, faces, MeshKind::solid);
    for (int i = 0; i < 40; ++i) {
      const Source<3, T> from = draw_source<3, T>();
      AnyShape<3, T> other = point_in_cube(random, T(1));
      if (i % 4 == 1) other = Sphere<3, T>{point_in_cube(random, T(1)), T(0.1) * static_cast<T>(between(random, 0, 1))};
      if (i % 4 == 2) {
        const Vec<3, T> center = point_in_cube(random, T(1));
        const auto corner = [&] { return center + T(0.3) * point_in_cube(random, T(1)); };
        other = Triangle<3, T>{corner(), corner(), corner()};
      }
      if (i % 4 == 3) other = draw_shape<3, T>(from, 1);
      RC_LOG() << to_source<3, T>(mesh) << ", " << to_source<3, T>(other) << "\n";
      const bool meet = intersects(mesh, other);
      RC_ASSERT(contact(mesh, other).has_value() == meet);
      RC_ASSERT(contact(other, mesh).has_value() == meet);
      RC_ASSERT((manifold(mesh, other).size > 0) == meet);
      RC_ASSERT((separation(mesh, other).distance > T(0)) == !meet);
      const auto impact = shape_cast(other, Vec<3, T>(T(0.5)), mesh);
      RC_ASSERT(!meet || (impact && impact->t == T(0)));
    }
  });
}

}  // namespace
}  // namespace graze::test::solid_contact_laws_test
