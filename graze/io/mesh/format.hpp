// SPDX-License-Identifier: MIT
// Tells mesh files apart by their content.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace graze::io {

/// The formats of mesh files. `gltf` is a JSON text, `glb` the same in a binary file.
enum class MeshFormat : std::uint8_t { stl_text, stl_binary, obj, ply, off, glb, gltf };

/// "stl", "obj", ...: the name of a format in reports, in the order of MeshFormat.
inline constexpr std::array<std::string_view, 7> mesh_format_names = {"stl", "stl",  "obj", "ply",
                                                                      "off", "gltf", "gltf"};

/// The format of a file, none if it is no mesh. JSON, which may hold a scene, is not decided here: see `is_gltf`.
/// Reading the whole file would be too slow: only its beginning is looked at.
std::optional<MeshFormat> mesh_format_of(std::string_view bytes);

/// "STL, OBJ, PLY, OFF and glTF (.gltf, .glb)": for messages.
inline constexpr std::string_view mesh_formats_in_words = "STL, OBJ, PLY, OFF and glTF 2.0 (.gltf, .glb)";

}  // namespace graze::io
