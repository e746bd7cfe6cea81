// SPDX-License-Identifier: MIT
// Codes that sort boxes so that those of every cell of an Orthtree are consecutive.
#pragma once

#include <cmath>
#include <cstdint>

#include <graze/broad/orthtree/place.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>

namespace graze::detail {

/// A box by its index, and the number of the cell of a fine grid that contains its center. The grid is `levels` below
/// the root and numbered level by level as by child_towards, so sorting by code makes the boxes of every cell
/// consecutive (Morton 1966).
struct CodedBox {
  std::uint32_t index;
  std::uint32_t code;
};

/// The number of levels below the root that a code distinguishes.
template <Dim N>
inline constexpr int code_levels = 32 / N;

/// Spreads the lowest bits of a number, leaving gaps between them for the bits of the other axes.
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

/// Maps a point to the numbers of its fine cell: (point - center) * cells_per_unit + middle, clamped to 0 and `last`. A
/// root that is a point, or too small for T, has one cell only.
template <Dim N, class T>
struct CodeScale {
  explicit CodeScale(const CellPosition<N>& root) {
    const double cells = std::ldexp(1.0, code_levels<N>);
    cells_per_unit = static_cast<T>(cells / 2 / root.half);
    if (!std::isfinite(cells_per_unit)) cells_per_unit = T(0);
    for (Dim i = 0; i < N; ++i) center[i] = static_cast<T>(root.center[i]);
    middle = static_cast<T>(cells / 2);
    last = static_cast<T>(cells - 1);
  }

  Vec<N, T> center;
  T cells_per_unit;
  T middle;  ///< The number of the center along each axis.
  T last;
};

/// Clamps to the range of fine cells; 0 for NaN, which a point that is not finite may give.
template <Dim N, class T>
std::uint32_t fine_cell(T along, const CodeScale<N, T>& scale) {
  const T positive = along > T(0) ? along : T(0);
  return static_cast<std::uint32_t>(positive < scale.last ? positive : scale.last);
}

template <Dim N, class T>
std::uint32_t code_of(const Vec<N, T>& point, const CodeScale<N, T>& scale) {
  std::uint32_t code = 0;
  for (Dim i = 0; i < N; ++i) {
    const T along = (point[i] - scale.center[i]) * scale.cells_per_unit + scale.middle;
    code |= spread_bits<N>(fine_cell(along, scale)) << static_cast<unsigned>(i);
  }
  return code;
}

/// The path from the root to the fine cell around a point, as the cell's numbers along the axes: the highest bits
/// select the child of the root, the next ones the child of that, and so on.
template <Dim N>
class CellWay {
 public:
  /// The path to the center of a box, up to rounding.
  template <class T>
  static CellWay to_middle(const Aabb<N, T>& box, const CodeScale<N, T>& scale) {
    CellWay way;
    for (Dim i = 0; i < N; ++i) {  // a short dependency chain, because everything else waits for it
      const T twice = (box.min[i] - scale.center[i]) + (box.max[i] - scale.center[i]);
      way.numbers_[i] = fine_cell(twice * (scale.cells_per_unit * T(0.5)) + scale.middle, scale);
    }
    return way;
  }

  /// The number of the next child on the path; 0 below the fine cell.
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
