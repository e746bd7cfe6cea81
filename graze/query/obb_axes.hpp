// SPDX-License-Identifier: MIT
// Which of the fifteen axes of two oriented boxes can be the one that parts them: a look in float, four numbers at a
// time, that leaves one or two for the careful search of penetration_boxes.hpp, and mostly knows the verdict, too.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <type_traits>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/obb_filter.hpp>
#include <graze/query/penetration_boxes.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/obb.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// What a look at two boxes shows. The axes are those that the search may not leave out; all of them where the look
/// showed nothing.
struct ObbAxes {
  std::optional<Relation> verdict;  ///< None: too close to tell.
  BoxesAxes candidates = all_boxes_axes<3>;
};

/// How far the axes are from orthonormal, as orthonormal_error in obb.hpp.
[[gnu::always_inline]] inline float skew_of(const LaneMatrix& axes) {
  const LaneMatrix rows = transposed(axes);
  Lanes squares = {-1, -1, -1, -1};
  Lanes products = {0, 0, 0, 0};
#pragma GCC unroll 3
  for (const Lanes row : rows.column) {
    squares += row * row;
    products += row * turned(row);
  }
  return largest_of_three(larger(magnitude(squares), magnitude(products)));
}

/// The axes whose gaps may be the widest, up to what a search takes for equal.
///
/// The gap on a face's axis is off by 7 skew of the size, that on a cross product of edges by 10, which is as wrong for
/// its length by 3: see filter_of_boxes. So no face is the widest that falls short of the widest one by two bands, nor
/// a cross product of length l with the gap g if g + band < (widest - 2 band) l. What the search takes for equal is
/// less than the least band by a factor of ten thousand.
[[gnu::always_inline]] inline ObbAxes axes_of(const LanesFromBox& seen, float skew) {
  const Lanes reach_of_own = seen.box_half + combined(seen.shadow, seen.half);
  const Lanes distance_of_own = magnitude(seen.between);
  const float size = sum_of_three(distance_of_own + reach_of_own);
  // Squares of a band must not come near the least numbers, nor those of a length near the largest.
  if (!(size > 0x1p-30F && size < 0x1p30F)) return {};
  const float band = static_cast<float>(tolerance::box_filter) * skew * size;
  const Lanes own = distance_of_own - reach_of_own;
  const Lanes other = magnitude(combined(transposed(seen.directions), seen.between)) -
                      (seen.half + combined(transposed(seen.shadow), seen.box_half));
  const float widest = largest_of_three(larger(own, other));
  if (widest > band) return {Relation::apart, {}};
  const float least = widest - 2 * band;

  LaneBits candidates = ((own >= least) & LaneBits{1, 2, 4, 0}) | ((other >= least) & LaneBits{8, 16, 32, 0});
  LaneBits are_open = {0, 0, 0, 0};
  LaneBits bits = {1 << 6, 1 << 9, 1 << 12, 0};
  Lanes widest_across = {-size, -size, -size, -size};
  const float parallel = 2 * static_cast<float>(tolerance::box_filter) * skew;
#pragma GCC unroll 3
  for (std::size_t j = 0; j < 3; ++j) {
    const Lanes gaps = seen.gaps_across(j);
    const Lanes near = turned(seen.shadow.column[j]);
    const Lanes far = turned_back(seen.shadow.column[j]);
    const Lanes short_by = gaps + band;
    widest_across = larger(widest_across, gaps);
    are_open |= (gaps >= -band) & (near + far >= parallel);
    const Lanes squared = (near * near + far * far) * (1.001F * least * least);
    candidates |= ((short_by >= 0.0F) | (short_by * short_by <= squared)) & bits;
    bits *= 2;
  }
  ObbAxes result;
  result.candidates = static_cast<BoxesAxes>(candidates[0] | candidates[1] | candidates[2]);
  const float across = largest_of_three(widest_across);
  if (across > band) {
    result.verdict = Relation::apart;
  } else if ((are_open[0] | are_open[1] | are_open[2]) == 0 && widest < -8 * band) {
    result.verdict = Relation::overlapping;
  }
  return result;
}

[[gnu::always_inline]] inline LaneBox lane_box(const Obb<3, double>& box, const Vec<3, double>& center) {
  const auto lanes = [](const Vec<3, double>& v) {
    return Lanes{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), 0};
  };
  return {lanes(center), lanes(box.half_extents), {lanes(box.axes[0]), lanes(box.axes[1]), lanes(box.axes[2])}};
}

template <class T>
[[gnu::always_inline]] inline ObbAxes axes_of(const Obb<3, T>& a, const Obb<3, T>& b) {
  const auto looked_at = [](const LaneBox& lanes_a, const LaneBox& lanes_b) {
    const float skew = std::max(skew_of(lanes_a.axes), skew_of(lanes_b.axes)) + tolerance::measured_skew<float>;
    return axes_of(LanesFromBox(lanes_a, lanes_b), skew);
  };
  if constexpr (std::is_same_v<T, float>) {
    return looked_at(LaneBox(a), LaneBox(b));
  } else {
    return looked_at(lane_box(a, Vec<3, double>(0.0)), lane_box(b, b.center - a.center));
  }
}

}  // namespace graze::detail
#endif
