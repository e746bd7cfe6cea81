// SPDX-License-Identifier: MIT
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/convex/zonotope.hpp>

#include "catalogue.hpp"
#include "exact/verdict_instances.hpp"

namespace graze::test::zonotope_test {
namespace {

template <class A, class B>
Relation relation_of(const A& a, const B& b) {
  const Relation one = detail::relation_of_zonotopes(detail::zonotope(a), detail::zonotope(b));
  const Relation two = detail::relation_of_zonotopes(detail::zonotope(b), detail::zonotope(a));
  EXPECT_EQ(one, two) << to_source(a) << ", " << to_source(b);
  return one;
}

TEST(Zonotope, OfAShapeIsItsCenterAndHalfEdges) {
  const auto box = detail::zonotope(Aabb<2, double>{{1, 2}, {5, 8}});
  EXPECT_EQ(box.reference + box.to_center, (Vec<2, double>(3, 5)));
  EXPECT_EQ(box.half_edges[0], (Vec<2, double>(2, 0)));
  EXPECT_EQ(box.half_edges[1], (Vec<2, double>(0, 3)));
  const auto segment = detail::zonotope(Segment<2, double>{{1, 2}, {5, 8}});
  EXPECT_EQ(segment.reference + segment.to_center, (Vec<2, double>(3, 5)));
  EXPECT_EQ(segment.half_edges[0], (Vec<2, double>(2, 3)));
}

TEST(RelationOfZonotopes, KnowsFlatBoxes) {
  const Aabb<3, double> plate{{-1, -1, 0}, {1, 1, 0}};
  EXPECT_EQ(relation_of(plate, plate), Relation::touching);
  EXPECT_EQ(relation_of(plate, Aabb<3, double>{{-1, -1, 0}, {1, 1, 5}}), Relation::touching);
  EXPECT_EQ(relation_of(plate, Aabb<3, double>{{-1, -1, -1}, {1, 1, 5}}), Relation::overlapping);
  EXPECT_EQ(relation_of(plate, Segment<3, double>{{0, 0, -1}, {0, 0, 1}}), Relation::overlapping);
  EXPECT_EQ(relation_of(plate, Segment<3, double>{{0, 0, 0}, {5, 5, 0}}), Relation::touching);
  EXPECT_EQ(relation_of(plate, Segment<3, double>{{1.5, 0, 0}, {0, 1.5, 0}}), Relation::touching);
  EXPECT_EQ(relation_of(plate, Segment<3, double>{{2.5, 0, 0}, {0, 2.5, 0}}), Relation::apart);
  EXPECT_EQ(relation_of(plate, Segment<3, double>{{0, 0, 1}, {0, 0, 1}}), Relation::apart);
}

TEST(RelationOfZonotopes, KnowsEdgesThatCross) {
  // A cube on its edge under another one rotated against it: along z the edges meet at sqrt(2) + sqrt(2).
  const Mat<3, double> on_edge = rotation_matrix(Vec<3, double>(1, 0, 0), 45);
  const Mat<3, double> crossed = rotation_matrix(Vec<3, double>(0, 1, 0), 45);
  const Obb<3, double> low{{0, 0, 0}, {1, 1, 1}, on_edge};
  EXPECT_EQ(relation_of(low, Obb<3, double>{{0, 0, 2.83}, {1, 1, 1}, crossed}), Relation::apart);
  EXPECT_EQ(relation_of(low, Obb<3, double>{{0, 0, 2.82}, {1, 1, 1}, crossed}), Relation::overlapping);
  EXPECT_EQ(relation_of(low, Obb<3, double>{{0, 0, 2 * std::sqrt(2.0)}, {1, 1, 1}, crossed}), Relation::touching);
}

// Two beams on their edges, one above the other, almost parallel: only the cross product of those edges separates them,
// and a plain cross product is mostly rounding there.
TEST(RelationOfZonotopes, KnowsEdgesThatCrossAtAlmostNoAngle) {
  const Vec<3, double> tilt(3, -5, 7);
  const Mat<3, double> tilted = rotation_matrix(tilt, 40);
  const Mat<3, double> on_edge = rotation_matrix(Vec<3, double>(1, 0, 0), 45);
  for (const double radians : {1e-3, 1e-6, 1e-8, 1e-10, 1e-12}) {
    const Mat<3, double> turned = rotation_matrix(Vec<3, double>(0, 0, 1), radians * (180 / 3.14159265358979323846));
    for (const double gap : {1e-2, 1e-6, 1e-10, 1e-12, -1e-12, -1e-10, -1e-6, -1e-2}) {
      const Vec<3, double> up = tilted * Vec<3, double>(0, 0, 2 * std::sqrt(2.0) + gap);
      const Obb<3, double> low{{0, 0, 0}, {9, 1, 1}, tilted * on_edge};
      const Obb<3, double> high{up, {9, 1, 1}, tilted * turned * on_edge};
      const ExactVerdict truth = solid_verdict(solid(low), solid(high), Measure::distance);
      EXPECT_EQ(name_of(relation_of(low, high)), name_of(truth.relation)) << "angle " << radians << ", gap " << gap;
    }
  }
}

TEST(CrossOfDirections, IsExactInDirectionForAlmostParallelEdges) {
  const Vec<3, double> a(0.1, 0.7, -0.3);
  for (const double off : {1.0, 1e-3, 1e-9, 1e-15}) {
    const Vec<3, double> b = a + Vec<3, double>(0.2, -0.5, 0.9) * off;
    const RationalVec<3> truth = cross(exact(a), exact(b));
    const Vec<3, double> product = detail::cross_of_directions(a, b);
    const Vec<3, double> swapped = detail::cross_of_directions(b, a);
    double size = 0;
    for (const Rational& x : truth) size = std::max(size, std::fabs(to_double(x)));
    for (Dim i = 0; i < 3; ++i) {
      const Rational error = exact(product[i]) - truth[static_cast<std::size_t>(i)];
      EXPECT_LE(std::fabs(to_double(error)), 1e-14 * size) << off;
      EXPECT_EQ(product[i], -swapped[i]) << off;
    }
  }
}

}  // namespace
}  // namespace graze::test::zonotope_test
