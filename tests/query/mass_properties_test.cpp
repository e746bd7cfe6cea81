// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/mass_properties.hpp>
#include <graze/query/transformed.hpp>

#include "catalogue.hpp"
#include "query/user_shapes.hpp"

namespace graze::mass_properties_test {
namespace {

constexpr double pi = std::numbers::pi;

void expect_near(const MassProperties<2>& is, double area, const Vec<2, double>& centroid, double inertia) {
  EXPECT_NEAR(is.volume, area, 1e-12 * area);
  EXPECT_NEAR(is.centroid.x, centroid.x, 1e-12);
  EXPECT_NEAR(is.centroid.y, centroid.y, 1e-12);
  EXPECT_NEAR(is.inertia, inertia, 1e-12 * inertia);
}

void expect_near(const MassProperties<3>& is, double volume, const Vec<3, double>& centroid,
                 const Mat<3, double>& inertia) {
  EXPECT_NEAR(is.volume, volume, 1e-12 * volume);
  for (Dim i = 0; i < 3; ++i) {
    EXPECT_NEAR(is.centroid[i], centroid[i], 1e-12);
    for (Dim k = 0; k < 3; ++k) EXPECT_NEAR(is.inertia[i][k], inertia[i][k], 1e-12 * (inertia[0][0] + inertia[1][1]));
  }
}

Mat<3, double> diagonal(double x, double y, double z) {
  return {Vec<3, double>(x, 0, 0), Vec<3, double>(0, y, 0), Vec<3, double>(0, 0, z)};
}

TEST(MassProperties, OfRoundShapesAreThoseOfTables) {
  expect_near(mass_properties(Circle<double>{{1, 2}, 3}), 9 * pi, {1, 2}, 0.5 * 9 * pi * 9);
  const double sphere = 4.0 / 3 * pi * 8;
  expect_near(mass_properties(Sphere<3, double>{{1, 2, 3}, 2}), sphere, {1, 2, 3},
              diagonal(0.4 * sphere * 4, 0.4 * sphere * 4, 0.4 * sphere * 4));
}

TEST(MassProperties, OfBoxesAreThoseOfTables) {
  expect_near(mass_properties(Aabb<2, double>{{1, 1}, {3, 5}}), 8, {2, 3}, 8 * (4 + 16) / 12.0);
  expect_near(mass_properties(Aabb<3, double>{{0, 0, 0}, {1, 2, 3}}), 6, {0.5, 1, 1.5},
              diagonal(6 * 13 / 12.0, 6 * 10 / 12.0, 6 * 5 / 12.0));
  const Mat<3, double> quarter_turn{Vec<3, double>(0, 1, 0), Vec<3, double>(-1, 0, 0), Vec<3, double>(0, 0, 1)};
  expect_near(mass_properties(Obb<3, double>{{5, 6, 7}, {0.5, 1, 1.5}, quarter_turn}), 6, {5, 6, 7},
              diagonal(6 * 10 / 12.0, 6 * 13 / 12.0, 6 * 5 / 12.0));
}

/// Slices of a capsule from (0, 0, -h) to (0, 0, h), by Simpson's rule: area, and the moments of x^2 and z^2.
template <Dim N>
std::array<double, 3> sliced_capsule(double half_length, double radius) {
  constexpr int slices = 200'000;
  std::array<double, 3> sums{};
  const double end = half_length + radius;
  for (int i = 0; i <= slices; ++i) {
    const double z = -end + 2 * end * i / slices;
    const double beyond = std::fmax(0, std::fabs(z) - half_length);
    const double width_squared = std::fmax(0, radius * radius - beyond * beyond);
    const double width = std::sqrt(width_squared);
    const double area = N == 2 ? 2 * width : pi * width_squared;
    const double square = N == 2 ? area * width_squared / 3 : area * width_squared / 4;
    const double weight = (i == 0 || i == slices ? 1 : i % 2 == 1 ? 4 : 2) * (2 * end / slices) / 3;
    sums[0] += weight * area;
    sums[1] += weight * square;
    sums[2] += weight * area * z * z;
  }
  return sums;
}

TEST(MassProperties, OfACapsuleAreThoseOfItsSlices) {
  const auto [volume, square, along] = sliced_capsule<3>(1.5, 0.8);
  const MassProperties<3> capsule = mass_properties(Capsule<3, double>{{1, 1, 0.5}, {1, 1, 3.5}, 0.8});
  EXPECT_NEAR(capsule.volume, volume, 1e-6);
  EXPECT_EQ(capsule.centroid, (Vec<3, double>{1, 1, 2}));
  EXPECT_NEAR(capsule.inertia[0][0], square + along, 1e-6);
  EXPECT_NEAR(capsule.inertia[1][1], square + along, 1e-6);
  EXPECT_NEAR(capsule.inertia[2][2], 2 * square, 1e-6);
  const auto [area, flat_square, flat_along] = sliced_capsule<2>(1.5, 0.8);
  const MassProperties<2> flat = mass_properties(Capsule<2, double>{{0, -1.5}, {0, 1.5}, 0.8});
  EXPECT_NEAR(flat.volume, area, 1e-5);
  EXPECT_NEAR(flat.inertia, flat_square + flat_along, 1e-5);
}

TEST(MassProperties, OfACapsuleWithoutLengthAreThoseOfABall) {
  const MassProperties<3> sphere = mass_properties(Sphere<3, double>{{1, 2, 3}, 2});
  expect_near(mass_properties(Capsule<3, double>{{1, 2, 3}, {1, 2, 3}, 2}), sphere.volume, sphere.centroid,
              sphere.inertia);
}

TEST(MassProperties, OfATriangleDoNotDependOnItsTurn) {
  const double area = 6;
  const double inertia = area / 36 * (16 + 9 + 25);  // of the squares of the sides
  expect_near(mass_properties(Triangle<2, double>{{0, 0}, {4, 0}, {0, 3}}), area, {4 / 3.0, 1}, inertia);
  expect_near(mass_properties(Triangle<2, double>{{0, 0}, {0, 3}, {4, 0}}), area, {4 / 3.0, 1}, inertia);
}

TEST(MassProperties, OfWhatHasNoVolumeAreItsMiddle) {
  EXPECT_EQ(mass_properties(Vec<3, double>{1, 2, 3}).centroid, (Vec<3, double>{1, 2, 3}));
  EXPECT_EQ(mass_properties(Segment<2, double>{{0, 0}, {2, 4}}).centroid, (Vec<2, double>{1, 2}));
  const MassProperties<3> triangle = mass_properties(Triangle<3, double>{{0, 0, 0}, {3, 0, 0}, {0, 3, 3}});
  EXPECT_EQ(triangle.volume, 0);
  EXPECT_EQ(triangle.centroid, (Vec<3, double>{1, 1, 1}));
  const std::vector<Vec<3, double>> square{{0, 0, 1}, {2, 0, 1}, {0, 2, 1}, {2, 2, 1}};
  const MassProperties<3> flat = mass_properties(convex_hull<3, double>(square));
  EXPECT_EQ(flat.volume, 0);
  EXPECT_EQ(flat.centroid, (Vec<3, double>{1, 1, 1}));
  EXPECT_EQ(flat.inertia, diagonal(0, 0, 0));
}

TEST(MassProperties, OfWhatHasNoEndHaveNoCentroid) {
  EXPECT_EQ(mass_properties(HalfSpace<3, double>{{0, 0, 1}, 2}).volume, std::numeric_limits<double>::infinity());
  EXPECT_EQ(mass_properties(Plane<2, float>{{0, 1}, 2}).volume, 0);
  EXPECT_TRUE(std::isnan(mass_properties(Ray<2, float>{{0, 1}, {2, 1}}).centroid.x));
  EXPECT_TRUE(std::isnan(mass_properties(Compound<3, float>{}).centroid.x));
}

TEST(MassProperties, OfVolumesBeyondFloatAreNumbers) {
  EXPECT_NEAR(mass_properties(Sphere<3>{{0, 0, 0}, 1e15F}).volume, 4 * pi / 3 * 1e45, 1e39);
}

TEST(MassProperties, OfACompoundAreTheSumOfItsParts) {
  const Compound<3, double> halves = compound_of<3, double>(
      {Aabb<3, double>{{0, 0, 0}, {1, 1, 3}}, Obb<3, double>{{0.5, 1.5, 1.5}, {0.5, 0.5, 1.5}, Mat<3, double>(1.0)}});
  const MassProperties<3> whole = mass_properties(Aabb<3, double>{{0, 0, 0}, {1, 2, 3}});
  expect_near(mass_properties(halves), whole.volume, whole.centroid, whole.inertia);
  const Compound<2, double> points = compound_of<2, double>({Vec<2, double>{0, 0}, Vec<2, double>{2, 4}});
  EXPECT_EQ(mass_properties(points).centroid, (Vec<2, double>{1, 2}));
}

/// Equal up to a share of the values of a box as large as the shape, or as far from the origin.
template <Dim N>
void expect_close(const MassProperties<N>& a, const MassProperties<N>& b, double size, double error) {
  const double volume = std::pow(size, N);
  RC_ASSERT(std::fabs(a.volume - b.volume) <= error * volume);
  for (Dim i = 0; i < N; ++i) {
    RC_ASSERT(std::fabs(a.centroid[i] - b.centroid[i]) * a.volume <= error * volume * size);
  }
  const Inertia<N> off = a.inertia - b.inertia;
  if constexpr (N == 2) {
    RC_ASSERT(std::fabs(off) <= error * volume * size * size);
  } else {
    for (Dim i = 0; i < N; ++i) RC_ASSERT((max_abs<N, double>(off[i]) <= error * volume * size * size));
  }
}

template <Dim N, class T>
double size_of(const Aabb<N, T>& box) {
  return 2 * static_cast<double>(std::max(max_abs<N, T>(box.min), max_abs<N, T>(box.max)));
}

template <class Space>
class MassPropertiesIn : public testing::Test {};
TYPED_TEST_SUITE(MassPropertiesIn, test::Spaces);

// A box is also the hull of its corners, and of these and any points inside.
TYPED_TEST(MassPropertiesIn, OfABoxAreThoseOfItsCornersHull) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  test::check_property([] {
    const auto box = *test::any<Aabb<N, T>>();
    std::vector<Vec<N, T>> points;
    for (int corner = 0; corner < 1 << N; ++corner) {
      Vec<N, T> point;
      for (Dim i = 0; i < N; ++i) point[i] = (corner >> i & 1) != 0 ? box.max[i] : box.min[i];
      points.push_back(point);
    }
    points.push_back(Vec<N, T>(0.5 * wide<N, T>(box.min) + 0.5 * wide<N, T>(box.max)));
    expect_close(mass_properties(box), mass_properties(convex_hull<N, T>(points)), size_of(box), 1e-14);
  });
}

template <Dim N>
MassProperties<N> turned(const MassProperties<N>& properties, const Pose<N, double>& pose) {
  MassProperties<N> result = properties;
  result.centroid = transformed(properties.centroid, pose);
  if constexpr (N == 3) {
    const Mat<3, double> back = transpose(pose.rotation);
    result.inertia = pose.rotation * properties.inertia * back;
  }
  return result;
}

template <Dim N>
void expect_turned_with_shape() {
  const auto shape = *test::any_shape<N, double>();
  const Pose<N, double> pose{*test::any_rotation<N, double>(), *test::any<Vec<N, double>>()};
  const AnyShape<N, double> moved = transformed(shape, pose);
  const Aabb<N, double> box = bounds(shape);
  const Aabb<N, double> moved_box = bounds(moved);
  const double size = std::max(size_of(box), size_of(moved_box));
  RC_PRE(std::isfinite(size));                                    // so it is bounded
  if (!std::isfinite(mass_properties(shape).centroid.x)) return;  // an empty compound
  expect_close(turned(mass_properties(shape), pose), mass_properties(moved), size, 1e-12);
}

template <class S>
concept HasMassProperties = requires(const S& shape) {
  mass_properties(shape);
};
static_assert(HasMassProperties<Posed<Polytope<2, float>>> && HasMassProperties<Compound<3, float>>);
static_assert(!HasMassProperties<user::Ellipsoid<double>> && !HasMassProperties<Posed<user::Ellipsoid<double>>>);

template <class S>
void expect_posed_as_transformed() {
  constexpr Dim N = dimension_of<S>;
  using T = scalar_of<S>;
  test::check_property([] {
    const S shape = *test::any<S>();
    const Pose<N, T> pose{*test::any_rotation<N, T>(), *test::any<Vec<N, T>>()};
    const S moved = transformed(shape, pose);
    const double size = std::max(size_of(bounds(shape)), size_of(bounds(moved)));
    const double error = 64 * static_cast<double>(std::numeric_limits<T>::epsilon());
    expect_close(mass_properties(Posed<S>{shape, pose}), mass_properties(moved), size, error);
  });
}

TEST(MassProperties, SeenThroughAPoseAreThoseOfTheTransformedShape) {
  expect_posed_as_transformed<Obb<3, double>>();
  expect_posed_as_transformed<Capsule<3, float>>();
  expect_posed_as_transformed<Polytope<3, double>>();
  expect_posed_as_transformed<Polytope<2, float>>();
  expect_posed_as_transformed<Triangle<2, double>>();
}

TEST(MassProperties, MoveWithTheShape) {
  test::check_property([] { expect_turned_with_shape<2>(); });
  test::check_property([] { expect_turned_with_shape<3>(); });
}

}  // namespace
}  // namespace graze::mass_properties_test
