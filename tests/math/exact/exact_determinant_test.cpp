// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include <graze/math/exact/exact_determinant.hpp>
#include <graze/math/orientation_3d.hpp>

#include "exact/numbers.hpp"

namespace graze::detail::whole_determinant_test {
namespace {

using V = Vec<3, double>;
using Points = std::array<V, 3>;

int exact_sign(const Points& points, const V& origin) {
  std::array<test::RationalVec<3>, 3> off{};
  for (std::size_t row = 0; row < 3; ++row) {
    off[row] = test::exact(points[row]);
    for (std::size_t i = 0; i < 3; ++i) off[row][i] -= test::exact(origin)[i];
  }
  test::Rational determinant = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    determinant += off[0][i] * (off[1][j] * off[2][k] - off[1][k] * off[2][j]);
  }
  return determinant.sign();
}

#ifdef GRAZE_HAS_INT128

IntegerPlane plane_of(const Points& points, double unit) {
  return {{IntegerPoint(points[0], unit), IntegerPoint(points[1], unit), IntegerPoint(points[2], unit)}, unit};
}

/// On which side of the plane of three points another one is, in units that fit all four.
std::optional<int> side_of_plane(const Points& points, const V& origin) {
  double largest = max_abs(origin);
  for (const V& point : points) largest = std::max(largest, max_abs(point));
  const double unit = integer_unit(largest);
  const std::optional<double> height = plane_of(points, unit).height_of(IntegerPoint(origin, unit));
  return height ? std::optional<int>(ternary_sign(*height)) : std::nullopt;
}

/// At the limits of 64 bits, where another method takes over.
TEST(Rough, HasTheSignAndAboutTheSizeOfEveryNumber) {
  EXPECT_EQ(rough(0), 0);
  for (int bits = 0; bits < 126; ++bits) {
    for (const int more : {-1, 0, 1}) {
      const Int128 number = (Int128{1} << static_cast<unsigned>(bits)) + more;
      const auto about = static_cast<double>(number);
      EXPECT_NEAR(rough(number), about, about * 0x1p-52) << bits << ' ' << more;
      EXPECT_NEAR(rough(-number), -about, about * 0x1p-52) << bits << ' ' << more;
      EXPECT_EQ(ternary_sign(rough(-number)), number == 0 ? 0 : -1) << bits << ' ' << more;
    }
  }
}

TEST(WholeDeterminant, HasTheSignThatRationalNumbersGive) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto point = [&] { return V(number(random), number(random), number(random)); };
  int counted = 0;
  for (int i = 0; i < 3000; ++i) {
    const double size = std::ldexp(1.0, i % 600 - 298);
    const V o = point() * size;
    const V a = point() * size;
    const V b = point() * size;
    // All kinds of nearly flat ones, also nearly collinear.
    const V c = i % 3 == 0   ? point() * size
                : i % 3 == 1 ? o + (a - o) * number(random) + (b - o) * number(random)
                             : o + (a - o) * number(random);
    const Points points = {a, i % 2 == 0 ? b : o + (a - o) * 0.3, c};
    const std::optional<int> sign = sign_of_exact_determinant(points, o);
    if (!sign) continue;
    ++counted;
    EXPECT_EQ(*sign, exact_sign(points, o)) << i;
    EXPECT_EQ(side_of_plane(points, o), -exact_sign(points, o)) << i;
  }
  EXPECT_GT(counted, 2500);
}

// The largest numbers that fit, where an overflow would change a sign.
TEST(WholeDeterminant, HasRoomForTheLargest) {
  constexpr double most = 0x1.fffffffffffffp60;
  std::mt19937_64 random(5);
  const auto end = [&] { return (random() % 2 == 0 ? most : -most) - (random() % 4 == 0 ? 0x1p20 : 0.0); };
  for (int i = 0; i < 3000; ++i) {
    Points points;
    for (V& point : points) point = V(end(), end(), end());
    const V origin(end(), end(), end());
    const std::optional<int> sign = sign_of_exact_determinant(points, origin);
    ASSERT_TRUE(sign.has_value());
    EXPECT_EQ(*sign, exact_sign(points, origin)) << i;
    EXPECT_EQ(side_of_plane(points, origin), -exact_sign(points, origin)) << i;
  }
}

