// SPDX-License-Identifier: MIT
// The first filter of a ray and a 3D triangle, in float, three edges at a time. Include ray_cast.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <optional>
#include <type_traits>

#include <graze/math/lanes/lanes.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/ray/hit_lanes.hpp>
#include <graze/query/ray/verdict.hpp>
#include <graze/query/ray_hit.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/triangle.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// The side of each edge on which the ray's line passes, as in TriangleBesidePath of ray/verdict_2d.hpp: direction .
/// (corner x edge), with corners relative to the ray's origin. Each number of a lane belongs to one corner or to the
/// edge that begins there. If the line passes on both sides by more than rounding in float, it misses; that is far more
/// than what the precise algorithm leaves to `relation`.
///
/// If it passes all edges on one side by as much, it goes through the triangle, provided that it reaches its plane in
/// time. The intersection is calculated in double as in `ray_verdict_of`: point, t and normal are bit-identical, and
/// the error up to its rounding to float. Needles, whose plane needs more care, rays at a small angle and everything
/// else are unclear.
class RayTriangleFilter {
 public:
  [[gnu::always_inline]] RayTriangleFilter(const Triangle<3, float>& triangle, const Ray<3, float>& ray, float t_max)
      : ray_(ray) {
    const LaneMatrix corners = transposed({read(triangle, 0), read(triangle, 3), arranged<1, 2, 3>(read(triangle, 5))});
    const auto& [x, y, z] = corners.column;
    const Lanes edge_x = turned(x) - x;
    const Lanes edge_y = turned(y) - y;
    const Lanes edge_z = turned(z) - z;
    const Lanes seen_x = x - ray.origin.x;
    const Lanes seen_y = y - ray.origin.y;
    const Lanes seen_z = z - ray.origin.z;
    const Lanes sides = (seen_y * edge_z - seen_z * edge_y) * ray.direction.x +
                        (seen_z * edge_x - seen_x * edge_z) * ray.direction.y +
                        (seen_x * edge_y - seen_y * edge_x) * ray.direction.z;
    const float size = largest_of_three(magnitude(seen_x) + magnitude(seen_y) + magnitude(seen_z));
    const Lanes edges = magnitude(edge_x) + magnitude(edge_y) + magnitude(edge_z);
    const float slope = sum_abs(ray.direction);
    const float band = tolerance::ray_edges<float> * slope * size * sum_of_three(edges);
    const float least = std::min(sides[0], std::min(sides[1], sides[2]));
    const float most = largest_of_three(sides);
    constexpr float no_product_overflows = 0x1p40F;
    constexpr float no_product_underflows = 0x1p-100F;
    const bool is_moderate =
        (size < no_product_overflows) & (slope < no_product_overflows) & (band > no_product_underflows) & (t_max >= 0);
    if (!is_moderate) return;
    if ((least < -band) & (most > band)) {
      verdict_ = RayVerdict::misses;
    } else if ((least > band) | (most < -band)) {
      const float two_edges = edges[0] + edges[2];  // everything that ray_verdict_of evaluates
      error_ = tolerance::rounding * static_cast<double>(size + two_edges);
      cross_plane(triangle, size, t_max);
    }
  }

  [[gnu::always_inline]] RayVerdict verdict() const { return verdict_; }

  [[gnu::always_inline]] std::optional<RayHit<3, float>> hit() const {
    const double length = std::sqrt(dot(normal_, normal_));
    const PairedVec normal = normal_ / (climb_ > 0 ? -length : length);
    const Lanes zero_and_normal = narrow(0, normal);
    const PairedVec point = PairedVec(ray_.direction) * t_ + PairedVec(ray_.origin);
    return hit_of(narrow(t_, point), __builtin_shufflevector(zero_and_normal, zero_and_normal, 1, 2, 3, 0), error_);
  }

 private:
  /// Whether the ray reaches the plane in time. The slack at its ends is four times that of ray_verdict_of.
  [[gnu::always_inline]] void cross_plane(const Triangle<3, float>& triangle, float size, float t_max) {
    const PairedVec origin(ray_.origin);
    const PairedVec direction(ray_.direction);
    const PairedVec a = PairedVec(triangle.a) - origin;
    const PairedVec first = PairedVec(triangle.b) - origin - a;
    const PairedVec second = PairedVec(triangle.c) - origin - a;
    normal_ = cross(first, second);
    climb_ = dot(normal_, direction);
    const double whole = dot(normal_, normal_);
    constexpr double least_sine_of_edges = 1.0 / 8;  // as in cross_of_directions
    const bool is_wide = whole > least_sine_of_edges * least_sine_of_edges * dot(first, first) * dot(second, second);
    constexpr double least_sine_squared = 0x1p-20;
    const bool is_steep = climb_ * climb_ > least_sine_squared * (whole * dot(direction, direction));
    if (!is_wide || !is_steep) return;
    t_ = dot(normal_, a) / climb_;
    const auto largest = static_cast<double>(max_abs(ray_.direction));
    const double to_start = t_ * largest;
    const double to_end = (static_cast<double>(t_max) - t_) * largest;
    const double to_latest = (latest_t(t_max) - t_) * largest;
    const double slack = 0x1p12 * tolerance::ray_side * static_cast<double>(size);
    if (to_start > slack && to_end > slack) verdict_ = RayVerdict::hits;
    if (to_start < -slack || to_latest < -slack) verdict_ = RayVerdict::misses;
  }

  /// Four of the nine floats of a triangle.
  [[gnu::always_inline]] static Lanes read(const Triangle<3, float>& triangle, std::size_t first) {
    static_assert(sizeof(triangle) == 9 * sizeof(float) && std::is_trivially_copyable_v<Triangle<3, float>>);
    Lanes lanes;
    std::memcpy(&lanes, reinterpret_cast<const char*>(&triangle) + first * sizeof(float), sizeof(lanes));
    return lanes;
  }

  const Ray<3, float>& ray_;
  RayVerdict verdict_ = RayVerdict::unclear;
  double error_ = 0;
  // The intersection with the plane.
  PairedVec normal_{LanePair{}, 0};
  double climb_ = 0;
  double t_ = 0;
};

[[gnu::always_inline]] inline RayTriangleFilter quick_cast(const Triangle<3, float>& triangle, const Ray<3, float>& ray,
                                                           float t_max) {
  return {triangle, ray, t_max};
}

}  // namespace graze::detail

#endif
