// SPDX-License-Identifier: MIT
// The first filter of a ray and a box along the axes in space and in float, four numbers at a time. Include
// ray_cast.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <optional>
#include <type_traits>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/obb_filter.hpp>
#include <graze/query/ray_hit.hpp>
#include <graze/query/ray_sight.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/ray.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// Between which t a ray is within the slabs of a box, in float, with all sides moved out and moved in: by more than
/// the calculation is wrong by, which is also far more than the slack of ray_sight_box.hpp. Where both say the same,
/// and the same side is the last to be crossed, only that is left to calculate, in double; so the answers are those of
/// `sight_of`, to the bit. Others, and rays that start inside, are unclear.
///
/// Which of the six sides it is is looked up and never branched on: half of the guesses would be wrong.
class RayBoxFilter {
 public:
  [[gnu::always_inline]] RayBoxFilter(const Aabb<3, float>& box, const Ray<3, float>& ray, float t_max)
      : box_(box), ray_(ray), t_max_(t_max) {
    const Lanes origin = read(ray, 0);
    const Lanes low = read(box, 0) - origin;
    const Lanes high = arranged<1, 2, 3>(read(box, 2)) - origin;
    const Lanes direction = arranged<1, 2, 3>(read(ray, 2)) + 0.0F;  // never minus zero
    // Across an axis along which the ray does not move, its inverse is infinite, and it is between the sides always or
    // never. Of one that is nearly zero, or NaN, nothing is said.
    constexpr float least_known = 0x1p-60F;
    const LaneBits is_usable = (direction == 0.0F) | (magnitude(direction) >= least_known);
    if ((is_usable[0] & is_usable[1] & is_usable[2]) == 0 || !(t_max >= 0)) return;
    const Lanes inverse = 1.0F / direction;
    const Lanes margin = Lanes{} + tolerance::ray_lanes<float> * sum_of_three(magnitude(low) + magnitude(high));
    const LaneBits is_down = direction < 0.0F;
    const Lanes entry = is_down ? high : low;
    const Lanes exit = is_down ? low : high;
    const Lanes inwards = is_down ? -margin : margin;
    const Lanes near = (entry - inwards) * inverse;
    const Lanes far = (exit + inwards) * inverse;
    const float enter = largest_of_three(near);
    const float leave = smallest_of_three(far);
    if (std::max(enter, 0.0F) > std::min(leave, t_max)) {
      sight_ = Sight::misses;
      return;
    }
    const Lanes late = (entry + inwards) * inverse;
    const float last = largest_of_three(late);
    const float soonest = smallest_of_three((exit - inwards) * inverse);
    const bool is_x = late[0] >= enter;
    const bool is_y = late[1] >= enter;
    const bool is_z = late[2] >= enter;
    axis_ = static_cast<std::size_t>(is_y) + 2 * static_cast<std::size_t>(is_z);
    const bool is_one_side = static_cast<int>(is_x) + static_cast<int>(is_y) + static_cast<int>(is_z) == 1;
    if ((enter > 0) & (last <= soonest) & (last <= t_max) & is_one_side) sight_ = Sight::hits;
  }

  [[gnu::always_inline]] Sight sight() const { return sight_; }

  [[gnu::always_inline]] std::optional<RayHit<3, float>> hit() const {
    const auto slope = number(ray_.direction, axis_);
    const bool is_max = slope < 0;
    const float side = number(is_max ? box_.max : box_.min, axis_);
    const double start = number(ray_.origin, axis_);
    const double t = (side - start) / static_cast<double>(slope);  // at least the least slope
    std::optional<RayHit<3, float>> result(std::in_place);
    result->t = static_cast<float>(std::min(t, static_cast<double>(t_max_)));
    const auto place = [&](Dim i) {
      const double origin = ray_.origin[i];
      const double low = box_.min[i] - origin;
      const double high = box_.max[i] - origin;
      const double along = std::min(std::max(ray_.direction[i] * t, low), high) + origin;
      const auto min = static_cast<double>(box_.min[i]);
      const auto max = static_cast<double>(box_.max[i]);
      return static_cast<float>(std::min(std::max(along, min), max)) + 0.0F;
    };
    result->point = {place(0), place(1), place(2)};
    put_number(result->point, axis_, side + 0.0F);
    put_number(result->normal, axis_, is_max ? 1.0F : -1.0F);
    const Vec<3, double> origin = wide<3, float>(ray_.origin);
    const double size = sum_abs(wide<3, float>(box_.min) - origin) + sum_abs(wide<3, float>(box_.max) - origin);
    result->error = tolerance::rounding * size;
    return result;
  }

 private:
  /// Four of the six floats that a box or a ray is.
  template <class S>
  [[gnu::always_inline]] static Lanes read(const S& six, std::size_t first) {
    static_assert(sizeof(S) == 6 * sizeof(float) && std::is_trivially_copyable_v<S>);
    Lanes lanes;
    std::memcpy(&lanes, reinterpret_cast<const char*>(&six) + first * sizeof(float), sizeof(lanes));
    return lanes;
  }

  [[gnu::always_inline]] static float smallest_of_three(Lanes v) { return std::min(v[0], std::min(v[1], v[2])); }

  [[gnu::always_inline]] static float number(const Vec<3, float>& v, std::size_t i) {
    float result = 0;
    std::memcpy(&result, reinterpret_cast<const char*>(&v) + i * sizeof(float), sizeof(float));
    return result;
  }
  [[gnu::always_inline]] static void put_number(Vec<3, float>& v, std::size_t i, float number) {
    std::memcpy(reinterpret_cast<char*>(&v) + i * sizeof(float), &number, sizeof(float));
  }

  const Aabb<3, float>& box_;
  const Ray<3, float>& ray_;
  float t_max_;
  Sight sight_ = Sight::unclear;
  std::size_t axis_ = 0;
};

[[gnu::always_inline]] inline RayBoxFilter quick_cast(const Aabb<3, float>& box, const Ray<3, float>& ray,
                                                      float t_max) {
  return {box, ray, t_max};
}

}  // namespace graze::detail

#endif
