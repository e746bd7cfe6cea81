// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/shape/polytope.hpp>

#include "../catalogue/nasty.hpp"

namespace graze::polytope_test {
namespace {

using Rational = boost::multiprecision::cpp_rational;

template <Dim N, class T>
std::vector<Vec<N, T>> corners(const Polytope<N, T>& polytope) {
  return {polytope.vertices().begin(), polytope.vertices().end()};
}

/// Twice the signed area of a triangle, exactly.
template <class T>
Rational area(const Vec<2, T>& a, const Vec<2, T>& b, const Vec<2, T>& c) {
  return (Rational(b.x) - Rational(a.x)) * (Rational(c.y) - Rational(a.y)) -
         (Rational(b.y) - Rational(a.y)) * (Rational(c.x) - Rational(a.x));
}

TEST(Polytope, DefaultsToThePointAtTheOrigin) {
  EXPECT_EQ(corners(Polytope<3>{}), (std::vector<Vec<3, float>>{{0, 0, 0}}));
  EXPECT_TRUE(is_valid(Polytope<2>{}));
  EXPECT_EQ(support(Polytope<2>{}, {1, 1}), (Vec<2, double>(0, 0)));
}

TEST(Polytope, HullInThePlaneRunsCounterClockwiseFromTheLeastCorner) {
  const std::vector<Vec<2, float>> points{{1, 1}, {2, 2}, {0, 2}, {2, 0}, {0, 0}, {1, 0}, {0, 1}};
  EXPECT_EQ(corners(convex_hull<2, float>(points)), (std::vector<Vec<2, float>>{{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
}

TEST(Polytope, HullForgetsDuplicates) {
  const std::vector<Vec<2, double>> points{{0, 0}, {1, 0}, {0, 1}, {1, 0}, {0, 0}, {0, 1}, {-0.0, 0}};
  EXPECT_EQ(corners(convex_hull<2, double>(points)), (std::vector<Vec<2, double>>{{0, 0}, {1, 0}, {0, 1}}));
}

TEST(Polytope, HullOfPointsOnALineIsItsTwoEnds) {
  const std::vector<Vec<2, float>> points{{1, 2}, {3, 6}, {2, 4}, {-1, -2}, {0, 0}};
  EXPECT_EQ(corners(convex_hull<2, float>(points)), (std::vector<Vec<2, float>>{{-1, -2}, {3, 6}}));
}

TEST(Polytope, HullOfOnePointIsThatPoint) {
  const std::vector<Vec<2, float>> flat{{7, 8}, {7, 8}, {7, 8}};
  EXPECT_EQ(corners(convex_hull<2, float>(flat)), (std::vector<Vec<2, float>>{{7, 8}}));
  const std::vector<Vec<3, double>> deep{{7, 8, 9}};
  EXPECT_EQ(corners(convex_hull<3, double>(deep)), deep);
}

TEST(Polytope, HullKeepsACornerThatSticksOutByOneBit) {
  const double below = std::nextafter(1.0, 0.0);
  const double above = std::nextafter(1.0, 2.0);
  const auto hull_with = [](double y) {
    return corners(convex_hull<2, double>(std::vector<Vec<2, double>>{{0, 0}, {3, 0}, {3, 1}, {1, y}, {0, 1}})).size();
  };
  EXPECT_EQ(hull_with(below), 4u);
  EXPECT_EQ(hull_with(1), 4u);
  EXPECT_EQ(hull_with(above), 5u);
}

TEST(Polytope, HullIsRightAtEveryMagnitudeOfDouble) {
  const std::vector<Vec<2, double>> points{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}, {2, 0}, {3, 1}, {1, 5}};
  const std::vector<Vec<2, double>> expected{{0, 0}, {4, 0}, {4, 4}, {1, 5}, {0, 4}};
  const std::vector<Vec<3, double>> flat{{0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {0, 4, 1}, {2, 2, 1}, {2, 0, 1}, {1, 5, 1}};
  for (const double unit : {0x1p-1060, 0x1p-900, 0x1p-520, 0x1p-460, 1.0, 0x1p460, 0x1p520, 0x1p900, 0x1p1019}) {
    std::vector<Vec<2, double>> scaled = points;
    for (Vec<2, double>& point : scaled) point *= unit;
    std::vector<Vec<2, double>> scaled_corners = expected;
    for (Vec<2, double>& corner : scaled_corners) corner *= unit;
    EXPECT_EQ(corners(convex_hull<2, double>(scaled)), scaled_corners) << unit;
    std::vector<Vec<3, double>> scaled_flat = flat;
    for (Vec<3, double>& point : scaled_flat) point *= unit;
    EXPECT_EQ((convex_hull<3, double>(scaled_flat).vertices().size()), 5U) << unit;
  }
}

TEST(Polytope, HullInSpaceHasItsCornersSorted) {
  const std::vector<Vec<3, float>> points{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
  EXPECT_EQ(corners(convex_hull<3, float>(points)),
            (std::vector<Vec<3, float>>{{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}}));
}

TEST(Polytope, HullInSpaceForgetsWhatIsInsideOrInTheMiddleOfAFaceOrEdge) {
  const std::vector<Vec<3, double>> tetrahedron{{0, 0, 0}, {0, 0, 4}, {0, 4, 0}, {4, 0, 0}};
  std::vector<Vec<3, double>> points{{1, 1, 1}, {0, 1, 1}, {0, 0, 2}, {1, 1, 2}, {2, 2, 0}};
  points.insert(points.end(), tetrahedron.begin(), tetrahedron.end());
  EXPECT_EQ(corners(convex_hull<3, double>(points)), tetrahedron);
}

TEST(Polytope, HullInSpaceOfFlatPointsIsFlat) {
  const std::vector<Vec<3, float>> level{{1, 1, 2}, {0, 0, 2}, {2, 0, 2}, {0, 2, 2}, {1, 0, 2}, {1, 1, 2}};
  EXPECT_EQ(corners(convex_hull<3, float>(level)), (std::vector<Vec<3, float>>{{0, 0, 2}, {0, 2, 2}, {2, 0, 2}}));
  const std::vector<Vec<3, float>> line{{1, 2, 3}, {3, 6, 9}, {2, 4, 6}, {-1, -2, -3}};
  EXPECT_EQ(corners(convex_hull<3, float>(line)), (std::vector<Vec<3, float>>{{-1, -2, -3}, {3, 6, 9}}));
}

TEST(Polytope, HullWorksUpToTheLargestFloat) {
  const float huge = std::numeric_limits<float>::max();
  const std::vector<Vec<2, float>> points{{huge, huge}, {-huge, huge}, {0, 0}, {-huge, -huge}, {huge, -huge}};
  EXPECT_EQ(corners(convex_hull<2, float>(points)),
            (std::vector<Vec<2, float>>{{-huge, -huge}, {huge, -huge}, {huge, huge}, {-huge, huge}}));
}

TEST(Polytope, HullOfNoPointsIsRefusedWithTheReason) {
  try {
    convex_hull<2, float>({});
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()), "convex_hull: there are no points");
  }
}

template <Dim N, class Row>
concept GivesAHullIn = requires(const Row& row) {
  convex_hull<N>(row);
};

static_assert(GivesAHullIn<2, std::vector<Vec<2, float>>> && GivesAHullIn<3, std::array<Vec<3, double>, 4>>);
static_assert(!GivesAHullIn<3, std::vector<Vec<2, float>>> && !GivesAHullIn<2, std::vector<float>>);

TEST(Polytope, IsTheHullOfAnyRowOfPoints) {
  const std::array<Vec<2, float>, 4> array{{{0, 0}, {2, 0}, {1, 0}, {0, 2}}};
  const std::vector<Vec<2, float>> list(array.begin(), array.end());
  const Polytope<2, float> hull = convex_hull(array);
  EXPECT_EQ(corners(hull), (std::vector<Vec<2, float>>{{0, 0}, {2, 0}, {0, 2}}));
  EXPECT_EQ(corners(convex_hull(list)), corners(hull));
  EXPECT_EQ(corners(convex_hull(std::span(list))), corners(hull));
  EXPECT_EQ(corners(convex_hull<2, float>(array)), corners(hull));
  EXPECT_EQ(corners(convex_hull<2>(list)), corners(hull));
  EXPECT_EQ(corners(convex_hull<2>(std::span(array))), corners(hull));
}

TEST(Polytope, CopiesShareTheirVertices) {
  const std::vector<Vec<2, float>> points{{0, 0}, {1, 0}, {0, 1}};
  const Polytope<2> original = convex_hull<2, float>(points);
  const Polytope<2> copy = original;  // NOLINT(performance-unnecessary-copy-initialization)
  EXPECT_EQ(copy.vertices().data(), original.vertices().data());
}

TEST(Polytope, HasItsFarthestVertexAsSupport) {
  const std::vector<Vec<2, float>> points{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  const Polytope<2> square = convex_hull<2, float>(points);
  EXPECT_EQ(support(square, {1, 0.1}), (Vec<2, double>(2, 2)));
  EXPECT_EQ(support(square, {-1e-9, 1e-10}), (Vec<2, double>(0, 2)));
  EXPECT_EQ(support(square, {0, -5}), (Vec<2, double>(0, 0)));  // of equally far ones the first
}

TEST(Polytope, HullInOrderNumbersCornersAsTheyComeAmongThePoints) {
  const std::vector<Vec<2, float>> flat{{1, 1}, {2, 2}, {0, 0}, {2, 2}, {0, 2}, {2, 0}, {1, 0}};
  EXPECT_EQ(corners(convex_hull_in_order<2, float>(flat)),
            (std::vector<Vec<2, float>>{{2, 2}, {0, 2}, {0, 0}, {2, 0}}));
  const std::vector<Vec<3, double>> deep{{1, 1, 1}, {0, 4, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 0}, {2, 2, 0}, {0, 0, 4}};
  const std::vector<Vec<3, double>> expected{{0, 4, 0}, {4, 0, 0}, {0, 0, 0}, {0, 0, 4}};
  EXPECT_EQ(corners(convex_hull_in_order<3, double>(deep)), expected);
  EXPECT_EQ(corners(convex_hull_in_order(deep)), expected);
  EXPECT_THROW((convex_hull_in_order<3, double>({})), std::invalid_argument);
}

TEST(Polytope, MovesWithItsVerticesWhichKeepTheirOrder) {
  const std::vector<Vec<2, double>> points{{0, 0}, {2, 0}, {0, 1}};
  const Polytope<2, double> moved = transformed(convex_hull<2, double>(points), {rotation_matrix(90), {10, 0}});
  EXPECT_EQ(corners(moved), (std::vector<Vec<2, double>>{{10, 0}, {10, 2}, {9, 0}}));
}

TEST(Polytope, MovesInThePlaneWithoutTheCornersThatRoundingHides) {
  const std::vector<Vec<2, double>> points{{-1, 5}, {0, 0}, {4, 0}, {4.125, 2}, {4, 4}};
  const auto hull = convex_hull<2, double>(points);
  ASSERT_EQ(corners(hull), (std::vector<Vec<2, double>>{{-1, 5}, {0, 0}, {4, 0}, {4.125, 2}, {4, 4}}));
  // At 2^52 what is left of x is 1.
  EXPECT_EQ(corners(transformed(hull, {Mat<2, double>(1), {0x1p52, 0}})),
            (std::vector<Vec<2, double>>{{0x1p52 - 1, 5}, {0x1p52, 0}, {0x1p52 + 4, 0}, {0x1p52 + 4, 4}}));
  EXPECT_EQ(corners(transformed(hull, {Mat<2, double>(1), {1e30, 1e30}})).size(), 1U);
  const Pose<2, double> mirror{Mat<2, double>(-1, 0, 0, 1), {0, 0}};  // not a pose, but accepted
  EXPECT_EQ(corners(transformed(hull, mirror)),
            (std::vector<Vec<2, double>>{{1, 5}, {-4, 4}, {-4.125, 2}, {-4, 0}, {0, 0}}));
}

TEST(Polytope, MovesInSpaceWithItsCorners) {
  const std::vector<Vec<3, double>> points{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto hull = convex_hull<3, double>(points);
  ASSERT_EQ(corners(hull), (std::vector<Vec<3, double>>{{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {2, 0, 0}}));
  EXPECT_EQ(corners(transformed(hull, {rotation_matrix({0, 0, 1}, 90), {0, 0, 5}})),
            (std::vector<Vec<3, double>>{{0, 0, 5}, {0, 0, 6}, {-1, 0, 5}, {0, 2, 5}}));
  // Two of them coincide afterwards.
  EXPECT_EQ(corners(transformed(hull, {Mat<3, double>(1), {1e30, 0, 0}})),
            (std::vector<Vec<3, double>>{{1e30, 0, 0}, {1e30, 0, 1}, {1e30, 1, 0}, {1e30, 0, 0}}));
  const Pose<3, double> too_far{Mat<3, double>(std::numeric_limits<double>::max()), {0, 0, 0}};
  EXPECT_THROW(transformed(hull, too_far), std::invalid_argument);
}

template <class S>
class PolytopeIn : public testing::Test {};
TYPED_TEST_SUITE(PolytopeIn, test::Spaces);

TYPED_TEST(PolytopeIn, RefusesEveryNumberThatIsNotFiniteWithTheReason) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for (std::size_t k = 0; k < 3; ++k) {
    for (Dim i = 0; i < N; ++i) {
      for (const T value : test::nasty_values<T>) {
        std::vector<Vec<N, T>> points{unit_axis<N, T>(0), unit_axis<N, T>(1), Vec<N, T>(T(2))};
        points[k][i] = value;
        try {
          EXPECT_TRUE(is_valid(convex_hull<N, T>(points)));
          EXPECT_TRUE(std::isfinite(value)) << points[k];
        } catch (const std::invalid_argument& error) {
          EXPECT_FALSE(std::isfinite(value)) << points[k];
          EXPECT_EQ(std::string(error.what()), "convex_hull: a point has a coordinate that is not finite");
        }
      }
    }
  }
}

TYPED_TEST(PolytopeIn, HullDoesNotDependOnTheOrderOfPoints) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    std::vector<Vec<N, T>> points = *test::some<Vec<N, T>>(12, test::draw_source<N, T>().point);
    const std::vector<Vec<N, T>> expected = corners(convex_hull<N, T>(points));
    std::reverse(points.begin(), points.end());
    RC_ASSERT((corners(convex_hull<N, T>(points))) == expected);
    std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2), points.end());
    RC_ASSERT((corners(convex_hull<N, T>(points))) == expected);
    RC_ASSERT((corners(convex_hull<N, T>(expected))) == expected);
  });
}

TYPED_TEST(PolytopeIn, HullInOrderHasTheCornersOfTheHullAndKeepsThoseOfOneThatWasMoved) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    const std::vector<Vec<N, T>> points = *test::some<Vec<N, T>>(12, test::draw_source<N, T>().point);
    const std::vector<Vec<N, T>> in_order = corners(convex_hull_in_order<N, T>(points));
    const std::vector<Vec<N, T>> expected = corners(convex_hull<N, T>(points));
    RC_ASSERT(std::is_permutation(in_order.begin(), in_order.end(), expected.begin(), expected.end()));
    const auto is_corner = [&](const Vec<N, T>& point) {
      return std::find(expected.begin(), expected.end(), point) != expected.end();
    };
    RC_ASSERT(in_order.front() == *std::find_if(points.begin(), points.end(), is_corner));
    RC_ASSERT((corners(convex_hull_in_order<N, T>(in_order))) == in_order);
  });
}

