// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <type_traits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/math/random/linear_congruential.hpp>
#include <graze/shape/obb.hpp>

#include "../catalogue/nasty.hpp"

namespace graze::obb_test {
namespace {

static_assert(std::is_same_v<OrientedRect<double>, Obb<2, double>> && std::is_same_v<OrientedRect<>, Obb<2>>);

template <class S>
class ObbIn : public testing::Test {};
TYPED_TEST_SUITE(ObbIn, test::Spaces);

TYPED_TEST(ObbIn, NamesTheDefectOfEveryNumber) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  // One entry of the identity changes: on the diagonal only 1 and, as a reflection, -1 leave it orthonormal; elsewhere
  // only 0 and tiny numbers.
  const auto axes = [](T value, Dim index) -> std::string_view {
    if (!std::isfinite(value)) return "has axes that are not finite";
    const bool diagonal = index / N == index % N;
    const bool orthonormal = diagonal ? std::fabs(value) == T(1) : std::fabs(value) < T(0.5);
    return orthonormal ? "" : "has axes that are not orthonormal (unit length, at right angles)";
  };
  EXPECT_EQ(test::expect_defects(
                Obb<N, T>{}, test::finite("has a center that is not finite"),
                test::finite_size("has half_extents that are not finite", "has a negative half extent"), axes),
            (2 * N + N * N) * 11);
}

TYPED_TEST(ObbIn, OfNoSizeIsValidAndItsOwnSupport) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  const Obb<N, T> point{Vec<N, T>(T(2)), Vec<N, T>(T(0))};
  EXPECT_TRUE(is_valid(point));
  EXPECT_EQ(support(point, unit_axis<N>(0)), (Vec<N, double>(2)));
}

TYPED_TEST(ObbIn, OrientedAabbHasTheSameSupports) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    const Aabb<N, T> box = *test::any<Aabb<N, T>>();
    const Vec<N, double> direction = wide<N, T>(*test::draw_source<N, T>().direction);
    const double size = static_cast<double>(std::max(max_abs(box.min), max_abs(box.max)));
    const double expected = dot(support(box, direction), direction);
    const double band = 8 * tolerance::epsilon * size * sum_abs(direction);
    RC_ASSERT(std::fabs(dot(support(oriented(box), direction), direction) - expected) <= band);
  });
}

TEST(Obb, DefaultsToTheUnitBoxUnrotated) {
  EXPECT_EQ((Obb<3>{}.center), (Vec<3, float>(0, 0, 0)));
  EXPECT_EQ((Obb<3>{}.half_extents), (Vec<3, float>(1, 1, 1)));
  EXPECT_EQ((Obb<3>{}.axes), (Mat<3, float>(1.0F)));
}

TEST(Obb, IsMadeFromAnAngle) {
  const Obb<2> box = Obb<2>::from_angle({10, 20}, {3, 4}, std::numbers::pi / 6);
  EXPECT_EQ(box.center, (Vec<2, float>(10, 20)));
  EXPECT_EQ(box.half_extents, (Vec<2, float>(3, 4)));
  EXPECT_FLOAT_EQ(box.axes[0].x, std::sqrt(0.75F));
  EXPECT_FLOAT_EQ(box.axes[0].y, 0.5F);
  EXPECT_FLOAT_EQ(box.axes[1].x, -0.5F);
  EXPECT_FLOAT_EQ(box.axes[1].y, std::sqrt(0.75F));
  EXPECT_THROW((void)Obb<2>::from_angle({0, 0}, {1, 1}, std::numeric_limits<double>::infinity()),
               std::invalid_argument);
}

TEST(Obb, IsMadeFromAnAxisAndAnAngleOrAQuaternion) {
  // A third of a turn about the diagonal: x goes to y, y to z, z to x.
  const Mat<3, double> expected({0, 1, 0}, {0, 0, 1}, {1, 0, 0});
  const double third = 2 * std::numbers::pi / 3;
  const auto about = Obb<3, double>::from_axis_angle({1, 2, 3}, {4, 5, 6}, {7, 7, 7}, third);
  const auto by = Obb<3, double>::from_quaternion({1, 2, 3}, {4, 5, 6}, Vec<4, double>(7, 7, 7, 7));
  for (const Obb<3, double>& box : {about, by}) {
    EXPECT_EQ(box.center, (Vec<3, double>(1, 2, 3)));
    EXPECT_EQ(box.half_extents, (Vec<3, double>(4, 5, 6)));
    for (Dim j = 0; j < 3; ++j) EXPECT_LE(max_abs(Vec<3, double>(box.axes[j] - expected[j])), 1e-15);
  }
  EXPECT_THROW((void)Obb<3>::from_axis_angle({0, 0, 0}, {1, 1, 1}, {0, 0, 0}, 1), std::invalid_argument);
  EXPECT_THROW((void)Obb<3>::from_quaternion({0, 0, 0}, {1, 1, 1}, Vec<4, float>(0.0F)), std::invalid_argument);
}

