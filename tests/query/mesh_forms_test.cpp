// SPDX-License-Identifier: MIT
// Different lists of vertices and faces that describe the same points have the same answers.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/query/closest_points.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/contains.hpp>
#include <graze/query/distance.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/signed_distance.hpp>
#include <graze/query/winding_number.hpp>

#include "catalogue.hpp"
#include "meshes.hpp"
#include "query/same_answers.hpp"

namespace graze::test::mesh_forms_test {
namespace {

template <class T>
class MeshForms : public testing::Test {
 public:
  using Point = Vec<3, T>;
  using Form = Mesh<3, T>;
  using Faces = std::vector<MeshFace>;

  /// A closed mesh or one with holes, a shape near it, a point and a direction; all on a grid of 1/32, so that middles
  /// of edges and their differences are exact.
  struct Case {
    Form mesh;
    AnyShape<3, T> other;
    Point point;
    Point direction;
  };

  static T on_grid(rc::Random& random, int most) {
    return static_cast<T>(static_cast<int>(random.next() % static_cast<std::uint64_t>(2 * most + 1)) - most) / T(32);
  }
  static Point point_on_grid(rc::Random& random, int most) {
    const T x = on_grid(random, most);
    const T y = on_grid(random, most);
    return {x, y, on_grid(random, most)};
  }

  static Case draw() {
    rc::Random random(*rc::gen::arbitrary<std::uint64_t>());
    const MeshKind kind = random.next() % 2 == 0 ? MeshKind::solid : MeshKind::surface;
    const Form ball = bumpy_ball<T>(6, 7, random, kind);
    std::vector<Point> vertices(ball.vertices().begin(), ball.vertices().end());
    for (Point& vertex : vertices) {
      for (Dim i = 0; i < 3; ++i) vertex[i] = std::round(vertex[i] * 32) / 32;
    }
    Faces faces(ball.faces().begin(), ball.faces().end());
    for (std::size_t holes = random.next() % 4; holes > 0; --holes) faces.pop_back();
    const Point center = point_on_grid(random, 48);
    AnyShape<3, T> other = Sphere<3, T>{center, std::fabs(on_grid(random, 16))};
    if (random.next() % 3 == 0) other = Capsule<3, T>{center, point_on_grid(random, 48), std::fabs(on_grid(random, 8))};
    if (random.next() % 3 == 0) other = Triangle<3, T>{center, point_on_grid(random, 48), point_on_grid(random, 48)};
    Point direction = point_on_grid(random, 32);
    if (direction == Point(T(0))) direction.x = 1;
    return {mesh_of<3, T>(vertices, faces, kind), other, point_on_grid(random, 64), direction};
  }

  static std::vector<std::uint32_t> shuffled(std::size_t count) {
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0U);
    rc::Random random(*rc::gen::arbitrary<std::uint64_t>());
    for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random.next() % i]);
    return order;
  }

  /// Every face in four, at the middles of its edges.
  static Form subdivided(const Form& mesh) {
    std::vector<Point> vertices(mesh.vertices().begin(), mesh.vertices().end());
    Faces faces;
    for (const MeshFace& face : mesh.faces()) {
      MeshFace middle{};
      for (std::size_t i = 0; i < 3; ++i) {
        middle[i] = static_cast<std::uint32_t>(vertices.size());
        vertices.push_back((vertices[face[i]] + vertices[face[(i + 1) % 3]]) / T(2));
      }
      faces.push_back({face[0], middle[0], middle[2]});
      faces.push_back({face[1], middle[1], middle[0]});
      faces.push_back({face[2], middle[2], middle[1]});
      faces.push_back(middle);
    }
    return mesh_of<3, T>(vertices, faces, mesh.kind());
  }

  /// What does not depend on which of several faces decides.
  static void check_same_set(const Case& one, const Form& form, T error) {
    const AnyShape<3, T> before = one.mesh;
    const AnyShape<3, T> after = form;
    const auto is_near = [error](T a, T b) { return std::fabs(a - b) <= error; };
    RC_LOG() << to_source(one.mesh) << ", " << to_source<3, T>(one.other) << "\n";
    RC_ASSERT(relation(after, one.other) == relation(before, one.other));
    RC_ASSERT(is_near(distance(after, one.other), distance(before, one.other)));
    RC_ASSERT(is_near(signed_distance(form, one.point), signed_distance(one.mesh, one.point)));
    RC_ASSERT(contains(form, one.point) == contains(one.mesh, one.point));
    RC_ASSERT(std::fabs(winding_number(form, one.point) - winding_number(one.mesh, one.point)) < T(1e-5));
    const Ray<3, T> ray{one.point, one.direction};
    const auto hit = ray_cast(form, ray);
    const auto expected = ray_cast(one.mesh, ray);
    RC_ASSERT(hit.has_value() == expected.has_value());
    if (hit) RC_ASSERT(std::fabs(hit->t - expected->t) * max_abs(one.direction) <= error);
  }
};
using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(MeshForms, Numbers);

