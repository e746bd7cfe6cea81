// SPDX-License-Identifier: MIT
// flat_vertices(hull): the corners of the hull of 3D points that are coplanar, collinear or coincident.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include <graze/math/orientation.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/hull/frame.hpp>
#include <graze/shape/hull/lexicographic.hpp>
#include <graze/shape/hull/monotone_chain.hpp>
#include <graze/shape/hull/quickhull.hpp>

namespace graze::detail {

/// The corners of the hull of collinear or coincident points.
template <class T>
std::vector<std::uint32_t> ends_of_line(const Quickhull<T>& hull) {
  const std::array<std::uint32_t, 2> ends = hull.frame().ends();
  if (hull.base().size() == 1) return {ends[0]};
  return {ends[0], ends[1]};
}

/// The corners of the hull of coplanar points, in order around it.
template <class T>
std::vector<std::uint32_t> corners_of_polygon(const Quickhull<T>& hull) {
  const HullFrame<T>& frame = hull.frame();
  Dim axis = 0;
  const auto shadow = [&](std::uint32_t i) {
    const Vec<3, T>& point = frame.point(i);
    return Vec<2, T>(point[(axis + 1) % 3], point[(axis + 2) % 3]);
  };
  const auto base = hull.base();
  while (orientation(shadow(base[0]), shadow(base[1]), shadow(base[2])) == 0) ++axis;
  std::vector<std::uint32_t> order(frame.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return lexicographically_less<2, T>(shadow(a), shadow(b)); });
  const auto are_equal = [&](std::uint32_t a, std::uint32_t b) { return shadow(a) == shadow(b); };
  order.erase(std::unique(order.begin(), order.end(), are_equal), order.end());
  return monotone_chain(order, shadow);
}

/// The corners of a hull without volume; of a polygon in order around it.
template <class T>
std::vector<std::uint32_t> flat_vertices(const Quickhull<T>& hull) {
  return hull.base().size() == 3 ? corners_of_polygon(hull) : ends_of_line(hull);
}

}  // namespace graze::detail
