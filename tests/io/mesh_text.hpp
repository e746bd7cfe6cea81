// SPDX-License-Identifier: MIT
// Common helpers of the tests of mesh files.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <rapidcheck.h>

#include <graze/io/mesh_file.hpp>

namespace graze::io {

using MeshPoints = std::vector<Vec<3, double>>;
using MeshFaces = std::vector<std::array<std::uint32_t, 3>>;

inline MeshPoints points_of(const Mesh<3, double>& mesh) { return {mesh.vertices().begin(), mesh.vertices().end()}; }
inline MeshFaces faces_of(const Mesh<3, double>& mesh) { return {mesh.faces().begin(), mesh.faces().end()}; }

/// The unit cube with quads cut into triangles; its faces run counter-clockwise as seen from outside.
inline Mesh<3, double> cube_mesh() {
  const MeshPoints points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const MeshFaces faces = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                           {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
  return mesh_of<3, double>(points, faces);
}

/// Parts with random triangles on random vertices, all of which are used. `Number`: what the coordinates fit in.
template <class Number>
std::vector<MeshPart> random_parts(std::size_t most) {
  std::vector<MeshPart> parts;
  const auto count = *rc::gen::inRange<std::size_t>(1, most + 1);
  for (std::size_t part = 0; part < count; ++part) {
    const auto triangles = *rc::gen::inRange<std::uint32_t>(1, 8);
    MeshPoints points;
    MeshFaces faces;
    for (std::uint32_t i = 0; i < triangles + 2; ++i) {
      Vec<3, double> point;
      for (Dim axis = 0; axis < 3; ++axis) {
        const double value = *rc::gen::arbitrary<double>();
        point[axis] = static_cast<double>(static_cast<Number>(value));
      }
      points.push_back(point);
      if (i >= 2) faces.push_back({i - 2, *rc::gen::inRange(0U, i), i});
      if (i == 2) faces.back()[1] = 1;
    }
    parts.push_back({"part " + std::to_string(part), mesh_of<3, double>(points, faces)});
  }
  return parts;
}

}  // namespace graze::io
