// SPDX-License-Identifier: MIT
// A surface mesh is the compound of its faces, bit for bit; a solid one is that and what is inside.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/math/motion.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/closest_boundary_point.hpp>
#include <graze/query/closest_point.hpp>
#include <graze/query/closest_points.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/distance.hpp>
#include <graze/query/intersects.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/mass_properties.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/query/signed_distance.hpp>
#include <graze/query/time_of_impact.hpp>
#include <graze/query/transformed.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "meshes.hpp"
#include "parts_of.hpp"
#include "query/every_pair.hpp"
#include "query/same_answers.hpp"

namespace graze::test::mesh_laws_test {
namespace {

template <class SpaceType>
class SurfaceMesh : public ::testing::Test {
 public:
  static constexpr Dim dimension = SpaceType::dimension;
  using Number = typename SpaceType::scalar;
  using Any = AnyShape<dimension, Number>;
  using Point = Vec<dimension, Number>;

  struct Case {
    Mesh<dimension, Number> mesh;  ///< In one of two cases seen through a pose.
    Any any;
    Any parts;
    Any other;  ///< Not a union, which would be split first.
    Point motion;
    Point point;
  };

  /// A grid of faces on few vertices, so that many are equally near.
  static Case draw() {
    const Source<dimension, Number> from = draw_source<dimension, Number>();
    std::vector<Point> vertices = *some<Point>(12, from.point);
    std::vector<MeshFace> faces(*choice(60));
    for (MeshFace& face : faces) {
      for (std::uint32_t& vertex : face) vertex = static_cast<std::uint32_t>(*choice(vertices.size()));
    }
    Mesh<dimension, Number> mesh = mesh_of<dimension, Number>(vertices, faces);
    if (*choice(2) == 0) {
      const Pose<dimension, Number> pose = Entry<Pose<dimension, Number>>::draw(from);
      for (const Point& vertex : vertices) RC_PRE(is_finite(transformed<dimension, Number>(vertex, pose)));
      mesh = transformed(mesh, pose);
    }
    Any other = draw_shape<dimension, Number>(from, 0);
    RC_PRE((!is_union<dimension, Number>(other)));
    const Point motion = *from.point;
    RC_LOG() << to_source(mesh) << ", " << to_source<dimension, Number>(other) << "\n";
    return {mesh, mesh, as_compound(mesh), other, motion, *from.point};
  }
};
TYPED_TEST_SUITE(SurfaceMesh, Spaces);

TYPED_TEST(SurfaceMesh, AnswersForPairsAsTheCompoundOfItsFaces) {
  check_property([] {
    const auto [mesh, any, parts, other, motion, point] = TestFixture::draw();
    RC_ASSERT(relation(any, other) == relation(parts, other));
    RC_ASSERT(relation(other, any) == relation(other, parts));
    RC_ASSERT(same(closest_points(any, other), closest_points(parts, other)));
    RC_ASSERT(same(closest_points(other, any), closest_points(other, parts)));
    RC_ASSERT(contact(any, other) == contact(parts, other));
    RC_ASSERT(contact(other, any) == contact(other, parts));
    RC_ASSERT(manifold(any, other) == manifold(parts, other));
    RC_ASSERT(manifold(other, any) == manifold(other, parts));
  });
}

TYPED_TEST(SurfaceMesh, MovesAsTheCompoundOfItsFaces) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  check_property([] {
    const auto [mesh, any, parts, other, motion, point] = TestFixture::draw();
    RC_ASSERT(shape_cast(any, motion, other) == shape_cast(parts, motion, other));
    RC_ASSERT(shape_cast(other, motion, any) == shape_cast(other, motion, parts));
    Motion<N, T> turning;
    turning.linear = motion;
    turning.center = point;
    turning.angular = Turn<N, T>(1.5);
    const Motion<N, T> resting;
    RC_ASSERT(time_of_impact(any, turning, other, resting) == time_of_impact(parts, turning, other, resting));
    RC_ASSERT(time_of_impact(other, turning, any, resting) == time_of_impact(other, turning, parts, resting));
  });
}

TYPED_TEST(SurfaceMesh, AnswersForPointsAndRaysAsTheCompoundOfItsFaces) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  check_property([] {
    const auto [mesh, any, parts, other, motion, point] = TestFixture::draw();
    RC_ASSERT(bounds(any) == bounds(parts));
    RC_ASSERT(contains(any, point) == contains(parts, point));
    RC_ASSERT(signed_distance(any, point) == signed_distance(parts, point));
    RC_ASSERT((same_point<N, T>(closest_point(any, point), closest_point(parts, point))));
    RC_ASSERT((same_point<N, T>(closest_boundary_point(any, point), closest_boundary_point(parts, point))));
    const MassProperties<N> mass = mass_properties(any);
    RC_ASSERT(mass.volume == mass_properties(parts).volume);
    RC_ASSERT((same_point<N, double>(mass.centroid, mass_properties(parts).centroid)));
    for (const RaySide side : {RaySide::entry, RaySide::exit}) {
      const RayOptions options{side};
      const Segment<N, T> segment{point, point + motion};
      RC_ASSERT(ray_cast(any, segment, options) == ray_cast(parts, segment, options));
      if (max_abs(motion) == T(0)) continue;
      const Ray<N, T> ray{point, motion};
      for (const T t_max : {T(1), std::numeric_limits<T>::infinity()}) {
        const auto expected = ray_cast(parts, ray, t_max, options);
        RC_ASSERT(ray_cast(any, ray, t_max, options) == expected);
        const auto hit = ray_cast(mesh, ray, t_max, options);
        RC_ASSERT(hit.has_value() == expected.has_value());
        if (!hit) continue;
        RC_ASSERT((static_cast<const RayHit<N, T>&>(*hit) == *expected));
        RC_ASSERT(ray_cast(mesh.triangle(hit->face), ray, t_max, options) == expected);
      }
    }
  });
}