TEST(Obb, FromAnyAxisAngleAndQuaternionIsOrthonormalToRounding) {
  detail::LinearCongruential random(7);
  const auto between = [&random](double least, double most) {
    return least + (most - least) * static_cast<double>(random.below(1'000'000)) / 1e6;
  };
  for (int i = 0; i < 10000; ++i) {
    const auto number = [&between] { return between(-1, 1) * std::exp2(between(-120, 120)); };
    const double angle = between(-1, 1) * std::exp2(between(-60, 60));
    const Vec<4, float> q(number(), number(), number(), number());
    const double flat = orthonormal_error<2, double>(Obb<2, double>::from_angle({0, 0}, {1, 1}, angle).axes);
    const double about = orthonormal_error<3, double>(
        Obb<3, double>::from_axis_angle({0, 0, 0}, {1, 1, 1}, Vec<3, double>(q), angle).axes);
    const double by = orthonormal_error<3, double>(Obb<3, double>::from_quaternion({0, 0, 0}, {1, 1, 1}, q).axes);
    const double rounded = orthonormal_error<3, float>(Obb<3>::from_quaternion({0, 0, 0}, {1, 1, 1}, q).axes);
    EXPECT_LE(std::max({flat, about, by}), 8 * std::numeric_limits<double>::epsilon()) << angle;
    EXPECT_LE(rounded, 2 * std::numeric_limits<float>::epsilon());
  }
}

TEST(Obb, MeasuresHowFarAxesAreFromOrthonormal) {
  EXPECT_EQ((orthonormal_error<2, double>(Mat<2, double>(1.0))), 0);
  EXPECT_EQ((orthonormal_error<2, double>(Mat<2, double>({2, 0}, {0, 1}))), 3);      // 2 * 2 - 1
  EXPECT_EQ((orthonormal_error<2, double>(Mat<2, double>({1, 0}, {0.5, 1}))), 0.5);  // the angle
  EXPECT_EQ((orthonormal_error<2, double>(Mat<2, double>(0.0))), 1);
  EXPECT_TRUE(std::isnan(orthonormal_error<2, double>(Mat<2, double>(std::numeric_limits<double>::quiet_NaN()))));
}

TEST(Obb, HalfEdgesAreTheAxesTimesTheHalfExtents) {
  const Obb<2, double> box{{9, 9}, {2, 3}, rotation_matrix(90)};
  const Mat<2, double> edges = half_edges(box);
  EXPECT_EQ(edges[0], (Vec<2, double>(0, 2)));
  EXPECT_EQ(edges[1], (Vec<2, double>(-3, 0)));
}

TEST(Obb, HasACornerAsSupport) {
  const Obb<2, double> box{{10, 20}, {5, 10}, Mat<2, double>({0.6, 0.8}, {-0.8, 0.6})};
  // Half edges (3, 4) and (-8, 6).
  EXPECT_EQ(support(box, {1, 0.1}), (Vec<2, double>(21, 18)));
  EXPECT_EQ(support(box, {0, 3}), (Vec<2, double>(5, 30)));
  EXPECT_EQ(support(box, {-1e9, -1}), (Vec<2, double>(-1, 22)));
}

TEST(Obb, TakesTheAxesAsStored) {
  // Off by 2e-5, as floats after many rotations: the set is the one given by the numbers.
  const Obb<2, double> box{{0, 0}, {1, 1}, Mat<2, double>({1.00001, 0}, {0, 1})};
  EXPECT_TRUE(is_valid(box));
  EXPECT_EQ(support(box, {1, 1}), (Vec<2, double>(1.00001, 1)));
}

TEST(Obb, TurnsItsAxes) {
  const Pose<2, double> pose{rotation_matrix(90), {100, 0}};
  const Obb<2, double> moved = transformed(Obb<2, double>{{1, 2}, {3, 4}, rotation_matrix(90)}, pose);
  EXPECT_EQ(moved.center, (Vec<2, double>(98, 1)));
  EXPECT_EQ(moved.half_extents, (Vec<2, double>(3, 4)));
  EXPECT_EQ(moved.axes, (Mat<2, double>({-1, 0}, {0, -1})));
}

TEST(Obb, OrientedAabbOfAnySizeDoesNotOverflow) {
  const double huge = std::numeric_limits<double>::max();
  const Obb<2, double> box = oriented(Aabb<2, double>{{-huge, 0}, {huge, huge}});
  EXPECT_EQ(box.center, (Vec<2, double>(0, huge / 2)));
  EXPECT_EQ(box.half_extents, (Vec<2, double>(huge, huge / 2)));
}

TEST(Obb, ATurnedAabbBecomesOne) {
  const Pose<2, float> pose{Mat<2, float>(rotation_matrix(90)), {0, 1}};
  const Obb<2, float> turned = transformed(Aabb<2, float>{{0, 2}, {6, 4}}, pose);
  EXPECT_EQ(turned.center, (Vec<2, float>(-3, 4)));
  EXPECT_EQ(turned.half_extents, (Vec<2, float>(3, 1)));
  EXPECT_EQ(turned.axes[0], (Vec<2, float>(0, 1)));
  EXPECT_EQ(turned.axes[1], (Vec<2, float>(-1, 0)));
}

}  // namespace
}  // namespace graze::obb_test
