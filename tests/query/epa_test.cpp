// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <graze/query/epa.hpp>
#include <graze/query/gjk.hpp>
#include <graze/shape/any_shape.hpp>

#include "catalogue.hpp"
#include "exact/verdict_instances.hpp"
#include "query/user_shapes.hpp"

namespace graze::test::epa_test {
namespace {

constexpr int limit = detail::epa_iteration_limit;

template <class A, class B>
auto depth_of(const A& a, const B& b) {
  return epa(a, b, gjk(a, b).simplex);
}

template <Dim N>
void expect_depth(const EpaResult<N>& result, double expected) {
  EXPECT_LE(result.lower, expected + result.resolution);
  EXPECT_GE(result.upper, expected - result.resolution);
  EXPECT_LE(result.upper - result.lower, 1e-12 * result.upper + 2 * result.resolution);
  EXPECT_EQ(result.status, Status::converged);
  EXPECT_LE(result.iterations, limit);
}

TEST(Epa, FindsDepthsComputedByHand) {
  const Aabb<2, double> square{{-1, -1}, {1, 1}};
  const Aabb<3, double> cube{{-1, -1, -1}, {1, 1, 1}};
  expect_depth(depth_of(square, Aabb<2, double>{{0.5, -1}, {9, 1}}), 0.5);
  expect_depth(depth_of(square, square), 2);
  expect_depth(depth_of(square, Vec<2, double>(0, 0)), 1);
  expect_depth(depth_of(square, Triangle<2, double>{{0, 0.5}, {9, 9}, {-9, 9}}), 0.5);
  expect_depth(depth_of(Segment<2, double>{{-3, -4}, {3, 4}}, Segment<2, double>{{4, -3}, {-4, 3}}), 5);
  expect_depth(depth_of(cube, Aabb<3, double>{{0.25, -1, -1}, {9, 1, 1}}), 0.75);
  expect_depth(depth_of(cube, cube), 2);
  expect_depth(depth_of(cube, Vec<3, double>(0, 0, 0.5)), 0.5);
  expect_depth(
      depth_of(Triangle<3, float>{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, Segment<3, float>{{1, 1, -0.25F}, {1, 1, 3}}),
      0.25);
}

TEST(Epa, ScalesWithThePowersOfTwoFromTheLeastNumbersToTheLargest) {
  for (const int exponent : {-1060, -1022, -600, -120, 120, 600, 1015}) {
    const auto at = [exponent](double x) { return std::ldexp(x, exponent); };
    const auto point = [&at](double x, double y, double z) { return Vec<3, double>(at(x), at(y), at(z)); };
    const Aabb<3, double> box{point(-1, -1, -1), point(1, 1, 1)};
    const auto of_boxes = depth_of(box, Aabb<3, double>{point(0.25, -1, -1), point(9, 1, 1)});
    EXPECT_NEAR(of_boxes.upper, at(0.75), of_boxes.resolution);
    EXPECT_NEAR(of_boxes.lower, at(0.75), at(1e-12) + of_boxes.resolution);
    EXPECT_EQ(of_boxes.status, Status::converged);
    EXPECT_NEAR(depth_of(box, point(0, 0, 0.5)).upper, at(0.5), of_boxes.resolution);
  }
}

TEST(Epa, OfATouchOrAFlatSetOfDifferencesIsZero) {
  const Triangle<3, double> floor{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  expect_depth(depth_of(floor, floor), 0);                                                       // a face
  expect_depth(depth_of(floor, Triangle<3, double>{{1, 1, 0}, {3, 1, 0}, {1, 3, 0}}), 0);        // one plane
  expect_depth(depth_of(floor, Triangle<3, double>{{0, 0, 0}, {-4, 0, 0}, {0, -4, 1}}), 0);      // a corner
  expect_depth(depth_of(floor, Triangle<3, double>{{0, 0, 0}, {4, 0, 0}, {0, 0, 4}}), 0);        // an edge
  expect_depth(depth_of(Vec<3, double>(1, 2, 3), Vec<3, double>(1, 2, 3)), 0);                   // a point
  expect_depth(depth_of(Segment<3, double>{{0, 0, 0}, {2, 2, 2}}, Vec<3, double>(1, 1, 1)), 0);  // a line
  expect_depth(depth_of(Aabb<3, double>{{0, 0, 0}, {1, 1, 1}}, Aabb<3, double>{{1, 1, 1}, {2, 2, 2}}), 0);
  expect_depth(depth_of(Aabb<3, double>{{0, 0, 0}, {1, 1, 1}}, Aabb<3, double>{{0, 1, 0}, {1, 2, 1}}), 0);
  expect_depth(depth_of(Segment<2, double>{{0, 0}, {2, 2}}, Segment<2, double>{{1, 1}, {3, 3}}), 0);
}

TEST(Epa, MovingTheSecondShapeByTheDepthPartsThem) {
  const Aabb<2, double> square{{-1, -1}, {1, 1}};
  const auto result = depth_of(square, Aabb<2, double>{{0.5, -1}, {9, 1}});
  EXPECT_NEAR(result.normal.x * result.upper, 0.5, 1e-12);
  EXPECT_NEAR(result.normal.y * result.upper, 0, 1e-12);
}

TEST(Epa, SaysWhenTheShapesDoNotMeetAfterAll) {
  const Aabb<3, double> box{{-1, -1, -1}, {1, 1, 1}};
  const auto result = epa(box, Vec<3, double>(0, 0, 1.5), gjk(box, Vec<3, double>(0, 0, 1.5)).simplex);
  EXPECT_EQ(result.gap, 0.5);
  EXPECT_EQ(result.lower, 0);
  EXPECT_EQ(result.upper, 0);
  EXPECT_EQ(depth_of(box, Vec<3, double>(0, 0, 0.5)).gap, 0);
}

TEST(Epa, WithAThresholdStopsAsSoonAsItKnows) {
  const user::Ellipsoid<double> egg{{0, 0, 0}, {3, 2, 1}};
  const user::Ellipsoid<double> other{{1, 1, 0}, {1, 3, 2}};
  const auto simplex = gjk(egg, other).simplex;
  const auto known = epa(egg, other, simplex, EpaOptions{0.01});
  EXPECT_GT(known.lower, 0.01);
  EXPECT_LT(known.iterations, epa(egg, other, simplex).iterations);
}

template <class T>
class EpaOfUsersShapes : public ::testing::Test {};
using Numbers = ::testing::Types<float, double>;
TYPED_TEST_SUITE(EpaOfUsersShapes, Numbers);

// Round shapes need as many faces as digits: the bounds enclose the depth, and 128 steps bring them this close.
TYPED_TEST(EpaOfUsersShapes, EnclosesDepthsComputedByHand) {
  using T = TypeParam;
  const auto expect_enclosed = [](const EpaResult<3>& result, double expected) {
    EXPECT_LE(result.lower, expected + result.resolution);
    EXPECT_GE(result.upper, expected - result.resolution);
    EXPECT_LE(result.upper - result.lower, 0.05 * expected + result.resolution);
    EXPECT_LE(result.iterations, limit);
  };
  const user::Ellipsoid<T> egg{{0, 0, 0}, {3, 2, 1}};
  const user::Cylinder<T> can{{0, 0, 2}, 4, 2};
  const user::Cone<T> hat{{0, 0, T(0.5)}, 2, 4};
  expect_enclosed(depth_of(egg, can), 1);                                 // pushed up
  expect_enclosed(depth_of(egg, hat), 0.5);                               // base at 0.5, egg's top at 1
  expect_enclosed(depth_of(can, Aabb<3, T>{{-9, -9, 3}, {9, 9, 9}}), 1);  // lid at 4
  expect_enclosed(depth_of(user::Superellipsoid<T>{{0, 0, 0}, {2, 2, 2}}, Aabb<3, T>{{1, -9, -9}, {9, 9, 9}}), 1);
  expect_enclosed(depth_of(user::Ellipsoid<T>{{0, 0, 0}, {1, 1, 1}}, user::Ellipsoid<T>{{1, 2, 2}, {3, 3, 3}}), 1);
}

template <class SpaceType>
class EpaAgreement : public ::testing::Test {};
using Spaces = ::testing::Types<Space<2, double>, Space<3, float>, Space<3, double>>;
TYPED_TEST_SUITE(EpaAgreement, Spaces);

TYPED_TEST(EpaAgreement, EnclosesTheExactDepthOfPolytopes) {
  constexpr Dim N = TypeParam::dimension;
  using Hull = Polytope<N, typename TypeParam::scalar>;
  int most = 0;
  double worst = 0;
  check_property([&] {
    const auto [a, b] = *any_pair<Hull, Hull>();
    const DifferenceSet<N> differences(solid(a), solid(b));
    RC_PRE(is_zero(differences.nearest().sum));
    const double depth = differences.depth();
    const auto result = depth_of(a, b);
    const double gap = std::max({result.lower - depth, depth - result.upper, 0.0});
    RC_ASSERT(gap <= result.resolution);
    RC_ASSERT(result.iterations <= limit);
    if (result.status == Status::converged) {
      RC_ASSERT(result.upper - result.lower <= 1e-12 * result.upper + result.resolution);
    }
    RC_TAG(result.status == Status::converged ? "converged" : "best bound");
    most = std::max(most, result.iterations);
    if (result.resolution > 0) worst = std::max(worst, gap / result.resolution);
  });
  std::cout << "at most " << most << " steps; bounds off by at most " << worst << " of the resolution\n";
}

TEST(Epa, EndsOnShapesThatAreNone) {
  const Aabb<3, double> box{{-1, -1, -1}, {1, 1, 1}};
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double x : {nan, infinity, -infinity, 1e300, 1e150, 5e-324, 0.0}) {
    const user::Liar<double> liar{{x, 1, x}};
    EXPECT_LE(depth_of(liar, box).iterations, limit) << x;
    EXPECT_LE(depth_of(box, liar).iterations, limit) << x;
  }
  EXPECT_LE(depth_of(user::Chaos{}, box).iterations, limit);
  EXPECT_LE(depth_of(user::Chaos{}, user::Chaos{}).iterations, limit);
}

}  // namespace
}  // namespace graze::test::epa_test
