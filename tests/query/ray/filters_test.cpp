// SPDX-License-Identifier: MIT
// The filter for a ray and a shape of any type agrees with the general method: the same hits, at points that differ by
// at most the sum of both errors; and it decides nearly all ordinary rays. The tests of the filters for 3D boxes and
// triangles check that the results are bit-identical.
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

#include <graze/math/pose.hpp>
#include <graze/query/intersects.hpp>
#include <graze/query/ray_cast.hpp>
#include <graze/query/relation.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail::ray_filters_test {
namespace {

struct Counts {
  std::size_t missed = 0;
  std::size_t hit = 0;
  std::size_t unclear = 0;
};

class Random {
 public:
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }

  template <Dim N>
  Vec<N, double> vector(double size) {
    Vec<N, double> v(0.0);
    for (Dim i = 0; i < N; ++i) v[i] = number(-size, size);
    return v;
  }

  template <std::size_t count>
  double one_of(const std::array<double, count>& numbers) {
    return numbers[std::uniform_int_distribution<std::size_t>(0, count - 1)(engine_)];
  }

  template <Dim N>
  Vec<N, double> point_of(const std::array<double, 8>& numbers) {
    Vec<N, double> v(0.0);
    for (Dim i = 0; i < N; ++i) v[i] = one_of(numbers);
    return v;
  }

 private:
  std::mt19937 engine_{20261126};
};

/// A source of numbers: ordinary ones about a center, or few that coincide.
struct Usual {
  Random& random;
  double unit = 1;
  template <Dim N>
  Vec<N, double> point() {
    return random.vector<N>(unit);
  }
  template <Dim N>
  Vec<N, double> edge() {
    return random.vector<N>(1);
  }
  double size() { return random.number(0.2, 1) * unit; }
  template <Dim N>
  Mat<N, double> axes() {
    if constexpr (N == 2) {
      return rotation_matrix(random.number(0, 360));
    } else {
      return rotation_matrix(random.vector<3>(1) + Vec<3, double>(0.01), random.number(0, 360));
    }
  }
};

struct Nasty {
  Random& random;
  static constexpr std::array<double, 8> places{-1, 0, 1, 2, 1 - 0x1p-18, 1 + 0x1p-23, -1 - 0x1p-23, 0x1p-30};
  static constexpr std::array<double, 8> sizes{0, 1, 1, 2, 2, 0x1p-20, 0x1p-30, 3};
  template <Dim N>
  Vec<N, double> point() {
    return random.point_of<N>(places);
  }
  template <Dim N>
  Vec<N, double> edge() {
    Vec<N, double> v = point<N>();
    while (max_abs(v) == 0) v = point<N>();
    return v;
  }
  double size() { return random.one_of(sizes); }
  /// Along the coordinate axes, or by 3 : 4 : 5; sometimes mirrored, and not quite perpendicular.
  template <Dim N>
  Mat<N, double> axes() {
    Mat<N, double> m(1.0);
    if (random.number(0, 1) < 0.5) {
      m[0][0] = 0.6;
      m[0][1] = 0.8;
      m[1][0] = -0.8;
      m[1][1] = 0.6;
    }
    if (random.number(0, 1) < 0.3) m[N - 1] = -m[N - 1];
    if (random.number(0, 1) < 0.3) m[0][1] += 4e-5;
    return m;
  }
};

