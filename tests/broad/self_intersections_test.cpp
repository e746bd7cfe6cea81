// SPDX-License-Identifier: MIT
#include <array>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/broad/self_intersections.hpp>
#include <graze/broad/touching_faces.hpp>

#include "catalogue.hpp"
#include "exact.hpp"
#include "meshes.hpp"

namespace graze::test::self_intersections_test {
namespace {

/// a with its common vertices cut off, and b enlarged from there: they meet if and only if the faces share more.
template <Dim N>
bool do_cross_at_vertex(const Triangle<N, double>& a, const Triangle<N, double>& b) {
  constexpr double large = 0x1p20;
  const auto halfway = [&](const Vec<N, double>& end) { return a.a * 0.5 + end * 0.5; };
  const auto enlarged = [&](const Vec<N, double>& end) { return b.a + (end - b.a) * large; };
  const Polytope<N, double> cut =
      convex_hull<N, double>(std::vector<Vec<N, double>>{halfway(a.b), halfway(a.c), a.b, a.c});
  const Triangle<N, double> wide_b{b.a, enlarged(b.b), enlarged(b.c)};
  return exact_verdict<N, double>(cut, wide_b, Measure::distance).relation != Relation::apart;
}

template <class S>
class SelfIntersections : public testing::Test {
 public:
  static constexpr Dim dimension = S::dimension;
  using Number = typename S::scalar;
  using Point = Vec<dimension, Number>;

