// SPDX-License-Identifier: MIT
// The first filter of two oriented 3D boxes in float, four numbers at a time. The same gaps as filter_of_boxes in
// box_filter.hpp calculates one after the other, and the same bands around zero; a branch on each of fifteen axes,
// which is mispredicted sooner or later, takes longer than all of them together.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <limits>
#include <optional>
#include <type_traits>

#include <graze/math/lanes/lanes.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/obb.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// An oriented box as it is in memory, fifteen consecutive floats, in five loads: none exceeds its end. The contents of
/// the fourth lanes are meaningless.
struct LaneBox {
  Lanes center, half;
  LaneMatrix axes;

  [[gnu::always_inline]] LaneBox(Lanes its_center, Lanes its_half, const LaneMatrix& its_axes)
      : center(its_center), half(its_half), axes(its_axes) {}
  [[gnu::always_inline]] explicit LaneBox(const Obb<3, float>& box)
      : center(read(box, 0)), half(read(box, 3)), axes{read(box, 6), read(box, 9), arranged<1, 2, 3>(read(box, 11))} {
    static_assert(sizeof(box) == 15 * sizeof(float) && std::is_trivially_copyable_v<Obb<3, float>>);
  }

 private:
  [[gnu::always_inline]] static Lanes read(const Obb<3, float>& box, std::size_t first) {
    Lanes lanes;
    std::memcpy(&lanes, reinterpret_cast<const char*>(&box) + first * sizeof(float), sizeof(lanes));
    return lanes;
  }
};

/// InFrameOfBox of box_filter.hpp: the second box in the axes of the first, where coordinate i of a vector is its dot
/// product with axis i, and the sizes of all coordinates of its directions.
struct LanesFromBox {
  Lanes box_half, half, between;
  LaneMatrix directions, shadow;

  [[gnu::always_inline]] LanesFromBox(const LaneBox& a, const LaneBox& b) : box_half(a.half), half(b.half) {
    const LaneMatrix rows = transposed(a.axes);
    between = combined(rows, b.center - a.center);
#pragma GCC unroll 3
    for (std::size_t j = 0; j < 3; ++j) {
      directions.column[j] = combined(rows, b.axes.column[j]);
      shadow.column[j] = magnitude(directions.column[j]);
    }
  }

  /// The gaps on the cross products of each axis of the first box with axis j of the second.
  [[gnu::always_inline]] Lanes gaps_across(std::size_t j) const {
    const Lanes d = directions.column[j];
    const Lanes s = shadow.column[j];
    const std::size_t j1 = (j + 1) % 3;
    const std::size_t j2 = (j + 2) % 3;
    const Lanes reach = turned(box_half) * turned_back(s) + turned_back(box_half) * turned(s) +
                        (shadow.column[j2] * half[j1] + shadow.column[j1] * half[j2]);
    return magnitude(turned_back(between) * turned(d) - turned(between) * turned_back(d)) - reach;
  }
};

/// As in box_filter.hpp: whether the only undecided gaps on cross products are those of nearly parallel edges.
[[gnu::always_inline]] inline bool only_parallel_edges_are_open(const LanesFromBox& seen,
                                                                const std::array<Lanes, 3>& across, float band) {
  constexpr auto parallel = static_cast<float>(2 * tolerance::box_filter * tolerance::orthonormal);
  LaneBits is_settled = {-1, -1, -1, -1};
  for (std::size_t j = 0; j < 3; ++j) {
    const Lanes s = seen.shadow.column[j];
    is_settled &= (across[j] < -band) | (turned(s) + turned_back(s) < parallel);
  }
  return (is_settled[0] & is_settled[1] & is_settled[2]) != 0;
}

/// No answer if box_filter.hpp has to repeat the test in double: too close to tell, NaN, numbers too large or too
/// small. The widths of the bands, and when parallel edges do not matter, are derived at filter_of_boxes.
[[gnu::always_inline]] inline std::optional<Relation> filter_of_obbs(const Obb<3, float>& box_a,
                                                                     const Obb<3, float>& box_b) {
  const LanesFromBox seen{LaneBox(box_a), LaneBox(box_b)};
  const Lanes reach_of_own = seen.box_half + combined(seen.shadow, seen.half);
  const Lanes distance_of_own = magnitude(seen.between);
  const float size = sum_of_three(distance_of_own + reach_of_own);
  constexpr float least_product = 0x1p20F * std::numeric_limits<float>::min();
  if (!(size * std::min(size, 1.0F) > least_product)) return std::nullopt;
  const float band = static_cast<float>(tolerance::box_filter * tolerance::orthonormal) * size;

  const Lanes reach_of_other = seen.half + combined(transposed(seen.shadow), seen.box_half);
  const Lanes distance_of_other = magnitude(combined(transposed(seen.directions), seen.between));
  const float widest = largest_of_three(larger(distance_of_own - reach_of_own, distance_of_other - reach_of_other));
  if (widest > band) return Relation::apart;

  const std::array<Lanes, 3> across{seen.gaps_across(0), seen.gaps_across(1), seen.gaps_across(2)};
  const float widest_across = largest_of_three(larger(across[0], larger(across[1], across[2])));
  if (widest_across > band) return Relation::apart;
  float least_depth = band;
  if (!(widest_across < -band)) {
    if (!only_parallel_edges_are_open(seen, across, band)) return std::nullopt;
    least_depth = 8 * band;
  }
  if (widest < -least_depth) return Relation::overlapping;
  return std::nullopt;
}

}  // namespace graze::detail
#endif
