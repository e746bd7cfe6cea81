// SPDX-License-Identifier: MIT
// The filter for a ray and a triangle agrees bit for bit with the general method, except for the error, which is
// rounded; and it decides most cases.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include <graze/query/ray_cast.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail::ray_triangle_filter_test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

struct Counts {
  std::size_t told = 0;
  std::size_t missed = 0;
  std::size_t told_hits = 0;
  std::size_t hits = 0;
};

void expect_same(const Triangle<3, float>& triangle, const Ray<3, float>& ray, Counts& counts, float t_max = infinity) {
  const std::optional<RayHit<3, float>> careful = cast_ray(triangle, ray, t_max, RaySide::entry);
  const RayTriangleFilter filter = quick_cast(triangle, ray, t_max);
  ++(careful ? counts.hits : counts.missed);
  if (filter.verdict() == RayVerdict::unclear) return;
  ++(careful ? counts.told_hits : counts.told);
  ASSERT_EQ(filter.verdict() == RayVerdict::hits, careful.has_value());
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
  int whole(int high) { return std::uniform_int_distribution<int>(0, high)(engine_); }

 private:
  std::mt19937 engine_{20261123};
};

TEST(RayTriangleFilter, TellsMostRays) {
  Random random;
  Counts counts;
  for (int i = 0; i < 100000; ++i) {
    const Triangle<3, float> triangle{random.vector(1), random.vector(1), random.vector(1)};
    const Vec<3> origin = random.vector(4);
    expect_same(triangle, {origin, random.vector(1) - origin}, counts, i % 2 == 0 ? infinity : random.number(0, 2));
  }
  EXPECT_GT(counts.missed, 80000U);
  EXPECT_GT(static_cast<double>(counts.told), 0.98 * static_cast<double>(counts.missed));
  EXPECT_GT(counts.hits, 3000U);
  EXPECT_GT(static_cast<double>(counts.told_hits), 0.9 * static_cast<double>(counts.hits));  // others are of needles
}

/// From a corner to close to the plane, ending close to the triangle or starting there.
TEST(RayTriangleFilter, SaysNothingElseOfRaysThatEndAtTheTriangle) {
  Random random;
  Counts counts;
  for (int i = 0; i < 100000; ++i) {
    const Triangle<3, float> triangle{random.vector(1), random.vector(1), random.vector(1)};
    const Vec<3> origin = random.vector(4);
    const Vec<3> inside = triangle.a * 0.25F + triangle.b * 0.5F + triangle.c * 0.25F;
    const float near_one = 1 + std::ldexp(random.number(-1, 1), -random.whole(30));
    expect_same(triangle, {origin, inside - origin}, counts, near_one);
    expect_same(triangle, {inside + (origin - inside) * (near_one - 1), inside - origin}, counts);
    const Vec<3> along = triangle.b - triangle.a + random.vector(std::ldexp(1.0F, -random.whole(24)));
    expect_same(triangle, {inside - along * 2.0F, along}, counts);
  }
  EXPECT_GT(counts.told, 30000U);
  EXPECT_GT(counts.told_hits, 30000U);
}

/// At points of the edges, moved slightly away from the triangle, from near and far: undecidable in float.
TEST(RayTriangleFilter, NeverMissesWhatIsHitAtAnEdge) {
  Random random;
  Counts counts;
  for (int i = 0; i < 200000; ++i) {
    const Vec<3> far = random.vector(i % 2 == 0 ? 1000.0F : 1.0F);
    const std::array<Vec<3>, 3> corners{far + random.vector(1), far + random.vector(1), far + random.vector(1)};
    const float share = random.number(-0.25F, 1.25F);
    const Vec<3> place = corners[0] + (corners[1] - corners[0]) * share;
    const float off = std::ldexp(random.number(-1, 1), -4 - random.whole(26));
    const Vec<3> aim = place + (corners[2] - place) * off;
    const Vec<3> origin = far + random.vector(i % 5 == 0 ? 500.0F : 4.0F);
    const auto first = static_cast<std::size_t>(random.whole(2));
    const Triangle<3, float> triangle{corners[first], corners[(first + 1) % 3], corners[(first + 2) % 3]};
    expect_same(triangle, {origin, aim - origin}, counts);
  }
  EXPECT_GT(counts.told, 20000U);
  EXPECT_LT(counts.told, counts.missed);
  EXPECT_GT(counts.told_hits, 10000U);
  EXPECT_LT(counts.told_hits, counts.hits);
}

/// On a lattice, where many triangles are needles or points, and rays run along them.
TEST(RayTriangleFilter, SaysNothingElseOfTheDegenerate) {
  Random random;
  Counts counts;
  const auto place = [&] {
    return Vec<3>(static_cast<float>(random.whole(3)), static_cast<float>(random.whole(3)),
                  static_cast<float>(random.whole(3)));
  };
  for (int i = 0; i < 100000; ++i) {
    const float size = std::ldexp(1.0F, random.whole(240) - 120);
    const float length = std::ldexp(1.0F, random.whole(240) - 120);
    const Triangle<3, float> triangle{place() * size, place() * size, place() * size};
    const Ray<3, float> ray{place() * size, (place() - place()) * length};
    if (is_valid(ray)) expect_same(triangle, ray, counts);
  }
  EXPECT_GT(counts.told, 1000U);
}

TEST(RayTriangleFilter, LeavesOpenWhatIsNoNumber) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const Triangle<3, float> triangle{{1, 0, 0}, {1, 1, 0}, {1, 0, 1}};
  const Ray<3, float> ray{{0, 0, 0}, {1, 2, 2}};
  ASSERT_EQ(quick_cast(triangle, ray, infinity).verdict(), RayVerdict::misses);
  EXPECT_EQ(quick_cast(triangle, ray, nan).verdict(), RayVerdict::unclear);
  for (Dim i = 0; i < 3; ++i) {
    Triangle<3, float> wrong = triangle;
    wrong.b[i] = nan;
    Ray<3, float> wrong_ray = ray;
    wrong_ray.direction[i] = nan;
    EXPECT_EQ(quick_cast(wrong, ray, infinity).verdict(), RayVerdict::unclear);
    EXPECT_EQ(quick_cast(triangle, wrong_ray, infinity).verdict(), RayVerdict::unclear);
  }
}

}  // namespace
}  // namespace graze::detail::ray_triangle_filter_test

#endif
