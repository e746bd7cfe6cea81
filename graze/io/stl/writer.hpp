// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>
#include <span>

#include <graze/io/mesh_file.hpp>

namespace graze::io {

/// Writes binary STL: the faces of all parts, with normals of length 1, zero for flat faces. The header is the name if
/// there is one part and its name fits. Coordinates are rounded to float. Throws OutputError for coordinates beyond the
/// range of floats, and for more faces than 32 bits count.
void write_stl(std::ostream& out, std::span<const MeshPart> parts);

}  // namespace graze::io
