// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/query/contains.hpp>
#include <graze/query/distance.hpp>
#include <graze/query/signed_distance.hpp>
#include <graze/query/winding_number.hpp>

#include "catalogue.hpp"
#include "meshes.hpp"

namespace graze::test::winding_number_test {
namespace {

/// The sum of the signed solid angles of all faces, over 4 pi.
template <class T>
double sum_of_solid_angles(const Mesh<3, T>& mesh, const Vec<3, T>& point) {
  using Wide = glm::vec<3, long double>;
  long double sum = 0;
  for (std::size_t face = 0; face < mesh.faces().size(); ++face) {
    std::array<Wide, 3> to;
    std::array<long double, 3> far{};
    for (std::size_t i = 0; i < 3; ++i) {
      to[i] = Wide(mesh.triangle(face).vertices()[i]) - Wide(point);
      far[i] = std::sqrt(glm::dot(to[i], to[i]));
    }
    const long double volume = glm::dot(to[0], glm::cross(to[1], to[2]));
    const long double flat = far[0] * far[1] * far[2] + glm::dot(to[0], to[1]) * far[2] +
                             glm::dot(to[1], to[2]) * far[0] + glm::dot(to[2], to[0]) * far[1];
    sum += std::atan2(volume, flat);
  }
  return static_cast<double>(sum / (2 * std::numbers::pi_v<long double>));
}

/// In 2D: faces that contain the point, with their turn; half of them on an edge.
template <class T>
double sum_of_turns(const Mesh<2, T>& mesh, const Vec<2, T>& point) {
  double sum = 0;
  for (std::size_t face = 0; face < mesh.faces().size(); ++face) {
    const Triangle<2, T> triangle = mesh.triangle(face);
    const int turn = orientation(triangle.a, triangle.b, triangle.c);
    const bool is_inside = orientation(triangle.a, triangle.b, point) == turn &&
                           orientation(triangle.b, triangle.c, point) == turn &&
                           orientation(triangle.c, triangle.a, point) == turn;
    if (is_inside) sum += turn;
  }
  return sum;
}

template <class T>
class WindingNumber : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(WindingNumber, Scalars);

// There the strips from two edges of the hole run through the point.
TYPED_TEST(WindingNumber, IsDefinedWhereACornerOfAHoleIsAheadAlongX) {
  using T = TypeParam;
  const std::vector<Vec<3, T>> corners = {{0, 0, 0}, {0, 0, 1}, {0, -3, -2}};
  const std::vector<MeshFace> faces = {{0, 1, 2}};
  const Mesh<3, T> mesh = mesh_of<3, T>(corners, faces);
  for (const Vec<3, T>& corner : corners) {
    for (const T back : {T(1), T(100), T(0.125)}) {
      const Vec<3, T> point = corner - Vec<3, T>(back, T(0), T(0));
      const Vec<3, T> beside = point + Vec<3, T>(T(0), T(1e-6), T(1e-6));
      EXPECT_NEAR(winding_number(mesh, point), sum_of_solid_angles(mesh, point), 1e-12);
      EXPECT_NEAR(winding_number(mesh, beside), winding_number(mesh, point), 1e-4);
    }
  }
}

TYPED_TEST(WindingNumber, IsTheSumOfSolidAnglesForAnyFaces) {
  using T = TypeParam;
  std::size_t far_from_faces = 0;
  check_property([&far_from_faces] {
    const Source<3, T> from = draw_source<3, T>();
    const Mesh<3, T> mesh = Entry<Mesh<3, T>>::draw(from);
    const Vec<3, T> point = *from.point;
    const double size = 1 + static_cast<double>(max_abs(point));
    RC_PRE(max_abs(point) < T(1e6));
    // Near a face the angles are uncertain; on one, there is no single number.
    RC_PRE(static_cast<double>(distance(mesh, point)) > 1e-3 * size);
    ++far_from_faces;
    const double expected = sum_of_solid_angles(mesh, point);
    RC_LOG() << to_source(mesh) << ", " << to_source(point) << ": " << winding_number(mesh, point) << ", not "
             << expected << "\n";
    RC_ASSERT(std::fabs(winding_number(mesh, point) - expected) < 1e-7);
  });
  EXPECT_GT(far_from_faces, 0U);
}

TYPED_TEST(WindingNumber, CountsHowOftenAClosedSurfaceRunsAroundAPoint) {
  using T = TypeParam;
  const Mesh<3, T> box = box_mesh(Aabb<3, T>{});
  EXPECT_EQ(winding_number(box, Vec<3, T>(T(0))), 1);
  EXPECT_EQ(winding_number(box, Vec<3, T>(T(2), T(0), T(0))), 0);
  EXPECT_EQ(winding_number(box, Vec<3, T>(T(-2), T(0), T(0))), 0);
  std::vector<MeshFace> faces(box.faces().begin(), box.faces().end());
  const std::vector<MeshFace> once = faces;
  faces.insert(faces.end(), once.begin(), once.end());
  EXPECT_EQ((winding_number(mesh_of<3, T>(box.vertices(), faces), Vec<3, T>(T(0)))), 2);
  for (MeshFace& face : faces) std::swap(face[0], face[1]);
  EXPECT_EQ((winding_number(mesh_of<3, T>(box.vertices(), faces), Vec<3, T>(T(0)))), -2);
}

/// Rays through vertices and edges, and along faces, are counted as exactly as others.
TYPED_TEST(WindingNumber, IsOneOfTheSidesOnASurfaceAndExactBesideIt) {
  using T = TypeParam;
  const Mesh<3, T> ring = ring_mesh<T>(12, 8);
  const auto steps = {T(-3), T(-2.5), T(-2), T(-1.5), T(-1), T(0), T(0.25), T(1), T(1.5), T(2), T(2.5)};
  for (const T x : steps) {
    for (const T y : steps) {
      for (const T z : {T(-0.5), T(-0.25), T(0), T(0.25), T(0.5)}) {
        const Vec<3, T> point(x, y, z);
        const double found = winding_number(ring, point);
        if (distance(ring, point) < T(1e-3)) {
          EXPECT_TRUE(found == 0 || found == 1) << to_source(point) << ": " << found;
        } else {
          EXPECT_NEAR(found, sum_of_solid_angles(ring, point), 1e-9) << to_source(point);
          EXPECT_EQ(found, std::round(found));
        }
      }
    }
  }
}

TYPED_TEST(WindingNumber, OfABallIsOneWhereTheCenterSeesThePointBeforeTheSurface) {
  using T = TypeParam;
  check_property([] {
    rc::Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Mesh<3, T> ball = transformed(bumpy_ball<T>(7, 9, random), *any_pose<3, T>());
    const Vec<3, T> center = detail::placed(ball).pose().position;
    RC_PRE(max_abs(center) < T(1e3));
    const Vec<3, double> way(static_cast<double>(random.next() % 2001) - 1000.5,
                             static_cast<double>(random.next() % 2001) - 1000.5,
                             static_cast<double>(random.next() % 2001) - 1000.5);
    const double share = static_cast<double>(random.next() % 2000) / 1000.0;
    const Vec<3, T> point(wide<3, T>(center) + way * (share / length(way)));
    RC_PRE(static_cast<double>(distance(ball, point)) > 1e-3);
    const Segment<3, T> sight{center, point};
    const Mesh<3, T> surface = mesh_of<3, T>(ball.vertices(), ball.faces());
    const bool is_inside = distance(surface, sight) > T(0);
    RC_ASSERT(winding_number(ball, point) == (is_inside ? 1 : 0));
    RC_ASSERT(contains(ball, point) == is_inside);
    RC_ASSERT((signed_distance(ball, point) < T(0)) == is_inside);
  });
}

TYPED_TEST(WindingNumber, IsHalfInTheMouthOfAHemisphereAndFadesOutside) {
  using T = TypeParam;
  const Mesh<3, T> box = box_mesh(Aabb<3, T>{});
  const std::vector<MeshFace> faces(box.faces().begin() + 2, box.faces().end());  // without the lower side, at z = -1
  const Mesh<3, T> open = mesh_of<3, T>(box.vertices(), faces, MeshKind::solid);
  const auto at = [&open](double z) { return winding_number(open, Vec<3, T>(T(0), T(0), static_cast<T>(z))); };
  EXPECT_NEAR(at(0), 5.0 / 6, 1e-12);
  EXPECT_NEAR(at(-1), 0.5, 1e-12);
  EXPECT_LT(at(-2), 0.5);
  EXPECT_NEAR(at(-1e6), 0, 1e-9);
  for (const double z : {-3.0, -1.5, -0.5, 0.5, 1.5, 3.0}) {
    EXPECT_NEAR(at(z), sum_of_solid_angles(open, Vec<3, T>(T(0), T(0), static_cast<T>(z))), 1e-12) << z;
  }
  EXPECT_TRUE(contains(open, Vec<3, T>(T(0), T(0), T(0.9))));
  EXPECT_FALSE(contains(open, Vec<3, T>(T(0), T(0), T(-1.5))));
}

/// Scaling by a power of two changes no bit, also of the number of an open mesh.
TEST(WindingNumberOfAnySize, IsTheSame) {
  rc::Random random(7);
  const Mesh<3, double> ball = bumpy_ball<double>(8, 10, random);
  const std::vector<MeshFace> most(ball.faces().begin() + 1, ball.faces().end());
  const auto number = [&](double scale, std::span<const MeshFace> faces, const Vec<3, double>& point) {
    std::vector<Vec<3, double>> vertices(ball.vertices().begin(), ball.vertices().end());
    for (Vec<3, double>& vertex : vertices) vertex *= scale;
    return winding_number(mesh_of<3, double>(vertices, faces), point * scale);
  };
  for (const Vec<3, double>& point :
       {Vec<3, double>(0.5, 0.25, 0.125), {-1.5, 0.1, 0.2}, {0, 0, 0}, {0.1, 0.2, 1.25}, {-0.75, -0.25, 0.5}}) {
    for (const double scale : {0x1p-900, 0x1p-365, 0x1p-290, 0x1p290, 0x1p342, 0x1p1000}) {
      EXPECT_EQ(number(scale, ball.faces(), point), number(1, ball.faces(), point)) << scale;
      EXPECT_EQ(number(scale, most, point), number(1, most, point)) << scale;
    }
  }
}

TYPED_TEST(WindingNumber, InThePlaneCountsFacesWithTheirTurn) {
  using T = TypeParam;
  check_property([] {
    const Source<2, T> from = draw_source<2, T>();
    const Mesh<2, T> mesh = Entry<Mesh<2, T>>::draw(from);
    const Vec<2, T> point = *from.point;
    for (std::size_t face = 0; face < mesh.faces().size(); ++face) {
      const auto corners = mesh.triangle(face).vertices();
      for (std::size_t i = 0; i < 3; ++i) RC_PRE(orientation(corners[i], corners[(i + 1) % 3], point) != 0);
    }
    RC_ASSERT(winding_number(mesh, point) == sum_of_turns(mesh, point));
  });
}

}  // namespace
}  // namespace graze::test::winding_number_test
