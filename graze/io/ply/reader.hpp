// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include <graze/io/mesh_file.hpp>

namespace graze::io {

/// Reads PLY as text or binary in either byte order, as one part without a name: x, y and z of `vertex`, the list
/// `vertex_indices` (or `vertex_index`) of `face`, and that of `tristrips`, where -1 begins a new strip. Other
/// properties do not matter, other elements are omitted. Throws InputError.
MeshFile read_ply(std::string_view bytes, const std::string& source);

}  // namespace graze::io