TYPED_TEST(SurfaceMesh, HitsAreAtTheirBarycentricCoordinates) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  check_property([] {
    const auto [mesh, any, parts, other, motion, point] = TestFixture::draw();
    RC_PRE(max_abs(motion) > T(0));
    const auto hit = ray_cast(mesh, Ray<N, T>{point, motion});
    RC_PRE(hit.has_value());
    const auto corners = mesh.triangle(hit->face).vertices();
    Vec<N, double> mean(0.0);
    double sum = 0;
    double size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto weight = static_cast<double>(hit->barycentric[static_cast<Dim>(i)]);
      RC_ASSERT(weight >= 0 && weight <= 1);
      sum += weight;
      mean += weight * wide<N, T>(corners[i]);
      size = std::max({size, static_cast<double>(max_abs(corners[i])), static_cast<double>(max_abs(point))});
    }
    RC_PRE(size < 1e9);
    RC_ASSERT(std::fabs(sum - 1) <= 4 * static_cast<double>(std::numeric_limits<T>::epsilon()));
    const double error = 64 * static_cast<double>(std::numeric_limits<T>::epsilon()) * size;
    RC_LOG() << mean[0] << ", " << mean[1] << " for " << hit->point[0] << ", " << hit->point[1] << "\n";
    RC_ASSERT(max_abs(mean - wide<N, T>(hit->point)) <= error);
  });
}

/// Its height is a rounding of T, and the point is beside it by another.
TEST(MeshHit, OfASliverHasTheWeightsOfItsPoint) {
  const Mesh<2, float> mesh = mesh_of<2, float>(
      std::vector<Vec<2, float>>{{2.5F, -1.5000004F}, {-4.5F, -4.500001F}, {-1, -3.0000007F}}, {{MeshFace{0, 1, 2}}});
  const auto hit = ray_cast(mesh, Ray<2, float>{{-1.999F, -4}, {0, 1}});
  ASSERT_TRUE(hit);
  const auto corners = mesh.triangle(0).vertices();
  const Vec<2, float> mean =
      hit->barycentric[0] * corners[0] + hit->barycentric[1] * corners[1] + hit->barycentric[2] * corners[2];
  EXPECT_LT(max_abs(mean - hit->point), 2e-6F);
}

