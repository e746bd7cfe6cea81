// SPDX-License-Identifier: MIT
// Where boxes stand when those of every cell of an Orthtree are to stand in a row.
#pragma once

#include <cmath>
#include <cstdint>

#include <graze/broad/orthtree/place.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// A box by its place among all, and the number of the cell of a fine grid that its center is in: `levels` below the
/// root, numbered level by level as child_towards does, so that the boxes of every cell between stand in a row when
/// they are sorted by it (Morton 1966).
struct CodedBox {
  std::uint32_t index;
  std::uint32_t code;
};

/// How many levels below the root a code tells apart.
template <Dim N>
inline constexpr int code_levels = 32 / N;

/// Spreads the lowest bits of a number, so that between two of them there is room for those of the other axes.
template <Dim N>
std::uint32_t spread_bits(std::uint32_t bits) {
  if constexpr (N == 2) {
    bits = (bits | bits << 8U) & 0x00FF'00FFU;
    bits = (bits | bits << 4U) & 0x0F0F'0F0FU;
    bits = (bits | bits << 2U) & 0x3333'3333U;
    return (bits | bits << 1U) & 0x5555'5555U;
  } else {
    bits = (bits | bits << 16U) & 0x0300'00FFU;
    bits = (bits | bits << 8U) & 0x0300'F00FU;
    bits = (bits | bits << 4U) & 0x030C'30C3U;
    return (bits | bits << 2U) & 0x0924'9249U;
  }
}

/// How a point becomes the numbers of the fine cell around it: (point - center) * cells_per_unit + middle, cut off
/// below 0 and above `last`. A root that is a point, or too small for T, has one cell only.
template <Dim N, class T>
struct CodeScale {
  explicit CodeScale(const CellPlace<N>& root) {
    const double cells = std::ldexp(1.0, code_levels<N>);
    cells_per_unit = static_cast<T>(cells / 2 / root.half);
    if (!std::isfinite(cells_per_unit)) cells_per_unit = T(0);
    for (Dim i = 0; i < N; ++i) center[i] = static_cast<T>(root.center[i]);
    middle = static_cast<T>(cells / 2);
    last = static_cast<T>(cells - 1);
  }

  Vec<N, T> center;
  T cells_per_unit;
  T middle;  ///< The number that the center has along each axis.
  T last;
};

/// Cuts off what is beyond the fine cells; 0 for NaN, which a point that is not finite may give.
template <Dim N, class T>
std::uint32_t fine_cell(T along, const CodeScale<N, T>& scale) {
  const T positive = along > T(0) ? along : T(0);
  return static_cast<std::uint32_t>(positive < scale.last ? positive : scale.last);
}

/// The code of a point.
template <Dim N, class T>
std::uint32_t code_of(const Vec<N, T>& point, const CodeScale<N, T>& scale) {
  std::uint32_t code = 0;
  for (Dim i = 0; i < N; ++i) {
    const T along = (point[i] - scale.center[i]) * scale.cells_per_unit + scale.middle;
    code |= spread_bits<N>(fine_cell(along, scale)) << static_cast<unsigned>(i);
  }
  return code;
}

/// The way from the root down to the fine cell around a point, by its numbers along the axes: of which the highest bits
/// say which child of the root it is in, the next ones which child of that, and so on.
template <Dim N>
class CellWay {
 public:
  /// To the middle of a box, give or take some rounding.
  template <class T>
  static CellWay to_middle(const Aabb<N, T>& box, const CodeScale<N, T>& scale) {
    CellWay way;
    for (Dim i = 0; i < N; ++i) {  // in as few steps as can be, one after the other: all else waits for them
      const T twice = (box.min[i] - scale.center[i]) + (box.max[i] - scale.center[i]);
      way.numbers_[i] = fine_cell(twice * (scale.cells_per_unit * T(0.5)) + scale.middle, scale);
    }
    return way;
  }

  /// The number of the next child on the way; 0 below the fine cell.
  std::uint32_t next() {
    std::uint32_t child = 0;
    for (Dim i = 0; i < N; ++i) {
      child |= (numbers_[i] >> (code_levels<N> - 1) & 1U) << static_cast<unsigned>(i);
      numbers_[i] <<= 1U;
    }
    return child;
  }

 private:
  std::uint32_t numbers_[N];
};

}  // namespace graze::detail
