// SPDX-License-Identifier: MIT
// How far sixteen boxes or triangles reach along a direction.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include <graze/math/lanes/sixteen.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/parts/box_block.hpp>
#include <graze/shape/parts/triangle_block.hpp>

#ifdef GRAZE_HAS_LANES

namespace graze::detail {

template <Dim N, class T>
struct LaneDirection {
  Vec<N, T> direction;
  T offset;                                                  ///< Added to every reach, with a margin for rounding.
  std::array<std::size_t, static_cast<std::size_t>(N)> far;  ///< The sides of a box that lie farthest.
};

template <Dim N, class T>
LaneDirection<N, T> lane_direction(const Vec<N, T>& direction, T offset) {
  LaneDirection<N, T> result{direction, offset, {}};
  for (Dim i = 0; i < N; ++i) {
    const auto k = static_cast<std::size_t>(i);
    result.far[k] = direction[i] < 0 ? k : k + static_cast<std::size_t>(N);
  }
  return result;
}

/// Writes minus the reach of each box. Returns the lanes where it is above `least`.
template <Dim N, class T>
LaneMask lanes_beyond(const BoxBlock<N, T>& block, const LaneDirection<N, T>& along, T least, Row<T>& keys) {
  return lanes_set_by<T>([&](auto& group) __attribute__((always_inline)) {
    using Numbers = NumbersOf<decltype(group)>;
    Numbers reach = Numbers{} + along.offset;
    for (Dim i = 0; i < N; ++i) {
      Numbers side;
      group.read(block.sides[along.far[static_cast<std::size_t>(i)]], side);
      reach += side * along.direction[i];
    }
    group.write(-reach, keys);
    group.flags = ~(reach <= least);
  });
}

/// The same for triangles.
template <Dim N, class T>
LaneMask lanes_beyond(const TriangleBlock<N, T>& triangles, const LaneDirection<N, T>& along, T least, Row<T>& keys) {
  return lanes_set_by<T>([&](auto& group) __attribute__((always_inline)) {
    using Numbers = NumbersOf<decltype(group)>;
    Numbers most = Numbers{} - std::numeric_limits<T>::infinity();
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Numbers reach = Numbers{} + along.offset;
      for (Dim i = 0; i < N; ++i) {
        Numbers coordinate;
        group.read(triangles.corners[corner][static_cast<std::size_t>(i)], coordinate);
        reach += coordinate * along.direction[i];
      }
      make_larger(most, reach);
    }
    group.write(-most, keys);
    group.flags = ~(most <= least);
  });
}

}  // namespace graze::detail

#endif
