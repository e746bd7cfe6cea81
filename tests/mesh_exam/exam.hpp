// SPDX-License-Identifier: MIT
// Asks graze about a mesh, and CGAL's exact kernel about the same numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "exact_mesh.hpp"

namespace graze::mesh_exam {

struct Settings {
  std::size_t rays = 200;
  std::size_t points = 100;
  std::size_t places = 2;           ///< Of a second mesh.
  std::size_t most_faces = 50'000;  ///< A larger mesh is not compared with copies and itself.
  std::uint64_t seed = 1;
};

/// The numbers of answers that were compared, and what was wrong.
struct Tally {
  std::size_t rays = 0;
  std::size_t hits = 0;
  std::size_t distances = 0;
  std::size_t winding_numbers = 0;
  std::size_t inside = 0;
  std::size_t pairs = 0;
  std::size_t own_pairs = 0;
  double hit_error = 0;       ///< The largest, in epsilon of T times the largest coordinate.
  double distance_error = 0;  ///< Likewise.
  std::vector<std::string> faults;
};

/// All questions to one mesh, with coordinates rounded to T: float or double.
template <class T>
Tally examine(std::span<const Point> vertices, std::span<const Face> faces, const Settings& settings);

}  // namespace graze::mesh_exam
