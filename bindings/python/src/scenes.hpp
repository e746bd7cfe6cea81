// SPDX-License-Identifier: MIT
// Scenes and their snapshots as Python objects.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <ostream>
#include <shared_mutex>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include <graze/io/recorded_scene.hpp>
#include <graze/scene/object.hpp>
#include <graze/scene/scene.hpp>
#include <graze/scene/scene_query.hpp>
#include <graze/scene/scene_view.hpp>

#include "keys.hpp"
#include "module.hpp"

namespace graze::python {

/// The query log of a scene, in a file.
template <Dim N, class T>
class SceneLog {
 public:
  /// Throws OutputError if the file cannot be written, and what RecordedScene throws.
  SceneLog(const std::filesystem::path& path, Scene<N, T>& scene);

  /// The scene with its calls recorded.
  io::RecordedScene<N, T>& scene() { return scene_; }

  /// Throws OutputError if the calls before could not be written.
  void require_written() const;

  /// Throws OutputError if not all is written.
  void finish();

 private:
  std::filesystem::path path_;
  std::stringbuf start_;  ///< What precedes the file, which is not touched if the scene cannot be recorded.
  std::filebuf file_;
  std::ostream stream_;
  io::RecordedScene<N, T> scene_;
};

/// A scene that can write its calls to a log. It must not be moved while it does.
template <Dim N, class T>
struct LoggedScene {
  /// use(scene), of a Scene<N, T>, or of a RecordedScene<N, T> while there is a log. Throws OutputError if that could
  /// not be written.
  template <class Use>
  decltype(auto) visit(const Use& use) {
    if (!log) return use(scene);
    log->require_written();
    return use(log->scene());
  }

  /// The same for queries, which are answered even if their log cannot be written.
  template <class Use>
  decltype(auto) visit(const Use& use) const {
    return log ? use(std::as_const(log->scene())) : use(static_cast<const SceneView<N, T>&>(scene));
  }

  Scene<N, T> scene;
  std::unique_ptr<SceneLog<N, T>> log;
};

/// A scene of any world. Queries share a lock; a call that changes the scene has it alone.
struct HeldScene {
  InAnyWorld<LoggedScene> any;
  std::uint32_t owner = 0;  ///< That of all ids.
  std::unique_ptr<std::shared_mutex> lock = std::make_unique<std::shared_mutex>();
};

template <Dim N, class T>
using Snapshot = std::shared_ptr<const SceneView<N, T>>;

/// What Scene.snapshot returns. It never changes, so it needs no lock.
struct HeldView {
  InAnyWorld<Snapshot> any;
  std::uint32_t owner = 0;
};

template <>
struct BoxedName<HeldScene> {
  static constexpr auto name = py::detail::const_name("Scene");
};
template <>
struct BoxedName<HeldView> {
  static constexpr auto name = py::detail::const_name("SceneView");
};

template <Dim N, class T>
World world_of(const LoggedScene<N, T>& /*scene*/) {
  return In<N, T>::world;
}
template <Dim N, class T>
World world_of(const Snapshot<N, T>& /*snapshot*/) {
  return In<N, T>::world;
}

/// A new Python object with a scene that may already have objects.
template <Dim N, class T>
py::object python_scene(Scene<N, T> scene);

/// A shape as one of the scene's world. Throws ValueError for another dimension, TypeError for another dtype.
template <Dim N, class T>
const AnyShape<N, T>& shape_in_scene(std::string_view function, const HeldShape& shape) {
  return shape_in<N, T>(std::string(function) + ": shape is", shape, "the scene");
}

/// An id from Python.
inline ObjectId id_of(std::string_view function, py::handle value, std::uint32_t owner) {
  return unpacked<ObjectId>(packed_of({function, "id"}, value), owner);
}

/// A set of layers: None for all, a mask, or a sequence of names and numbers. Throws ValueError for a name that is not
/// among those of the scene.
LayerMask mask_of(Argument argument, py::handle value, const std::vector<std::string>& names);

/// Adds the queries that scenes and snapshots have in common.
void add_scene_queries(TypeMaker& scene, TypeMaker& view);

/// Draws the objects of a scene, and those of its pairs that touch, as SVG.
std::string svg_of(const HeldScene& scene);

}  // namespace graze::python
