// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>
#include <span>

#include <graze/io/mesh_file.hpp>

namespace graze::io {

/// Writes OBJ with an object (`o`) for each part. Numbers read back bit for bit.
void write_obj(std::ostream& out, std::span<const MeshPart> parts);

}  // namespace graze::io
