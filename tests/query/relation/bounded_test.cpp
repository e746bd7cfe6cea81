// SPDX-License-Identifier: MIT
// The closed forms of segments, spheres, boxes and capsules. relation_test.cpp has every pair by hand,
// agreement_test.cpp every pair against the oracle; this tests cases where closed forms fail easily.
#include <cmath>
#include <tuple>

#include <gtest/gtest.h>

#include <graze/query/relation.hpp>

#include "catalogue.hpp"
#include "exact.hpp"

namespace graze::test::relation_bounded_test {
namespace {

/// graze's verdict, in both orders, and the oracle's.
template <class A, class B>
void expect(const A& a, const B& b, Relation expected) {
  EXPECT_EQ(name_of(relation(a, b)), name_of(expected)) << to_source(a) << ", " << to_source(b);
  EXPECT_EQ(name_of(relation(b, a)), name_of(expected)) << "swapped: " << to_source(a) << ", " << to_source(b);
  const ExactVerdict truth = exact_verdict_of(a, b, Measure::distance);
  EXPECT_EQ(name_of(truth.relation), name_of(expected)) << "oracle: " << to_source(a) << ", " << to_source(b);
}

// Reported apart once: the crossing of two almost parallel lines was lost in the rounding of a determinant.
TEST(RelationBounded, SegmentsThatCrossAtAlmostNoAngleOverlap) {
  const Segment<2, float> small{{-0.27411723F, -0.003531331F}, {0.0023997936F, -0.0020539726F}};
  const Capsule<2, float> large{{1732.4413F, -5.4925604F}, {-2665.351F, 8.444495F}, 0};
  expect(small, large, Relation::overlapping);
  expect(small, axis(large), Relation::overlapping);
}

// Reported apart by 7e-11 once: the vector from the segment to the box was calculated from zero, a million away.
TEST(RelationBounded, AnAabbAndACapsuleFarFromTheOriginAreAsExactAsNearIt) {
  expect(Aabb<2, double>{{999990.1721995814, 999997.2571762068}, {999991.5260422312, 1000007.6337609334}},
         Capsule<2, double>{
             {999989.8204108725, 999995.8132825054}, {999994.8231564942, 999999.287637318}, 0.21301817087017283},
         Relation::overlapping);
}

// Reported overlapping once: the edges of the box were calculated a million from zero.
TEST(RelationBounded, AnObbAndACapsuleFarFromTheOriginAreAsExactAsNearIt) {
  expect(Obb<2, double>{{999992.5709829318, 999995.846026824},
                        {4.34504290484978, 3.5170529961203565},
                        {{0.9834032659204457, -0.1814332289769468}, {0.1814332289769468, 0.9834032659204457}}},
         Capsule<2, double>{
             {999991.858945523, 1000013.6029152591}, {999985.3503480122, 1000002.4489026372}, 4.290471753551371},
         Relation::apart);
  expect(Obb<3, double>{{1000000.6309445495, 1000009.774822574, 999992.3447719994},
                        {0.13979493744760707, 3.522114478277773, 0.6978360828553881},
                        {{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}},
         Capsule<3, double>{{1000003.7661680107, 1000022.6125983665, 1000005.1134902267},
                            {999993.583587209, 1000004.6946600407, 999988.3302374494},
                            3.461284358384667},
         Relation::apart);
}

TEST(RelationBounded, BoxesAndPointsCompareExactly) {
  const double next = std::nextafter(1.0, 2.0);
  expect(Aabb<2, double>{{0, 0}, {1, 1}}, Aabb<2, double>{{1, 1}, {2, 2}}, Relation::touching);
  expect(Aabb<2, double>{{0, 0}, {1, 1}}, Aabb<2, double>{{next, 0}, {2, 2}}, Relation::apart);
  expect(Aabb<2, double>{{0, 0}, {next, 1}}, Aabb<2, double>{{1, 0}, {2, 2}}, Relation::overlapping);
  expect(Aabb<2, double>{{0, 0}, {1, 1}}, Vec<2, double>(1, 0.5), Relation::touching);
  expect(Aabb<2, double>{{0, 0}, {1, 1}}, Vec<2, double>(next, 0.5), Relation::apart);
  expect(Aabb<2, double>{{0, 0}, {next, 1}}, Vec<2, double>(1, 0.5), Relation::overlapping);
  expect(Vec<3, double>(1, 1, 1), Vec<3, double>(1, 1, 1), Relation::touching);
  expect(Vec<3, double>(1, 1, 1), Vec<3, double>(1, 1, next), Relation::apart);
}

TEST(RelationBounded, FloatShapesAreDecidedInDouble) {
  // One float step apart at a million: 0.0625, and the sum of the radii is exact.
  expect(Sphere<2, float>{{1000000, 0}, 1}, Sphere<2, float>{{1000002.0625F, 0}, 1}, Relation::apart);
  expect(Sphere<2, float>{{1000000, 0}, 1}, Sphere<2, float>{{1000002, 0}, 1}, Relation::touching);
  expect(Sphere<2, float>{{1000000, 0}, 1}, Sphere<2, float>{{1000001.9375F, 0}, 1}, Relation::overlapping);
}

TEST(RelationBounded, DeeplyCrossingThinShapesOverlap) {
  expect(Capsule<2, double>{{-1, 0}, {1, 0}, 0}, Capsule<2, double>{{0, -1}, {0, 1}, 0}, Relation::overlapping);
  expect(Capsule<2, double>{{-1, 0}, {1, 0}, 1e-18}, Capsule<2, double>{{0, -1}, {0, 1}, 0}, Relation::overlapping);
  expect(Capsule<3, double>{{-1, 0, 0}, {1, 0, 0}, 0}, Capsule<3, double>{{0, -1, 0}, {0, 1, 0}, 0},
         Relation::touching);
  expect(Capsule<3, double>{{-9, 0, 0}, {9, 0, 0}, 0}, Aabb<3, double>{{-1, -1, -1}, {1, 1, 1}}, Relation::overlapping);
  expect(Sphere<3, double>{{0.5, 0.5, 0.5}, 1e-18}, Aabb<3, double>{{-1, -1, -1}, {1, 1, 1}}, Relation::overlapping);
}

/// The closed form and the generic answer differ only within rounding.
template <class A, class B>
void expect_generic_agrees() {
  check_property([] {
    const auto [a, b] = *any_pair<A, B>();
    const Relation closed = relation(a, b);
    const Relation generic = detail::relation_of_convex(a, b);
    if (closed == generic) return;
    const ExactVerdict truth = exact_verdict_of(a, b, Measure::depth);
    RC_LOG() << "closed: " << name_of(closed) << ", generic: " << name_of(generic) << ", gap " << truth.gap << "\n";
    RC_ASSERT(closed == Relation::touching || generic == Relation::touching || truth.relation == Relation::touching);
    RC_ASSERT(std::fabs(truth.gap) <= 128 * tolerance::epsilon * truth.largest);
  });
}

template <template <Dim, class> class A, template <Dim, class> class B>
void expect_generic_agrees_in_every_space() {
  expect_generic_agrees<A<2, float>, B<2, float>>();
  expect_generic_agrees<A<3, double>, B<3, double>>();
}

TEST(RelationBounded, SegmentsAreAsTheGenericAnswerHasThem) {
  expect_generic_agrees_in_every_space<Segment, Segment>();
  expect_generic_agrees_in_every_space<Segment, Sphere>();
  expect_generic_agrees_in_every_space<Segment, Aabb>();
  expect_generic_agrees_in_every_space<Segment, Obb>();
  expect_generic_agrees_in_every_space<Segment, Capsule>();
}

TEST(RelationBounded, SpheresAreAsTheGenericAnswerHasThem) {
  expect_generic_agrees_in_every_space<Sphere, Sphere>();
  expect_generic_agrees_in_every_space<Sphere, Aabb>();
  expect_generic_agrees_in_every_space<Sphere, Obb>();
  expect_generic_agrees_in_every_space<Sphere, Capsule>();
}

TEST(RelationBounded, BoxesAndCapsulesAreAsTheGenericAnswerHasThem) {
  expect_generic_agrees_in_every_space<Aabb, Aabb>();
  expect_generic_agrees_in_every_space<Aabb, Obb>();
  expect_generic_agrees_in_every_space<Aabb, Capsule>();
  expect_generic_agrees_in_every_space<Obb, Obb>();
  expect_generic_agrees_in_every_space<Obb, Capsule>();
  expect_generic_agrees_in_every_space<Capsule, Capsule>();
}

}  // namespace
}  // namespace graze::test::relation_bounded_test