template <class T>
class PolygonIn : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(PolygonIn, Scalars);

TYPED_TEST(PolygonIn, HullIsStrictlyConvexAndContainsItsPointsExactly) {
  using Point = Vec<2, TypeParam>;
  test::check_property([] {
    const std::vector<Point> points = *test::some<Point>(16, test::draw_source<2, TypeParam>().point);
    const std::vector<Point> hull = corners(convex_hull<2, TypeParam>(points));
    for (const Point& corner : hull) RC_ASSERT(std::find(points.begin(), points.end(), corner) != points.end());
    if (hull.size() < 3) {
      // A point or a segment: everything is on the line between the ends, and inside their box.
      for (const Point& point : points) {
        RC_ASSERT(area(hull.front(), hull.back(), point) == 0);
        RC_ASSERT(Rational(dot(wide<2, TypeParam>(point) - wide<2, TypeParam>(hull.front()),
                               wide<2, TypeParam>(point) - wide<2, TypeParam>(hull.back()))) <= 0);
      }
      return;
    }
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const Point& a = hull[i];
      const Point& b = hull[(i + 1) % hull.size()];
      RC_ASSERT(area(a, b, hull[(i + 2) % hull.size()]) > 0);
      for (const Point& point : points) RC_ASSERT(area(a, b, point) >= 0);
    }
  });
}

}  // namespace
}  // namespace graze::polytope_test
