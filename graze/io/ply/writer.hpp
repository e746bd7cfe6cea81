// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>
#include <span>

#include <graze/io/mesh_file.hpp>

namespace graze::io {

/// Writes PLY in little-endian bytes: all parts as one mesh, coordinates as doubles. Throws OutputError for more
/// vertices than 32 bits count.
void write_ply(std::ostream& out, std::span<const MeshPart> parts);

}  // namespace graze::io
