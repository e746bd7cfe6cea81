// SPDX-License-Identifier: MIT
// Whatever the filter of rays and segments rejects is a miss; it rejects nearly all misses.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include <graze/broad/index/path_filter.hpp>
#include <graze/query/intersects.hpp>

#include "spaces.hpp"

namespace graze::detail::path_filter_test {
namespace {

template <class SpaceType>
class PathFilterOf : public ::testing::Test {
 public:
  static constexpr Dim dimension = SpaceType::dimension;
  using Number = typename SpaceType::scalar;

  Number number(double size) {
    return static_cast<Number>(std::uniform_real_distribution<double>(-size, size)(engine_));
  }

  /// One coordinate in four is zero.
  Vec<dimension, Number> vector(double size) {
    Vec<dimension, Number> v;
    for (Dim i = 0; i < dimension; ++i) v[i] = engine_() % 4 == 0 ? Number(0) : number(size);
    return v;
  }

  template <class Path>
  void check(const Path& path, const Aabb<dimension, Number>& box) {
    const bool is_apart = PathFilter<dimension>(path).part(box, 0);
    const bool is_met = intersects(path, box);
    ASSERT_FALSE(is_apart && is_met);
    met_ += is_met ? 1 : 0;
    apart_ += is_apart ? 1 : 0;
    ++all_;
  }

  std::mt19937 engine_{20261125};
  std::size_t met_ = 0;
  std::size_t apart_ = 0;
  std::size_t all_ = 0;
};

TYPED_TEST_SUITE(PathFilterOf, test::Spaces);

TYPED_TEST(PathFilterOf, PartsNearlyAllThatAreApart) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for (int i = 0; i < 20000; ++i) {
    const T far = i % 3 == 0 ? T(1000) : T(0);
    const Vec<N, T> min = this->vector(2) + far;
    const Aabb<N, T> box{min, min + abs(this->vector(2))};
    const Vec<N, T> start = this->vector(4) + far;
    const Vec<N, T> end = this->vector(3) + far;
    this->check(Segment<N, T>{start, end}, box);
    if (start != end) this->check(Ray<N, T>{start, end - start}, box);
  }
  EXPECT_GT(this->met_, 1000U);
  EXPECT_GT(static_cast<double>(this->apart_), 0.99 * static_cast<double>(this->all_ - this->met_));
}

TYPED_TEST(PathFilterOf, KnowsDirectionsOfAnySizeAndSegmentsOfNone) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  constexpr T least = std::numeric_limits<T>::denorm_min();
  constexpr T most = std::numeric_limits<T>::max();
  const Vec<N, T> along = unit_axis<N, T>(0);
  const Aabb<N, T> box{Vec<N, T>(T(-1)), Vec<N, T>(T(1))};
  for (const T length : {least, T(1e-30), T(1), T(1e30), most}) {
    EXPECT_FALSE(PathFilter<N>(Ray<N, T>{along * T(-3), along * length}).part(box, 0));
    EXPECT_TRUE(PathFilter<N>(Ray<N, T>{along * T(3), along * length}).part(box, 0));
    EXPECT_FALSE(PathFilter<N>(Ray<N, T>{along * T(3), along * length}).part(box, 2.001));
  }
  EXPECT_FALSE((PathFilter<N>(Segment<N, T>{along, along}).part(box, 0)));
  EXPECT_TRUE((PathFilter<N>(Segment<N, T>{along * T(2), along * T(2)}).part(box, 0)));
  EXPECT_FALSE((PathFilter<N>(Segment<N, T>{along * T(2), along * T(2)}).part(box, 1.001)));
  EXPECT_FALSE((PathFilter<N>(Segment<N, T>{along * T(2), along * T(3)}).share_point(box, 0)));
}

/// The box around the end is met, and one slightly beyond it is not; the bounds contain both ends.
TYPED_TEST(PathFilterOf, KnowsWhereTheBeginningOfARayEnds) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  for (int i = 0; i < 2000; ++i) {
    const Ray<N, T> ray{this->vector(i % 3 == 0 ? 1000 : 1), this->vector(2)};
    if (max_abs(ray.direction) < T(0.1)) continue;
    const T t_max = std::fabs(this->number(4)) + T(0.5);
    const RayUntil<N, T> way{ray, t_max};
    const auto place = [&](double t) { return wide<N, T>(ray.origin) + wide<N, T>(ray.direction) * t; };
    const Aabb<N, T> box = bounds(way);
    for (Dim k = 0; k < N; ++k) {
      const double end = place(static_cast<double>(t_max))[k];
      EXPECT_LE(static_cast<double>(box.min[k]), std::min(end, static_cast<double>(ray.origin[k])));
      EXPECT_GE(static_cast<double>(box.max[k]), std::max(end, static_cast<double>(ray.origin[k])));
    }
    const auto around = [](const Vec<N, double>& center) {
      return Aabb<N, T>{Vec<N, T>(center - 0.01), Vec<N, T>(center + 0.01)};
    };
    EXPECT_FALSE(PathFilter<N>(way).part(around(place(static_cast<double>(t_max))), 0));
    EXPECT_TRUE(PathFilter<N>(way).part(around(place(static_cast<double>(t_max) + 1)), 0));
  }
}

TYPED_TEST(PathFilterOf, SaysNothingOfInfiniteBoxes) {
  constexpr Dim N = TypeParam::dimension;
  using T = typename TypeParam::scalar;
  constexpr T infinity = std::numeric_limits<T>::infinity();
  const Vec<N, T> along = unit_axis<N, T>(0);
  for (Dim i = 0; i < N; ++i) {
    Aabb<N, T> box{Vec<N, T>(T(5)), Vec<N, T>(T(6))};
    box.max[i] = infinity;
    EXPECT_FALSE(PathFilter<N>(Ray<N, T>{along, along}).part(box, 0));
    EXPECT_FALSE((PathFilter<N>(Segment<N, T>{along, along * T(2)}).part(box, 0)));
  }
}

}  // namespace
}  // namespace graze::detail::path_filter_test
