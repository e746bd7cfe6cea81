// SPDX-License-Identifier: MIT
#include <array>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/query/bounds.hpp>
#include <graze/shape/mesh.hpp>

#include "catalogue.hpp"
#include "meshes.hpp"

namespace graze::mesh_test {
namespace {

template <class Make>
std::string refusal_of(const Make& make) {
  try {
    make();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

template <class S>
class MeshIn : public testing::Test {};
TYPED_TEST_SUITE(MeshIn, test::Spaces);

TYPED_TEST(MeshIn, IsEmptyByDefault) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const Mesh<N, T> mesh;
  EXPECT_TRUE(mesh.vertices().empty());
  EXPECT_TRUE(mesh.faces().empty());
  EXPECT_EQ(mesh.kind(), MeshKind::surface);
  EXPECT_TRUE(is_valid(mesh));
  EXPECT_EQ(bounds(mesh), (Aabb<N, T>::nothing()));
  EXPECT_EQ(bounds(transformed(mesh, Pose<N, T>{})), (Aabb<N, T>::nothing()));
}

TYPED_TEST(MeshIn, KeepsWhatItIsMadeOf) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  std::vector<Vec<N, T>> vertices(4, Vec<N, T>(T(0)));
  vertices[1][0] = 1;
  vertices[2][1] = 2;
  vertices[3][0] = 9;
  const std::vector<std::array<std::uint32_t, 3>> faces = {{0, 1, 2}, {2, 2, 1}};
  const Mesh<N, T> mesh = mesh_of<N, T>(vertices, faces, MeshKind::solid);
  EXPECT_TRUE(std::equal(vertices.begin(), vertices.end(), mesh.vertices().begin(), mesh.vertices().end()));
  EXPECT_TRUE(std::equal(faces.begin(), faces.end(), mesh.faces().begin(), mesh.faces().end()));
  EXPECT_EQ(mesh.kind(), MeshKind::solid);
  EXPECT_EQ(mesh.triangle(1).b, vertices[2]);
  EXPECT_EQ(bounds(mesh).max[0], T(1)) << "the last vertex belongs to no face";
  const Mesh<N, T> copy = mesh;
  EXPECT_EQ(copy.vertices().data(), mesh.vertices().data()) << "copies share the triangles";
}

TYPED_TEST(MeshIn, NamesTheVertexOrFaceThatItRefuses) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  std::vector<Vec<N, T>> vertices(3, Vec<N, T>(T(0)));
  const std::array<std::array<std::uint32_t, 3>, 2> faces = {{{0, 1, 2}, {0, 3, 1}}};
  EXPECT_EQ(refusal_of([&] { mesh_of<N, T>(vertices, faces); }),
            "mesh_of: face 1 has vertex 3, but there are 3 vertices, numbered from 0");
  const Mesh<N, T> mesh = mesh_of<N, T>(vertices, std::array<std::array<std::uint32_t, 3>, 1>{faces[0]});
  for (const T wrong : {std::numeric_limits<T>::quiet_NaN(), std::numeric_limits<T>::infinity()}) {
    vertices[2][1] = wrong;
    const std::string flaw = ": vertex 2 has a coordinate that is not finite";
    EXPECT_EQ(refusal_of([&] { mesh_of<N, T>(vertices, faces); }), "mesh_of" + flaw);
    EXPECT_EQ(refusal_of([&] { moved<N, T>(mesh, vertices); }), "moved" + flaw);
  }
  vertices.pop_back();
  EXPECT_EQ(refusal_of([&] { moved<N, T>(mesh, vertices); }), "moved: the mesh has 3 vertices, but 2 are given");
  Pose<N, T> far;
  far.position[0] = std::numeric_limits<T>::infinity();
  EXPECT_EQ(refusal_of([&] { transformed(mesh, far); }), "transformed: a vertex has a coordinate that is not finite");
}

TYPED_TEST(MeshIn, MovesEachVertexAsAPoint) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    const Mesh<N, T> mesh = *test::any<Mesh<N, T>>();
    const Pose<N, T> pose = *test::any_pose<N, T>();
    const Mesh<N, T> placed = transformed(mesh, pose);
    Aabb<N, T> box = Aabb<N, T>::nothing();
    for (std::size_t i = 0; i < mesh.vertices().size(); ++i) {
      RC_ASSERT((placed.vertices()[i] == transformed<N, T>(mesh.vertices()[i], pose)));
    }
    for (std::size_t face = 0; face < mesh.faces().size(); ++face) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const Vec<N, T> expected = placed.vertices()[mesh.faces()[face][corner]];
        RC_ASSERT(placed.triangle(face).vertices()[corner] == expected);
        box.grow(expected);
      }
    }
    RC_ASSERT(bounds(placed) == box);
    RC_ASSERT(placed.faces().data() == mesh.faces().data());
  });
}

TEST(Mesh, MovedFarBetweenItsVerticesHasANewTree) {
  rc::Random random(1);
  const Mesh<3, double> ball = test::bumpy_ball<double>(12, 16, random);
  std::vector<Vec<3, double>> vertices(ball.vertices().begin(), ball.vertices().end());
  const auto total_size = [](const Mesh<3, double>& mesh) {
    return detail::placed(mesh).data()->tree().size_of_boxes();
  };
  for (Vec<3, double>& vertex : vertices) vertex *= 2;
  EXPECT_DOUBLE_EQ(total_size(moved<3, double>(ball, vertices)), total_size(ball));
  for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i] = ball.vertices()[i * 97 % vertices.size()];
  const Mesh<3, double> mixed = moved<3, double>(ball, vertices);
  EXPECT_DOUBLE_EQ(total_size(mixed), total_size(mesh_of<3, double>(vertices, ball.faces())));
}

}  // namespace
}  // namespace graze::mesh_test