  static Point small_point() {
    Point point;
    for (Dim i = 0; i < dimension; ++i) point[i] = static_cast<Number>(*choice(5));
    return point;
  }
  static Triangle<dimension, double> widened(const Point& a, const Point& b, const Point& c) {
    return {wide<dimension, Number>(a), wide<dimension, Number>(b), wide<dimension, Number>(c)};
  }
};
TYPED_TEST_SUITE(SelfIntersections, Spaces);

TYPED_TEST(SelfIntersections, AtAVertexAreThoseOfConesFromThere) {
  using Fixture = TestFixture;
  static constexpr Dim N = Fixture::dimension;
  using T = typename Fixture::Number;
  std::size_t crossing = 0;
  check_property([&crossing] {
    std::vector<Vec<N, T>> v(5);
    for (auto& each : v) each = Fixture::small_point();
    // A flat face could reach over the vertex to both sides.
    const auto a = Fixture::widened(v[0], v[1], v[2]);
    const auto b = Fixture::widened(v[0], v[3], v[4]);
    RC_PRE((!detail::is_flat(a.vertices())) && (!detail::is_flat(b.vertices())));
    const Mesh<N, T> mesh = mesh_of<N, T>(v, std::array<MeshFace, 2>{{{0, 1, 2}, {4, 0, 3}}});
    const bool do_cross = do_cross_at_vertex<N>(a, b);
    crossing += do_cross ? 1 : 0;
    RC_LOG() << to_source(mesh) << "\n";
    RC_ASSERT((self_intersections(mesh) == (do_cross ? std::vector<Pair>{{0, 1}} : std::vector<Pair>{})));
  });
  EXPECT_GT(crossing, 0U);
}

TYPED_TEST(SelfIntersections, AtAnEdgeAreFacesFoldedOntoEachOther) {
  using Fixture = TestFixture;
  static constexpr Dim N = Fixture::dimension;
  using T = typename Fixture::Number;
  check_property([] {
    std::vector<Vec<N, T>> v(4);
    for (auto& each : v) each = Fixture::small_point();
    const auto area = [&v](std::size_t k) {
      const Vec<N, double> edge = wide<N, T>(v[1] - v[0]);
      const Vec<N, double> to = wide<N, T>(v[k] - v[0]);
      if constexpr (N == 3) return Vec<3, double>(glm::cross(edge, to));
      if constexpr (N == 2) return Vec<3, double>(0.0, 0.0, edge[0] * to[1] - edge[1] * to[0]);
    };
    RC_PRE(max_abs(area(2)) > 0 && max_abs(area(3)) > 0);
    const bool is_folded = max_abs(glm::cross(area(2), area(3))) == 0 && dot(area(2), area(3)) > 0;
    const Mesh<N, T> mesh = mesh_of<N, T>(v, std::array<MeshFace, 2>{{{0, 1, 2}, {0, 3, 1}}});
    RC_LOG() << to_source(mesh) << "\n";
    RC_ASSERT(self_intersections(mesh).empty() != is_folded);
  });
}

TYPED_TEST(SelfIntersections, OfFacesWithoutCommonVerticesAreThoseThatTouch) {
  using Fixture = TestFixture;
  static constexpr Dim N = Fixture::dimension;
  using T = typename Fixture::Number;
  check_property([] {
    std::vector<Vec<N, T>> v(12);
    for (auto& each : v) each = Fixture::small_point();
    const Mesh<N, T> mesh = mesh_of<N, T>(v, std::array<MeshFace, 4>{{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11}}});
    std::vector<Pair> expected;
    for (const Pair& pair : touching_faces(mesh, mesh)) {
      if (pair.a < pair.b) expected.push_back(pair);
    }
    RC_ASSERT(self_intersections(mesh) == expected);
  });
}

TEST(SelfIntersections, AreNoneInAGoodMeshAndAllInADoubledOne) {
  const Mesh<3, float> ring = ring_mesh<float>(20, 12);
  EXPECT_TRUE(self_intersections(ring).empty());
  std::vector<MeshFace> faces(ring.faces().begin(), ring.faces().end());
  const auto count = static_cast<std::uint32_t>(faces.size());
  for (std::uint32_t face = 0; face < count; ++face) faces.push_back({faces[face][1], faces[face][0], faces[face][2]});
  const std::vector<Pair> twice = self_intersections(mesh_of<3, float>(ring.vertices(), faces));
  ASSERT_EQ(twice.size(), count);
  for (std::uint32_t face = 0; face < count; ++face) EXPECT_EQ(twice[face], (Pair{face, face + count}));
}

TEST(SelfIntersections, OfFlatFacesAreThoseOfTheirSegments) {
  const auto crossings = [](std::vector<Vec<2, double>> v, std::vector<MeshFace> faces) {
    return self_intersections(mesh_of<2, double>(v, faces)).size();
  };
  // From vertex 0 at the origin: 1 right, 2 left, 3 up, 4 farther right.
  const std::vector<Vec<2, double>> v = {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {2, 0}};
  EXPECT_EQ(crossings(v, {{0, 1, 2}, {0, 3, 3}}), 0U);
  EXPECT_EQ(crossings(v, {{0, 1, 2}, {0, 3, 4}}), 1U);
  EXPECT_EQ(crossings(v, {{0, 1, 1}, {0, 4, 4}}), 1U);
  EXPECT_EQ(crossings(v, {{0, 1, 1}, {0, 2, 2}}), 0U);
  EXPECT_EQ(crossings(v, {{0, 1, 4}, {0, 1, 2}}), 0U) << "both share the edge from 0 to 1 and no more";
  EXPECT_EQ(crossings(v, {{1, 0, 2}, {1, 0, 2}}), 1U);
  EXPECT_EQ(crossings(v, {{0, 0, 0}, {0, 1, 3}}), 0U);
}

TEST(SelfIntersections, StopWhenToldTo) {
  const Mesh<3, float> ring = ring_mesh<float>(20, 12);
  EXPECT_TRUE(visit_self_intersections(ring, [](const Pair&) { return false; }));
  const Mesh<3, float> twice = mesh_of<3, float>(ring.vertices(), std::vector<MeshFace>(3, ring.faces()[0]));
  int visited = 0;
  EXPECT_FALSE(visit_self_intersections(twice, [&visited](const Pair&) { return ++visited < 2; }));
  EXPECT_EQ(visited, 2);
}

}  // namespace
}  // namespace graze::test::self_intersections_test
