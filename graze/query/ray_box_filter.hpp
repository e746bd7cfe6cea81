// SPDX-License-Identifier: MIT
// The first filter of a ray and a box along the axes in space and in float, four numbers at a time. Include
// ray_cast.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>
#include <optional>
#include <type_traits>

#include <graze/math/bit_cast.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/lanes.hpp>
#include <graze/query/ray_hit.hpp>
#include <graze/query/ray_hit_lanes.hpp>
#include <graze/query/ray_sight.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/ray.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// Between which t a ray is within the slabs of a box, in float, with all sides moved out and moved in: by more than
/// the calculation is wrong by, which is also far more than the slack of ray_sight_box.hpp. Where both say the same,
/// and the same side is the last to be crossed, only that is left to calculate, in double; so place, t and normal are
/// those of `sight_of`, to the bit, and the error up to its rounding to float. Others, and rays that start inside, are
/// unclear.
///
/// Across an axis along which the ray does not move, its inverse is infinite, and it is between the sides always or
/// never. So it is taken to be where the inverse overflows: then it takes at least 2^126 times the margin to cross a
/// side, and nothing is said of a t that comes near that.
///
/// Each t is the rounded product of a place and an inverse that are right up to the margin. To round a product leaves
/// order as it is, even where it underflows or overflows, but may make two of them equal: so nothing that is equal
/// settles a ray.
class RayBoxFilter {
 public:
  [[gnu::always_inline]] RayBoxFilter(const Aabb<3, float>& box, const Ray<3, float>& ray, float t_max)
      : box_(box), ray_(ray) {
    const Lanes origin = read(ray, 0);
    const Lanes low = read(box, 0) - origin;
    const Lanes high = arranged<1, 2, 3>(read(box, 2)) - origin;
    const Lanes inverse = Lanes{1, 1, 1, 1} / arranged<1, 2, 3>(read(ray, 2));
    const Lanes sizes = magnitude(low) + magnitude(high);
    const Lanes size = arranged<0, 0, 0>(sizes) + arranged<1, 1, 1>(sizes) + arranged<2, 2, 2>(sizes);
    const Lanes margin = tolerance::ray_lanes<float> * size;
    const Lanes to_low = (low - margin) * inverse;
    const Lanes to_high = (high + margin) * inverse;
    const Lanes enter_and_left = largest_of_both(smaller(to_low, to_high), -larger(to_low, to_high));
    const float enter = enter_and_left[0];
    const float leave = std::min(-enter_and_left[1], t_max);
    const float most_t = most_size * size[0];
    if (std::max(0.0F, enter) > leave) {
      if (leave < most_t && is_moderate(size[0])) sight_ = Sight::misses;
      return;
    }
    margin_ = margin[0];
    const Lanes low_inside = low + margin;
    const Lanes high_inside = high - margin;
    const LaneBits is_flat = ~(low_inside < high_inside) & LaneBits{-4, -4, -4, 0};  // more than all sides together
    const Lanes to_low_inside = low_inside * inverse;
    const Lanes to_high_inside = high_inside * inverse;
    const Lanes late = smaller(to_low_inside, to_high_inside);
    const Lanes last_and_left = largest_of_both(late, -larger(to_low_inside, to_high_inside));
    const float last = last_and_left[0];
    is_side_ = ~(late < arranged<0, 0, 0>(enter_and_left)) & LaneBits{-1, -1, -1, 0};  // or NaN
    const bool is_in_time = enter > 0 && last < -last_and_left[1] && last < t_max && last < most_t;
    if (is_in_time && has_one(is_side_ + is_flat) && is_moderate(size[0])) sight_ = Sight::hits;
  }

  [[gnu::always_inline]] Sight sight() const { return sight_; }

  /// The t of the side that is met is the largest, and the place is between all others by the margin.
  [[gnu::always_inline]] std::optional<RayHit<3, float>> hit() const {
    const Lanes direction = arranged<1, 2, 3>(read(ray_, 2));
    const LaneBits is_down = bit_cast<LaneBits>(direction) < 0;  // minus zero, too: its t is then minus infinity
    const Lanes side = is_down ? arranged<1, 2, 3>(read(box_, 2)) : read(box_, 0);
    const PairedVec origin(ray_.origin);
    const PairedVec slope(ray_.direction);
    const PairedVec across = (PairedVec(side) - origin) / slope;
    const double t = std::max(across.xy[0], std::max(across.xy[1], across.z));
    const Lanes along = turned_by_one(narrow(t, slope * t + origin));
    const Lanes point = is_side_ ? side : along;
    const LaneBits against = ~is_down & std::numeric_limits<int>::min();
    const LaneBits normal = is_side_ & (bit_cast<LaneBits>(Lanes{1, 1, 1, 1}) | against);
    constexpr double share = tolerance::rounding / static_cast<double>(tolerance::ray_lanes<float>);
    return hit_of(__builtin_shufflevector(point, point, 3, 0, 1, 2), bit_cast<Lanes>(normal), margin_ * share);
  }

 private:
  static constexpr float most_size = 0x1p100F;

  /// Whether the margin neither underflows nor overflows.
  [[gnu::always_inline]] static bool is_moderate(float size) { return size > 1 / most_size && size < most_size; }

  /// Four of the six floats that a box or a ray is.
  template <class S>
  [[gnu::always_inline]] static Lanes read(const S& six, std::size_t first) {
    static_assert(sizeof(S) == 6 * sizeof(float) && std::is_trivially_copyable_v<S>);
    Lanes lanes;
    std::memcpy(&lanes, reinterpret_cast<const char*>(&six) + first * sizeof(float), sizeof(lanes));
    return lanes;
  }

  [[gnu::always_inline]] static Lanes turned_by_one(Lanes v) { return __builtin_shufflevector(v, v, 1, 2, 3, 0); }

  [[gnu::always_inline]] static bool has_one(LaneBits bits) {
    const LaneBits sums = bits + __builtin_shufflevector(bits, bits, 2, 3, 2, 3);
    return sums[0] + sums[1] == -1;
  }

  const Aabb<3, float>& box_;
  const Ray<3, float>& ray_;
  Sight sight_ = Sight::unclear;
  float margin_ = 0;
  LaneBits is_side_{};
};

[[gnu::always_inline]] inline RayBoxFilter quick_cast(const Aabb<3, float>& box, const Ray<3, float>& ray,
                                                      float t_max) {
  return {box, ray, t_max};
}

}  // namespace graze::detail

#endif
