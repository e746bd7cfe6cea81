// SPDX-License-Identifier: MIT
// The first filter of a ray and three slabs, in float, four numbers at a time. Include ray_cast.hpp.
#pragma once

#include <algorithm>

#include <graze/math/lanes/lanes.hpp>
#include <graze/query/ray/verdict.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// The range of t for which a ray from zero is within three slabs, with all sides moved outwards and inwards by a
/// margin: more than the error of the calculation, which also far exceeds the slack of ray/verdict_box.hpp. If both
/// give the same answer, and the same side is crossed last, the ray hits. Others, and rays that start inside, are
/// unclear.
///
/// For an axis along which the ray does not move, its inverse is infinite, and it is between the sides always or never.
/// The same is assumed if the inverse overflows: it then takes at least 2^126 times the margin to cross a side, and no
/// t close to that is ever decided.
///
/// Each t is the rounded product of a coordinate and an inverse that are correct up to the margin. Rounding a product
/// is monotonic, even if it underflows or overflows, but may make two of them equal: so equal values never decide a
/// ray. The same is true for a t_max that is rounded to float.
class RaySlabFilter {
 public:
  /// The sides relative to the ray's origin and the finite slopes, all of which may be rounded to float, in the first
  /// three lanes. The margin is relative to the sides' magnitudes.
  [[gnu::always_inline]] void cross(Lanes low, Lanes high, Lanes slope, float t_max, float relative_margin) {
    const Lanes inverse = Lanes{1, 1, 1, 1} / slope;
    const Lanes sizes = magnitude(low) + magnitude(high);
    const Lanes size = arranged<0, 0, 0>(sizes) + arranged<1, 1, 1>(sizes) + arranged<2, 2, 2>(sizes);
    const Lanes margin = relative_margin * size;
    const Lanes to_low = (low - margin) * inverse;
    const Lanes to_high = (high + margin) * inverse;
    const Lanes enter_and_left = largest_of_both(smaller(to_low, to_high), -larger(to_low, to_high));
    const float enter = enter_and_left[0];
    const float leave = std::min(-enter_and_left[1], t_max);
    const float most_t = most_size * size[0];
    size_ = size[0];
    if (std::max(0.0F, enter) > leave) {
      if (leave < most_t && is_moderate(size_)) verdict_ = RayVerdict::misses;
      return;
    }
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
    if (is_in_time && has_one(is_side_ + is_flat) && is_moderate(size_)) verdict_ = RayVerdict::hits;
  }

  [[gnu::always_inline]] RayVerdict verdict() const { return verdict_; }
  /// The sum of all magnitudes of sides.
  [[gnu::always_inline]] float size() const { return size_; }
  /// All bits of the lane of the slab whose side is met, if there is a hit.
  [[gnu::always_inline]] LaneBits is_side() const { return is_side_; }

 private:
  static constexpr float most_size = 0x1p100F;

  /// Whether the margin neither underflows nor overflows.
  [[gnu::always_inline]] static bool is_moderate(float size) { return size > 1 / most_size && size < most_size; }

  [[gnu::always_inline]] static bool has_one(LaneBits bits) {
    const LaneBits sums = bits + __builtin_shufflevector(bits, bits, 2, 3, 2, 3);
    return sums[0] + sums[1] == -1;
  }

  RayVerdict verdict_ = RayVerdict::unclear;
  float size_ = 0;
  LaneBits is_side_{};
};

}  // namespace graze::detail

#endif
