// SPDX-License-Identifier: MIT
// Meshes to test with: boxes, rings, bumpy balls, hulls.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include <rapidcheck.h>

#include <graze/math/vec.hpp>
#include <graze/shape/aabb.hpp>
#include <graze/shape/hull/faces.hpp>
#include <graze/shape/mesh.hpp>
#include <graze/shape/polytope.hpp>

#include "catalogue/numbers.hpp"

namespace graze::test {

using MeshFace = std::array<std::uint32_t, 3>;

/// The surface of a box: corner i has the upper coordinate j if bit j of i is set.
template <class T>
Mesh<3, T> box_mesh(const Aabb<3, T>& box, MeshKind kind = MeshKind::solid) {
  std::vector<Vec<3, T>> corners(8);
  for (std::size_t i = 0; i < 8; ++i) {
    for (Dim j = 0; j < 3; ++j) corners[i][j] = (i >> static_cast<std::size_t>(j) & 1U) != 0 ? box.max[j] : box.min[j];
  }
  const std::array<MeshFace, 12> faces = {{{0, 2, 1},
                                           {1, 2, 3},
                                           {4, 5, 6},
                                           {5, 7, 6},
                                           {0, 1, 4},
                                           {1, 5, 4},
                                           {2, 6, 3},
                                           {3, 6, 7},
                                           {0, 4, 2},
                                           {2, 4, 6},
                                           {1, 3, 5},
                                           {3, 7, 5}}};
  return mesh_of<3, T>(corners, faces, kind);
}

/// Rows of quads, the last next to the first in both directions: point(i, j) of `rows` times `columns`.
template <class T, class Point>
Mesh<3, T> closed_grid(std::uint32_t rows, std::uint32_t columns, MeshKind kind, const Point& point) {
  std::vector<Vec<3, T>> vertices;
  std::vector<MeshFace> faces;
  for (std::uint32_t i = 0; i < rows; ++i) {
    for (std::uint32_t j = 0; j < columns; ++j) {
      vertices.push_back(Vec<3, T>(point(i, j)));
      const std::uint32_t next_i = (i + 1) % rows;
      const std::uint32_t next_j = (j + 1) % columns;
      const std::array<std::uint32_t, 4> at = {i * columns + j, next_i * columns + j, next_i * columns + next_j,
                                               i * columns + next_j};
      faces.push_back({at[0], at[1], at[2]});
      faces.push_back({at[0], at[2], at[3]});
    }
  }
  return mesh_of<3, T>(vertices, faces, kind);
}

/// A ring around the z axis: of radius 2, its tube of radius 0.5.
template <class T>
Mesh<3, T> ring_mesh(std::uint32_t around, std::uint32_t across, MeshKind kind = MeshKind::solid) {
  return closed_grid<T>(around, across, kind, [&](std::uint32_t i, std::uint32_t j) {
    const double angle = 2 * std::numbers::pi * i / around;
    const double turn = 2 * std::numbers::pi * j / across;
    const double radius = 2 + 0.5 * std::cos(turn);
    return Vec<3, double>(radius * std::cos(angle), radius * std::sin(angle), 0.5 * std::sin(turn));
  });
}

/// All coordinates between -size and size.
template <class T>
Vec<3, T> point_in_cube(rc::Random& random, T size) {
  Vec<3, T> point;
  for (Dim i = 0; i < 3; ++i) point[i] = size * static_cast<T>(between(random, -1, 1));
  return point;
}

/// A ball whose vertices are at random distances, from 0.7 to 1.3, from the origin: not convex, and all of it is seen
/// from there.
template <class T>
Mesh<3, T> bumpy_ball(std::uint32_t rows, std::uint32_t columns, rc::Random random, MeshKind kind = MeshKind::solid) {
  const auto noise = [&random] { return between(random, 0.7, 1.3); };
  std::vector<Vec<3, T>> vertices = {Vec<3, T>(Vec<3, double>(0, 0, 1) * noise())};
  std::vector<MeshFace> faces;
  for (std::uint32_t i = 1; i < rows; ++i) {
    const double polar = std::numbers::pi * i / rows;
    for (std::uint32_t j = 0; j < columns; ++j) {
      const double angle = 2 * std::numbers::pi * j / columns;
      vertices.push_back(Vec<3, T>(
          Vec<3, double>(std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle), std::cos(polar)) *
          noise()));
    }
  }
  vertices.push_back(Vec<3, T>(Vec<3, double>(0, 0, -1) * noise()));
  const auto last = static_cast<std::uint32_t>(vertices.size() - 1);
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return 1 + (i - 1) * columns + j % columns; };
  for (std::uint32_t j = 0; j < columns; ++j) {
    faces.push_back({0, at(1, j), at(1, j + 1)});
    for (std::uint32_t i = 1; i + 1 < rows; ++i) {
      faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
    faces.push_back({last, at(rows - 1, j + 1), at(rows - 1, j)});
  }
  return mesh_of<3, T>(vertices, faces, kind);
}

/// The surface of a convex hull that is not flat.
template <class T>
Mesh<3, T> hull_mesh(const Polytope<3, T>& hull, MeshKind kind = MeshKind::solid) {
  std::vector<MeshFace> faces;
  for (const auto& face : detail::hull_faces<T>(hull.vertices())) faces.push_back({face[0], face[1], face[2]});
  return mesh_of<3, T>(hull.vertices(), faces, kind);
}

}  // namespace graze::test
