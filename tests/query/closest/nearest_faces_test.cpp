// SPDX-License-Identifier: MIT
// Two trees find what a loop over the faces of one mesh finds, to the bit.
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/query/closest_points.hpp>

#include "catalogue.hpp"
#include "meshes.hpp"
#include "query/same_answers.hpp"

namespace graze::test::nearest_faces_test {
namespace {

/// Face by face, each against the whole other mesh.
template <Dim N, class T>
Proximity<N, double> by_faces_of_first(const Mesh<N, T>& a, const Mesh<N, T>& b) {
  detail::NearestPart<N> best;
  for (std::size_t face = 0; face < a.faces().size(); ++face) {
    best.add(detail::proximity(a.triangle(face), b), face);
  }
  if (best.nearest().relation == Relation::apart) {
    if (const auto point = detail::point_inside(a, b)) return detail::proximity_inside(wide<N, T>(*point));
  }
  return best.nearest();
}

/// What only touches may still be inside, which the faces of the other mesh tell as well.
template <Dim N, class T>
Proximity<N, double> by_faces(const Mesh<N, T>& a, const Mesh<N, T>& b) {
  Proximity<N, double> result = by_faces_of_first(a, b);
  if (result.relation == Relation::touching) result.relation = by_faces_of_first(b, a).relation;
  return result;
}

template <class S>
class NearestFaces : public testing::Test {};
TYPED_TEST_SUITE(NearestFaces, Spaces);

TYPED_TEST(NearestFaces, AreThoseOfALoopOverAllFaces) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  std::array<std::size_t, 3> seen{};
  check_property([&seen] {
    const Source<N, T> from = draw_source<N, T>();
    const Mesh<N, T> a = Entry<Mesh<N, T>>::draw(from);
    const Mesh<N, T> b = *choice(8) == 0 ? a : Entry<Mesh<N, T>>::draw(from);
    RC_LOG() << to_source(a) << ", " << to_source(b) << "\n";
    const Proximity<N, double> expected = by_faces(a, b);
    const Proximity<N, double> found = detail::proximity_of_meshes(a, b);
    RC_ASSERT(same(found, expected));
    ++seen[static_cast<std::size_t>(found.relation)];
  });
  // A few cases, as with sanitizers, may miss one.
  if (seen[0] + seen[1] + seen[2] < 100) return;
  for (const std::size_t times : seen) EXPECT_GT(times, 0U);
}

template <class T>
class NearestFacesOfSolids : public testing::Test {};
using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(NearestFacesOfSolids, Numbers);

template <class T>
Mesh<3, T> scaled(const Mesh<3, T>& mesh, T factor, const Vec<3, T>& by) {
  std::vector<Vec<3, T>> vertices(mesh.vertices().begin(), mesh.vertices().end());
  for (Vec<3, T>& vertex : vertices) vertex = factor * vertex + by;
  return mesh_of<3, T>(vertices, mesh.faces(), mesh.kind());
}

// Balls that are apart, cross each other, or lie one in the other.
TYPED_TEST(NearestFacesOfSolids, AreThoseOfALoopOverAllFaces) {
  using T = TypeParam;
  std::array<std::size_t, 3> seen{};
  check_property([&seen] {
    const MeshKind kind = *choice(2) == 0 ? MeshKind::surface : MeshKind::solid;
    const auto draw = [] { return rc::Random(*rc::gen::arbitrary<std::uint64_t>()); };
    const Mesh<3, T> ball = bumpy_ball<T>(9, 10, draw(), kind);
    const T size = *choice(3) == 0 ? T(0.0625) : T(1);
    const Vec<3, T> by(static_cast<T>(*choice(40)) / T(10), T(0.1), T(0));
    const Mesh<3, T> moved = scaled(bumpy_ball<T>(6, 7, draw(), MeshKind::solid), size, by);
    for (const auto& [a, b] : {std::pair{ball, moved}, std::pair{moved, ball}}) {
      const Proximity<3, double> found = detail::proximity_of_meshes(a, b);
      RC_ASSERT(same(found, by_faces(a, b)));
      ++seen[static_cast<std::size_t>(found.relation)];
    }
  });
  if (seen[0] + seen[1] + seen[2] < 100) return;
  EXPECT_GT(seen[static_cast<std::size_t>(Relation::apart)], 0U);
  EXPECT_GT(seen[static_cast<std::size_t>(Relation::overlapping)], 0U);
}

}  // namespace
}  // namespace graze::test::nearest_faces_test
