// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/contact.hpp>
#include <graze/query/contact/boxes.hpp>

#include "catalogue.hpp"

namespace graze::detail::penetration_boxes_test {
namespace {

using V3 = Vec<3, double>;
using Box = Obb<3, double>;

const Box cube{{0, 0, 0}, {1, 1, 1}};

TEST(BoxesSearch, FindsAFaceOrTheEdgesThatTheAxisBelongsTo) {
  const BoxSides<3> sides = sides_of(cube);
  const BoxesAxis<3> on_face = BoxesSearch<3>(sides, sides_of(Box{{0, 0, 1.5}, {1, 1, 1}}), 10).run();
  EXPECT_EQ(on_face.axis.normal, V3(0, 0, 1));
  EXPECT_EQ(on_face.axis.gap, -0.5);
  EXPECT_FALSE(on_face.edges);
  const BoxSides<3> below = sides_of(Box{{0, 0, 0}, {1, 1, 1}, rotation_matrix(V3(0, 1, 0), 45)});
  const BoxSides<3> above = sides_of(Box{{0, 0, 2.5}, {1, 1, 1}, rotation_matrix(V3(1, 0, 0), 45)});
  const BoxesAxis<3> on_edges = BoxesSearch<3>(below, above, 10).run();
  EXPECT_NEAR(length(on_edges.axis.normal - V3(0, 0, 1)), 0, 1e-15);
  EXPECT_NEAR(on_edges.axis.gap, 2.5 - 2 * std::sqrt(2.0), 1e-15);
  ASSERT_TRUE(on_edges.edges);
  EXPECT_EQ((*on_edges.edges)[0], 1);
  EXPECT_EQ((*on_edges.edges)[1], 0);
}

// Up: a's face, b's face, and the edges along the other two of each; and the vertical edges, which have no axis.
constexpr BoxesAxes up_axes = 1U << 2U | 1U << 5U | 1U << 6U | 1U << 7U | 1U << 9U | 1U << 10U | 1U << 14U;
const Mat<3, double> whole_turn = rotation_matrix(V3(1, 2, 3), 50);

TEST(DistinctAxes, OfABoxOnABoxIsTheFirstFacesNormal) {
  const BoxesAxes repeated = repeated_axes(whole_turn, whole_turn * rotation_matrix(V3(0, 0, 1), 20));
  EXPECT_EQ(distinct_axes(up_axes, repeated), 1U << 2U);
  EXPECT_EQ(distinct_axes(1U << 6U, repeated), 1U << 6U);  // nothing else is left
}

TEST(RepeatedAxes, AreNoneOfBoxesThatAreTurnedFreely) {
  EXPECT_EQ(repeated_axes(whole_turn, rotation_matrix(V3(1, 2, 2), 51)), 0U);
}

// Their cross product is an arbitrary direction.
TEST(RepeatedAxes, AreNotAcrossEdgesThatAreNearlyParallel) {
  const BoxesAxes repeated = repeated_axes(whole_turn, whole_turn * rotation_matrix(V3(0, 0, 1), 1e-6));
  EXPECT_EQ(repeated & 1U << 6U, 0U);
  EXPECT_EQ(repeated & 1U << 10U, 0U);
  EXPECT_NE(repeated & 1U << 7U, 0U);
}

// In that case the normal of a face differs from the edge across it.
TEST(RepeatedAxes, AreNoneOfAxesThatAreLessThanOrthonormal) {
  Mat<3, double> skewed(1.0);
  EXPECT_NE(repeated_axes(Mat<3, double>(1.0), skewed), 0U);
  skewed[2][0] = 1e-5;
  EXPECT_EQ(repeated_axes(Mat<3, double>(1.0), skewed), 0U);
}

TEST(FarthestEdge, IsTheOneThatReachesFarthest) {
  const Segment<3, double> edge = farthest_edge(frame_of(cube), 1, V3(1, 0, -0.5));
  EXPECT_EQ(edge.start, V3(1, -1, -1));
  EXPECT_EQ(edge.end, V3(1, 1, -1));
}

TEST(PenetrationOfBoxes, IsAtTheDeepestOfTheManifoldsPoints) {
  const Box floor_box{{0, 0, 0}, {3, 3, 1}};
  const Box tilted{{0, 0, 1.9}, {1, 1, 1}, rotation_matrix(V3(0, 1, 0), 10)};
  for (const bool is_swapped : {false, true}) {
    const Box& a = is_swapped ? tilted : floor_box;
    const Box& b = is_swapped ? floor_box : tilted;
    const BoxesContact<3> contact = contact_of_boxes(a, b);
    EXPECT_EQ(contact.axis.is_of_b, is_swapped);
    const SurfacePairs<3> pairs = pairs_of_boxes(a, b, contact);
    double deepest = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) deepest = std::fmax(deepest, pairs[i].depth);
    EXPECT_NEAR(deepest, contact.found.depth, 1e-15);
    const Penetration<3> found = penetration_of_boxes(a, b);
    EXPECT_NEAR(length(found.point_a - found.point_b - found.normal * deepest), 0, 1e-15);
  }
}

// The search with shortcuts equals the search without.
TEST(BoxesSearch, IsTheLeastOfAllAxes) {
  test::check_property([] {
    const auto [a, b] = *test::any_pair<Box, Box>();
    const double size = size_around_zero(a) + size_around_zero(b);
    SeparatingAxisSearch<Box, Box> search(a, b, size);
    offer_faces(a, b, search);
    const BoxesAxis<3> found = BoxesSearch<3>(sides_of(a), sides_of(b), size).run();
    RC_LOG() << test::to_source(a) << ", " << test::to_source(b) << "\n";
    RC_ASSERT(std::fabs(found.axis.gap - search.best().gap) <= 4 * tolerance::rounding * size);
  });
}

}  // namespace
}  // namespace graze::detail::penetration_boxes_test
