// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>
#include <span>

#include <graze/io/mesh_file.hpp>

namespace graze::io {

/// Writes OFF as text: all parts as one mesh. Numbers read back bit for bit.
void write_off(std::ostream& out, std::span<const MeshPart> parts);

}  // namespace graze::io
