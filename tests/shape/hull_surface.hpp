// SPDX-License-Identifier: MIT
// Whether triangles are the surface of a convex hull, exactly.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <graze/math/orientation_3d.hpp>
#include <graze/math/vec.hpp>
#include <graze/shape/hull/faces.hpp>

namespace graze::test {

inline std::set<std::uint32_t> corners_of(const std::vector<detail::HullTriangle>& faces) {
  std::set<std::uint32_t> corners;
  for (const detail::HullTriangle& face : faces) corners.insert(face.begin(), face.end());
  return corners;
}

/// A closed surface with no point outside of any of its triangles is that of the hull, if it is not empty.
template <class T>
bool is_hull_of(const std::vector<detail::HullTriangle>& faces, const std::vector<Vec<3, T>>& points) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const detail::HullTriangle& face : faces) {
    for (std::size_t i = 0; i < 3; ++i) ++edges[{face[i], face[(i + 1) % 3]}];
    if (detail::are_on_one_line(points[face[0]], points[face[1]], points[face[2]])) return false;
    for (const Vec<3, T>& point : points) {
      if (orientation(points[face[0]], points[face[1]], points[face[2]], point) > 0) return false;
    }
  }
  for (const auto& [edge, count] : edges) {
    if (count != 1 || edges.count({edge.second, edge.first}) != 1) return false;
  }
  return faces.size() == 2 * corners_of(faces).size() - 4;  // Euler
}

}  // namespace graze::test
