// SPDX-License-Identifier: MIT
// Scenes and their snapshots as Python objects.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <shared_mutex>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include <graze/scene/object.hpp>
#include <graze/scene/scene.hpp>
#include <graze/scene/scene_query.hpp>
#include <graze/scene/scene_view.hpp>

#include "keys.hpp"
#include "module.hpp"

namespace graze::python {

/// A scene of any world. Queries share a lock; a call that changes the scene has it alone.
struct HeldScene {
  InAnyWorld<Scene> any;
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
World world_of(const Scene<N, T>& /*scene*/) {
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
const AnyShape<N, T>& shape_in(const char* function, const HeldShape& shape) {
  if (const auto* const any = std::get_if<AnyShape<N, T>>(&shape.any)) return *any;
  const std::string facts = fmt::format("{}: shape is {}, the scene in {}D of {}", function, described(shape), N,
                                        name_of_numbers(In<N, T>::world));
  if (world_of(shape).dimension != N) throw py::value_error(facts);
  throw py::type_error(facts + ": use astype");
}

/// An id from Python.
inline ObjectId id_of(std::string_view function, py::handle value, std::uint32_t owner) {
  return unpacked<ObjectId>(packed_of({function, "id"}, value), owner);
}

/// A set of layers: None for all, a mask, or a sequence of names and numbers. Throws ValueError for a name that is not
/// among those of the scene.
LayerMask mask_of(const char* function, py::handle value, const std::vector<std::string>& names);

/// Adds the queries that scenes and snapshots have in common.
void add_scene_queries(TypeMaker& scene, TypeMaker& view);

/// Draws the objects of a scene, and those of its pairs that touch, as SVG.
std::string svg_of(const HeldScene& scene);

}  // namespace graze::python
