// SPDX-License-Identifier: MIT
// The triangle meshes of bench/mesh.cpp: made here, or read from a file.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <graze/math/vec.hpp>

namespace mesh_bench {

using Point = graze::Vec<3, float>;
using Face = std::array<std::uint32_t, 3>;

struct Surface {
  std::string name;
  std::vector<Point> vertices;
  std::vector<Face> faces;
};

/// A closed, star-shaped surface of about this many faces, 8 n^2 of them: the faces of an octahedron, each divided into
/// n^2, pushed out to a unit sphere and displaced by noise, the finest of which is as fine as the faces. Always the
/// same for the same number.
Surface potato(std::size_t faces);

/// The triangles of an OFF, STL, PLY or OBJ file, by CGAL's readers; polygons become fans. Equal points are merged, as
/// STL has no indices. Throws std::runtime_error if the file cannot be read or has no face.
Surface surface_of_file(const std::string& path);

}  // namespace mesh_bench
