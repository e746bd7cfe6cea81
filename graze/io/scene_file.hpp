// SPDX-License-Identifier: MIT
// The one door for scene files of every format.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <graze/io/omission.hpp>
#include <graze/scene/scene.hpp>

namespace graze::io {

/// A scene from a file is in double, and its dimension is known when it has been read.
using AnyScene = std::variant<Scene<2, double>, Scene<3, double>>;

/// Which way y grows on a picture of a 2D scene.
enum class YAxis { up, down };

/// How an object moves, in units per second; z is 0 in 2D.
struct ObjectVelocity {
  ObjectId id;
  Vec<3, double> velocity;
};

/// A scene with what a file says around it.
struct SceneFile {
  AnyScene scene;
  std::string source;                           ///< The file's name as the user gave it, for messages and reports.
  std::string format;                           ///< "graze.scene/1", "csv", "tiled"
  YAxis y_axis = YAxis::up;                     ///< Tiled maps: down.
  std::vector<Omission> omissions;              ///< In the order of first appearance.
  std::vector<ObjectVelocity> velocities = {};  ///< Of the objects that have one.
  std::vector<std::string> warnings = {};       ///< What is doubtful about the file, in sentences that name the place.
};

/// Reads a scene file: our JSON, CSV, or a Tiled map in XML or JSON, told apart by content, not by name.
/// Throws InputError.
SceneFile read_scene(const std::filesystem::path& path);

/// The same from text that has been read already. `source` names it in messages; relative references (Tiled's tilesets
/// and templates) are looked up from `folder`. Throws InputError.
SceneFile parse_scene(std::string_view text, const std::string& source, const std::filesystem::path& folder);

}  // namespace graze::io
