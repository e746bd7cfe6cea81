// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include <graze/io/mesh_file.hpp>

namespace graze::io {

/// Reads the vertices and faces of OBJ. Each object (`o`), or in a file without objects each group (`g`), is a part
/// with the vertices that it uses. Points and lines are omitted, as are curves and free-form surfaces; materials and
/// normals do not matter. Throws InputError.
MeshFile read_obj(std::string_view text, const std::string& source);

}  // namespace graze::io
