// SPDX-License-Identifier: MIT
// The ids in a saved scene, which make objects identifiable across saving and loading.
#pragma once

#include <vector>

#include <graze/io/json/fields.hpp>
#include <graze/scene/object.hpp>

namespace graze::io {

/// The arguments of Scene::plan_ids: the ids of the objects, in order, and the vacant ids. Both are empty for a scene
/// that was saved without ids.
struct SavedIds {
  std::vector<ObjectId> next;
  std::vector<ObjectId> vacant;
};

/// Reads "id" of all objects and "vacant_ids" of a scene. Throws InputError, naming the object, unless all objects have
/// ids or none has, and the indexes of all ids are 0, 1, ..., each once.
SavedIds read_saved_ids(const JsonFields& scene);

}  // namespace graze::io