// The faces keep their order, so everything is the same to the bit, also what depends on the first of equal faces.
TYPED_TEST(MeshForms, HaveAnswersThatDoNotDependOnTheOrderOfVertices) {
  using T = TypeParam;
  check_property([] {
    const auto one = TestFixture::draw();
    const std::size_t count = one.mesh.vertices().size();
    const std::vector<std::uint32_t> new_place = TestFixture::shuffled(count);
    std::vector<Vec<3, T>> vertices(count);
    for (std::size_t i = 0; i < count; ++i) vertices[new_place[i]] = one.mesh.vertices()[i];
    std::vector<MeshFace> faces(one.mesh.faces().begin(), one.mesh.faces().end());
    for (MeshFace& face : faces) {
      for (std::uint32_t& vertex : face) vertex = new_place[vertex];
    }
    const Mesh<3, T> form = mesh_of<3, T>(vertices, faces, one.mesh.kind());
    TestFixture::check_same_set(one, form, T(0));
    const AnyShape<3, T> before = one.mesh;
    const AnyShape<3, T> after = form;
    RC_ASSERT(same(closest_points(after, one.other), closest_points(before, one.other)));
    RC_ASSERT(contact(after, one.other) == contact(before, one.other));
    RC_ASSERT(manifold(after, one.other) == manifold(before, one.other));
    const Ray<3, T> ray{one.point, one.direction};
    RC_ASSERT(ray_cast(form, ray) == ray_cast(one.mesh, ray));
  });
}

TYPED_TEST(MeshForms, HaveAnswersThatDoNotDependOnTheOrderOfFaces) {
  using T = TypeParam;
  check_property([] {
    const auto one = TestFixture::draw();
    std::vector<MeshFace> faces;
    for (const std::uint32_t face : TestFixture::shuffled(one.mesh.faces().size())) {
      faces.push_back(one.mesh.faces()[face]);
    }
    TestFixture::check_same_set(one, mesh_of<3, T>(one.mesh.vertices(), faces, one.mesh.kind()), T(0));
  });
}

TYPED_TEST(MeshForms, HaveAnswersThatDoNotDependOnTheFirstVertexOfAFace) {
  using T = TypeParam;
  check_property([] {
    const auto one = TestFixture::draw();
    std::vector<MeshFace> faces(one.mesh.faces().begin(), one.mesh.faces().end());
    for (std::size_t i = 0; i < faces.size(); ++i) {
      std::rotate(faces[i].begin(), faces[i].begin() + static_cast<std::ptrdiff_t>(i % 3), faces[i].end());
    }
    const Mesh<3, T> form = mesh_of<3, T>(one.mesh.vertices(), faces, one.mesh.kind());
    TestFixture::check_same_set(one, form, 16 * std::numeric_limits<T>::epsilon());
  });
}

TYPED_TEST(MeshForms, HaveAnswersThatDoNotDependOnTheSideOfSurfaces) {
  using T = TypeParam;
  check_property([] {
    auto one = TestFixture::draw();
    one.mesh = mesh_of<3, T>(one.mesh.vertices(), one.mesh.faces());
    std::vector<MeshFace> faces(one.mesh.faces().begin(), one.mesh.faces().end());
    for (MeshFace& face : faces) std::swap(face[1], face[2]);
    const Mesh<3, T> form = mesh_of<3, T>(one.mesh.vertices(), faces);
    const AnyShape<3, T> turned = form;
    RC_ASSERT(relation(turned, one.other) == relation(AnyShape<3, T>(one.mesh), one.other));
    RC_ASSERT(std::fabs(winding_number(form, one.point) + winding_number(one.mesh, one.point)) < T(1e-5));
    const Ray<3, T> ray{one.point, one.direction};
    RC_ASSERT(ray_cast(form, ray).has_value() == ray_cast(one.mesh, ray).has_value());
  });
}

TYPED_TEST(MeshForms, HaveAnswersThatDoNotDependOnSubdivision) {
  using T = TypeParam;
  check_property([] {
    const auto one = TestFixture::draw();
    TestFixture::check_same_set(one, TestFixture::subdivided(one.mesh), 64 * std::numeric_limits<T>::epsilon());
  });
}

TYPED_TEST(MeshForms, AreScaledByPowersOfTwoToTheBit) {
  using T = TypeParam;
  check_property([] {
    const auto one = TestFixture::draw();
    const T factor = std::ldexp(T(1), static_cast<int>(*choice(41)) - 20);
    std::vector<Vec<3, T>> vertices(one.mesh.vertices().begin(), one.mesh.vertices().end());
    for (Vec<3, T>& vertex : vertices) vertex *= factor;
    const Mesh<3, T> form = mesh_of<3, T>(vertices, one.mesh.faces(), one.mesh.kind());
    const Vec<3, T> point = factor * one.point;
    RC_ASSERT(signed_distance(form, point) == factor * signed_distance(one.mesh, one.point));
    RC_ASSERT(contains(form, point) == contains(one.mesh, one.point));
    const auto hit = ray_cast(form, Ray<3, T>{point, one.direction});
    const auto expected = ray_cast(one.mesh, Ray<3, T>{one.point, one.direction});
    RC_ASSERT(hit.has_value() == expected.has_value());
    if (!hit) return;
    RC_ASSERT(hit->t == factor * expected->t && hit->point == factor * expected->point);
    RC_ASSERT(hit->face == expected->face && hit->normal == expected->normal);
    RC_ASSERT(hit->barycentric == expected->barycentric);
  });
}

}  // namespace
}  // namespace graze::test::mesh_forms_test