TEST(MeshHit, OfAThinOrHugeFaceHasTheWeightsOfItsPoint) {
  for (const double height : {1e-155, 3e-162, 1e-300}) {
    const Mesh<3, double> thin =
        mesh_of<3, double>(std::vector<Vec<3, double>>{{0, 0, 0}, {1, 0, 0}, {0.5, height, 0}}, {{MeshFace{0, 1, 2}}});
    const auto hit = ray_cast(thin, Ray<3, double>{{0.375, 0, 1}, {0, 0, -1}});
    ASSERT_TRUE(hit) << height;
    EXPECT_NEAR(hit->barycentric[1] + 0.5 * hit->barycentric[2], 0.375, 1e-15) << height;
  }
  const Mesh<3, double> huge = mesh_of<3, double>(
      std::vector<Vec<3, double>>{{-1e308, -1e308, 0}, {1e308, -1e308, 0}, {0, 1e308, 0}}, {{MeshFace{0, 1, 2}}});
  const auto hit = ray_cast(huge, Ray<3, double>{{1e307, 2e307, 1e307}, {0, 0, -1}});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(max_abs(hit->barycentric - Vec<3, double>(0.15, 0.25, 0.6)), 0, 1e-15);
}

template <class T>
class SolidMesh : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(SolidMesh, Scalars);

TYPED_TEST(SolidMesh, OfABoxIsTheBox) {
  using T = TypeParam;
  check_property([] {
    const Source<3, T> from = draw_source<3, T>();
    const Aabb<3, T> box = Entry<Aabb<3, T>>::draw(from);
    for (Dim i = 0; i < 3; ++i) RC_PRE(box.max[i] > box.min[i]);
    RC_PRE(max_abs(box.min) < T(1e6) && max_abs(box.max) < T(1e6));
    const Mesh<3, T> mesh = box_mesh(box);
    const AnyShape<3, T> other = draw_shape<3, T>(from, 1);
    RC_LOG() << to_source(box) << ", " << to_source<3, T>(other) << "\n";
    const Relation expected = relation(AnyShape<3, T>(box), other);
    const Relation found = relation(AnyShape<3, T>(mesh), other);
    RC_ASSERT(found == expected || found == Relation::touching || expected == Relation::touching);
    const double size = static_cast<double>(std::max(max_abs(box.min), max_abs(box.max)));
    const auto distance_of_box = static_cast<double>(distance(AnyShape<3, T>(box), other));
    RC_PRE(distance_of_box < 1e9);
    const double error = 1e-5 * (size + distance_of_box);
    RC_ASSERT(std::fabs(static_cast<double>(distance(AnyShape<3, T>(mesh), other)) - distance_of_box) <= error);
    const Vec<3, T> point = *from.point;
    RC_PRE(max_abs(point) < T(1e6));
    const auto is_clear = [size](T gap) { return std::fabs(static_cast<double>(gap)) > 1e-6 * size; };
    if (is_clear(signed_distance(box, point))) RC_ASSERT(contains(mesh, point) == contains(box, point));
    RC_ASSERT(std::fabs(static_cast<double>(signed_distance(mesh, point) - signed_distance(box, point))) <=
              1e-5 * (size + static_cast<double>(max_abs(point))));
    const Vec<3, T> direction = *from.direction;
    const auto hit = ray_cast(mesh, Ray<3, T>{point, direction});
    const auto hit_of_box = ray_cast(box, Ray<3, T>{point, direction});
    if (relation(box, Ray<3, T>{point, direction}) == Relation::touching) return;
    RC_ASSERT(hit.has_value() == hit_of_box.has_value());
    if (hit && contains(box, point)) RC_ASSERT(hit->t == T(0));
  });
}

