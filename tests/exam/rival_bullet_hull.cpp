// SPDX-License-Identifier: MIT
#include <cstddef>
#include <optional>
#include <vector>

#include <LinearMath/btConvexHullComputer.h>

#include <graze/math/vec.hpp>

#include "exam/rival.hpp"

namespace graze::exam {

std::optional<std::vector<std::size_t>> bullet_corners(const std::vector<Vec<3, double>>& points) {
  std::vector<double> coordinates;
  for (const Vec<3, double>& point : points) {
    for (Dim i = 0; i < 3; ++i) coordinates.push_back(point[i]);
  }
  btConvexHullComputer computer;
  computer.compute(coordinates.data(), static_cast<int>(3 * sizeof(double)), static_cast<int>(points.size()), 0, 0);
  std::vector<std::size_t> places;
  for (int i = 0; i < computer.original_vertex_index.size(); ++i)
    places.push_back(static_cast<std::size_t>(computer.original_vertex_index[i]));
  if (places.empty()) return std::nullopt;
  return places;
}

}  // namespace graze::exam
