// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include <graze/query/closest_points.hpp>

#include "catalogue.hpp"

namespace graze::detail::closest_unbounded_test {
namespace {

using V2 = Vec<2, double>;
using V3 = Vec<3, double>;
using R3 = Ray<3, double>;
using P3 = Plane<3, double>;
using H3 = HalfSpace<3, double>;

TEST(ExtremesOver, APlaneAreInUnitsOfLength) {
  const P3 plane{{0, 0, 4}, 8};
  const auto box = extremes_over(plane, Aabb<3, double>{{0, 0, 0}, {1, 1, 1}});
  EXPECT_EQ(box.lowest.height, -2);
  EXPECT_EQ(box.highest.height, -1);
  EXPECT_EQ(box.highest.point.z, 1);
  const auto turned = extremes_over(plane, Obb<3, double>{{0, 0, 5}, {1, 2, 3}, Mat<3, double>(1.0)});
  EXPECT_EQ(turned.lowest.height, 0);
  EXPECT_EQ(turned.highest.height, 6);
}

TEST(CrossingOf, ARayAndAPlaneIsOnThePlane) {
  const P3 plane{{0, 0, 4}, 8};
  EXPECT_EQ(crossing_of(R3{{1, 2, 0}, {1, 0, 1}}, plane), V3(3, 2, 2));
  EXPECT_EQ(crossing_of(R3{{1, 2, 2}, {1, 0, 0}}, plane), V3(1, 2, 2));
}

TEST(CrossingOf, PlanesIsOnBothHoweverSmallTheAngle) {
  for (const double angle : {1.0, 1e-4, 1e-8, 1e-12}) {
    const UnitPlane first{V3(0, 0, 1), 2};
    const UnitPlane second{V3(std::sin(angle), 0, std::cos(angle)), 2 + angle};
    const V3 common = crossing_of(first, second);
    EXPECT_NEAR(dot(first.normal, common), first.offset, 1e-15);
    EXPECT_NEAR(dot(second.normal, common), second.offset, 2e-15);
  }
}

template <class A, class B>
Vec<dimension_of<A>, double> common_point(const A& a, const B& b) {
  const auto found = proximity(a, b);
  EXPECT_NE(found.relation, Relation::apart);
  EXPECT_EQ(found.point_a, found.point_b);
  EXPECT_EQ(found.normal, (Vec<dimension_of<A>, double>(0.0)));
  return found.point_a;
}

TEST(Levels, ThatMeetHaveACommonPointNearTheOrigin) {
  const P3 floor{{0, 0, 2}, 4};
  EXPECT_EQ(common_point(floor, P3{{0, 1, 0}, 3}), V3(0, 3, 2));
  EXPECT_EQ(common_point(floor, H3{{0, 1, 0}, 3}), V3(0, 0, 2));  // below y = 3
  EXPECT_EQ(common_point(floor, H3{{0, 1, 0}, -3}), V3(0, -3, 2));
  EXPECT_EQ(common_point(H3{{0, 0, 2}, 4}, H3{{0, 1, 0}, -3}), V3(0, -3, 0));
  EXPECT_EQ(common_point(H3{{0, 0, 1}, -1}, H3{{0, 1, 0}, -3}), V3(0, -3, -1));
  EXPECT_EQ(common_point(H3{{0, 0, 1}, -1}, H3{{0, 0, 1}, -3}), V3(0, 0, -3));
  EXPECT_EQ(common_point(floor, P3{{0, 0, -1}, -2}), V3(0, 0, 2));
  EXPECT_EQ(common_point(Plane<2, double>{{1, 0}, 1}, Plane<2, double>{{0, 1}, 2}), V2(1, 2));
}

TEST(Levels, ThatAreApartAreParallel) {
  const auto planes = proximity(P3{{0, 0, 2}, 4}, P3{{0, 0, -1}, -5});
  EXPECT_EQ(planes.distance, 3);
  EXPECT_EQ(planes.normal, V3(0, 0, planes.point_b.z > planes.point_a.z ? 1 : -1));
  EXPECT_EQ(std::fabs(planes.point_b.z - planes.point_a.z), 3);
  const auto solids = proximity(H3{{0, 0, 1}, 1}, H3{{0, 0, -1}, -5});
  EXPECT_EQ(solids.distance, 4);
  EXPECT_EQ(solids.point_a, V3(0, 0, 1));
  EXPECT_EQ(solids.point_b, V3(0, 0, 5));
  EXPECT_EQ(solids.normal, V3(0, 0, 1));
}

TEST(Rays, AreNearestAtOriginsOrWhereTheirLinesAre) {
  const R3 along{{0, 0, 0}, {2, 0, 0}};
  const auto crossing = closest_of_rays(along, R3{{3, 4, 5}, {0, -1, 0}});
  EXPECT_EQ(crossing.on_a, V3(3, 0, 0));
  EXPECT_EQ(crossing.on_b, V3(3, 0, 5));
  EXPECT_EQ(crossing.squared, 25);
  EXPECT_EQ(closest_of_rays(along, R3{{3, 4, 3}, {0, 1, 0}}).squared, 25);    // away from it
  EXPECT_EQ(closest_of_rays(along, R3{{-3, 4, 0}, {-1, 0, 0}}).squared, 25);  // back to back
  EXPECT_EQ(closest_of_rays(along, R3{{-3, 4, 0}, {1, 0, 0}}).squared, 16);   // side by side
  EXPECT_EQ(closest_of_rays(along, R3{{9, 4, 0}, {-1, 0, 0}}).squared, 16);   // one towards the other
  EXPECT_EQ(closest_of_rays(along, R3{{9, 0, 0}, {-1, 0, 0}}).squared, 0);
}

TEST(Rays, ThatAreNearlyParallelAreNearestFarAway) {
  const double slope = 0x1p-30;
  const auto found = closest_of_rays(R3{{0, 0, 0}, {1, 0, 0}}, R3{{0, 1, 3}, {1, -slope, 0}});
  EXPECT_NEAR(std::sqrt(found.squared), 3, 1e-15);
  EXPECT_NEAR(found.on_a.x, 0x1p30, 1e-6);
}

TEST(SeenBeside, CutsARayBehindWhatItIsCutFor) {
  const R3 ray{{1, 0, 0}, {1e-3, 0, 0}};
  const auto cut = local_beside(V3(1, 0, 0), ray, Sphere<3, double>{{6, 0, 0}, 2});
  EXPECT_EQ(cut.start, V3(0, 0, 0));
  EXPECT_GT(cut.end.x, 7);
  EXPECT_LT(cut.end.x, 15);
}

}  // namespace
}  // namespace graze::detail::closest_unbounded_test
