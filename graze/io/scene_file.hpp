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
  std::string format;                           ///< "graze.scene/1", "csv", "tiled"
  YAxis y_axis = YAxis::up;                     ///< Down for Tiled maps, else up.
  std::vector<Omission> omissions;              ///< What was not read, in the order of first occurrence.
  std::vector<ObjectVelocity> velocities = {};  ///< Only of objects that have one.
  std::vector<std::string> warnings = {};       ///< Doubtful facts about the file, as sentences that name the place.
};

/// Reads a scene file: the library's JSON format, CSV, or a Tiled map in XML or JSON, distinguished by content, not by
/// name. Throws InputError.
GRAZE_EXPORT SceneFile read_scene(const std::filesystem::path& path);

/// Reads a scene from text. `source` names it in messages; relative references (Tiled's tilesets and templates) are
/// resolved from `folder`. Throws InputError.
GRAZE_EXPORT SceneFile parse_scene(std::string_view text, const std::string& source,
                                   const std::filesystem::path& folder);

}  // namespace graze::io
