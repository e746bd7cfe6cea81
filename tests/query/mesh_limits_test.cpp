// SPDX-License-Identifier: MIT
// Meshes whose numbers are near their limits have the answers of a loop over their faces.
#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/closest_points.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/transformed.hpp>
#include <graze/shape/mesh.hpp>
#include <graze/shape/obb.hpp>

#include "catalogue/numbers.hpp"
#include "meshes.hpp"

namespace graze::test::mesh_limits_test {
namespace {

template <class T>
class MeshesNearTheLimits : public testing::Test {
 public:
  static constexpr T most = std::numeric_limits<T>::max();

  static Vec<3, T> draw_vector(rc::Random& random, double size) {
    return Vec<3, T>(size * Vec<3, double>(between(random, -1, 1), between(random, -1, 1), between(random, -1, 1)));
  }

  static Mat<3, T> draw_rotation(rc::Random& random) {
    return Pose<3, T>::from_axis_angle({}, draw_vector(random, 1) + Vec<3, T>(T(2), 0, 0), between(random, -3, 3))
        .rotation;
  }

  static Mesh<3, T> ball(T radius, MeshKind kind = MeshKind::surface) {
    const Mesh<3, T> unit = bumpy_ball<T>(9, 10, rc::Random(3), kind);
    std::vector<Vec<3, T>> vertices(unit.vertices().begin(), unit.vertices().end());
    for (Vec<3, T>& vertex : vertices) vertex *= radius;
    return mesh_of<3, T>(vertices, unit.faces(), kind);
  }

  static Relation by_faces(const Mesh<3, T>& mesh, const Obb<3, T>& box) {
    Relation result = Relation::apart;
    for (std::size_t face = 0; face < mesh.faces().size(); ++face) {
      result = std::max(result, relation(mesh.triangle(face), box));
    }
    return result;
  }

  static double least_distance(const Mesh<3, T>& a, const Mesh<3, T>& b) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t face = 0; face < a.faces().size(); ++face) {
      least = std::min(least, detail::proximity(a.triangle(face), b).distance);
    }
    return least;
  }
};
using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(MeshesNearTheLimits, Numbers);

// The faces are moved to where sums of coordinates overflow.
TYPED_TEST(MeshesNearTheLimits, TouchOrientedBoxesAsTheirFacesDo) {
  using T = TypeParam;
  rc::Random random(1);
  std::size_t touching = 0;
  for (const T place : {this->most / 100, this->most / 8, this->most / 2, this->most * T(0.7)}) {
    const T radius = this->most / 40;
    const Mesh<3, T> unmoved = this->ball(radius);
    for (int round = 0; round < 100; ++round) {
      const Mesh<3, T> mesh = transformed(unmoved, Pose<3, T>{this->draw_rotation(random), Vec<3, T>(place)});
      const double off = 2 * static_cast<double>(radius);
      const Obb<3, T> box{Vec<3, T>(place) + this->draw_vector(random, off),
                          Vec<3, T>(radius) + this->draw_vector(random, 0.9 * static_cast<double>(radius)),
                          this->draw_rotation(random)};
      const Relation expected = this->by_faces(mesh, box);
      EXPECT_EQ(relation(mesh, box), expected) << "at " << place;
      touching += expected != Relation::apart ? 1 : 0;
    }
  }
  EXPECT_GT(touching, 100U);
}

TYPED_TEST(MeshesNearTheLimits, AreAsFarApartAsTheirFaces) {
  using T = TypeParam;
  rc::Random random(2);
  for (const T place : {this->most / 100, this->most * T(0.9)}) {
    const Mesh<3, T> unmoved = this->ball(this->most / 300);
    for (int round = 0; round < 10; ++round) {
      const double radius = static_cast<double>(this->most / 300);
      const Vec<3, T> at(place);
      const Vec<3, T> way = Vec<3, T>(static_cast<T>(1.6 * radius)) + this->draw_vector(random, radius);
      const Mesh<3, T> a = transformed(unmoved, Pose<3, T>{this->draw_rotation(random), at});
      const Mesh<3, T> b = transformed(unmoved, Pose<3, T>{this->draw_rotation(random), at + way});
      EXPECT_EQ(detail::proximity_of_meshes(a, b).distance, this->least_distance(a, b)) << "at " << place;
    }
    const Mesh<3, T> c = transformed(unmoved, Pose<3, T>{this->draw_rotation(random), Vec<3, T>(place)});
    const Mesh<3, T> d = transformed(unmoved, Pose<3, T>{this->draw_rotation(random), Vec<3, T>(-place)});
    EXPECT_EQ(detail::proximity_of_meshes(c, d).distance, this->least_distance(c, d)) << "at +-" << place;
  }
}

}  // namespace
}  // namespace graze::test::mesh_limits_test
