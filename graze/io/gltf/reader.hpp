// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include <graze/io/json/document.hpp>
#include <graze/io/mesh_file.hpp>

namespace graze::io {

/// Reads glTF 2.0 from a document: one part for each node of the scene that shows a mesh, in the order of the tree.
/// `binary` is the chunk of a .glb, and buffers in files lie in `folder` or below. Throws InputError, also for required
/// extensions that change the shape, such as Draco's compression.
MeshFile read_gltf(const JsonDocument& document, std::optional<std::string_view> binary,
                   const std::filesystem::path& folder);

/// Reads a .glb, which begins with "glTF". Throws InputError.
MeshFile read_glb_file(std::string_view bytes, const std::string& source, const std::filesystem::path& folder);

}  // namespace graze::io
