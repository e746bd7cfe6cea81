// SPDX-License-Identifier: MIT
// Boxes grown by more than the rounding error within which shapes count as touching; see touching_bounds.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <graze/math/platform/bit_cast.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// The largest finite coordinate of an unbounded box.
template <Dim N, class T>
[[gnu::noinline]] T size_of_unbounded(const Aabb<N, T>& box) {
  T size = 0;
  for (Dim i = 0; i < N; ++i) {
    size = std::max(size, std::max(finite_magnitude(box.min[i]), finite_magnitude(box.max[i])));
  }
  return size;
}

/// The largest finite coordinate of a box.
template <Dim N, class T>
T size_of_box(const Aabb<N, T>& box) {
  const T size = std::max(max_abs(box.min), max_abs(box.max));
  return size <= std::numeric_limits<T>::max() ? size : size_of_unbounded(box);
}

/// Grows a box as touching_bounds does, and returns the largest of its finite coordinates before.
template <Dim N, class T>
T grow_by_slack(Aabb<N, T>& box) {
  const T size = size_of_box(box);
  const double slack = tolerance::box_slack * static_cast<double>(size);
  for (Dim i = 0; i < N; ++i) {
    box.min[i] = round_down<T>(static_cast<double>(box.min[i]) - slack);
    box.max[i] = round_up<T>(static_cast<double>(box.max[i]) + slack);
  }
  return size;
}

/// Whether the slack of a box is at most one step of the floats around each coordinate, as for nearly all boxes, from
/// the least and greatest magnitude among its numbers. Then none of them is zero or infinite. Bits are ordered as
/// magnitudes are.
inline bool is_slack_within_a_step(float least, float greatest) {
  constexpr std::uint32_t infinity = 255U << 23U;
  constexpr std::uint32_t most_apart = 20U << 23U;  // in powers of two
  static_assert(tolerance::box_slack * 0x1p20 <= 0x1p-24, "a step from x is 2^-24 |x| or more");
  const auto low = bit_cast<std::uint32_t>(least);
  const auto high = bit_cast<std::uint32_t>(greatest);
  return low != 0 && high < infinity && high - low <= most_apart;
}

/// Grows a box likewise, usually by one step of each side's bits.
template <Dim N, class T>
T grow_for_touching(Aabb<N, T>& box) {
  if constexpr (std::is_same_v<T, float>) {
    float near_zero = std::numeric_limits<float>::max();
    float size = 0;
    for (Dim i = 0; i < N; ++i) {
      const float low = std::fabs(box.min[i]);
      const float high = std::fabs(box.max[i]);
      near_zero = std::min(std::min(near_zero, low), high);
      size = std::max(std::max(size, low), high);
    }
    if (is_slack_within_a_step(near_zero, size)) {
      for (Dim i = 0; i < N; ++i) {
        const auto low = bit_cast<std::uint32_t>(box.min[i]);
        const auto high = bit_cast<std::uint32_t>(box.max[i]);
        box.min[i] = bit_cast<float>(low - 1 + 2 * (low >> 31U));
        box.max[i] = bit_cast<float>(high + 1 - 2 * (high >> 31U));
      }
      return size;
    }
  }
  return grow_by_slack(box);
}

}  // namespace graze::detail