TYPED_TEST(SolidMesh, OfAHullHasItsMassAndItsInside) {
  using T = TypeParam;
  check_property([] {
    rc::Random random(*rc::gen::arbitrary<std::uint64_t>());
    std::vector<Vec<3, T>> points(4 + random.next() % 30);
    for (Vec<3, T>& point : points) point = point_in_cube(random, T(1));
    const Polytope<3, T> hull = convex_hull<3, T>(points);
    const Mesh<3, T> mesh = hull_mesh(hull);
    const MassProperties<3> expected = mass_properties(hull);
    const MassProperties<3> found = mass_properties(mesh);
    RC_ASSERT(std::fabs(found.volume - expected.volume) < 1e-12);
    RC_ASSERT(max_abs(found.centroid - expected.centroid) < 1e-9);
    for (int i = 0; i < 20; ++i) {
      const Vec<3, T> point = point_in_cube(random, T(1));
      if (std::fabs(signed_distance(hull, point)) < T(1e-5)) continue;
      RC_ASSERT(contains(mesh, point) == contains(hull, point));
      const Sphere<3, T> ball{point, T(0.05)};
      if (std::fabs(signed_distance(hull, point) - ball.radius) < T(1e-5)) continue;
      RC_ASSERT(intersects(mesh, ball) == intersects(hull, ball));
    }
  });
}

/// Aimed at vertices and at points of edges, from inside: every ray hits, also where two faces meet.
TYPED_TEST(SolidMesh, LetsNoRayOut) {
  using T = TypeParam;
  const std::size_t rays = 20 * number_of_cases(100);
  std::size_t shot = 0;
  for (std::uint64_t seed = 1; shot < rays; ++seed) {
    rc::Random random(seed);
    const Mesh<3, T> ball = bumpy_ball<T>(12, 16, random, MeshKind::surface);
    const Vec<3, T> origin = point_in_cube(random, T(0.3));
    for (std::size_t face = 0; face < ball.faces().size(); ++face, ++shot) {
      const Triangle<3, T> triangle = ball.triangle(face);
      const T along = static_cast<T>(between(random, 0, 1));
      const Vec<3, T> target = face % 2 == 0 ? triangle.a : triangle.a + along * (triangle.b - triangle.a);
      const Ray<3, T> ray{origin, (target - origin) * (T(0.1) + 5 * static_cast<T>(between(random, 0, 1)))};
      ASSERT_TRUE(ray_cast(ball, ray).has_value()) << to_source(ray) << " leaves the ball of seed " << seed;
      ASSERT_TRUE(intersects(ball, ray)) << to_source(ray);
    }
  }
}

TYPED_TEST(SolidMesh, TouchesWhatIsWhollyInside) {
  using T = TypeParam;
  const Mesh<3, T> ring = ring_mesh<T>(24, 12);
  const Mesh<3, T> small = transformed(box_mesh(Aabb<3, T>{Vec<3, T>(T(-0.1)), Vec<3, T>(T(0.1))}),
                                       Pose<3, T>{.position = {T(2), T(0), T(0)}});
  EXPECT_EQ(relation(ring, small), Relation::overlapping);
  EXPECT_EQ(relation(small, ring), Relation::overlapping);
  EXPECT_EQ(distance(ring, small), T(0));
  EXPECT_EQ(relation(ring, Sphere<3, T>{{T(0), T(2), T(0)}, T(0.1)}), Relation::overlapping);
  EXPECT_EQ(relation(ring, Sphere<3, T>{{T(0), T(0), T(0)}, T(0.1)}), Relation::apart) << "in the hole";
  const Mesh<3, T> surface = ring_mesh<T>(24, 12, MeshKind::surface);
  EXPECT_EQ(relation(surface, small), Relation::apart) << "a surface has no inside";
  const auto hit = ray_cast(ring, Ray<3, T>{{T(2), T(0), T(0)}, {T(1), T(0), T(0)}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->t, T(0));
  EXPECT_EQ(hit->face, no_face);
  const auto out = ray_cast(ring, Ray<3, T>{{T(2), T(0), T(0)}, {T(1), T(0), T(0)}}, std::numeric_limits<T>::infinity(),
                            RayOptions{RaySide::exit});
  ASSERT_TRUE(out);
  EXPECT_NEAR(static_cast<double>(out->t), 0.5, 1e-6);
  EXPECT_LT(out->face, ring.faces().size());
}

}  // namespace
}  // namespace graze::test::mesh_laws_test
