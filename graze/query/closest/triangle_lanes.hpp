// SPDX-License-Identifier: MIT
// How far a point is from sixteen triangles: at least and at most.
#pragma once

#include <cstddef>
#include <limits>
#include <type_traits>

#include <graze/math/lanes/lane_vec.hpp>
#include <graze/math/lanes/sixteen.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/parts/triangle_block.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

/// A point, and how far away a triangle may be from where the point sees it.
template <class T>
struct LanePoint {
  Vec<3, T> point;
  T error;
  bool is_moderate;  ///< Whether no product of a few lengths overflows.
};

/// For triangles in a box.
template <class T>
LanePoint<T> lane_point(const Vec<3, T>& point, const Aabb<3, T>& around, double error) {
  constexpr T most = std::is_same_v<T, float> ? T(0x1p30) : T(0x1p250);
  const bool is_moderate = max_abs(point) < most && max_abs(around.min) < most && max_abs(around.max) < most;
  return {point, round_up<T>(2 * error), is_moderate};
}

/// Of the squared distances so far and that of an edge, the lesser. `seen` leads from the point to the edge's start.
template <class V>
[[gnu::always_inline]] inline void add_edge(const LaneVec<V>& seen, const LaneVec<V>& edge, V& squared) {
  V along;
  V length;
  V to_edge;
  dot_of(seen, edge, along);
  dot_of(edge, edge, length);
  V share = {};
  make_larger(share, -along / length);  // 0 of an edge without length
  make_smaller(share, V{} + 1);
  const LaneVec<V> nearest = {seen.x + share * edge.x, seen.y + share * edge.y, seen.z + share * edge.z};
  dot_of(nearest, nearest, to_edge);
  make_smaller(squared, to_edge);
}

/// How far the point is on the outer side of an edge, or minus how far on the inner side: the greatest so far.
template <class V>
[[gnu::always_inline]] inline void add_outside(const LaneVec<V>& seen, const LaneVec<V>& edge, const LaneVec<V>& normal,
                                               V& outside) {
  LaneVec<V> inward;
  V side;
  cross_of(normal, edge, inward);
  dot_of(seen, inward, side);
  make_larger(outside, side);
}

/// Bounds on the squared distance of each triangle; for NaN, 0 and the largest number.
template <class T>
struct alignas(64) SquaredDistances {
  Row<T> least;
  Row<T> most;
};

/// Writes these bounds, and returns the lanes where the lower one is not above `limit`.
///
/// If the point is outside of an edge by more than rounding, the nearest edge is as far as the triangle; else the plane
/// is never farther. If it is inside of all edges by more than rounding, the plane is as far; else the nearest edge is
/// never nearer. What is subtracted and added is above the rounding errors: of a point on an edge, a few epsilon of the
/// way to it; of the normal, a few epsilon of the squared edges; and of squares that vanish.
template <class T>
// NOLINTNEXTLINE(readability-function-size): one kernel
LaneMask find_squared_distances(const TriangleBlock<3, T>& triangles, const LanePoint<T>& from, T limit,
                                SquaredDistances<T>& squared) {
  constexpr T largest = std::numeric_limits<T>::max();
  if (!from.is_moderate) {
    squared.least = {};
    squared.most.fill(largest);
    return first_lanes(row_length);
  }
  return lanes_set_by<T>([&](auto& group) __attribute__((always_inline)) {
    using Group = std::remove_reference_t<decltype(group)>;
    using Numbers = typename Group::Numbers;
    LaneVec<Numbers> a;
    LaneVec<Numbers> b;
    LaneVec<Numbers> c;
    read_vec(group, triangles.corners[0], a);
    read_vec(group, triangles.corners[1], b);
    read_vec(group, triangles.corners[2], c);
    LaneVec<Numbers> to_b;
    LaneVec<Numbers> to_c;
    LaneVec<Numbers> back;
    subtract(b, a, to_b);
    subtract(c, b, to_c);
    subtract(a, c, back);
    LaneVec<Numbers> normal;
    cross_of(to_b, to_c, normal);
    subtract(a, from.point, a);
    subtract(b, from.point, b);
    subtract(c, from.point, c);
    Numbers to_edges = Numbers{} + largest;
    add_edge(a, to_b, to_edges);
    add_edge(b, to_c, to_edges);
    add_edge(c, back, to_edges);
    Numbers outside = Numbers{} - largest;
    add_outside(a, to_b, normal, outside);
    add_outside(b, to_c, normal, outside);
    add_outside(c, back, normal, outside);

    constexpr T few = 8 * std::numeric_limits<T>::epsilon();
    Numbers first;  // edge
    Numbers second;
    Numbers reach;
    sum_magnitudes<Group>(to_b, first);
    sum_magnitudes<Group>(to_c, second);
    sum_magnitudes<Group>(a, reach);
    reach += first + second;
    const Numbers of_normal = few * first * second;  // its error
    Numbers height;
    Numbers length;
    dot_of(a, normal, height);
    sum_magnitudes<Group>(normal, length);
    Numbers whole;
    dot_of(normal, normal, whole);
    make_positive<Group>(height);
    // No less than the least normal numbers, so that no quotient of others leaves the range.
    const Numbers least = Numbers{} + std::numeric_limits<T>::min() * T(0x1p26);
    const Numbers of_height = reach * of_normal;
    const Numbers of_whole = of_normal * (2 * length + of_normal);
    Numbers low = height - of_height;
    make_larger(low, Numbers{});
    Numbers high_whole = whole + of_whole;
    make_larger(high_whole, least);
    const Numbers high = height + of_height;
    Numbers low_whole = whole - of_whole;
    make_larger(low_whole, least);

    const Numbers unclear = (first + second) * reach * (of_normal + few * length) + least;
    const Numbers margin = 2 * reach * (few * reach + from.error);
    const Numbers at_least = (outside > unclear ? to_edges : low / high_whole * low) - margin;
    const Numbers at_most = (-outside > unclear ? high / low_whole * high : to_edges) + margin + least;
    Numbers low_result = {};
    make_larger(low_result, at_least);
    make_smaller(low_result, Numbers{} + largest);
    Numbers high_result = Numbers{} + largest;
    make_smaller(high_result, at_most);
    group.write(low_result, squared.least);
    group.write(high_result, squared.most);
    group.flags = ~(low_result > limit);
  });
}

}  // namespace graze::detail

#endif
