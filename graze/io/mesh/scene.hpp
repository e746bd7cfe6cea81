// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <graze/io/mesh_file.hpp>
#include <graze/io/scene_file.hpp>
#include <graze/math/platform/export.hpp>

namespace graze::io {

/// A scene with an object for each part, in the same order. Names that occur twice get a number: "bolt", "bolt-2".
/// Parts without a name are called by their place: "#3".
GRAZE_EXPORT SceneFile scene_of_meshes(MeshFile file);

}  // namespace graze::io
