// SPDX-License-Identifier: MIT
// The one door for scene files of every format.
#pragma once

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <graze/scene/scene.hpp>

namespace graze::io {

/// A scene from a file is in double, and its dimension is known when it has been read.
using AnyScene = std::variant<Scene<2, double>, Scene<3, double>>;

/// What a scene lacks because of an omission.
enum class Loss {
  none,       ///< No shape: what was not read has none, such as a custom property or a picture.
  precision,  ///< Every shape is there, but not exactly the one in the file.
  shape,      ///< A shape that could touch others is not in the scene.
};

/// Something that a file holds and graze did not read, or read only approximately: "text object", 3 times.
struct Omission {
  std::string what;  ///< Singular, as the rest of "not read: 3 x ...".
  std::size_t count = 0;
  Loss loss = Loss::none;
  std::string where = {};  ///< Where the first one is: "level.tmx, line 12"; empty when the format does not say.
  std::string why =
      {};  ///< Why it was not read, and the way out where there is one; empty when the format does not say.
};

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
};

/// Reads a scene file: our JSON, CSV of boxes, or a Tiled map in XML or JSON, told apart by content, not by name.
/// Throws InputError.
SceneFile read_scene(const std::filesystem::path& path);

/// The same from text that has been read already. `source` names it in messages; relative references (Tiled's tilesets
/// and templates) are looked up from `folder`. Throws InputError.
SceneFile parse_scene(std::string_view text, const std::string& source, const std::filesystem::path& folder);

}  // namespace graze::io
