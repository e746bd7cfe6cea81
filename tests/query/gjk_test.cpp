// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/convex/wide_support.hpp>
#include <graze/query/gjk.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/visit.hpp>

#include "catalogue.hpp"
#include "exact.hpp"
#include "query/flush_prisms.hpp"
#include "query/user_shapes.hpp"

namespace graze::test::gjk_test {
namespace {

constexpr int limit = detail::gjk_iteration_limit;

template <Dim N>
void expect_distance(const GjkResult<N>& result, double expected) {
  EXPECT_LE(result.lower, expected + result.resolution);
  EXPECT_GE(result.upper, expected - result.resolution);
  EXPECT_LE(result.upper - result.lower, 1e-12 * result.upper + result.resolution);
  EXPECT_EQ(result.status, Status::converged);
  EXPECT_LE(result.iterations, limit);
}

// ---- By hand

TEST(Gjk, FindsDistancesComputedByHand) {
  using V2 = Vec<2, double>;
  using V3 = Vec<3, double>;
  expect_distance(gjk(V2(0, 0), V2(3, 4)), 5);
  expect_distance(gjk(Aabb<2, double>{{-1, -1}, {1, 1}}, Triangle<2, double>{{4, 5}, {9, 5}, {4, 9}}), 5);
  expect_distance(gjk(Segment<2, double>{{-2, 0}, {2, 0}}, Segment<2, double>{{-1, 3}, {1, 3}}), 3);
  expect_distance(gjk(Segment<3, double>{{-1, 0, 0}, {1, 0, 0}}, Segment<3, double>{{0, -1, 2}, {0, 1, 2}}), 2);
  expect_distance(gjk(Triangle<3, float>{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, Vec<3, float>{1, 1, 7}), 7);
  expect_distance(gjk(Aabb<3, double>{{0, 0, 0}, {1, 1, 1}}, V3(2, 3, 3)), 3);
  expect_distance(gjk(Obb<3, double>{{0, 0, 0}, {1, 2, 3}, Mat<3, double>(1.0)}, V3(3, 5, 9)), 7);
}

TEST(Gjk, ScalesWithThePowersOfTwoFromTheLeastNumbersToTheLargest) {
  for (const int exponent : {-1060, -1022, -600, -120, 120, 600, 1015}) {
    const auto at = [exponent](double x) { return std::ldexp(x, exponent); };
    const auto point = [&at](double x, double y, double z) { return Vec<3, double>(at(x), at(y), at(z)); };
    const Aabb<3, double> box{point(0, 0, 0), point(4, 2, 6)};
    const auto apart = gjk(box, Segment<3, double>{point(7, 6, 9), point(9, 8, 7)});
    EXPECT_EQ(apart.status, Status::converged);
    EXPECT_GT(apart.lower, 0);
    EXPECT_LE(apart.lower, at(5.875));  // the root of 34
    EXPECT_GE(apart.upper, apart.lower);
    EXPECT_LE(apart.upper - apart.lower, at(1e-11) + 2 * apart.resolution);
    EXPECT_EQ(gjk(box, point(7, 6, 6)).upper, at(5));
    EXPECT_GT(gjk(box, point(7, 6, 6), GjkOptions{at(2)}).lower, at(2));
    const auto met = gjk(box, Triangle<3, double>{point(1, 1, 1), point(9, 9, 9), point(8, 0, 0)});
    EXPECT_LE(met.upper, met.resolution);
  }
}

TEST(Gjk, GivesTheSeparationFromTheSecondToTheFirst) {
  const auto result = gjk(Vec<2, double>(1, 2), Aabb<2, double>{{3, 0}, {5, 9}});
  EXPECT_EQ(result.separation, (Vec<2, double>(-2, 0)));
  EXPECT_EQ(result.upper, 2);
}

TEST(Gjk, OfShapesThatMeetIsZero) {
  const Aabb<3, double> box{{-1, -1, -1}, {1, 1, 1}};
  const std::vector<AnyShape<3, double>> others = {Vec<3, double>(0.5, 0.25, 0.125), Vec<3, double>(1, 1, 1), box,
                                                   Aabb<3, double>{{1, 1, 1}, {2, 2, 2}},
                                                   Segment<3, double>{{-5, 0.5, 0.25}, {5, 0.5, 0.25}}};
  for (const auto& other : others) {
    const auto distance = detail::visit(
        [&](const auto& held) {
          if constexpr (Convex<std::decay_t<decltype(held)>>) return gjk(box, held);
          return GjkResult<3>{};
        },
        other);
    EXPECT_EQ(distance.lower, 0) << other;
    EXPECT_LE(distance.upper, distance.resolution) << other;
  }
}

TEST(Gjk, WithAThresholdStopsAsSoonAsItKnows) {
  const Sphere<3, double> sphere{{0, 0, 0}, 1};
  const Sphere<3, double> other{{10, 2, 3}, 1};
  const auto far = gjk(sphere, other, GjkOptions{1.0});
  const auto near = gjk(sphere, other, GjkOptions{100.0});
  EXPECT_GT(far.lower, 1.0);
  EXPECT_LT(near.upper, 100.0);
  EXPECT_LT(far.iterations, gjk(sphere, other).iterations);
  EXPECT_EQ(near.iterations, 0);
}

// The first step is too small to reduce the distance, but its direction leads to the right corner of the box.
TEST(Gjk, IsNotStoppedByAStepTooSmallToMeasure) {
  const Aabb<3, float> box{{0.006993956F, -6949.267F, 0.0014318873F}, {300995.75F, 9.423732e-06F, 0.0030424062F}};
  const Triangle<3, float> triangle{{305732.03F, -33222.582F, -556.97394F},
                                    {305732.03F, -24121.977F, -0.016510185F},
                                    {300995.75F, -6949.2676F, 0.0018096385F}};
  expect_distance(gjk(box, triangle), 0.00048828125);
}

template <class T>
void expect_flush_prisms_converge() {
  for (unsigned turn = 0; turn < 2000; ++turn) {
    const auto [a, b, normal] = flush_prisms<T>(turn, flush_gap(turn));
    const auto result = gjk(a, b);
    EXPECT_EQ(result.status, Status::converged) << turn;
    EXPECT_LE(result.upper - result.lower, 1e-12 * result.upper + result.resolution) << turn;
  }
}

TEST(Gjk, ConvergesWhereFacesAreNearlyParallel) {
  expect_flush_prisms_converge<double>();
  expect_flush_prisms_converge<float>();
}

// ---- User-defined shapes

template <class T>
class GjkOfUsersShapes : public ::testing::Test {};
using Numbers = ::testing::Types<float, double>;
TYPED_TEST_SUITE(GjkOfUsersShapes, Numbers);

TYPED_TEST(GjkOfUsersShapes, FindsDistancesComputedByHand) {
  using T = TypeParam;
  const user::Ellipsoid<T> egg{{0, 0, 0}, {3, 2, 1}};
  const user::Superellipsoid<T> soap{{10, 0, 0}, {2, 1, 1}};
  const user::Cylinder<T> can{{0, 0, 10}, 1, 2};
  const user::Cone<T> hat{{0, 0, 3}, 2, 4};
  expect_distance(gjk(egg, soap), 5);                                               // 10 - 2 - 3
  expect_distance(gjk(egg, can), 7);                                                // 10 - 2 - 1
  expect_distance(gjk(hat, can), 1);                                                // tip at 7, lid at 8
  expect_distance(gjk(egg, hat), 2);                                                // base at 3
  expect_distance(gjk(can, user::Cylinder<T>{{3, 4, 10}, 2, 1}), 2);                // 5 - 1 - 2
  expect_distance(gjk(can, user::Cylinder<T>{{3, 4, 20}, 2, 4}), std::sqrt(20.0));  // 2 aside, 4 above
  expect_distance(gjk(egg, Vec<3, T>(0, 9, 0)), 7);
  expect_distance(gjk(Aabb<3, T>{{-1, -1, -9}, {1, 1, -4}}, egg), 3);
}

TYPED_TEST(GjkOfUsersShapes, EnclosesTheDistanceOfBallsAnywhere) {
  int most = 0;
  check_property([&most] {
    using T = TypeParam;
    const auto point = vector_of<3, double>(drawn<double>([](rc::Random& random) { return between(random, -9, 9); }));
    const Vec<3, T> p(*point);
    const Vec<3, T> q(*point);
    const Vec<3, double> off = wide<3, T>(q) - wide<3, T>(p);
    const double distance = std::max(0.0, std::sqrt(dot(off, off)) - 3);
    const auto result = gjk(user::Ellipsoid<T>{p, {1, 1, 1}}, user::Ellipsoid<T>{q, {2, 2, 2}});
    RC_ASSERT(result.lower <= distance + result.resolution);
    RC_ASSERT(result.upper >= distance - result.resolution);
    RC_ASSERT(result.upper - result.lower <= 0.25 * static_cast<double>(std::sqrt(std::numeric_limits<T>::epsilon())));
    RC_ASSERT(result.iterations <= limit);
    most = std::max(most, result.iterations);
  });
  std::cout << "at most " << most << " steps for balls\n";
}

// ---- Against the oracle

template <class SpaceType>
class GjkAgreement : public ::testing::Test {};
using Spaces = ::testing::Types<Space<2, double>, Space<3, float>, Space<3, double>>;
TYPED_TEST_SUITE(GjkAgreement, Spaces);

TYPED_TEST(GjkAgreement, EnclosesTheExactDistanceOfPolytopes) {
  constexpr Dim N = TypeParam::dimension;
  using Hull = Polytope<N, typename TypeParam::scalar>;
  int most = 0;
  check_property([&most] {
    const auto [a, b] = *any_pair<Hull, Hull>();
    const ExactVerdict truth = exact_verdict_of(a, b, Measure::distance);
    const double distance = std::max(0.0, truth.gap);
    const auto result = gjk(a, b);
    RC_TAG(truth.relation == Relation::apart ? "apart" : "meeting");
    RC_ASSERT(result.lower <= distance + result.resolution);
    RC_ASSERT(result.upper >= distance - result.resolution);
    RC_ASSERT(result.iterations <= limit);
    most = std::max(most, result.iterations);
    if (result.lower == 0) return;
    const double gap =
        dot(result.normal, detail::wide_support(a, -result.normal) - detail::wide_support(b, result.normal));
    RC_ASSERT(gap >= (result.lower - result.resolution) * std::sqrt(dot(result.normal, result.normal)));
  });
  std::cout << "at most " << most << " steps for polytopes\n";
}

// The shortest vector is as long as the rounding error of its direction at the far end of the hull.
TEST(Gjk, KnowsThePlaneThatPartsWhatIsNearlyTouching) {
  const Polytope<3, double> hull = convex_hull<3, double>(
      std::vector<Vec<3, double>>{{-2.9363806547327087, 4.741393265194742, -2.2128846683181322},
                                  {-2.547019421712185, -2.727552434677235, -2.464376144485094},
                                  {0.24945298444527997, 3.8313456186314028, -2.0636288326986745},
                                  {1.013176673122209, -4.21684748472331, -0.43780168983651313},
                                  {1.4498108853956915, -0.6751255678332748, -1.5627712130206262},
                                  {2.5177599264529187, 2.6738454160108063, -3.9384559974723334}});
  const Vec<3, double> point(2.4472396341596148, 2.3508761814481094, -3.7743790490976803);
  const auto result = gjk(point, hull);
  EXPECT_NEAR(result.lower, result.upper, result.resolution);
  ASSERT_GT(result.lower, 1e3 * result.resolution);
  const double gap = dot(result.normal, point - detail::wide_support(hull, result.normal));
  EXPECT_GE(gap, (result.lower - result.resolution) * std::sqrt(dot(result.normal, result.normal)));
}

// ---- Nasty values

TEST(Gjk, EndsOnShapesThatAreNone) {
  const Aabb<3, double> box{{-1, -1, -1}, {1, 1, 1}};
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double x : {nan, infinity, -infinity, 1e300, 1e150, -1e150, 5e-324, 0.0}) {
    const user::Liar<double> liar{{x, 1, x}};
    EXPECT_LE(gjk(liar, box).iterations, limit) << x;
    EXPECT_LE(gjk(box, liar).iterations, limit) << x;
    EXPECT_LE(gjk(liar, liar).iterations, limit) << x;
  }
  EXPECT_LE(gjk(user::Chaos{}, box).iterations, limit);
  EXPECT_LE(gjk(user::Chaos{}, Vec<3, double>(5, 5, 5)).iterations, limit);
}

TEST(Gjk, WorksFromTheSmallestToTheLargestPromisedCoordinates) {
  for (const double scale : {1e-140, 1e-100, 1e100, 1e140}) {
    const Aabb<3, double> box{Vec<3, double>(-scale), Vec<3, double>(scale)};
    expect_distance(gjk(box, Vec<3, double>(2, 3, 3) * scale), 3 * scale);
  }
}

}  // namespace
}  // namespace graze::test::gjk_test
