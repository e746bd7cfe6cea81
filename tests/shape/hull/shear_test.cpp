// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/math/tolerance.hpp>
#include <graze/shape/hull/frame.hpp>
#include <graze/shape/hull/shear.hpp>

#include "catalogue.hpp"
#include "exact/numbers.hpp"
#include "query/point_sets.hpp"
#include "shape/thin_clouds.hpp"

namespace graze::detail::hull_shear_test {
namespace {

template <class T>
std::vector<Vec<3, double>> places_of(const std::vector<Vec<3, T>>& points) {
  return HullShear<T>(std::span<const Vec<3, T>>(points)).places();
}

/// The indices of four points in turn.
template <class T>
std::array<std::uint32_t, 4> four_of(const std::vector<Vec<3, T>>& points, std::size_t i) {
  const auto index = [&](std::size_t k) { return static_cast<std::uint32_t>((7 * i + k) % points.size()); };
  return {index(0), index(11), index(29), index(67)};
}

/// How many sides of planes through three points are uncertain in double in a frame.
template <class T>
std::size_t count_in_doubt(const HullFrame<T>& frame, const std::vector<Vec<3, T>>& points) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [a, b, c, d] = four_of(points, i);
    const HullPlane plane = frame.plane(frame.at(a), frame.at(b), frame.at(c));
    count += std::fabs(plane.height(frame.at(d).place)) <= plane.doubt ? 1U : 0U;
  }
  return count;
}

TEST(HullShear, TakesWhatIsOnALineOfItsLongestAxisOut) {
  const std::vector<Vec<3, double>> points{{1, 1, 1}, {5, 3, 0}, {3, 2, 0.5}, {3, 2.125, 0.5}, {3, 2, 0.53125}};
  const auto places = places_of(points);
  EXPECT_EQ(places[0], (Vec<3, double>(0)));
  EXPECT_EQ(places[1], (Vec<3, double>(0.5, 0, 0)));
  EXPECT_EQ(places[2], (Vec<3, double>(0.25, 0, 0)));
  EXPECT_EQ(places[3], (Vec<3, double>(0.25, 0.5, 0)));
  EXPECT_EQ(places[4], (Vec<3, double>(0.25, 0, 0.5)));
}

TEST(HullShear, LeavesNothingOfWhatIsExactlyOnALineOrAtOnePlace) {
  for (const Vec<3, double>& place : places_of(std::vector<Vec<3, float>>{{1, 2, 3}, {3, 4, 2}, {2, 3, 2.5}})) {
    EXPECT_EQ(place.y, 0);
    EXPECT_EQ(place.z, 0);
  }
  for (const Vec<3, double>& place : places_of(std::vector<Vec<3, float>>(3, {1, 2, 3})))
    EXPECT_EQ(place, (Vec<3, double>(0)));
}

TEST(HullShear, ShowsWhatRoundingHides) {
  const auto points = test::thin_crowd<double>(test::ThinCloud::lines, 4, 1);
  std::vector<Vec<3, double>> needle;
  for (std::size_t i = 0; i < 2000; ++i) {
    needle.push_back(points[0] + (points[1] - points[0]) * (static_cast<double>(i * i % 1999) / 1999));
  }
  EXPECT_GT(count_in_doubt(HullFrame<double>(needle), needle), 1900U);
  EXPECT_LT(count_in_doubt(HullFrame<double>::sheared(needle), needle), 20U);
}

template <class T>
class HullShearIn : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(HullShearIn, Scalars);

/// Heights above planes in a sheared frame have the right sign if they are certain.
template <class T>
void expect_right_planes(const std::vector<Vec<3, T>>& points) {
  const HullFrame<T> frame = HullFrame<T>::sheared(points);
  for (std::size_t i = 0; i < std::min<std::size_t>(points.size(), 200); ++i) {
    const auto [a, b, c, d] = four_of(points, i);
    RC_ASSERT(max_abs(frame.at(d).place) <= 1);
    const HullPlane plane = frame.plane(frame.at(a), frame.at(b), frame.at(c));
    const double height = plane.height(frame.at(d).place);
    const int side = frame.orientation_of({a, b, c}, d);
    if (height > plane.doubt) RC_ASSERT(side == 1);
    if (height < -plane.doubt) RC_ASSERT(side == -1);
  }
}

TYPED_TEST(HullShearIn, KeepsSidesOfPlanes) {
  using T = TypeParam;
  test::check_property([] {
    const auto cluster = static_cast<test::ThinCloud>(*test::choice(test::thin_clouds));
    expect_right_planes(test::thin_crowd<T>(cluster, 1 + *test::choice(600), *test::choice(1U << 30U)));
    const std::vector<Vec<3, T>> points = test::draw_points<3, T>(12);
    const HullFrame<T> in_range(points);
    std::vector<Vec<3, T>> moderate;
    for (std::uint32_t i = 0; i < in_range.size(); ++i) moderate.push_back(in_range.point(i));
    expect_right_planes(moderate);
  });
}

// An affine map preserves the ratio of the volumes of any two tetrahedra.
TYPED_TEST(HullShearIn, IsExactUpToItsTolerance) {
  using T = TypeParam;
  test::check_property([] {
    const auto cluster = static_cast<test::ThinCloud>(*test::choice(test::thin_clouds));
    const std::vector<Vec<3, T>> points = test::thin_crowd<T>(cluster, 40, *test::choice(1U << 30U));
    const std::vector<Vec<3, double>> places = places_of(points);
    const auto volume = [](const auto& list, const std::array<std::uint32_t, 4>& four) {
      std::array<std::array<test::Rational, 3>, 3> rows;
      for (std::size_t row = 0; row < 3; ++row) {
        for (Dim i = 0; i < 3; ++i) {
          rows[row][static_cast<std::size_t>(i)] =
              test::Rational(list[four[row]][i]) - test::Rational(list[four[3]][i]);
        }
      }
      const auto& [a, b, c] = rows;
      return test::Rational(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                            a[2] * (b[0] * c[1] - b[1] * c[0]));
    };
    test::Rational largest = 0;
    std::array<std::uint32_t, 4> base{};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const test::Rational size = abs(volume(places, four_of(points, i)));
      if (size <= largest) continue;
      largest = size;
      base = four_of(points, i);
    }
    // Flat points, or points whose units are affected by rounding, have no such base.
    if (largest < test::Rational(0x1p-10)) return;
    const test::Rational scale = volume(points, base) / volume(places, base);
    RC_ASSERT(scale > 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const test::Rational off = volume(points, four_of(points, i)) / scale - volume(places, four_of(points, i));
      RC_ASSERT(abs(off) < test::Rational(0x1p20 * tolerance::hull_shear));
    }
  });
}

}  // namespace
}  // namespace graze::detail::hull_shear_test