template <class From, Dim N, class T>
void draw(From& from, const Vec<N, double>& center, Sphere<N, T>& sphere) {
  sphere = {Vec<N, T>(center + from.template point<N>()), static_cast<T>(from.size())};
}
template <class From, Dim N, class T>
void draw(From& from, const Vec<N, double>& center, Capsule<N, T>& capsule) {
  capsule = {Vec<N, T>(center + from.template point<N>()), Vec<N, T>(center + from.template point<N>()),
             static_cast<T>(from.size())};
}
template <class From, Dim N, class T>
void draw(From& from, const Vec<N, double>& center, Aabb<N, T>& box) {
  const Vec<N, T> min(center + from.template point<N>());
  box = {min, min};
  for (Dim i = 0; i < N; ++i) box.max[i] += static_cast<T>(from.size());
}
template <class From, Dim N, class T>
void draw(From& from, const Vec<N, double>& center, Obb<N, T>& box) {
  box.center = Vec<N, T>(center + from.template point<N>());
  const Mat<N, double> axes = from.template axes<N>();
  for (Dim i = 0; i < N; ++i) {
    box.half_extents[i] = static_cast<T>(from.size());
    box.axes[i] = Vec<N, T>(axes[i]);
  }
}
template <class From, Dim N, class T>
void draw(From& from, const Vec<N, double>& center, Plane<N, T>& plane) {
  plane.normal = Vec<N, T>(from.template edge<N>());
  plane.offset = static_cast<T>(dot(wide<N, T>(plane.normal), center + from.template point<N>()));
}
template <class From, Dim N, class T>
void draw(From& from, const Vec<N, double>& center, HalfSpace<N, T>& solid) {
  Plane<N, T> plane;
  draw(from, center, plane);
  solid = {plane.normal, plane.offset};
}
template <class From, Dim N, class T>
void draw(From& from, const Vec<N, double>& center, Segment<N, T>& segment) {
  segment = {Vec<N, T>(center + from.template point<N>()), Vec<N, T>(center + from.template point<N>())};
}
template <class From, Dim N, class T>
void draw(From& from, const Vec<N, double>& center, Triangle<N, T>& triangle) {
  for (Vec<N, T>* corner : {&triangle.a, &triangle.b, &triangle.c}) {
    *corner = Vec<N, T>(center + from.template point<N>());
  }
}
template <class From, Dim N, class T>
void draw(From& from, const Vec<N, double>& center, Polytope<N, T>& polygon) {
  std::vector<Vec<N, T>> points(static_cast<std::size_t>(from.random.number(3, 70)));
  for (Vec<N, T>& point : points) point = Vec<N, T>(center + from.template point<N>());
  polygon = convex_hull<N, T>(points);
}

template <class S>
class RayFilters : public ::testing::Test {
 public:
  static constexpr Dim dimension = dimension_of<S>;
  using Number = scalar_of<S>;
  using Hit = std::optional<RayHit<dimension, Number>>;
  static constexpr Number infinity = std::numeric_limits<Number>::infinity();
  static constexpr double epsilon = static_cast<double>(std::numeric_limits<Number>::epsilon());

  template <class U>
  static void add_numbers(std::ostream& out, const U& value) {
    if constexpr (is_a<Polytope, U>) {
      for (const auto& corner : value.vertices()) add_numbers(out, corner);
    } else {
      const auto* numbers = reinterpret_cast<const Number*>(&value);
      for (std::size_t i = 0; i < sizeof(value) / sizeof(Number); ++i) out << numbers[i] << ", ";
    }
  }

  static std::string described(const S& shape, const Ray<dimension, Number>& ray) {
    std::ostringstream out;
    out.precision(17);
    add_numbers(out, shape);
    add_numbers(out << "; ", ray);
    return out.str();
  }

