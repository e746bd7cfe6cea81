// SPDX-License-Identifier: MIT
// What the writers of mesh files have in common.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <graze/io/mesh_file.hpp>
#include <graze/math/vec.hpp>

namespace graze::io {

/// Vertices and faces of several meshes, one after the other.
struct JoinedMesh {
  std::vector<Vec<3, double>> vertices;
  std::vector<std::array<std::uint32_t, 3>> faces;
};

/// All parts as one mesh. Throws OutputError for more vertices than 32 bits count.
JoinedMesh joined(std::span<const MeshPart> parts);

/// A coordinate rounded to float; `format` names the format in messages. Throws OutputError if it is beyond the range
/// of floats.
float as_float(double coordinate, std::string_view format);

}  // namespace graze::io