TEST(IntegerPlane, SaysOfAPointWhatOrientationSays) {
  const Points points{V(0.5, 0.25, 1), V(1, -0.75, 1), V(-0.125, 0.375, 1)};
  const double unit = integer_unit(1);
  const IntegerPlane plane = plane_of(points, unit);
  const auto height = [&](const V& point) { return plane.height_of(IntegerPoint(point, unit)); };
  for (const double z : {0.5, std::nextafter(1.0, 0.0), 1.0}) {
    const V point(0.25, 0.75, z);
    ASSERT_TRUE(height(point));
    EXPECT_EQ(ternary_sign(*height(point)), orientation(points[0], points[1], points[2], point)) << z;
  }
  EXPECT_EQ(height(V(0, 0, 1e-30)), std::nullopt) << "far more bits";
  EXPECT_EQ(height(V(1e30, 0, 0)), std::nullopt) << "far beyond";
  const Points fine{points[0], points[1], V(1.0 / 3, 0, 0x1p-70)};
  EXPECT_EQ(plane_of(fine, unit).height_of(IntegerPoint(points[0], unit)), std::nullopt);
  EXPECT_EQ(plane_of(points, 0).height_of(IntegerPoint(points[0], 0)), std::nullopt);
}

TEST(IntegerPlane, SaysRoughlyHowHighAPointIs) {
  const std::array<V, 3> points = {V(1, 0, 0), V(0, 1, 0), V(0, 0, 1)};
  const double unit = integer_unit(1);
  const IntegerPlane plane = plane_of(points, unit);
  const auto height = [&](double x) { return *plane.height_of(IntegerPoint(V(x, x, x), unit)); };
  const double step = height(1) / 2;  // of x + y + z - 1
  EXPECT_NEAR(height(0.5) / step, 0.5, 1e-12);
  EXPECT_NEAR(height(0.25) / step, -0.25, 1e-12);
  EXPECT_DOUBLE_EQ(height(std::nextafter(1.0 / 3, 1)) / step, 0x1p-53);  // 1 / 3 is rounded down by a third of that
  EXPECT_GT(height(std::nextafter(1.0 / 3, 1)), 0);
  EXPECT_LT(height(1.0 / 3), 0);
}

TEST(WholeDeterminant, IsZeroOnAPlaneAndAHairBesideItIsNot) {
  const V a(0.5, 0.25, 1);
  const V b(1, -0.75, 1);
  const V c(-0.125, 0.375, 1);
  EXPECT_EQ(sign_of_exact_determinant({a, b, c}, V(0.1, 0.2, 1)), 0);
  const int above = *sign_of_exact_determinant({a, b, c}, V(0.1, 0.2, std::nextafter(1, 2)));
  EXPECT_NE(above, 0);
  EXPECT_EQ(sign_of_exact_determinant({a, b, c}, V(0.1, 0.2, std::nextafter(1, 0))), -above);
  EXPECT_EQ(sign_of_exact_determinant({b, a, c}, V(0.1, 0.2, std::nextafter(1, 0))), above);
}

TEST(WholeDeterminant, KnowsWhatItDoesNotKnow) {
  const V a(1, 0, 0);
  const V b(0, 1, 0);
  const V third(1.0 / 3, 1.0 / 3, 1.0 / 3);
  EXPECT_EQ(sign_of_exact_determinant({a, b, third}, V(0.0)), 1);
  EXPECT_EQ(sign_of_exact_determinant({a, b, V(0, 0, 1e-30)}, V(0.0)), std::nullopt) << "far more bits";
  EXPECT_EQ(sign_of_exact_determinant({a, b, third * 0x1p-20}, V(0.0)), std::nullopt);
  EXPECT_EQ(sign_of_exact_determinant({a, b, V(0, 0, 0x1p-40)}, V(0.0)), 1) << "a single bit";
  EXPECT_EQ(sign_of_exact_determinant({V(0.0), V(0.0), V(0.0)}, V(0.0)), std::nullopt);
  EXPECT_EQ(sign_of_exact_determinant({a * 1e95, b * 1e95, third}, V(0.0)), std::nullopt);
}

#endif

}  // namespace
}  // namespace graze::detail::whole_determinant_test