  static void expect_same(const S& shape, const Ray<dimension, Number>& ray, Number t_max, Counts& counts) {
    if (!is_valid(shape) || !is_valid(ray)) return;
    const auto speed = static_cast<double>(max_abs(ray.direction));
    if (speed > 1e-140 && speed < 1e140) {  // where `relation` squares it
      const bool is_met = relation(shape, ray) != Relation::apart;
      ASSERT_EQ(intersects(shape, ray), is_met) << described(shape, ray);
      ASSERT_EQ(intersects(ray, shape), is_met) << described(shape, ray);
    }
    const auto filter = quick_cast(shape, ray, t_max);
    if (filter.verdict() == RayVerdict::unclear) {
      ++counts.unclear;
      return;
    }
    const Hit careful = cast_ray(shape, ray, t_max, RaySide::entry);
    ASSERT_EQ(filter.verdict() == RayVerdict::hits, careful.has_value()) << described(shape, ray) << t_max;
    ++(careful ? counts.hit : counts.missed);
    if (!careful) return;
    const RayHit<dimension, Number> hit = *filter.hit();
    ASSERT_TRUE(hit.t >= Number(0) && hit.t <= t_max) << hit.t << " of " << t_max;
    const Vec<dimension, double> normal = wide<dimension, Number>(hit.normal);
    ASSERT_NEAR(dot(normal, normal), 1, 4 * epsilon);
    const Vec<dimension, double> direction =
        wide<dimension, Number>(ray.direction) / static_cast<double>(max_abs(ray.direction));
    ASSERT_LE(dot(normal, direction), 8 * epsilon);
    if (!is_finite(careful->point)) {
      ASSERT_FALSE(is_finite(hit.point));
      return;
    }
    // A grazing ray's point may be anywhere along it where that is as close to the surface as the error says.
    const Vec<dimension, double> apart = wide<dimension, Number>(hit.point) - wide<dimension, Number>(careful->point);
    const double roundings = 4 * epsilon * static_cast<double>(max_abs(hit.point) + max_abs(ray.origin));
    ASSERT_LE(std::fabs(dot(apart, normal)), hit.error + careful->error + roundings);
    const auto is_minus_zero = [](Number number) { return number == Number(0) && std::signbit(number); };
    for (Dim i = 0; i < dimension; ++i) ASSERT_FALSE(is_minus_zero(hit.point[i]) || is_minus_zero(hit.normal[i]));
  }
};

using Shapes = ::testing::Types<
    Plane<2, float>, Plane<2, double>, Plane<3, float>, Plane<3, double>, HalfSpace<2, float>, HalfSpace<2, double>,
    HalfSpace<3, float>, HalfSpace<3, double>, Sphere<2, float>, Sphere<2, double>, Sphere<3, float>, Sphere<3, double>,
    Capsule<2, float>, Capsule<2, double>, Capsule<3, float>, Capsule<3, double>, Aabb<2, float>, Aabb<2, double>,
    Aabb<3, double>, Obb<2, float>, Obb<2, double>, Obb<3, float>, Obb<3, double>, Segment<2, float>,
    Segment<2, double>, Triangle<2, float>, Triangle<2, double>, Polytope<2, float>, Polytope<2, double>>;
TYPED_TEST_SUITE(RayFilters, Shapes);

TYPED_TEST(RayFilters, SettleUsualRaysAsTheCarefulWayDoes) {
  constexpr Dim N = TestFixture::dimension;
  using T = typename TestFixture::Number;
  Random random;
  Usual from{random, 1};
  Counts counts;
  for (int i = 0; i < 20000; ++i) {
    const Vec<N, double> center = random.vector<N>(i % 3 == 0 ? 1000 : 1);
    TypeParam shape;
    draw(from, center, shape);
    Vec<N, double> way = random.vector<N>(1);
    while (max_abs(way) < 0.5) way = random.vector<N>(1);
    const Vec<N, T> origin(center + way * 8.0);
    const Ray<N, T> ray{origin, Vec<N, T>(center + random.vector<N>(1.2) - wide<N, T>(origin))};
    const T t_max = i % 2 == 0 ? TestFixture::infinity : static_cast<T>(random.number(0, 2));
    ASSERT_NO_FATAL_FAILURE(TestFixture::expect_same(shape, ray, t_max, counts));
  }
  EXPECT_GT(counts.missed, 2000U);
  EXPECT_GT(counts.hit, 1000U);
  const bool begins_inside_often = is_a<HalfSpace, TypeParam>;
  EXPECT_LT(counts.unclear, begins_inside_often ? 11000U : 800U);
}

