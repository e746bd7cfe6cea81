// SPDX-License-Identifier: MIT
// extreme_points(points): selects the farthest points along a fixed fan of directions. A volume that bounds them nearly
// bounds all.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>

#include <graze/math/vec.hpp>

namespace graze::detail {

/// The dot products of a vector with the fan's directions: in 2D the axes and the diagonals, in 3D the axes and the
/// diagonals of the cube. Larsson and Källberg, "Fast computation of tight-fitting oriented bounding boxes" (2011), use
/// these seven.
inline std::array<double, 4> fan_heights(const Vec<2, double>& v) { return {v.x, v.y, v.x + v.y, v.x - v.y}; }

inline std::array<double, 7> fan_heights(const Vec<3, double>& v) {
  return {v.x, v.y, v.z, v.x + v.y + v.z, v.x + v.y - v.z, v.x - v.y + v.z, v.x - v.y - v.z};
}

/// The number of directions.
template <Dim N>
inline constexpr std::size_t fan_size = N == 2 ? 4 : 7;

/// The indices of the lowest and the highest point along each direction of the fan, up to rounding; the first of equal
/// ones. An index may appear twice. At least one point.
template <Dim N, class T>
std::array<std::size_t, 2 * fan_size<N>> extreme_points(std::span<const Vec<N, T>> points) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<std::size_t, 2 * fan_size<N>> indices{};
  std::array<double, fan_size<N>> lowest;
  std::array<double, fan_size<N>> highest;
  lowest.fill(infinity);
  highest.fill(-infinity);
  const Vec<N, double> origin = wide<N, T>(points.front());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::array<double, fan_size<N>> heights = fan_heights(wide<N, T>(points[i]) - origin);
    for (std::size_t k = 0; k < heights.size(); ++k) {
      if (heights[k] < lowest[k]) {
        lowest[k] = heights[k];
        indices[2 * k] = i;
      }
      if (heights[k] > highest[k]) {
        highest[k] = heights[k];
        indices[2 * k + 1] = i;
      }
    }
  }
  return indices;
}

}  // namespace graze::detail
