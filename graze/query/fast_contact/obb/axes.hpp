// SPDX-License-Identifier: MIT
// Which of the fifteen axes of two oriented boxes may be the separating one: a test in float, four numbers at a time,
// that leaves one or two for the precise search of contact/boxes.hpp and usually decides the verdict, too.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <type_traits>

#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/contact/boxes.hpp>
#include <graze/query/relation/obb_filter.hpp>
#include <graze/query/verdict.hpp>
#include <graze/shape/obb.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// The result of testing two boxes. The axes are those that the search has to include; all of them if the test was not
/// conclusive.
struct ObbAxes {
  BoxesAxes candidates = all_boxes_axes<3>;
  Relation verdict = Relation::touching;  ///< Touching: too close to tell.
};

/// How far the axes are from orthonormal, as orthonormal_error in rotation.hpp.
[[gnu::always_inline]] inline float orthonormality_error_of(const LaneMatrix& axes) {
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

/// The gaps on the cross products of edges, column j for edge j of the second box; scaled by the products' lengths.
struct GapsAcross {
  LaneMatrix gaps;
  LaneMatrix squared_length;
  Lanes widest;
  Lanes least_squared;  ///< The least ((depth + band) / length)^2: deeper pairs of edges are irrelevant.
  LaneBits are_open;    ///< Where there may be a gap, for edges that are not nearly parallel.

  [[gnu::always_inline]] GapsAcross(const LanesFromBox& seen, float size, float orthonormality_error)
      : widest{-size, -size, -size, -size}, least_squared(widest * widest), are_open{0, 0, 0, 0} {
    const float band = static_cast<float>(tolerance::box_filter) * orthonormality_error * size;
    const float parallel = 2 * static_cast<float>(tolerance::box_filter) * orthonormality_error;
#pragma GCC unroll 3
    for (std::size_t j = 0; j < 3; ++j) {
      const Lanes gap = seen.gaps_across(j);
      const Lanes near = turned(seen.shadow.column[j]);
      const Lanes far = turned_back(seen.shadow.column[j]);
      const Lanes deepest = gap - band;  // positive only if the boxes are disjoint
      gaps.column[j] = gap;
      squared_length.column[j] = near * near + far * far;
      widest = larger(widest, gap);
      least_squared = smaller(deepest * deepest / squared_length.column[j], least_squared);
      are_open |= (gap >= -band) & (near + far >= parallel);
    }
  }

  /// Those whose gap may exceed a negative gap.
  [[gnu::always_inline]] LaneBits candidates(float least, float band) const {
    LaneBits result = {0, 0, 0, 0};
    LaneBits bits = {1 << 6, 1 << 9, 1 << 12, 0};
#pragma GCC unroll 3
    for (std::size_t j = 0; j < 3; ++j) {
      const Lanes short_by = gaps.column[j] + band;
      const Lanes squared = squared_length.column[j] * (1.001F * least * least);
      result |= ((short_by >= 0.0F) | (short_by * short_by <= squared)) & bits;
      bits *= 2;
    }
    return result;
  }
};

/// The axes whose gaps may be the widest, up to differences that a search treats as equal.
///
/// The gap on a face's axis is off by up to 7 skew of the size, that on a cross product of edges by 10, and its length
/// by 3: see filter_of_boxes. So the widest gap is at least that on any face less a band, and (g - band) / l of any
/// cross product of length l with the gap g: with w the largest of these, no face with a gap below w - band is the
/// widest, nor a cross product with g + band < (w - band) l. Differences that the search treats as equal are smaller
/// than the least band by a factor of ten thousand; the rest of a band covers the rounding of w.
[[gnu::always_inline]] inline ObbAxes axes_of(const LanesFromBox& seen, float orthonormality_error) {
  const Lanes reach_of_own = seen.box_half + combined(seen.shadow, seen.half);
  const Lanes distance_of_own = magnitude(seen.between);
  const float size = sum_of_three(distance_of_own + reach_of_own);
  // Squares of a band must not be close to the smallest numbers, nor those of a length close to the largest.
  if (!(size > 0x1p-30F && size < 0x1p30F)) return {};
  const float band = static_cast<float>(tolerance::box_filter) * orthonormality_error * size;
  const Lanes own = distance_of_own - reach_of_own;
  const LaneMatrix rows = transposed(seen.directions);
  const Lanes other = magnitude(combined(rows, seen.between)) - (seen.half + combined(magnitude(rows), seen.box_half));
  const float widest = largest_of_three(larger(own, other));
  if (widest > band) return {0, Relation::apart};

  const GapsAcross across(seen, size, orthonormality_error);
  const float least = std::max(widest - band, -std::sqrt(smallest_of_three(across.least_squared))) - band;
  const LaneBits candidates = ((own >= least) & LaneBits{1, 2, 4, 0}) | ((other >= least) & LaneBits{8, 16, 32, 0}) |
                              across.candidates(least, band);
  ObbAxes result;
  result.candidates = static_cast<BoxesAxes>(candidates[0] | candidates[1] | candidates[2]);
  const float widest_across = largest_of_three(across.widest);
  if (widest_across > band) {
    result.verdict = Relation::apart;
  } else if ((across.are_open[0] | across.are_open[1] | across.are_open[2]) == 0 && widest < -8 * band) {
    result.verdict = Relation::overlapping;
  }
  return result;
}

/// Three adjacent numbers of the fifteen of a box, and the one after them, which must belong to the box.
[[gnu::always_inline]] inline Lanes narrowed(const Obb<3, double>& box, std::size_t first) {
  using Four = double __attribute__((vector_size(32)));  // in two registers
  Four four;
  std::memcpy(&four, reinterpret_cast<const char*>(&box) + first * sizeof(double), sizeof(four));
  return __builtin_convertvector(four, Lanes);
}

[[gnu::always_inline]] inline LaneBox lane_box(const Obb<3, double>& box, const Vec<3, double>& center) {
  static_assert(sizeof(box) == 15 * sizeof(double) && std::is_trivially_copyable_v<Obb<3, double>>);
  const Lanes seen = {static_cast<float>(center.x), static_cast<float>(center.y), static_cast<float>(center.z), 0};
  return {seen, narrowed(box, 3), {narrowed(box, 6), narrowed(box, 9), arranged<1, 2, 3>(narrowed(box, 11))}};
}

[[gnu::always_inline]] inline ObbAxes axes_of_lanes(const LaneBox& a, const LaneBox& b) {
  const float orthonormality_error = std::max(orthonormality_error_of(a.axes), orthonormality_error_of(b.axes)) +
                                     tolerance::measured_orthonormality_error<float>;
  return axes_of(LanesFromBox(a, b), orthonormality_error);
}

template <class T>
[[gnu::always_inline]] inline ObbAxes axes_of(const Obb<3, T>& a, const Obb<3, T>& b) {
  if constexpr (std::is_same_v<T, float>) {
    return axes_of_lanes(LaneBox(a), LaneBox(b));
  } else {
    return axes_of_lanes(lane_box(a, Vec<3, double>(0.0)), lane_box(b, b.center - a.center));
  }
}

}  // namespace graze::detail
#endif
