// SPDX-License-Identifier: MIT
// The filter for a ray and a box agrees bit for bit with the general method, except for the error, which is rounded;
// and it decides most cases.
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include <graze/query/ray_cast.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail::ray_box_filter_test {
namespace {

using Box = Aabb<3, float>;
using RayOfFloats = Ray<3, float>;
constexpr float infinity = std::numeric_limits<float>::infinity();

struct Counts {
  std::size_t missed = 0;
  std::size_t hit = 0;
  std::size_t unclear = 0;
};

void expect_same(const Box& box, const RayOfFloats& ray, float t_max, Counts& counts) {
  const auto filter = quick_cast(box, ray, t_max);
  if (filter.verdict() == RayVerdict::unclear) {
    ++counts.unclear;
    return;
  }
  const std::optional<RayHit<3, float>> careful = cast_ray(box, ray, t_max, RaySide::entry);
  ASSERT_EQ(filter.verdict() == RayVerdict::hits, careful.has_value());
  ++(careful ? counts.hit : counts.missed);
  if (!careful) return;
  std::optional<RayHit<3, float>> hit = filter.hit();
  ASSERT_NEAR(hit->error, careful->error, 0x1p-20 * careful->error);
  hit->error = careful->error;
  ASSERT_EQ(*hit, *careful);
  const auto is_minus_zero = [](float number) { return number == 0 && std::signbit(number); };
  for (Dim i = 0; i < 3; ++i) ASSERT_FALSE(is_minus_zero(hit->point[i]) || is_minus_zero(hit->normal[i]));
}

class Random {
 public:
  float number(float low, float high) { return std::uniform_real_distribution<float>(low, high)(engine_); }
  Vec<3> vector(float size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
  float one_of(const std::array<float, 8>& numbers) {
    return numbers[std::uniform_int_distribution<std::size_t>(0, 7)(engine_)];
  }

 private:
  std::mt19937 engine_{20261123};
};

TEST(RayBoxFilter, SettlesUsualRaysAsTheCarefulWayDoes) {
  Random random;
  Counts counts;
  for (int i = 0; i < 200000; ++i) {
    const Vec<3> center = random.vector(i % 3 == 0 ? 1000.0F : 1.0F);
    const Box box = Box::from_center(center, abs(random.vector(1)));
    const Vec<3> origin = center + random.vector(4);
    const RayOfFloats ray{origin, center + random.vector(1.2F) - origin};
    expect_same(box, ray, i % 2 == 0 ? infinity : random.number(0, 2), counts);
  }
  EXPECT_GT(counts.missed, 50000U);
  EXPECT_GT(counts.hit, 40000U);
  EXPECT_LT(counts.unclear, 10000U);  // which start inside
}

/// Rays along axes and sides, at edges and corners, from the box's surface, at flat boxes, with either zero, tiny
/// slopes or no direction.
TEST(RayBoxFilter, SaysNothingElseOfTheNasty) {
  Random random;
  Counts counts;
  constexpr float next = 1 + 0x1p-23F;
  const std::array<float, 8> places{-1, 0, 1, 2, 1 - 0x1p-18F, next, -next, 0x1p-30F};
  const std::array<float, 8> sizes{0, 1, 1, 2, 2, 0x1p-20F, 0x1p-30F, 3};
  const std::array<float, 8> slopes{0, -0.0F, 1, -1, 0.5F, -0x1p-70F, 0x1p-149F, -0x1p-20F};
  const std::array<float, 8> ends{0, 1, 2, infinity, 0.5F, 0x1p-149F, 1 + 0x1p-20F, 4};
  for (int i = 0; i < 400000; ++i) {
    const Vec<3> min(random.one_of(places), random.one_of(places), random.one_of(places));
    const Box box{min, min + Vec<3>(random.one_of(sizes), random.one_of(sizes), random.one_of(sizes))};
    RayOfFloats ray{Vec<3>(random.one_of(places), random.one_of(places), random.one_of(places)) * 2.0F,
                    {random.one_of(slopes), random.one_of(slopes), random.one_of(slopes)}};
    if (i % 2 == 0) {
      const Vec<3> aim = box.center() - ray.origin;
      ray.direction[i / 2 % 3] = aim[i / 2 % 3];
      ray.direction[i / 6 % 3] = aim[i / 6 % 3];
    }
    if (is_valid(ray)) expect_same(box, ray, random.one_of(ends), counts);
  }
  EXPECT_GT(counts.missed, 50000U);
  EXPECT_GT(counts.hit, 1000U);
}

/// Lattices so small or large, and rays so slow or fast, that products underflow or overflow.
TEST(RayBoxFilter, SaysNothingElseAtTheEndsOfTheRangeOfFloat) {
  Random random;
  Counts counts;
  const std::array<float, 8> places{-3, -2, -1, 0, 1, 2, 3, 5};
  const std::array<float, 8> sizes{1, 1, 2, 2, 3, 3, 5, 0x1p-18F};
  const std::array<float, 8> slopes{1, -1, 0.5F, 2, -3, 0, 0x1p-90F, 0x1p-149F};
  const std::array<float, 8> units{1, 0x1p-30F, 0x1p-90F, 0x1p-126F, 0x1p-146F, 0x1p60F, 0x1p99F, 0x1p124F};
  const std::array<float, 8> ends{0x1p-149F, 0x1p-140F, 0x1p-100F, infinity, infinity, 1, 0x1p100F, 0x1p127F};
  for (int i = 0; i < 400000; ++i) {
    const float unit = random.one_of(units);
    const float speed = random.one_of(units);
    const Vec<3> min(random.one_of(places), random.one_of(places), random.one_of(places));
    const Vec<3> size(random.one_of(sizes), random.one_of(sizes), random.one_of(sizes));
    const Vec<3> origin(random.one_of(places), random.one_of(places), random.one_of(places));
    Vec<3> direction(random.one_of(slopes), random.one_of(slopes), random.one_of(slopes));
    if (i % 2 == 0) direction = min + size * 0.5F - origin;
    const RayOfFloats ray{origin * unit, direction * speed};
    if (is_valid(ray)) expect_same({min * unit, (min + size) * unit}, ray, random.one_of(ends), counts);
  }
  EXPECT_GT(counts.missed, 50000U);
  EXPECT_GT(counts.hit, 20000U);
}

TEST(RayBoxFilter, LeavesOpenWhatIsNoNumberOrTooLarge) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float huge = std::numeric_limits<float>::max();
  const Box box{{-1, -1, -1}, {1, 1, 1}};
  const RayOfFloats ray{{-3, 0.25F, 0.125F}, {1, 0, 0}};
  ASSERT_EQ(quick_cast(box, ray, infinity).verdict(), RayVerdict::hits);
  EXPECT_EQ(quick_cast(box, ray, nan).verdict(), RayVerdict::unclear);
  EXPECT_EQ(quick_cast(box, ray, -1.0F).verdict(), RayVerdict::misses);
  for (Dim i = 0; i < 3; ++i) {
    for (const float value : {nan, -huge, huge}) {
      Box wrong_min = box;
      Box wrong_max = box;
      RayOfFloats wrong_origin = ray;
      RayOfFloats wrong_direction = ray;
      wrong_min.min[i] = value;
      wrong_max.max[i] = value;
      wrong_origin.origin[i] = value;
      wrong_direction.direction[i] = value;
      Counts counts;
      if (std::isnan(value)) {
        EXPECT_EQ(quick_cast(wrong_min, ray, infinity).verdict(), RayVerdict::unclear);
        EXPECT_EQ(quick_cast(wrong_max, ray, infinity).verdict(), RayVerdict::unclear);
        EXPECT_EQ(quick_cast(box, wrong_origin, infinity).verdict(), RayVerdict::unclear);
        EXPECT_EQ(quick_cast(box, wrong_direction, infinity).verdict(), RayVerdict::unclear);
      } else {
        if (wrong_min.min[i] <= box.max[i]) expect_same(wrong_min, ray, infinity, counts);
        if (wrong_max.max[i] >= box.min[i]) expect_same(wrong_max, ray, infinity, counts);
        expect_same(box, wrong_origin, infinity, counts);
        expect_same(box, wrong_direction, infinity, counts);
      }
    }
  }
}

}  // namespace
}  // namespace graze::detail::ray_box_filter_test

#endif
