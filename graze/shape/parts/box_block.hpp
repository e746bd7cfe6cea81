// SPDX-License-Identifier: MIT
// Sixteen boxes side by side, and questions to all of them at once: which overlap another, how far they are from it,
// where a path enters them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <graze/math/lanes/sixteen.hpp>
#include <graze/math/rounding.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// One row for each coordinate of the corners. Default: not set.
template <Dim N, class T>
struct alignas(64) BoxBlock {
  /// The least coordinates, then the greatest.
  std::array<Row<T>, 2 * static_cast<std::size_t>(N)> sides;

  /// Boxes that contain nothing.
  static BoxBlock nothing() {
    BoxBlock block;
    for (Dim i = 0; i < N; ++i) {
      block.min_row(i).fill(std::numeric_limits<T>::infinity());
      block.max_row(i).fill(-std::numeric_limits<T>::infinity());
    }
    return block;
  }

  Row<T>& min_row(Dim axis) { return sides[static_cast<std::size_t>(axis)]; }
  Row<T>& max_row(Dim axis) { return sides[static_cast<std::size_t>(N) + static_cast<std::size_t>(axis)]; }
  const Row<T>& min_row(Dim axis) const { return sides[static_cast<std::size_t>(axis)]; }
  const Row<T>& max_row(Dim axis) const { return sides[static_cast<std::size_t>(N) + static_cast<std::size_t>(axis)]; }

  Aabb<N, T> box(std::size_t lane) const {
    Aabb<N, T> result;
    for (Dim i = 0; i < N; ++i) {
      result.min[i] = min_row(i)[lane];
      result.max[i] = max_row(i)[lane];
    }
    return result;
  }

  void set(std::size_t lane, const Aabb<N, T>& box) {
    for (Dim i = 0; i < N; ++i) {
      min_row(i)[lane] = box.min[i];
      max_row(i)[lane] = box.max[i];
    }
  }

  /// The box around all.
  Aabb<N, T> around() const {
    Aabb<N, T> result;
    for (Dim i = 0; i < N; ++i) {
      result.min[i] = least_of(min_row(i));
      result.max[i] = greatest_of(max_row(i));
    }
    return result;
  }
};

#ifdef GRAZE_HAS_LANES

// All calculate in T, with or without fused operations, and lean to the safe side by more than their rounding error.

/// Relative to the largest of the products and sums in a kernel.
template <class T>
inline constexpr T lane_slack = 8 * std::numeric_limits<T>::epsilon();

/// The lanes whose boxes overlap another. Those of NaN do.
template <Dim N, class T>
LaneMask overlapping_lanes(const BoxBlock<N, T>& block, const Aabb<N, T>& box) {
  return lanes_set_by<T>([&](auto& group) __attribute__((always_inline)) {
    using Numbers = NumbersOf<decltype(group)>;
    // One comparison of the widest gap: GCC 12 compares lane by lane where flags are combined.
    Numbers gap = Numbers{} - 1;
    for (Dim i = 0; i < N; ++i) {
      Numbers low;
      Numbers high;
      group.read(block.min_row(i), low);
      group.read(block.max_row(i), high);
      make_larger(gap, low - box.max[i]);
      make_larger(gap, box.min[i] - high);
    }
    group.flags = ~(gap > 0);
  });
}

/// The lanes whose boxes overlap another by at least so much along every axis, before and behind; writes keys, which
/// are negative and the lower the more they overlap. Those of NaN do.
template <Dim N, class T>
LaneMask overlapping_lanes(const BoxBlock<N, T>& block, const Aabb<N, T>& box, T least, Row<T>& keys) {
  return lanes_set_by<T>([&](auto& group) __attribute__((always_inline)) {
    using Numbers = NumbersOf<decltype(group)>;
    Numbers overlap = Numbers{} + std::numeric_limits<T>::max();
    for (Dim i = 0; i < N; ++i) {
      Numbers low;
      Numbers high;
      group.read(block.min_row(i), low);
      group.read(block.max_row(i), high);
      make_smaller(overlap, high - box.min[i]);
      make_smaller(overlap, box.max[i] - low);
    }
    group.write(-overlap, keys);
    group.flags = ~(overlap < least);
  });
}

/// A path that enters boxes.
template <Dim N, class T>
struct LanePath {
  Vec<N, T> origin;
  Vec<N, T> inverse;  ///< Of the direction's coordinates.
  Vec<N, T> slack;    ///< How much earlier it may enter between two sides, and how much later leave.
  std::array<std::size_t, static_cast<std::size_t>(N)> near;  ///< The sides that it meets first, and last.
  std::array<std::size_t, static_cast<std::size_t>(N)> far;
};

/// The lanes whose boxes a path meets up to `end`, and where it enters them, or before. Those of NaN do.
template <Dim N, class T>
LaneMask entered_lanes(const BoxBlock<N, T>& block, const LanePath<N, T>& path, T end, Row<T>& entries) {
  return lanes_set_by<T>([&](auto& group) __attribute__((always_inline)) {
    using Numbers = NumbersOf<decltype(group)>;
    Numbers enter = {};
    Numbers leave = Numbers{} + end;
    for (Dim i = 0; i < N; ++i) {
      Numbers near;
      Numbers far;
      group.read(block.sides[path.near[static_cast<std::size_t>(i)]], near);
      group.read(block.sides[path.far[static_cast<std::size_t>(i)]], far);
      make_larger(enter, (near - path.origin[i]) * path.inverse[i] - path.slack[i]);
      make_smaller(leave, (far - path.origin[i]) * path.inverse[i] + path.slack[i]);
    }
    group.write(enter, entries);
    group.flags = enter <= leave;
  });
}

