// SPDX-License-Identifier: MIT
#include <array>
#include <cstdint>
#include <vector>

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/broad/touching_faces.hpp>
#include <graze/query/intersects.hpp>

#include "catalogue.hpp"
#include "exact.hpp"
#include "meshes.hpp"

namespace graze::test::touching_faces_test {
namespace {

template <Dim N, class T>
bool do_touch(const Triangle<N, T>& a, const Triangle<N, T>& b) {
  return exact_verdict<N, T>(a, b, Measure::distance).relation != Relation::apart;
}

template <class S>
class TouchingFaces : public testing::Test {};
TYPED_TEST_SUITE(TouchingFaces, Spaces);

TYPED_TEST(TouchingFaces, AreAllPairsThatShareAPoint) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  check_property([] {
    const Source<N, T> from = draw_source<N, T>();
    const Mesh<N, T> a = Entry<Mesh<N, T>>::draw(from);
    const Mesh<N, T> b = *choice(4) == 0 ? a : Entry<Mesh<N, T>>::draw(from);
    RC_LOG() << to_source(a) << ", " << to_source(b) << "\n";
    std::vector<Pair> expected;
    for (std::uint32_t i = 0; i < a.faces().size(); ++i) {
      for (std::uint32_t j = 0; j < b.faces().size(); ++j) {
        if (do_touch(a.triangle(i), b.triangle(j))) expected.push_back({i, j});
      }
    }
    RC_ASSERT(touching_faces(a, b) == expected);
    if (!expected.empty()) RC_ASSERT(intersects(a, b));
  });
}

TEST(VisitTouchingFaces, StopsWhenToldTo) {
  const Mesh<3, float> ring = ring_mesh<float>(20, 12);
  int visited = 0;
  EXPECT_FALSE(visit_touching_faces(ring, ring, [&visited](const Pair&) { return ++visited < 3; }));
  EXPECT_EQ(visited, 3);
}

}  // namespace
}  // namespace graze::test::touching_faces_test
