// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include "surface.hpp"

namespace mesh_bench {
namespace {

using Corner = CGAL::Simple_cartesian<double>::Point_3;

/// Adds each point once, rounded to float. Returns the index of each corner's vertex.
std::vector<std::uint32_t> add_vertices(const std::vector<Corner>& corners, Surface& surface) {
  std::map<std::array<float, 3>, std::uint32_t> numbers;
  std::vector<std::uint32_t> merged;
  for (const Corner& corner : corners) {
    const std::array<float, 3> place{static_cast<float>(corner.x()), static_cast<float>(corner.y()),
                                     static_cast<float>(corner.z())};
    const auto [found, is_new] = numbers.try_emplace(place, static_cast<std::uint32_t>(surface.vertices.size()));
    if (is_new) surface.vertices.push_back({place[0], place[1], place[2]});
    merged.push_back(found->second);
  }
  return merged;
}

}  // namespace

Surface surface_of_file(const std::string& path) {
  std::vector<Corner> corners;
  std::vector<std::vector<std::size_t>> polygons;
  if (!CGAL::IO::read_polygon_soup(path, corners, polygons) || polygons.empty()) {
    throw std::runtime_error(path + ": cannot be read as OFF, STL, PLY or OBJ, or has no face");
  }
  Surface surface;
  surface.name = std::filesystem::path(path).filename().string();
  const std::vector<std::uint32_t> merged = add_vertices(corners, surface);
  for (const std::vector<std::size_t>& polygon : polygons) {
    for (const std::size_t corner : polygon) {
      if (corner < merged.size()) continue;
      throw std::runtime_error(path + ": face " + std::to_string(&polygon - polygons.data()) + " has vertex " +
                               std::to_string(corner) + ", but there are " + std::to_string(merged.size()));
    }
    for (std::size_t k = 2; k < polygon.size(); ++k) {
      surface.faces.push_back({merged[polygon[0]], merged[polygon[k - 1]], merged[polygon[k]]});
    }
  }
  return surface;
}

}  // namespace mesh_bench
