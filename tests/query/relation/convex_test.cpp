// SPDX-License-Identifier: MIT
// GJK and EPA for any two convex shapes. agreement_test.cpp has every pair against the oracle; this has cases that once
// failed, user-defined shapes, and the ways in which shapes can touch.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/relation.hpp>

#include "catalogue.hpp"
#include "exact.hpp"
#include "query/user_shapes.hpp"

namespace graze::test::relation_convex_test {
namespace {

template <class A, class B>
void expect(const A& a, const B& b, Relation expected) {
  EXPECT_EQ(name_of(relation(a, b)), name_of(expected)) << to_source(a) << ", " << to_source(b);
  EXPECT_EQ(name_of(relation(b, a)), name_of(expected)) << "swapped: " << to_source(a) << ", " << to_source(b);
  const ExactVerdict truth = exact_verdict_of(a, b, Measure::distance);
  EXPECT_EQ(name_of(truth.relation), name_of(expected)) << "oracle: " << to_source(a) << ", " << to_source(b);
}

// Reported touching once, for gaps of 1e-8 of the size: the direction to a near edge was mostly rounding, so its
// supporting line proved nothing. One order of arguments was right, the other was not.
TEST(RelationOfConvex, SmallGapsBesideAnEdgeAreGaps) {
  expect(Vec<2, float>{-6.322878F, -0.09922283F},
         Triangle<2, float>{{-7.495305F, -5.9910636F}, {-6.218822F, 0.42369294F}, {6.2166533F, 10.421352F}},
         Relation::apart);
  expect(Vec<2, float>{-7.5301046F, 8.146923F},
         convex_hull<2, float>(std::vector<Vec<2, float>>{
             {-14.261673F, 1.6231904F}, {-1.2346687F, -3.8947601F}, {-6.6885185F, 8.962525F}}),
         Relation::apart);
  expect(
      Vec<3, double>{7.983675896472647, 9.597633864406045, 1.615441411780278},
      convex_hull<3, double>(std::vector<Vec<3, double>>{{0.8700123963586197, 3.5605678131710303, 1.4701453302506937},
                                                         {5.358468654111176, 1.181722070949262, 13.192004911208675},
                                                         {15.097339637383167, 15.634700230839899, 1.7607378085086995}}),
      Relation::apart);
}

// Reported touching once, for a gap of 5e-4: beside a long edge a step of GJK was too small to measure, and was taken
// for the last.
TEST(RelationOfConvex, GapsBesideLongEdgesAreGaps) {
  expect(Aabb<3, float>{{0.006993956F, -6949.267F, 0.0014318873F}, {300995.75F, 9.423732e-06F, 0.0030424062F}},
         Triangle<3, float>{{305732.03F, -33222.582F, -556.97394F},
                            {305732.03F, -24121.977F, -0.016510185F},
                            {300995.75F, -6949.2676F, 0.0018096385F}},
         Relation::apart);
  // GJK's bounds do not converge here; EPA's expanding hull finds the separating plane.
  expect(
      Obb<3, double>{{0.3559726824682347, 1928.308723330378, 5.646087751201691},
                     {0, 1.1119045197822864e-05, 0.003543851543096086},
                     {{0.7012304061114889, 0.7129347217976657, 4.0314334852129876e-08},
                      {-0.7129347217976663, 0.7012304061114895, 3.096008396565483e-14},
                      {-2.826961532795475e-08, -2.8741510812413423e-08, 0.9999999999999992}}},
      convex_hull<3, double>(std::vector<Vec<3, double>>{{-269317.31039057544, 6791.291313754358, -735.2994211280464},
                                                         {0.35499524341569866, 6570.613497431325, 5.681293321629049},
                                                         {0.3559647471203878, 1928.3087235754128, 5.642552961239492}}),
      Relation::apart);
}

// Reported touching once: the origin is inside the last tetrahedron, but so close to a thin face that GJK ended on the
// face.
TEST(RelationOfConvex, SmallDepthsBehindAThinFaceAreDepths) {
  expect(Obb<3, float>{{3.9813945e-06F, -0.07550284F, 39.21928F},
                       {7.789901e-06F, 5.8892274e-05F, 7.388426e-05F},
                       {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}}},
         Triangle<3, float>{{-9.877508F, 161843.8F, 39.219013F},
                            {-5.046618F, 163867.72F, 804382.44F},
                            {6.0062256F, -98412.53F, 39.21945F}},
         Relation::overlapping);
  expect(Aabb<3, float>{{-472.9171F, -0.31649482F, -7.5521812F}, {0.0114172315F, 2.4288585e-05F, -1.7646332F}},
         Triangle<3, float>{{-210.64313F, 515208.22F, 12323.662F},
                            {855493.75F, 514024.3F, 12324.281F},
                            {-210.05687F, -4.6505175F, -1.8683171F}},
         Relation::overlapping);
}

// Reported touching once, for 4e-13: bounds that agreed up to 1e-12 of the distance were taken as an answer about the
// radius.
TEST(RelationOfConvex, TheRadiusIsComparedToTheLastDigit) {
  expect(Capsule<3, double>{{-0.19872602555168206, -2.2763909430828955, -0.8823560738265457},
                            {-2.7168528497628612, -0.3729717311400207, -0.6925335230195245},
                            3},
         convex_hull<3, double>(
             std::vector<Vec<3, double>>{{-6.388473609439117, -8.365696953662654, -5.805275146783419},
                                         {-6.168656790845063, -9.131399177285239, -0.4793592001125915},
                                         {-4.661544915591844, -10.341140151795054, 0.03555882255001741},
                                         {-4.561463765233853, -2.9959045854707402, 1.4629684479019525},
                                         {-3.650529966633402, -11.034818389227407, -0.669181750920322},
                                         {-3.512806623537632, -3.012688349457954, -5.529887657040858},
                                         {-3.1066621618338726, -4.497722939715272, -6.323435980690174},
                                         {-2.2819748559851356, -4.4720688105128925, -0.9087122838403696}}),
         Relation::overlapping);
}

// The first bounds are just beyond the resolution, but not clear enough for a verdict.
TEST(RelationOfConvex, BoundsThatLeaveTheVerdictOpenAreMadeCloser) {
  using V2 = Vec<2, double>;
  const Capsule<2, double> capsule{{1, -4}, {-3, -3.9999847412109375}, 1};
  const Polytope<2, double> corner = convex_hull<2, double>(std::vector<V2>{{-4.00000000000003, -4}});
  EXPECT_EQ(relation(capsule, corner), Relation::apart);  // by 1e-10
  const Polytope<2, double> house = convex_hull<2, double>(std::vector<V2>{
      {-3.9375, -0x1p-45}, {0.0625, -1 - 0x1p-45}, {1.0625, -0x1p-45}, {2.0625, 4 - 0x1p-45}, {-0.9375, 4 - 0x1p-45}});
  EXPECT_EQ(relation(Sphere<2, double>{{-1, -1 + 0x1p-52}, 1}, house), Relation::overlapping);
}

TEST(RelationOfConvex, ASmallRadiusIsDepthEnoughThoughTheDistanceOfLongCoresIsHardToFind) {
  // The capsule's axis begins at a corner of the thin box: the depth is the radius.
  const Aabb<3, double> box{{0, 0, 0}, {0.0005111603167539062, 49, 1038}};
  const Capsule<3, double> capsule{
      {0.0005111603167539062, 49, 1038}, {-1.2, 51620, 4.45034418751834e-05}, 2.8768816333705592e-06};
  EXPECT_EQ(detail::relation_of_convex(box, capsule), Relation::overlapping);
  EXPECT_EQ(detail::relation_of_convex(capsule, box), Relation::overlapping);
}

TEST(RelationOfConvex, PolytopesTouchAtCornersEdgesAndFaces) {
  using V = Vec<3, double>;
  const auto octahedron = [](const V& at) {
    return convex_hull<3, double>(std::vector<V>{at + V(1, 0, 0), at - V(1, 0, 0), at + V(0, 1, 0), at - V(0, 1, 0),
                                                 at + V(0, 0, 1), at - V(0, 0, 1)});
  };
  const auto at_zero = octahedron({0, 0, 0});
  expect(at_zero, octahedron({2, 0, 0}), Relation::touching);           // corner on corner
  expect(at_zero, octahedron({1, 1, 0}), Relation::touching);           // edge on edge
  expect(at_zero, octahedron({0.5, 0.5, 1}), Relation::touching);       // face on face
  expect(at_zero, octahedron({0.75, 0.75, 0.75}), Relation::apart);     // faces facing
  expect(at_zero, octahedron({0.5, 0.5, 0.5}), Relation::overlapping);  // sum 1.5 < 2
  expect(at_zero, octahedron({1.25, 0.25, 0.5}), Relation::touching);   // faces shifted
  expect(at_zero, octahedron({2, 0x1p-40, 0}), Relation::apart);        // corner beside corner
  expect(at_zero, Triangle<3, double>{{1, 0, 0}, {3, 1, 0}, {3, 0, 1}}, Relation::touching);
  expect(at_zero, Triangle<3, double>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, Relation::touching);
  expect(at_zero, Triangle<3, double>{{0.5, 0, 0}, {0, 9, 0}, {0, 0, 9}}, Relation::overlapping);
}

TEST(RelationOfConvex, FlatSetsOfDifferencesOnlyTouch) {
  using V = Vec<3, double>;
  const auto square = convex_hull<3, double>(std::vector<V>{{0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {0, 4, 1}});
  expect(square, square, Relation::touching);
  expect(square, Triangle<3, double>{{1, 1, 1}, {2, 1, 1}, {1, 2, 1}}, Relation::touching);
  expect(square, convex_hull<3, double>(std::vector<V>{{1, 1, 1}}), Relation::touching);
  expect(square, convex_hull<3, double>(std::vector<V>{{5, 1, 1}, {6, 1, 1}}), Relation::apart);
  expect(convex_hull<3, double>(std::vector<V>{{0, 0, 0}, {3, 3, 3}}),
         Triangle<3, double>{{1, 1, 1}, {2, 2, 2}, {5, 5, 5}}, Relation::touching);
}

/// For two shapes whose gap along an axis is known: the verdict just outside, at and just inside.
template <class A, class MakeB>
void expect_border(const A& a, const MakeB& b_at, double border, double step) {
  EXPECT_EQ(name_of(relation(a, b_at(border + step))), "apart");
  EXPECT_EQ(name_of(relation(a, b_at(border))), "touching");
  EXPECT_EQ(name_of(relation(a, b_at(border - step))), "overlapping");
  EXPECT_EQ(name_of(relation(b_at(border + step), a)), "apart");
  EXPECT_EQ(name_of(relation(b_at(border), a)), "touching");
  EXPECT_EQ(name_of(relation(b_at(border - step), a)), "overlapping");
}

template <class T>
class UsersShapes : public ::testing::Test {};
using Numbers = ::testing::Types<float, double>;
TYPED_TEST_SUITE(UsersShapes, Numbers);

TYPED_TEST(UsersShapes, MeetOthersWhereTheyShould) {
  using T = TypeParam;
  const double step = std::is_same_v<T, float> ? 1e-3 : 1e-11;
  const auto t = [](double x) { return static_cast<T>(x); };
  const user::Ellipsoid<T> egg{{0, 0, 0}, {3, 2, 1}};
  expect_border(
      egg,
      [t](double x) {
        return user::Ellipsoid<T>{{t(x), 0, 0}, {2, 2, 2}};
      },
      5, step);
  expect_border(
      egg,
      [t](double x) {
        return Sphere<3, T>{{t(x), 0, 0}, 2};
      },
      5, step);
  expect_border(
      egg,
      [t](double x) {
        return Aabb<3, T>{{t(x), -5, -5}, {9, 5, 5}};
      },
      3, step);
  expect_border(
      egg,
      [t](double x) {
        return user::Superellipsoid<T>{{0, t(x), 0}, {1, 2, 1}};
      },
      4, step);
  expect_border(
      egg,
      [t](double x) {
        return user::Cylinder<T>{{0, 0, t(x)}, 4, 2};
      },
      3, step);
  expect_border(
      egg,
      [t](double x) {
        return user::Cone<T>{{0, 0, t(x)}, 2, 4};
      },
      1, step);
  expect_border(
      egg,
      [t](double x) {
        return Segment<3, T>{{t(x), 0, 0}, {9, 0, 0}};
      },
      3, step);
  expect_border(
      user::Cone<T>{{0, 0, 0}, 1, 4}, [t](double x) { return Vec<3, T>(0, 0, t(x)); }, 4, step);
  expect_border(
      user::Cylinder<T>{{0, 0, 0}, 1, 1}, [t](double x) { return Vec<3, T>(t(x * 0.6), t(x * 0.8), 0); }, 1, step);
}

TYPED_TEST(UsersShapes, AreJudgedTheSameInBothOrders) {
  check_property([] {
    using T = TypeParam;
    const auto point =
        vector_of<3, T>(drawn<T>([](rc::Random& random) { return draw_coordinate<T>(Kind::grid, random); }));
    const user::Ellipsoid<T> egg{*point, {3, 2, 1}};
    const user::Ellipsoid<T> other{*point, {1, 2, 2}};
    const user::Cone<T> hat{*point, 2, 4};
    const auto box = *any<Obb<3, T>>();
    RC_ASSERT(relation(egg, other) == relation(other, egg));
    RC_ASSERT(relation(egg, hat) == relation(hat, egg));
    RC_ASSERT(relation(egg, box) == relation(box, egg));
  });
}

TEST(RelationOfConvex, OfShapesThatAreNoneEnds) {
  const Aabb<3, double> box{{-1, -1, -1}, {1, 1, 1}};
  const double nan = std::nan("");
  EXPECT_EQ(relation(user::Liar<double>{{nan, 0, 0}}, box), Relation::apart);
  EXPECT_EQ(relation(user::Liar<double>{{nan, nan, nan}}, user::Liar<double>{{nan, nan, nan}}), Relation::apart);
  for (const double x : {1e150, 1e300, 5e-324, std::numeric_limits<double>::infinity()}) {
    EXPECT_NO_FATAL_FAILURE((void)relation(user::Liar<double>{{x, -x, x}}, box));
  }
  EXPECT_NO_FATAL_FAILURE((void)relation(user::Chaos{}, box));
}

TEST(IsInOrder, ByTypeThenByCorners) {
  const Triangle<3, double> a{{0, 0, 0}, {9, 9, 9}, {1, 5, 5}};
  const Triangle<3, double> b{{0, 0, 0}, {9, 9, 9}, {1, 5, 6}};
  EXPECT_TRUE(detail::is_in_order(a, b)) << "though they reach equally far along every axis";
  EXPECT_FALSE(detail::is_in_order(b, a));
  EXPECT_TRUE(detail::is_in_order(a, a));
  EXPECT_EQ((detail::type_place<Vec<2, float>>), 0U);
  EXPECT_LT((detail::type_place<Triangle<2, float>>), (detail::type_place<Polytope<2, float>>));
  EXPECT_EQ((detail::type_place<user::Cone<float>>), shape_type_names.size());
}

}  // namespace
}  // namespace graze::test::relation_convex_test