/// The place at which boxes are seen: columns of a rotation and their magnitudes, a position.
template <Dim N, class T>
struct LanePlace {
  Mat<N, T> rotation;
  Vec<N, T> position;
  T slack;  ///< By which the moved boxes grow.
};

/// For boxes in `around`.
template <Dim N, class T>
LanePlace<N, T> lane_place(const Mat<N, T>& rotation, const Vec<N, T>& position, const Aabb<N, T>& around) {
  T largest = 1;
  for (Dim j = 0; j < N; ++j) largest = std::max(largest, max_abs(rotation[j]));
  const T reach = largest * std::max(max_abs(around.min), max_abs(around.max));
  const T size = T(2 * N) * reach + max_abs(position);
  constexpr T relative = 4 * (lane_slack<T> + static_cast<T>(tolerance::box_slack));
  return {rotation, position, relative * size + 16 * std::numeric_limits<T>::denorm_min()};
}

/// Boxes around those of a block at another place.
template <Dim N, class T>
void place_lanes(const BoxBlock<N, T>& block, const LanePlace<N, T>& place, BoxBlock<N, T>& placed) {
  lanes_set_by<T>([&](auto& group) __attribute__((always_inline)) {
    using Numbers = NumbersOf<decltype(group)>;
    Numbers center[static_cast<std::size_t>(N)];
    Numbers reach[static_cast<std::size_t>(N)];
    for (Dim j = 0; j < N; ++j) {
      Numbers low;
      Numbers high;
      group.read(block.min_row(j), low);
      group.read(block.max_row(j), high);
      center[j] = low * T(0.5) + high * T(0.5);
      reach[j] = high * T(0.5) - low * T(0.5);
    }
    for (Dim i = 0; i < N; ++i) {
      Numbers middle = Numbers{} + place.position[i];
      Numbers size = Numbers{} + place.slack;
      for (Dim j = 0; j < N; ++j) {
        const T factor = place.rotation[j][i];
        middle += center[j] * factor;
        size += reach[j] * (factor < 0 ? -factor : factor);
      }
      group.write(middle - size, placed.min_row(i));
      group.write(middle + size, placed.max_row(i));
    }
  });
}

#endif

/// The lanes whose boxes overlap another, and perhaps some that contain nothing.
template <Dim N, class T>
LaneMask lanes_that_overlap(const BoxBlock<N, T>& block, const Aabb<N, T>& box) {
#ifdef GRAZE_HAS_LANES
  return overlapping_lanes(block, box);
#else
  LaneMask mask = 0;
  for (std::size_t lane = 0; lane < row_length; ++lane) {
    mask |= (boxes_overlap(block.box(lane), box) ? LaneMask{1} : LaneMask{0}) << lane;
  }
  return mask;
#endif
}

/// Writes at most the squared distance of each box from another: the largest finite number if the square overflows, 0
/// for NaN. Returns the lanes where it is not above `most`.
template <Dim N, class T>
LaneMask squared_distances(const BoxBlock<N, T>& block, const Aabb<N, T>& box, T most, Row<T>& squared) {
#ifdef GRAZE_HAS_LANES
  return lanes_set_by<T>([&](auto& group) __attribute__((always_inline)) {
    using Numbers = NumbersOf<decltype(group)>;
    Numbers sum = {};
    for (Dim i = 0; i < N; ++i) {
      Numbers low;
      Numbers high;
      group.read(block.min_row(i), low);
      group.read(block.max_row(i), high);
      Numbers gap = low - box.max[i];
      make_larger(gap, box.min[i] - high);
      make_larger(gap, Numbers{});
      sum += gap * gap;
    }
    sum *= 1 - lane_slack<T>;
    make_smaller(sum, Numbers{} + std::numeric_limits<T>::max());
    Numbers result = {};
    make_larger(result, sum);
    group.write(result, squared);
    group.flags = ~(result > most);
  });
#else
  LaneMask mask = 0;
  for (std::size_t lane = 0; lane < row_length; ++lane) {
    const Aabb<N, T> other = block.box(lane);
    double sum = 0;
    for (Dim i = 0; i < N; ++i) {
      const double gap = std::max(static_cast<double>(other.min[i]) - static_cast<double>(box.max[i]),
                                  static_cast<double>(box.min[i]) - static_cast<double>(other.max[i]));
      sum += gap > 0 ? gap * gap : 0;
    }
    sum *= 1 - 8 * std::numeric_limits<double>::epsilon();
    squared[lane] = round_down<T>(std::min(sum, static_cast<double>(std::numeric_limits<T>::max())));
    mask |= (squared[lane] > most ? LaneMask{0} : LaneMask{1}) << lane;
  }
  return mask;
#endif
}

}  // namespace graze::detail
