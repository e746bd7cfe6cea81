// SPDX-License-Identifier: MIT
// Published cases: the distance of two shapes. query/published_cases.hpp describes the rows.
#include <array>

#include <gtest/gtest.h>

#include "query/published_cases.hpp"

namespace graze::test::published_distance_test {
namespace {

constexpr std::array<PublishedCase, 109> cases = {{
    {"FCL issue 275: 25 for two spheres 10 apart", "3D distance", "sphere 0 0 0 20", "sphere 0 40 0 10",
     "10 0 20 0 0 30 0"},
    {"FCL issue 127: nearest points in the wrong place on the box", "3D distance", "sphere 0 0 0 1",
     "aabb -5 4 -2 5 6 8", "3"},
    {"FCL issue 508: 3.162 along y and z", "3D distance", "aabb -0.5 3.5 -0.5 0.5 4.5 0.5",
     "aabb -0.5 -0.5 -0.5 0.5 0.5 0.5", "3"},
    {"FCL issue 508: along z", "3D distance", "aabb -0.5 -0.5 3.5 0.5 0.5 4.5", "aabb -0.5 -0.5 -0.5 0.5 0.5 0.5", "3"},
    {"FCL issue 508: along x", "3D distance", "aabb 3.5 -0.5 -0.5 4.5 0.5 0.5", "aabb -0.5 -0.5 -0.5 0.5 0.5 0.5", "3"},
    {"FCL issue 640: a box and three points, off by 9", "3D distance", "aabb 9.5 -0.5 -0.5 10.5 0.5 0.5", "point 9 0 0",
     "0.5"},
    {"FCL issue 640", "3D distance", "aabb 9.5 -0.5 -0.5 10.5 0.5 0.5", "point 12 0 1", "1.5811388300841898"},
    {"FCL test_fcl_capsule_capsule", "3D distance", "capsule 0 0 -5 0 0 5 5", "capsule 20.1 0 -5 20.1 0 5 5", "10.1"},
    {"FCL test_fcl_capsule_capsule", "3D distance", "capsule 0 0 -5 0 0 5 5", "capsule 20 20 -5 20 20 5 5",
     "18.284271247461902"},
    {"FCL test_fcl_capsule_capsule", "3D distance", "capsule 0 0 -5 0 0 5 5",
     "capsule 0 0 15.100000000000001 0 0 25.1 5", "0.100000000000001"},
    {"FCL test_fcl_capsule_capsule: 5.1 was expected, the length lies crosswise", "3D distance",
     "capsule 0 0 -5 0 0 5 5", "capsule -5 0 25.1 5 0 25.1 5", "10.1 0 0 10 0 0 20.1"},
    {"FCL test_fcl_capsule_box_1", "3D distance", "capsule 3 0 -2 3 0 2 2", "aabb -0.5 -1 -2 0.5 1 2", "0.5"},
    {"FCL issue 25: above the box the nearest x was wrong", "3D distance", "capsule 0 0 6 0 0 10 2",
     "aabb -0.5 -1 -2 0.5 1 2", "2 0 0 4 0 0 2"},
    {"FCL test_fcl_capsule_box_1: turned, behind the box", "3D distance", "capsule -12 0 0 -8 0 0 2",
     "aabb -0.5 -1 -2 0.5 1 2", "5.5 -6 0 0 -0.5 0 0"},
    {"FCL test_fcl_signed_distance", "3D distance", "sphere 0 0 0 20", "sphere 40 0 0 10", "10 20 0 0 30 0 0"},
    {"FCL test_fcl_signed_distance: sphere and capsule", "3D distance", "sphere 0 0 0 20",
     "capsule 40 0 -10 40 0 10 10", "10 20 0 0 30 0 0"},
    {"FCL issue 388: validateNearestFeatureOfPolytopeBeingEdge threw", "3D distance",
     "obb 0.6349997962735081 -0.4850000221563644 1.0778146458339641 0.015 0.06 0.05 -3.062793785257868e-08 "
     "0.999999999999998 -6.472992772296385e-08 -0.9999999999999989 -3.0627939739957804e-08 -2.889386302944875e-08 "
     "-2.8893865161583314e-08 6.472992691852751e-08 0.9999999999999971",
     "obb 0.8 -0.4575 1.0225 0.0125 0.175 0.9225 0 1 0 -1 0 0 0 0 1", "1.7082191699676156e-08"},
    {"FCL issue 493: tilted boxes on each other", "3D distance",
     "obb 0 0 0.05 0.005 0.005 0.005 0.9409606321741776 -0.2356983684129988 -0.2429801799032639 0.292968400372895 "
     "0.9266152359584843 0.23569836841299885 0.16959541586174812 -0.29296840037289507 0.9409606321741776",
     "obb 0.002932613687732679 0.009275418511944428 0.05235934066781412 0.005 0.005 0.005 0.9409606321741776 "
     "-0.2356983684129988 -0.2429801799032639 0.292968400372895 0.9266152359584843 0.23569836841299885 "
     "0.16959541586174812 -0.29296840037289507 0.9409606321741776",
     "1.0000000000000518e-05"},
    {"FCL issue 493: tilted boxes on each other", "3D double distance",
     "obb 0 0 0.05 0.005 0.005 0.005 0.9409606321741776 -0.2356983684129988 -0.2429801799032639 0.292968400372895 "
     "0.9266152359584843 0.23569836841299885 0.16959541586174812 -0.29296840037289507 0.9409606321741776",
     "obb 0.0029296840066586343 0.009266152368850995 0.052356983686486974 0.005 0.005 0.005 0.9409606321741776 "
     "-0.2356983684129988 -0.2429801799032639 0.292968400372895 0.9266152359584843 0.23569836841299885 "
     "0.16959541586174812 -0.29296840037289507 0.9409606321741776",
     "1.0000000181598861e-11"},
    {"FCL issue 493: tilted boxes on each other", "3D distance",
     "obb 0 0 2.5 0.25 0.25 0.25 0.9409606321741776 -0.2356983684129988 -0.2429801799032639 0.292968400372895 "
     "0.9266152359584843 0.23569836841299885 0.16959541586174812 -0.29296840037289507 0.9409606321741776",
     "obb 0.14663068438663396 0.4637709255972214 2.617967033390706 0.25 0.25 0.25 0.9409606321741776 "
     "-0.2356983684129988 -0.2429801799032639 0.292968400372895 0.9266152359584843 0.23569836841299885 "
     "0.16959541586174812 -0.29296840037289507 0.9409606321741776",
     "0.0005000000000000287"},
    {"FCL issue 493: tilted boxes on each other", "3D double distance",
     "obb 0 0 2.5 0.25 0.25 0.25 0.9409606321741776 -0.2356983684129988 -0.2429801799032639 0.292968400372895 "
     "0.9266152359584843 0.23569836841299885 0.16959541586174812 -0.29296840037289507 0.9409606321741776",
     "obb 0.14648420033293172 0.46330761844254975 2.6178491843243488 0.25 0.25 0.25 0.9409606321741776 "
     "-0.2356983684129988 -0.2429801799032639 0.292968400372895 0.9266152359584843 0.23569836841299885 "
     "0.16959541586174812 -0.29296840037289507 0.9409606321741776",
     "5.000000341146219e-10"},
    {"FCL issue 493: tilted boxes on each other", "3D distance",
     "obb 0 0 50 5 5 5 0.9409606321741776 -0.2356983684129988 -0.2429801799032639 0.292968400372895 0.9266152359584843 "
     "0.23569836841299885 0.16959541586174812 -0.29296840037289507 0.9409606321741776",
     "obb 2.932613687732679 9.275418511944428 52.359340667814116 5 5 5 0.9409606321741776 -0.2356983684129988 "
     "-0.2429801799032639 0.292968400372895 0.9266152359584843 0.23569836841299885 0.16959541586174812 "
     "-0.29296840037289507 0.9409606321741776",
     "0.009999999999999575"},
    {"FCL issue 493: tilted boxes on each other", "3D double distance",
     "obb 0 0 50 5 5 5 0.9409606321741776 -0.2356983684129988 -0.2429801799032639 0.292968400372895 0.9266152359584843 "
     "0.23569836841299885 0.16959541586174812 -0.29296840037289507 0.9409606321741776",
     "obb 2.929684006658634 9.266152368850996 52.35698368648697 5 5 5 0.9409606321741776 -0.2356983684129988 "
     "-0.2429801799032639 0.292968400372895 0.9266152359584843 0.23569836841299885 0.16959541586174812 "
     "-0.29296840037289507 0.9409606321741776",
     "1.0000000077530104e-08"},
    {"FCL issue 493: tilted boxes on each other", "3D distance",
     "obb 0 0 5000 500 500 500 0.9409606321741776 -0.2356983684129988 -0.2429801799032639 0.292968400372895 "
     "0.9266152359584843 0.23569836841299885 0.16959541586174812 -0.29296840037289507 0.9409606321741776",
     "obb 293.2613687732679 927.5418511944428 5235.934066781412 500 500 500 0.9409606321741776 -0.2356983684129988 "
     "-0.2429801799032639 0.292968400372895 0.9266152359584843 0.23569836841299885 0.16959541586174812 "
     "-0.29296840037289507 0.9409606321741776",
     "1.0000000000000517"},
    {"FCL issue 493: tilted boxes on each other", "3D double distance",
     "obb 0 0 5000 500 500 500 0.9409606321741776 -0.2356983684129988 -0.2429801799032639 0.292968400372895 "
     "0.9266152359584843 0.23569836841299885 0.16959541586174812 -0.29296840037289507 0.9409606321741776",
     "obb 292.9684006658634 926.6152368850995 5235.698368648697 500 500 500 0.9409606321741776 -0.2356983684129988 "
     "-0.2429801799032639 0.292968400372895 0.9266152359584843 0.23569836841299885 0.16959541586174812 "
     "-0.29296840037289507 0.9409606321741776",
     "9.999999150914867e-07"},
    {"FCL test_gjk_libccd-inl_signed_distance", "3D distance", "obb 0 0 0.5 0.5 0.5 0.5 1 0 0 0 1 0 0 0 1",
     "obb -1.1 0 0.5 0.3 0.4 0.5 0.6 0.8 0 -0.8 0.6 0 0 0 1", "0.1"},
    {"FCL test_gjk_libccd-inl_signed_distance", "3D distance", "obb 0 0 0.5 0.5 0.5 0.5 1 0 0 0 1 0 0 0 1",
     "obb -1.25 0.1 0.5 0.3 0.4 0.5 0.6 0.8 0 -0.8 0.6 0 0 0 1", "0.25"},
    {"FCL issue 408: center just beside the box", "3D distance", "sphere 1.7855056639081962e-10 0.04 0.33 0.06",
     "aabb 0 0.1 0.3 0.1 0.2 0.4", "0"},
    {"FCL test_sphere_box", "3D distance", "sphere 0.15 0.3 2.57 0.7", "aabb -0.3 -0.6 -1.8 0.3 0.6 1.8",
     "0.07 0.15 0.3 1.87 0.15 0.3 1.8"},
    {"FCL test_sphere_box: nearest the corner", "3D distance", "sphere 1.175 1.475 2.675 0.7",
     "aabb -0.3 -0.6 -1.8 0.3 0.6 1.8", "0.8155444566227676"},
    {"FCL test_sphere_box: a grain over a long box", "3D distance", "sphere 14.25 0 1.011 0.01",
     "aabb -15 -1 -1 15 1 1", "0.001"},
    {"Coal box_box_distance", "3D distance", "aabb -3 -5 -1 3 5 1", "aabb 24 19 4 26 21 6", "25.41653005427767"},
    {"Coal box_box_distance: a corner over a face", "3D distance", "aabb -3 -5 -1 3 5 1",
     "obb 0 0 10 1 1 1 0.804737854124365 0.5058793634016805 -0.31061721752604554 -0.31061721752604554 "
     "0.804737854124365 0.5058793634016805 0.5058793634016805 -0.31061721752604554 0.804737854124365",
     "7.378765564947909"},
    {"Coal box_box_distance: crossed edges, 4 - sqrt 2", "3D distance",
     "obb -2 1 0.5 0.5 0.5 0.5 0.7071067811865476 0.7071067811865476 0 -0.7071067811865476 0.7071067811865476 0 0 0 1",
     "obb 2 0.5 0.5 0.5 0.5 0.5 0.7071067811865476 0 -0.7071067811865476 0 1 0 0.7071067811865476 0 0.7071067811865476",
     "2.5857864376269046"},
    {"Coal box_box_distance", "3D distance", "aabb 1.5 -0.5 -0.5 2.5 0.5 0.5", "aabb -0.5 -0.5 -0.5 0.5 0.5 0.5", "1"},
    {"Coal box_box_distance", "3D distance", "aabb 0.51 -0.5 -0.5 1.51 0.5 0.5", "aabb -0.5 -0.5 -0.5 0.5 0.5 0.5",
     "0.01"},
    {"Coal gjk: a needle of a triangle", "3D distance",
     "triangle -12.723232520044062 -1.353475714831201 3.5894575302757805 -12.989763285770795 -1.2891305896265277 "
     "3.720706157989417 -12.989391437959869 -1.286704240895501 3.725831537939471",
     "triangle -25.655 -1.2858199462890625 3.72498095703125 -10.926 -1.284259033203125 3.72814990234375 -10.926 "
     "-1.2866180419921875 3.72335400390625",
     "0.0011415189219457892"},
    {"Coal gjk: triangles of two meshes", "3D distance",
     "triangle -1.044316053075459 -1.194898581192133 0.35059532124756626 -0.9873940799876995 -0.594913352548079 "
     "0.4092428432926411 0.5630754209489433 -0.7026956553447877 0.0070435210380314075",
     "triangle -0.224713996052742 -0.7417119741439819 0.19999997317790985 -0.5247139930725098 -0.7417119741439819 "
     "0.19999997317790985 -0.224713996052742 -0.7417119741439819 0.09999997168779373",
     "3.0376494098084244e-07"},
    {"Jolt GJKTests: spheres far apart", "3D distance", "sphere 0 0 0 1", "sphere 10 10 10 1", "15.320508075688773"},
    {"Parry issue 431: longer from one side than from the other", "2D distance", "aabb -1 -1 1 1",
     "aabb -6.573167 -2 -4.573167 2", "3.573167"},
    {"Parry issue 431: longer from one side than from the other", "3D distance", "aabb -1 -1 -1 1 1 1",
     "aabb -6.573167 -2 -2 -4.573167 2 2", "3.573167"},
    {"Parry issue 431: side by side", "2D distance", "aabb -1 -1 1 1", "aabb 5 -0.5 9 1.5", "4"},
    {"Parry issue 431: corner and corner", "2D distance", "aabb -1 -1 1 1", "aabb 4 3 6 5", "3.605551275463989"},
    {"Parry issue 431: corner and corner", "3D distance", "aabb -1 -1 -1 1 1 1", "aabb 4 3 2 6 5 4",
     "3.7416573867739413"},
    {"Parry issue 431: a corner over a face", "2D distance", "aabb -1 -1 1 1",
     "obb 0 4 1 1 0.7071067811865476 0.7071067811865476 -0.7071067811865476 0.7071067811865476", "1.5857864376269049"},
    {"Parry issue 431: a corner beside a turned face", "3D distance", "aabb -1 -1 -1 1 1 1",
     "obb 4 4 0 1 1 1 0.7071067811865476 0.7071067811865476 0 -0.7071067811865476 0.7071067811865476 0 0 0 1",
     "3.242640687119285"},
    {"Parry issue 431: edge and edge", "3D distance", "aabb -1 -1 -1 1 1 1",
     "obb 5 0 5 1 1 1 0.8660254037844386 0 -0.5 0 1 0 0.5 0 0.8660254037844386", "4.48816148767499"},
    {"Parry closest_points_cuboid_cuboid: the far corner was taken", "2D distance", "aabb -1 -1 1 1",
     "aabb 2 1.5 4 3.5", "1.118033988749895 1 1 2 1.5"},
    {"Parry closest_points_cuboid_cuboid: the far corner was taken", "2D distance", "aabb -1 -1 1 1",
     "aabb 2 -3.5 4 -1.5", "1.118033988749895 1 -1 2 -1.5"},
    {"Parry closest_points_cuboid_cuboid: the far corner was taken", "2D distance", "aabb -1 -1 1 1",
     "aabb -4 1.5 -2 3.5", "1.118033988749895 -1 1 -2 1.5"},
    {"Parry closest_points_cuboid_cuboid: the far corner was taken", "2D distance", "aabb -1 -1 1 1",
     "aabb -4 -3.5 -2 -1.5", "1.118033988749895 -1 -1 -2 -1.5"},
    {"Parry closest_points_cuboid_cuboid, one of eight corners", "3D distance", "aabb -1 -1 -1 1 1 1",
     "aabb -4 -3.5 -3.25 -2 -1.5 -1.25", "1.14564392373896 -1 -1 -1 -2 -1.5 -1.25"},
    {"Parry closest_points_cuboid_cuboid, one of eight corners", "3D distance", "aabb -1 -1 -1 1 1 1",
     "aabb -4 -3.5 1.25 -2 -1.5 3.25", "1.14564392373896 -1 -1 1 -2 -1.5 1.25"},
    {"Parry closest_points_cuboid_cuboid, one of eight corners", "3D distance", "aabb -1 -1 -1 1 1 1",
     "aabb -4 1.5 -3.25 -2 3.5 -1.25", "1.14564392373896 -1 1 -1 -2 1.5 -1.25"},
    {"Parry closest_points_cuboid_cuboid, one of eight corners", "3D distance", "aabb -1 -1 -1 1 1 1",
     "aabb -4 1.5 1.25 -2 3.5 3.25", "1.14564392373896 -1 1 1 -2 1.5 1.25"},
    {"Parry closest_points_cuboid_cuboid, one of eight corners", "3D distance", "aabb -1 -1 -1 1 1 1",
     "aabb 2 -3.5 -3.25 4 -1.5 -1.25", "1.14564392373896 1 -1 -1 2 -1.5 -1.25"},
    {"Parry closest_points_cuboid_cuboid, one of eight corners", "3D distance", "aabb -1 -1 -1 1 1 1",
     "aabb 2 -3.5 1.25 4 -1.5 3.25", "1.14564392373896 1 -1 1 2 -1.5 1.25"},
    {"Parry closest_points_cuboid_cuboid, one of eight corners", "3D distance", "aabb -1 -1 -1 1 1 1",
     "aabb 2 1.5 -3.25 4 3.5 -1.25", "1.14564392373896 1 1 -1 2 1.5 -1.25"},
    {"Parry closest_points_cuboid_cuboid, one of eight corners", "3D distance", "aabb -1 -1 -1 1 1 1",
     "aabb 2 1.5 1.25 4 3.5 3.25", "1.14564392373896 1 1 1 2 1.5 1.25"},
    {"Parry closest_points_cuboid_cuboid: parallel edges, one longer", "3D distance", "aabb -1 -1 -1 1 1 1",
     "aabb 2 1.5 -5 4 3.5 5", "1.118033988749895"},
    {"Parry closest_points_cuboid_cuboid: corners at one height", "2D double distance", "aabb -1 -1 1 1",
     "aabb 1.0001 1 3.0001 3", "0.0001"},
    {"Parry closest_points_cuboid_cuboid: a gap below one ulp gave twice the width", "2D double distance",
     "aabb -0.5386359 -0.8874373 0.5386359 0.8874373", "aabb -2.7384776 0.88743813 -0.5386358 1.23182667", "8.3e-07"},
    {"Box2D test_distance: segments", "2D distance", "segment -1 -1 -1 1", "segment 2 0 1 0", "2 -1 0 1 0"},
    {"Box2D test_distance: a polygon and a segment", "2D distance", "polytope 4 -1 -1 1 -1 1 1 -1 1",
     "segment 2 -1 2 1", "1"},
    {"Box2D ShapeDistanceShortEdgeTest: 0 beside a thin plank", "2D distance",
     "polytope 4 -0.5 -0.0016 0.5 -0.0016 0.5 0.0016 -0.5 0.0016", "point 0.505 0", "0.005"},
    {"Box2D ShapeDistanceShortEdgeTest: 0 beside a thin plank", "2D distance",
     "polytope 4 -0.5 -0.0002 0.5 -0.0002 0.5 0.0002 -0.5 0.0002", "point 0.505 0", "0.005"},
    {"Box2D ShapeDistanceShortEdgeTest: 0 beside a thin plank", "2D distance",
     "polytope 4 -0.5 -1e-6 0.5 -1e-6 0.5 1e-6 -0.5 1e-6", "point 0.505 0", "0.005"},
    {"Box2D issue 115: the start of a false impact", "2D distance",
     "obb 24 -60 25 5 -0.981702202998454 0.19042264736102724 -0.19042264736102724 -0.981702202998454",
     "obb 53.474274 -50.252514 2.5 2.5 -0.2798509592403103 -0.9600434576685986 0.9600434576685986 -0.2798509592403103",
     "7.829673165201241"},
    {"Box2D issue 115: the end of it", "2D distance",
     "obb 24 -60 25 5 -0.981702202998454 0.19042264736102724 -0.19042264736102724 -0.981702202998454",
     "obb 54.595478 -51.083473 2.5 2.5 -0.022586940960576285 -0.999744882506554 0.999744882506554 "
     "-0.022586940960576285",
     "6.818448787603192"},
    {"dyn4j CircleRectangleTest", "2D distance", "sphere -1 0 1", "aabb -0.5 0.9 0.5 1.9", "0.029563014098700033"},
    {"dyn4j CircleRectangleTest", "2D distance", "sphere -2 0 1", "aabb -0.5 0.9 0.5 1.9", "0.7492855684535902"},
    {"dyn4j CapsuleCapsuleTest", "2D distance", "capsule -0.5 -0.25 -0.5 0.25 0.25", "capsule -0.25 0.7 0.25 0.7 0.25",
     "0.014781507049350016"},
    {"dyn4j CapsuleCapsuleTest", "2D distance", "capsule -0.5 -0.25 -0.5 0.25 0.25", "capsule 0.75 0.7 1.25 0.7 0.25",
     "0.8285330255586423"},
    {"Godot test_geometry_2d", "2D distance", "segment 50 -25 50 -10", "segment -50 10 -40 10",
     "92.19544457292888 50 -10 -40 10"},
    {"Godot test_geometry_2d: parallel", "2D distance", "segment 2 1 4 3", "segment 2 3 4 5", "1.4142135623730951"},
    {"Godot test_geometry_2d", "2D distance", "segment 2 4 2 3", "segment 1 1 4 4", "0.7071067811865476"},
    {"Godot test_geometry_2d: two points", "2D distance", "segment 0 0 0 0", "segment 0 0 0 0", "0"},
    {"Godot test_geometry_3d", "3D distance", "segment 1 -1 1 1 1 -1", "segment -1 -2 -1 -1 1 1",
     "2 1 -0.2 0.2 -1 -0.2 0.2"},
    {"Godot test_geometry_3d", "3D distance", "segment 1 -2 0 1 2 0", "segment -1 2 0 -1 -2 0", "2"},
    {"three.js Ray.distanceSqToSegment", "3D distance", "ray 1 1 1 0 0 1", "segment 3 5 50 50 50 50",
     "4.47213595499958 1 1 50 3 5 50"},
    {"three.js Ray.distanceSqToSegment: behind", "3D distance", "ray 1 1 1 0 0 1", "segment -50 -50 -50 -3 -5 -4",
     "8.774964387392123 1 1 1 -3 -5 -4"},
    {"three.js Ray.distanceSqToSegment: through the origin", "3D distance", "ray 1 1 1 0 0 1",
     "segment -50 -50 -50 50 50 50", "0"},
    {"GeometRi issue 16: 10.02 for parallel segments 1.7 apart", "3D distance",
     "segment 399.83 273.22 0 399.83 253.56 0", "segment 401.53 283.1 0 401.53 272.6 0", "1.7"},
    {"GeometricTools issue 40: nearly parallel, a clash of two algorithms", "2D distance",
     "segment 2.2352092822407803 -1.7068004885705972 1.4357507764403734 -4.4188128129047435",
     "segment 1.8515323877379666 -1.5936985848524166 1.2171034035398707 -3.7458793566829809", "0.3999999999999998"},
    {"sceneview pull request 1139: at right angles, the square root of 5", "3D distance", "segment 0 0 0 2 0 0",
     "segment 1 1 0 1 3 0", "1 1 0 0 1 1 0"},
    {"Thunderbots: a segment of no length", "2D distance", "segment -2 2 -2 2", "point 5 3",
     "7.0710678118654755 -2 2 5 3"},
    {"cuSpatial linestring_distance", "2D distance", "segment 0 0 0 1", "segment 0 2 0 3", "1"},
    {"cuSpatial linestring_distance: crossing", "2D distance", "segment 0 0 2 2", "segment 2 0 0 2", "0"},
    {"Eberly, Robust Computation of Distance Between Line Segments", "3D double distance",
     "segment -1.0896217473782599 9.7236145595088601e-7 0 0.91220578597858548 -9.4369829432107506e-7 0",
     "segment -0.90010447502136237 9.0671446351334441e-7 0 1.073087717872113 -9.818578763399274e-7 0",
     "1.1575046138574105e-07"},
    {"Eberly, the same: the second example", "3D double distance",
     "segment -1.0896217473782599 9.7236145595088601e-7 0 0.91220578597858548 -9.4369829432107506e-7 0",
     "segment 0.77998990099877119 -0.61192502360790658 -0.22703111823648214 0.53215344529598951 -0.85724585503339767 "
     "-0.10102437809109688",
     "0.6526824366412606"},
    {"Sunday, segments that are points", "3D distance", "segment 1 1 1 1 1 1", "segment 4 5 1 4 5 1", "5 1 1 1 4 5 1"},
    {"CGAL issue 4805", "3D distance", "segment 15.5444 1.53163 0.311164 15.5444 1.53163 0.311164",
     "segment 15.568 1.79418 0.0550635 15.399 1.5103 -0.0616675", "0.3403204932557339"},
    {"JTS issue 270: a point 1e-13 from the line, of two minds", "2D double distance",
     "segment 0 0 -10 1.2246467991473533e-15",
     "segment -9.999143275740073 -0.13089595571333978 -10 1.0535676356486768e-13", "6.815382446385462e-16"},
    {"JTS issue 119: nothing in common, all was taken", "2D double distance",
     "polytope 4 3.166572116932842 48.5390194687463 3.166572116932842 50.470470727186765 4.180930086918854 "
     "50.470470727186765 4.180930086918854 48.5390194687463",
     "triangle 2.152214146946829 50.470470727186765 18.381941666723034 19.567250592139274 2.390837642830135 "
     "49.228045261718165",
     "1.6480542723999356e-15"},
    {"DART pull request 3343: five samples of the axis, the square root of 2", "3D distance",
     "capsule -8 2 0 12 2 0 0.25", "aabb -1 -1 -1 1 1 1", "0.75"},
    {"DART pull request 3343: the axis alone", "3D distance", "segment -8 2 0 12 2 0", "aabb -1 -1 -1 1 1 1", "1"},
    {"MuJoCo issue 1473: a capsule over a box", "3D distance", "capsule 0 0 0.85 0 0 1.15 0.15",
     "aabb -0.1 -0.1 -0.1 0.1 0.1 0.1", "0.6"},
    {"jsk_roseus issue 616: wrong by 70 for small cubes", "3D double distance", "aabb -500 -500 -500 500 500 500",
     "aabb 99500 -500 -500 100500 500 500", "99000"},
    {"jsk_roseus issue 616: wrong by 70 for small cubes", "3D double distance", "aabb -50 -50 -50 50 50 50",
     "aabb 99950 -50 -50 100050 50 50", "99900"},
    {"jsk_roseus issue 616: wrong by 70 for small cubes", "3D double distance", "aabb -25 -25 -25 25 25 25",
     "aabb 99975 -25 -25 100025 25 25", "99950"},
    {"jsk_roseus issue 616: wrong by 70 for small cubes", "3D double distance", "aabb -5 -5 -5 5 5 5",
     "aabb 99995 -5 -5 100005 5 5", "99990"},
    {"jsk_roseus issue 616: wrong by 70 for small cubes", "3D double distance", "aabb -0.5 -0.5 -0.5 0.5 0.5 0.5",
     "aabb 99999.5 -0.5 -0.5 100000.5 0.5 0.5", "99999"},
    {"mujoco_warp pull request 1188: less by the margin", "3D distance", "aabb -0.1 -0.1 -0.1 0.1 0.1 0.1",
     "aabb -0.1 -0.1 0.15 0.1 0.1 0.35", "0.05"},
    {"FCL issue 589: a capsule beside a box", "3D distance", "capsule 0 0 0 0 0 0.5 0.05",
     "aabb 0.45 -0.15 0 0.75 0.15 0.5", "0.4"},
    {"FCL issue 138: metres taken for centimetres", "3D distance", "capsule 0 0 -0.25 0 0 0.25 0.014",
     "capsule 0.1 0 -0.175 0.1 0 0.175 0.01", "0.076"},
    {"godot-box2d issue 4: how far before the cast", "2D distance", "aabb 5.26 2.74 6.26 3.74",
     "aabb 11.02 2.74 12.02 3.74", "4.76"},
    {"DOLFINx issue 3653: no end on a simple hull", "3D distance",
     "polytope 7 46.0659 38.6251 16.3637 44.2764 42.3867 18.239 50.0397 38.4649 19.9843 47.1963 40.4563 19.1057 "
     "48.0266 38.5593 18.2475 45.1735 40.495 17.3336 48.0415 40.4456 18.1963",
     "point 44.2919 39.7508 18.8208", "1.8134526453385034"},
    {"distance3d issue 27: an exception", "3D distance",
     "polytope 6 1.9408982677575293 1.7555630101186028 0.18558370457138618 0.8325772811802072 0.07348739881751665 "
     "1.7363835855830982 0.4647979626331866 0.7802364656205514 0.7683352436509485 1.8147849498111688 "
     "0.1710650007346617 1.802196858095821 0.05742372721610556 1.6599005060005285 0.014474511746654706 "
     "1.5270861966500002 0.4945624540164677 0.7162419894551117",
     "polytope 6 0.13746727993941066 0.20129636190312772 0.34482818309629215 0.5315223185064999 0.859293459032485 "
     "0.6275795914219559 0.5810087058274663 0.42871589938255994 0.6201313431197037 0.48395328848552066 "
     "0.35710287272501984 0.27586601014041534 0.1586377710691551 0.6421620047252284 0.6487788989727401 "
     "0.5185197562895357 0.058044153658207476 0.4020269780737239",
     "0.027535806024984583"},
    {"FCL issue 493: as reported, an exception", "3D double distance",
     "obb 2.077006399578687 0.4846824747564195 1.1543291419087276 0.25 0.25 0.25 0.9619397662556435 "
     "-0.19134171618254486 -0.19509032201612822 0.1540127991573736 0.9693649495128391 -0.19134171618254486 "
     "0.2257253725032892 0.1540127991573736 0.9619397662556435",
     "obb 2 0 1.25 0.25 0.25 0.25 0.9619397662556435 -0.19134171618254486 -0.19509032201612822 0.1540127991573736 "
     "0.9693649495128391 -0.19134171618254486 0.2257253725032892 0.1540127991573736 0.9619397662556435",
     "2.3405939129643587e-17"},
}};

TEST(PublishedDistance, EveryPairIsAsFarApartAsItShouldBe) { expect_published(cases); }

}  // namespace
}  // namespace graze::test::published_distance_test
