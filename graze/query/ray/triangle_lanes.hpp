// SPDX-License-Identifier: MIT
// Which of sixteen triangles a ray may meet. Include ray_cast.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>

#include <graze/math/lanes/lane_vec.hpp>
#include <graze/math/lanes/sixteen.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/parts/triangle_block.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// The line of a ray, and how far beside it a triangle may be and still count as met.
template <class T>
struct LaneLine {
  Vec<3, T> origin;
  Vec<3, T> direction;
  T band_of_edges;   ///< To be multiplied by the sum of a triangle's edges.
  T least_band;      ///< To be added.
  bool is_moderate;  ///< Whether no product overflows.
};

/// For triangles that are within `size` of the origin, the sum of the coordinates, and at most `error` away from where
/// the ray sees them.
template <class T>
LaneLine<T> lane_line(const Vec<3, double>& origin, const Vec<3, double>& direction, double size, double error) {
  constexpr double epsilon = std::numeric_limits<T>::epsilon();
  constexpr double relative = tolerance::ray_edges<T> + 2 * epsilon + 4 * tolerance::box_slack;
  constexpr double most = std::is_same_v<T, float> ? 0x1p40 : 0x1p300;
  constexpr double no_product_underflows = 0x1p26 * static_cast<double>(std::numeric_limits<T>::min());
  const Vec<3, T> start(origin);
  const double off = error + max_abs(wide<3, T>(start) - origin);
  const double slope = sum_abs(direction);
  return {start, Vec<3, T>(direction), round_up<T>(slope * (relative * size + 2 * off)),
          round_up<T>(4 * slope * (size + off) * off + std::max(1.0, slope) * no_product_underflows),
          size < most && slope < most};
}

/// Adds an edge and the side of it on which the line passes, as in RayTriangleFilter: to the least and the greatest.
template <class Group, class T, class V>
// NOLINTNEXTLINE(readability-function-size): vectors in and out
[[gnu::always_inline]] inline void add_side(const LaneVec<V>& corner, const LaneVec<V>& next, const LaneLine<T>& line,
                                            V& least, V& most, V& edges) {
  LaneVec<V> edge;
  LaneVec<V> seen;
  LaneVec<V> across;
  V length;
  V side;
  subtract(next, corner, edge);
  subtract(corner, line.origin, seen);
  sum_magnitudes<Group>(edge, length);
  edges += length;
  cross_of(seen, edge, across);
  dot_of(across, line.direction, side);
  make_smaller(least, side);
  make_larger(most, side);
}

/// The lanes of the triangles that the line does not pass on both sides by more than the band.
template <class T>
LaneMask met_lanes(const TriangleBlock<3, T>& triangles, const LaneLine<T>& line) {
  if (!line.is_moderate) return first_lanes(row_length);
  return lanes_set_by<T>([&](auto& group) __attribute__((always_inline)) {
    using Group = std::remove_reference_t<decltype(group)>;
    using Numbers = typename Group::Numbers;
    LaneVec<Numbers> a;
    LaneVec<Numbers> b;
    LaneVec<Numbers> c;
    read_vec(group, triangles.corners[0], a);
    read_vec(group, triangles.corners[1], b);
    read_vec(group, triangles.corners[2], c);
    Numbers least = {};
    Numbers most = {};
    Numbers edges = {};
    add_side<Group>(a, b, line, least, most, edges);
    add_side<Group>(b, c, line, least, most, edges);
    add_side<Group>(c, a, line, least, most, edges);
    const Numbers band = edges * line.band_of_edges + line.least_band;
    make_smaller(most, -least);
    group.flags = ~(most > band);
  });
}

}  // namespace graze::detail

#endif
