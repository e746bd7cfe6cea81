// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
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

/// The corners of all faces in the order of the tree.
std::vector<Vec<3, double>> corners_in_tree(const Mesh<3, double>& mesh) {
  std::vector<Vec<3, double>> corners;
  for (std::size_t place = 0; place < mesh.faces().size(); ++place) {
    for (const auto& corner : detail::placed(mesh).triangle_in_tree(place).vertices()) corners.push_back(corner);
  }
  return corners;
}

TEST(Mesh, MovedFarBetweenItsVerticesHasANewTree) {
  rc::Random random(1);
  const Mesh<3, double> ball = test::bumpy_ball<double>(12, 16, random);
  std::vector<Vec<3, double>> vertices(ball.vertices().begin(), ball.vertices().end());
  for (Vec<3, double>& vertex : vertices) vertex *= 2;
  std::vector<Vec<3, double>> same_order = corners_in_tree(ball);
  for (Vec<3, double>& corner : same_order) corner *= 2;
  EXPECT_EQ(corners_in_tree(moved<3, double>(ball, vertices)), same_order);
  for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i] = ball.vertices()[i * 97 % vertices.size()];
  const Mesh<3, double> mixed = moved<3, double>(ball, vertices);
  EXPECT_EQ(corners_in_tree(mixed), corners_in_tree(mesh_of<3, double>(vertices, ball.faces())));
}

/// Runs all tasks at the same time, or from the last to the first.
struct Disorder {
  template <class Task>
  void parallel_for(std::size_t count, const Task& task) const {
    if (is_parallel) {
      std::vector<std::thread> threads;
      for (std::size_t i = 0; i < count; ++i) threads.emplace_back([&task, i] { task(i); });
      for (std::thread& thread : threads) thread.join();
    } else {
      for (std::size_t i = count; i > 0; --i) task(i - 1);
    }
  }

  bool is_parallel;
};

TEST(Mesh, IsTheSameWhoeverBuildsIt) {
  rc::Random random(2);
  const Mesh<3, double> ball = test::bumpy_ball<double>(200, 250, random);
  ASSERT_GT(ball.faces().size(), 5 * detail::length_of_piece);
  for (const bool is_parallel : {false, true}) {
    const Mesh<3, double> other = mesh_of<3, double>(ball.vertices(), ball.faces(), ball.kind(), Disorder{is_parallel});
    EXPECT_EQ(corners_in_tree(other), corners_in_tree(ball));
    EXPECT_EQ(other.kind(), ball.kind());
  }
}

}  // namespace
}  // namespace graze::mesh_test
