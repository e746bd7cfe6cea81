// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/query/mass_properties.hpp>
#include <graze/shape/convex_mesh.hpp>

#include "catalogue.hpp"
#include "query/point_sets.hpp"

namespace graze::convex_mesh_test {
namespace {

template <class T>
std::vector<std::uint32_t> edges_of_face(const ConvexMesh<T>& mesh, std::size_t face) {
  std::vector<std::uint32_t> edges{mesh.faces[face]};
  while (mesh.half_edges[edges.back()].next != edges.front()) edges.push_back(mesh.half_edges[edges.back()].next);
  return edges;
}

template <class T>
std::vector<Vec<3, T>> corners_of_face(const ConvexMesh<T>& mesh, std::size_t face) {
  std::vector<Vec<3, T>> corners;
  for (const std::uint32_t edge : edges_of_face(mesh, face)) {
    corners.push_back(mesh.vertices[mesh.half_edges[edge].origin]);
  }
  return corners;
}

template <class T>
double volume_of(const ConvexMesh<T>& mesh) {
  double volume = 0;
  for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
    const std::vector<Vec<3, T>> corners = corners_of_face(mesh, face);
    const auto from_first = [&](std::size_t i) { return wide<3, T>(corners[i]) - wide<3, T>(mesh.vertices[0]); };
    for (std::size_t i = 2; i < corners.size(); ++i) {
      volume += dot(from_first(0), accurate_cross(from_first(i - 1), from_first(i))) / 6;
    }
  }
  return volume;
}

std::vector<Vec<3, float>> grid(int size) {
  std::vector<Vec<3, float>> points;
  for (int x = 0; x < size; ++x) {
    for (int y = 0; y < size; ++y) {
      for (int z = 0; z < size; ++z) points.emplace_back(z, x, y);
    }
  }
  return points;
}

TEST(ConvexMesh, OfAGridIsACube) {
  const ConvexMesh<float> cube = convex_mesh<float>(grid(4));
  EXPECT_EQ(cube.vertices,
            (std::vector<Vec<3, float>>{
                {0, 0, 0}, {0, 0, 3}, {0, 3, 0}, {0, 3, 3}, {3, 0, 0}, {3, 0, 3}, {3, 3, 0}, {3, 3, 3}}));
  ASSERT_EQ(cube.faces.size(), 6U);
  EXPECT_EQ(cube.half_edges.size(), 24U);
  EXPECT_EQ(corners_of_face(cube, 0), (std::vector<Vec<3, float>>{{0, 0, 0}, {0, 0, 3}, {0, 3, 3}, {0, 3, 0}}));
  EXPECT_EQ(corners_of_face(cube, 1), (std::vector<Vec<3, float>>{{0, 0, 0}, {0, 3, 0}, {3, 3, 0}, {3, 0, 0}}));
  EXPECT_EQ(corners_of_face(cube, 5), (std::vector<Vec<3, float>>{{3, 0, 0}, {3, 3, 0}, {3, 3, 3}, {3, 0, 3}}));
  EXPECT_EQ(face_plane(cube, 0).normal, (Vec<3, double>(-1, 0, 0)));
  EXPECT_EQ(face_plane(cube, 5).normal, (Vec<3, double>(1, 0, 0)));
  EXPECT_EQ(face_plane(cube, 5).offset, 3);
  EXPECT_EQ(volume_of(cube), 27);
}

TEST(ConvexMesh, OfAPyramidHasOneSquareFace) {
  const std::vector<Vec<3, double>> points{{0, 0, 2},  {1, 1, 0}, {-1, 1, 0}, {-1, -1, 0},
                                           {1, -1, 0}, {0, 1, 0}, {0, 0, 1}};
  const ConvexMesh<double> pyramid = convex_mesh<double>(points);
  EXPECT_EQ(pyramid.vertices.size(), 5U);
  std::multiset<std::size_t> sizes;
  for (std::size_t face = 0; face < pyramid.faces.size(); ++face) sizes.insert(edges_of_face(pyramid, face).size());
  EXPECT_EQ(sizes, (std::multiset<std::size_t>{3, 3, 3, 3, 4}));
}

TEST(ConvexMesh, OfFlatPointsIsAPolygonFromBothSides) {
  const std::vector<Vec<3, double>> points{{0, 0, 5}, {2, 0, 5}, {1, 1, 5}, {0, 2, 5}, {2, 2, 5}, {1, 0, 5}};
  const ConvexMesh<double> square = convex_mesh<double>(points);
  EXPECT_EQ(square.vertices.size(), 4U);
  ASSERT_EQ(square.faces.size(), 2U);
  EXPECT_EQ(corners_of_face(square, 0), (std::vector<Vec<3, double>>{{0, 0, 5}, {0, 2, 5}, {2, 2, 5}, {2, 0, 5}}));
  EXPECT_EQ(corners_of_face(square, 1), (std::vector<Vec<3, double>>{{0, 0, 5}, {2, 0, 5}, {2, 2, 5}, {0, 2, 5}}));
  EXPECT_EQ(face_plane(square, 0).normal, (Vec<3, double>(0, 0, -1)));
  EXPECT_EQ(face_plane(square, 1).normal, (Vec<3, double>(0, 0, 1)));
}

TEST(ConvexMesh, IsOfAnyRowOfPoints) {
  const std::array<Vec<3, double>, 4> array{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  EXPECT_EQ(convex_mesh(array).faces.size(), 4U);
  EXPECT_EQ(convex_mesh(std::vector<Vec<3, double>>(array.begin(), array.end())).vertices.size(), 4U);
}

TEST(ConvexMesh, OfLessHasNoFaces) {
  const auto expect_vertices = [](const std::vector<Vec<3, float>>& points,
                                  const std::vector<Vec<3, float>>& vertices) {
    const ConvexMesh<float> mesh = convex_mesh<float>(points);
    EXPECT_EQ(mesh.vertices, vertices);
    EXPECT_TRUE(mesh.faces.empty());
    EXPECT_TRUE(mesh.half_edges.empty());
  };
  expect_vertices({{2, 2, 2}, {1, 1, 1}, {3, 3, 3}}, {{1, 1, 1}, {3, 3, 3}});
  expect_vertices({{1, 2, 3}, {1, 2, 3}}, {{1, 2, 3}});
}

TEST(ConvexMesh, RefusesNoPointsAndNumbersThatAreNotFinite) {
  const auto refusal_of = [](const std::vector<Vec<3, double>>& points) -> std::string {
    try {
      convex_mesh<double>(points);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal_of({}), "convex_mesh: there are no points");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal_of({{0, 0, 0}, {0, nan, 0}}), "convex_mesh: a point has a coordinate that is not finite");
}

TEST(ConvexMesh, HasPlanesForTheLargestAndLeastCoordinates) {
  for (const double size : {1e150, 1e-150}) {
    const ConvexMesh<double> mesh =
        convex_mesh<double>(std::vector<Vec<3, double>>{{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}});
    ASSERT_EQ(mesh.faces.size(), 4U);
    EXPECT_EQ(face_plane(mesh, 0).normal, (Vec<3, double>(-1, 0, 0)));
    EXPECT_NEAR(face_plane(mesh, 3).offset / size, std::sqrt(1.0 / 3), 1e-15);
  }
}

template <class T>
class ConvexMeshIn : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(ConvexMeshIn, Scalars);

template <class T>
void check_links(const ConvexMesh<T>& mesh) {
  for (std::uint32_t i = 0; i < mesh.half_edges.size(); ++i) {
    const HalfEdge& edge = mesh.half_edges[i];
    const HalfEdge& twin = mesh.half_edges[edge.twin];
    RC_ASSERT(twin.twin == i);
    RC_ASSERT(edge.twin != i);
    RC_ASSERT(twin.origin == mesh.half_edges[edge.next].origin);
    RC_ASSERT(mesh.half_edges[twin.next].origin == edge.origin);
    RC_ASSERT(mesh.half_edges[edge.next].face == edge.face);
    RC_ASSERT(twin.face != edge.face);
  }
  std::size_t count = 0;
  for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
    RC_ASSERT(mesh.half_edges[mesh.faces[face]].face == face);
    const std::vector<std::uint32_t> edges = edges_of_face(mesh, face);
    RC_ASSERT(edges.size() >= 3U);
    for (std::size_t i = 0; i < edges.size(); ++i) RC_ASSERT(edges[i] == mesh.faces[face] + i);
    count += edges.size();
  }
  RC_ASSERT(count == mesh.half_edges.size());
  if (!mesh.faces.empty()) RC_ASSERT(mesh.vertices.size() + mesh.faces.size() == mesh.half_edges.size() / 2 + 2);
}

TYPED_TEST(ConvexMeshIn, IsLinkedAndHasTheVerticesOfThePolytope) {
  using T = TypeParam;
  test::check_property([] {
    const std::vector<Vec<3, T>> points = test::draw_points<3, T>(30);
    const ConvexMesh<T> mesh = convex_mesh<T>(points);
    check_links(mesh);
    const Polytope<3, T> polytope = convex_hull<3, T>(points);
    RC_ASSERT(
        std::equal(mesh.vertices.begin(), mesh.vertices.end(), polytope.vertices().begin(), polytope.vertices().end()));
    const ConvexMesh<T> again = convex_mesh(polytope);
    RC_ASSERT(again.half_edges == mesh.half_edges);
  });
}

/// All vertices of a face are coplanar, and all others strictly inside: so neighbouring faces are not coplanar.
TYPED_TEST(ConvexMeshIn, HasFacesThatAreFlatAndStrictlyConvex) {
  using T = TypeParam;
  test::check_property([] {
    const std::vector<Vec<3, T>> points = test::draw_points<3, T>(30);
    const ConvexMesh<T> mesh = convex_mesh<T>(points);
    if (mesh.faces.size() < 3) return;
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
      const std::vector<Vec<3, T>> corners = corners_of_face(mesh, face);
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec<3, T>& next = corners[(i + 1) % corners.size()];
        const Vec<3, T>& after = corners[(i + 2) % corners.size()];
        RC_ASSERT(!detail::are_on_one_line(corners[i], next, after));
        for (const Vec<3, T>& vertex : mesh.vertices) {
          const bool is_corner = std::find(corners.begin(), corners.end(), vertex) != corners.end();
          RC_ASSERT(orientation(corners[i], next, after, vertex) == (is_corner ? 0 : -1));
        }
        for (const Vec<3, T>& point : points) RC_ASSERT(orientation(corners[i], next, after, point) <= 0);
      }
    }
  });
}

