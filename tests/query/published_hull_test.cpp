// SPDX-License-Identifier: MIT
// Published cases: hulls, smallest spheres and masses. query/published_cases.hpp describes the rows.
#include <array>

#include <gtest/gtest.h>

#include "query/published_cases.hpp"

namespace graze::test::published_hull_test {
namespace {

constexpr std::array<PublishedCase, 21> cases = {{
    {"Box2D ShapeMassTest", "2D mass", "sphere 1 0 1", "", "3.141592653589793 1 0"},
    {"Box2D ShapeMassTest", "2D mass", "capsule -1 0 1 0 1", "", "7.141592653589793 0 0"},
    {"Box2D ShapeMassTest", "2D mass", "polytope 4 -1 -1 1 -1 1 1 -1 1", "", "4 0 0"},
    {"hbf/miniball issue 41", "3D ball", "polytope 5 1 0 0 0 1 0 0 0 1 0 0 0 0 -2 0", "", "1.5 0 -0.5 0"},
    {"marmakoide/miniball issue 4: 16.8 and not 3.9", "3D ball", "polytope 3 -6 -4 5 0 -2 0 -2 -6 -1", "",
     "4.0942835630592125 -3.1052631578947367 -3.6052631578947367 2.1315789473684212"},
    {"OpenCV issue 6438: 12.5 instead of 0.5", "2D ball", "polytope 3 0 0 0.5 0.01 1 0", "", "0.5 0.5 0"},
    {"OpenCV issue 6438 in another order", "2D ball", "polytope 3 0.5 0.01 0 0 1 0", "", "0.5 0.5 0"},
    {"OpenCV issue 6438 in another order", "2D ball", "polytope 3 1 0 0.5 0.01 0 0", "", "0.5 0.5 0"},
    {"Hipparchus issue 20: WelzlEncloser failed", "3D double ball",
     "polytope 5 0.9999999731 0.000200015 0.0001174338 0.9987716667 0.0350821284 0.0349914572 0.9987856181 "
     "-0.0346743952 0.0349996489 0.9987938115 -0.0346825853 -0.0347568755 0.9987798601 0.0350739383 -0.0347650673",
     "", "0.04932531217754311 0.9987827390999938 0.00019977156929501503 0.00011729081929048453", 4000},
    {"3d-quickhull issue 2: an octagon with a wrong face", "3D hull",
     "polytope 16 40 100 0 100 40 0 100 -40 0 40 -100 0 -40 -100 0 -100 -40 0 -100 40 0 -40 100 0 40 100 100 100 40 "
     "100 100 -40 100 40 -100 100 -40 -100 100 -100 -40 100 -100 40 100 -40 100 100",
     "", "16 3280000"},
    {"3d-quickhull issue 2: a box with points in its faces", "3D hull",
     "polytope 15 0 50 0 100 100 0 0 100 0 -100 100 0 -100 0 0 100 -100 0 0 -50 0 50 -50 0 -100 -100 0 0 -100 0 100 0 "
     "0 100 100 200 -100 100 200 100 -100 200 -100 -100 200",
     "", "8 8000000"},
    {"OpenJSCAD issue 1347: four of five corners in a plane", "3D hull",
     "polytope 5 -8 1 0 -7 4 0 -6 5 -2 -7 0 -4 -8 0 -1", "", "5 0"},
    {"akuukka/quickhull issue 6: a point on the side was kept", "2D hull",
     "polytope 9 -3 4 -2 3 -3 1 1 -2 2 1 -10 0 0 -10 10 0 0 10", "", "4 200"},
    {"Jolt ConvexHullBuilderTest: a quad with points inside", "2D hull",
     "polytope 100 0 0 0 2 0 4 0 6 0 8 0 10 0 12 0 14 0 16 0 18 1 0 1 2 1 4 1 6 1 8 1 10 1 12 1 14 1 16 1 18 2 0 2 2 2 "
     "4 2 6 2 8 2 10 2 12 2 14 2 16 2 18 3 0 3 2 3 4 3 6 3 8 3 10 3 12 3 14 3 16 3 18 4 0 4 2 4 4 4 6 4 8 4 10 4 12 4 "
     "14 4 16 4 18 5 0 5 2 5 4 5 6 5 8 5 10 5 12 5 14 5 16 5 18 6 0 6 2 6 4 6 6 6 8 6 10 6 12 6 14 6 16 6 18 7 0 7 2 7 "
     "4 7 6 7 8 7 10 7 12 7 14 7 16 7 18 8 0 8 2 8 4 8 6 8 8 8 10 8 12 8 14 8 16 8 18 9 0 9 2 9 4 9 6 9 8 9 10 9 12 9 "
     "14 9 16 9 18",
     "", "4 162"},
    {"Jolt ConvexHullBuilderTest: a cube of points", "3D hull",
     "polytope 64 0 1 0 0 1 6 0 1 12 0 1 18 0 3 0 0 3 6 0 3 12 0 3 18 0 5 0 0 5 6 0 5 12 0 5 18 0 7 0 0 7 6 0 7 12 0 7 "
     "18 1 1 0 1 1 6 1 1 12 1 1 18 1 3 0 1 3 6 1 3 12 1 3 18 1 5 0 1 5 6 1 5 12 1 5 18 1 7 0 1 7 6 1 7 12 1 7 18 2 1 0 "
     "2 1 6 2 1 12 2 1 18 2 3 0 2 3 6 2 3 12 2 3 18 2 5 0 2 5 6 2 5 12 2 5 18 2 7 0 2 7 6 2 7 12 2 7 18 3 1 0 3 1 6 3 "
     "1 12 3 1 18 3 3 0 3 3 6 3 3 12 3 3 18 3 5 0 3 5 6 3 5 12 3 5 18 3 7 0 3 7 6 3 7 12 3 7 18",
     "", "8 324"},
    {"Jolt ConvexHullBuilderTest: points within a thousandth", "3D hull",
     "polytope 4 1 2 3 1.0005 2 3 1 2.0005 3 1 2 3.0005", "", "4 2.0833333333333332e-11"},
    {"Jolt ConvexHullBuilderTest: points on a line", "3D double hull",
     "polytope 11 0 0 0 1 0 0 2 0 0 3 0 0 4 0 0 5 0 0 6 0 0 7 0 0 8 0 0 9 0 0 10 0 0", "", "2 0"},
    {"Kettner et al., Classroom examples of robustness problems: the point that float drops", "2D double hull",
     "polytope 9 7.3000000000000194 7.3000000000000167 24.000000000000068 24.000000000000071 24.00000000000005 "
     "24.000000000000053 0.50000000000001621 0.50000000000001243 8 4 4 9 15 27 26 25 19 11",
     "", "6 275.24999999999994"},
    {"MIConvexHull issue 44: a cube", "3D hull",
     "polytope 8 -10 -10 -10 -10 -10 10 -10 10 -10 -10 10 10 10 -10 -10 10 -10 10 10 10 -10 10 10 10", "", "8 8000"},
    {"numpy-stl issue 120", "3D hull", "polytope 8 0 0 0 0 0 20 0 10 0 0 10 20 10 0 0 10 0 20 10 10 0 10 10 20", "",
     "8 2000"},
    {"akuukka/quickhull issue 1: four corners of a plane rectangle", "3D double hull",
     "polytope 4 -3 -0.25 -0.8 -3 0.25 -0.8 -3.125 0.25 -0.75 -3.125 -0.25 -0.75", "", "4 0"},
}};

TEST(PublishedHull, EveryHullAndBallIsAsLargeAsItShouldBe) { expect_published(cases); }

}  // namespace
}  // namespace graze::test::published_hull_test
