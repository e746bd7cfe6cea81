// SPDX-License-Identifier: MIT
/// @file
/// Reads scene files of every format.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <graze/io/omission.hpp>
#include <graze/math/platform/export.hpp>
#include <graze/scene/scene.hpp>
#include <graze/shape/mesh.hpp>

namespace graze::io {

/// A scene from a file: in double, its dimension known only at run time.
using AnyScene = std::variant<Scene<2, double>, Scene<3, double>>;

/// The direction in which y grows on a picture of a 2D scene.
enum class YAxis { up, down };

/// The velocity of an object, in units per second.
struct ObjectVelocity {
  ObjectId id;              ///< Names the object.
  Vec<3, double> velocity;  ///< z is 0 in 2D.
};

/// A scene and the other contents of its file.
struct SceneFile {
  AnyScene scene;                               ///< Not updated yet.
  std::string source;                           ///< The file's name as the user gave it, for messages and reports.
  std::string format;                           ///< "graze.scene/1", "csv", "tiled", "stl", "obj", "ply", "off", "gltf"
  YAxis y_axis = YAxis::up;                     ///< Down for Tiled maps, else up.
  std::vector<Omission> omissions;              ///< What was not read, in the order of first occurrence.
  std::vector<ObjectVelocity> velocities = {};  ///< Only of objects that have one.
  std::vector<std::string> warnings = {};       ///< Doubtful facts about the file, as sentences that name the place.
};

/// How a scene file is read.
struct SceneReading {
  /// What the meshes of a mesh file become. `solid`: those that are closed; see make_closed_parts_solid in
  /// io/mesh_file.hpp.
  MeshKind meshes = MeshKind::surface;
};

/// Reads a scene file: the library's JSON format, CSV, a Tiled map in XML or JSON, or a mesh file, whose parts are the
/// objects (io/mesh_file.hpp). Formats are distinguished by content, not by name. Throws InputError.
GRAZE_EXPORT SceneFile read_scene(const std::filesystem::path& path, const SceneReading& reading = {});

/// Reads a scene from the bytes of a file. `source` names it in messages; relative references (Tiled's tilesets and
/// templates, mesh files, buffers of glTF) are resolved from `folder`. Throws InputError.
GRAZE_EXPORT SceneFile parse_scene(std::string_view text, const std::string& source,
                                   const std::filesystem::path& folder, const SceneReading& reading = {});

}  // namespace graze::io
