// SPDX-License-Identifier: MIT
// Scenes and snapshots behind handles.
#pragma once

#include <memory>
#include <utility>
#include <variant>

#include <graze/scene/scene.hpp>

#include "../graze.h"
#include "handles.hpp"
#include "results.hpp"
#include "world.hpp"

namespace graze::c {

/// A scene, or a snapshot, which has only a view.
template <Dim N, class T>
struct SceneOrSnapshot {
  std::shared_ptr<Scene<N, T>> scene;
  std::shared_ptr<const SceneView<N, T>> view;
};

struct HeldScene {
  InAnyWorld<SceneOrSnapshot> any;
};

HandleTable<const HeldScene>& scenes();

/// Gives a scene a handle.
template <Dim N, class T>
graze_scene scene_out(Scene<N, T> scene) {
  auto shared = std::make_shared<Scene<N, T>>(std::move(scene));
  const SceneOrSnapshot<N, T> held{shared, shared};
  return {scenes().add(std::make_shared<const HeldScene>(HeldScene{held}))};
}

/// Calls use(SceneView) for the scene or snapshot of a handle.
template <class Use>
auto on_view(graze_scene scene, const Use& use) {
  const std::shared_ptr<const HeldScene> held = scenes().find(scene.handle);
  return std::visit([&](const auto& of_world) { return use(*of_world.view); }, held->any);
}

/// Calls use(Scene). Throws Error for a snapshot.
template <class Use>
auto on_scene(graze_scene scene, const Use& use) {
  const std::shared_ptr<const HeldScene> held = scenes().find(scene.handle);
  return std::visit(
      [&](const auto& of_world) {
        if (of_world.scene == nullptr) {
          throw Error(GRAZE_INVALID_ARGUMENT, "the scene is a snapshot, which has queries only");
        }
        return use(*of_world.scene);
      },
      held->any);
}

// ---- Ids

inline ObjectId id_in(graze_id id) { return {id.index, id.generation, id.owner}; }

inline graze_id c_result(const ObjectId& id) { return {id.index, id.generation, id.owner}; }

inline graze_id_pair c_result(const ObjectPair& pair) { return {c_result(pair.a), c_result(pair.b)}; }

// ---- Answers

template <Dim N, class T>
graze_object_hit c_result(const ObjectHit<N, T>& found) {
  return {c_result(found.id), c_result(found.hit)};
}
template <Dim N, class T>
graze_object_impact c_result(const ObjectImpact<N, T>& found) {
  return {c_result(found.id), c_result(found.impact)};
}
template <Dim N, class T>
graze_object_touch c_result(const ObjectTouch<N, T>& found) {
  return {c_result(found.id), c_result(found.manifold)};
}
template <Dim N, class T>
graze_object_contact c_result(const ObjectContact<N, T>& found) {
  return {c_result(found.pair), c_result(found.manifold)};
}
template <class T>
graze_near_object c_result(const NearObject<T>& found) {
  return {c_result(found.id), static_cast<double>(found.distance)};
}
template <class T>
graze_near_pair c_result(const NearPair<T>& found) {
  return {c_result(found.pair), static_cast<double>(found.distance)};
}

/// For buffers.
inline constexpr auto found_in_c = [](const auto& found) { return c_result(found); };

}  // namespace graze::c
