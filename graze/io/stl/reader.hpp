// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include <graze/io/mesh_file.hpp>

namespace graze::io {

/// Reads STL as text: one part for each `solid`. Normals are not used: the order of the corners gives the side. Equal
/// corners of a part are welded. Throws InputError.
MeshFile read_stl_text(std::string_view text, const std::string& source);

/// Reads binary STL: one part, named by the header unless that is not text. Equal corners are welded. Throws InputError
/// if the file is shorter than its header says; if it is longer, there is a warning.
MeshFile read_stl_binary(std::string_view bytes, const std::string& source);

}  // namespace graze::io