TYPED_TEST(ConvexMeshIn, DoesNotDependOnTheOrderOfPoints) {
  using T = TypeParam;
  test::check_property([] {
    std::vector<Vec<3, T>> points = test::draw_points<3, T>(30);
    const ConvexMesh<T> mesh = convex_mesh<T>(points);
    const auto turn = static_cast<std::ptrdiff_t>(*test::choice(points.size()));
    std::rotate(points.begin(), points.begin() + turn, points.end());
    std::reverse(points.begin(), points.begin() + turn);
    points.push_back(points.front());
    const ConvexMesh<T> other = convex_mesh<T>(points);
    RC_ASSERT(other.vertices == mesh.vertices);
    RC_ASSERT(other.half_edges == mesh.half_edges);
    RC_ASSERT(other.faces == mesh.faces);
  });
}

TYPED_TEST(ConvexMeshIn, HasTheVolumeOfThePolytope) {
  using T = TypeParam;
  test::check_property([] {
    const std::vector<Vec<3, T>> points = test::draw_points<3, T>(30);
    const Polytope<3, T> polytope = convex_hull<3, T>(points);
    const double volume = mass_properties(polytope).volume;
    double size = 0;
    for (const Vec<3, T>& vertex : polytope.vertices()) {
      size = std::max(size, max_abs(wide<3, T>(vertex) - wide<3, T>(polytope.vertices()[0])));
    }
    RC_ASSERT(std::fabs(volume_of(convex_mesh(polytope)) - volume) <= 64 * tolerance::epsilon * size * size * size);
  });
}

}  // namespace
}  // namespace graze::convex_mesh_test
