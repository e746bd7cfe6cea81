// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>
#include <span>

#include <graze/io/mesh_file.hpp>

namespace graze::io {

/// Writes glTF 2.0 in its binary container: a node for each part. Parts that share triangles are instances of one mesh.
/// Coordinates are rounded to float. Throws OutputError for coordinates beyond the range of floats, and for more than
/// 4 GiB.
void write_glb(std::ostream& out, std::span<const MeshPart> parts);

}  // namespace graze::io