/// Rays along axes and sides, at edges and corners, from the shape's surface, at flat shapes, with zero or tiny slopes.
TYPED_TEST(RayFilters, SayNothingElseOfTheNasty) {
  constexpr Dim N = TestFixture::dimension;
  using T = typename TestFixture::Number;
  Random random;
  Nasty from{random};
  Counts counts;
  const std::array<double, 8> slopes{0, -0.0, 1, -1, 0.5, -0x1p-70, 0x1p-130, -0x1p-20};
  const std::array<double, 8> ends{0, 1, 2, std::numeric_limits<double>::infinity(), 0.5, 0x1p-149, 1 + 0x1p-20, 4};
  for (int i = 0; i < 40000; ++i) {
    TypeParam shape;
    draw(from, Vec<N, double>(0.0), shape);
    Ray<N, T> ray{Vec<N, T>(from.template point<N>() * 2.0), Vec<N, T>(random.point_of<N>(slopes))};
    if (i % 2 == 0) ray.direction = Vec<N, T>(from.template point<N>()) - ray.origin;
    ASSERT_NO_FATAL_FAILURE(TestFixture::expect_same(shape, ray, static_cast<T>(random.one_of(ends)), counts));
  }
  EXPECT_GT(counts.missed, 1000U);
  EXPECT_GT(counts.hit, 100U);
}

/// Shapes so small or large, and rays so slow or fast, that products underflow or overflow.
TYPED_TEST(RayFilters, SayNothingElseAtTheEndsOfTheRange) {
  constexpr Dim N = TestFixture::dimension;
  using T = typename TestFixture::Number;
  constexpr bool is_float = std::is_same_v<T, float>;
  Random random;
  Counts counts;
  const std::array<double, 8> units{1,
                                    0x1p-30,
                                    is_float ? 0x1p-90 : 0x1p-300,
                                    is_float ? 0x1p-126 : 0x1p-440,
                                    is_float ? 0x1p-140 : 0x1p-460,
                                    0x1p60,
                                    is_float ? 0x1p99 : 0x1p300,
                                    is_float ? 0x1p120 : 0x1p440};
  const std::array<double, 8> speeds{
      1, 1, 0x1p-90, is_float ? 0x1p-120 : 0x1p-900, 0x1p60, is_float ? 0x1p100 : 0x1p900, 0x1p-30, 0x1p30};
  for (int i = 0; i < 40000; ++i) {
    const double unit = random.one_of(units);
    const double speed = random.one_of(speeds);
    Usual from{random, unit};
    TypeParam shape;
    draw(from, Vec<N, double>(0.0), shape);
    const Vec<N, double> origin = random.vector<N>(4);
    const Vec<N, double> aim = random.vector<N>(1) - origin;
    const Ray<N, T> ray{Vec<N, T>(origin * unit), Vec<N, T>(aim * speed)};
    const T t_max = i % 2 == 0 ? TestFixture::infinity : static_cast<T>(random.number(0, 2) * (unit / speed));
    ASSERT_NO_FATAL_FAILURE(TestFixture::expect_same(shape, ray, t_max, counts));
  }
  EXPECT_GT(counts.missed, 2000U);
  EXPECT_GT(counts.hit, 500U);
}

TYPED_TEST(RayFilters, LeaveOpenWhatIsNoNumber) {
  constexpr Dim N = TestFixture::dimension;
  using T = typename TestFixture::Number;
  constexpr T nan = std::numeric_limits<T>::quiet_NaN();
  Random random;
  Usual from{random, 1};
  TypeParam shape;
  draw(from, Vec<N, double>(0.0), shape);
  for (Dim i = 0; i < N; ++i) {
    Ray<N, T> ray{Vec<N, T>(T(4)), Vec<N, T>(T(-1))};
    EXPECT_NE(quick_cast(shape, ray, nan).verdict(), RayVerdict::hits);
    EXPECT_NE(quick_cast(shape, ray, T(-1)).verdict(), RayVerdict::hits);
    Ray<N, T> wrong = ray;
    wrong.origin[i] = nan;
    EXPECT_EQ(quick_cast(shape, wrong, TestFixture::infinity).verdict(), RayVerdict::unclear);
    wrong = ray;
    wrong.direction[i] = nan;
    EXPECT_EQ(quick_cast(shape, wrong, TestFixture::infinity).verdict(), RayVerdict::unclear);
  }
}

}  // namespace
}  // namespace graze::detail::ray_filters_test

#endif
