// SPDX-License-Identifier: MIT
// The first filter of a ray and a triangle in space and in float, three edges at a time. Include ray_cast.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <optional>
#include <type_traits>

#include <graze/math/tolerance.hpp>
#include <graze/query/obb_filter.hpp>
#include <graze/query/ray_hit.hpp>
#include <graze/query/ray_sight.hpp>
#include <graze/shape/ray.hpp>
#include <graze/shape/triangle.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// On which side of each edge the ray's line passes, as TriangleBesidePath of ray_sight_flat.hpp has it: direction .
/// (corner x edge), with corners as the ray's origin sees them. Each number of a lane is of one corner or the edge that
/// begins there. What passes on both sides by more than rounding in float misses; that is far more than what the
/// careful way leaves to `relation`. All else is unclear.
class RayTriangleFilter {
 public:
  [[gnu::always_inline]] RayTriangleFilter(const Triangle<3, float>& triangle, const Ray<3, float>& ray, float t_max) {
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
    const float edges = sum_of_three(magnitude(edge_x) + magnitude(edge_y) + magnitude(edge_z));
    const float slope = sum_abs(ray.direction);
    const float band = tolerance::ray_edges<float> * slope * size * edges;
    const float least = std::min(sides[0], std::min(sides[1], sides[2]));
    const float most = largest_of_three(sides);
    constexpr float no_product_overflows = 0x1p40F;
    constexpr float no_product_underflows = 0x1p-100F;
    const bool is_moderate =
        (size < no_product_overflows) & (slope < no_product_overflows) & (band > no_product_underflows) & (t_max >= 0);
    is_missed_ = is_moderate & (least < -band) & (most > band);
  }

  [[gnu::always_inline]] Sight sight() const { return is_missed_ ? Sight::misses : Sight::unclear; }
  [[gnu::always_inline]] static std::optional<RayHit<3, float>> hit() { return std::nullopt; }

 private:
  /// Four of the nine floats that a triangle is.
  [[gnu::always_inline]] static Lanes read(const Triangle<3, float>& triangle, std::size_t first) {
    static_assert(sizeof(triangle) == 9 * sizeof(float) && std::is_trivially_copyable_v<Triangle<3, float>>);
    Lanes lanes;
    std::memcpy(&lanes, reinterpret_cast<const char*>(&triangle) + first * sizeof(float), sizeof(lanes));
    return lanes;
  }

  bool is_missed_;
};

[[gnu::always_inline]] inline RayTriangleFilter quick_cast(const Triangle<3, float>& triangle, const Ray<3, float>& ray,
                                                           float t_max) {
  return {triangle, ray, t_max};
}

}  // namespace graze::detail

#endif
