// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include <graze/io/mesh_file.hpp>

namespace graze::io {

/// Reads OFF as text, as one part without a name: its vertices, and its faces as triangles. Colours, normals and
/// texture coordinates, at the ends of lines, do not matter. Throws InputError.
MeshFile read_off(std::string_view text, const std::string& source);

}  // namespace graze::io
