// SPDX-License-Identifier: MIT
// The ids in a saved scene: so that an object is the same object after it was read.
#pragma once

#include <vector>

#include <graze/io/json/fields.hpp>
#include <graze/scene/object.hpp>

namespace graze::io {

/// What Scene::plan_ids takes: the ids of the objects, in their order, and of the places that are free. Both are
/// empty for a scene that was not saved with its ids.
struct SavedIds {
  std::vector<ObjectId> next;
  std::vector<ObjectId> vacant;
};

/// Reads "id" of all objects and "vacant_ids" of a scene. Throws InputError, naming the object, unless all objects have
/// ids or none, and the indexes of all ids are 0, 1, ..., each once.
SavedIds read_saved_ids(const JsonFields& scene);

}  // namespace graze::io
