// SPDX-License-Identifier: MIT
/// @file
/// Converts scenes between number types.
#pragma once

#include <string>
#include <vector>

#include <graze/io/shape_numbers.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/scene.hpp>

namespace graze::io {

/// A scene with the same objects, whose shapes are converted to another number type: exactly if it is the larger one,
/// otherwise rounded. Indices and generations of ids, vacant ones included, names, layers, masks, user values and
/// excepted pairs are kept; owners of ids are not, and the new scene has had no update. Files hold numbers in double,
/// so this is how a float scene is saved and restored exactly. Throws std::invalid_argument, naming the fault, if a
/// rounded shape is invalid.
template <Scalar To, Dim N, class From>
Scene<N, To> scene_with_numbers(const Scene<N, From>& scene) {
  Scene<N, To> result;
  const std::vector<ObjectId> ids = scene.ids();
  const std::vector<ObjectId> vacant = scene.vacant_ids();
  if (!ids.empty() || !vacant.empty()) result.plan_ids(ids, vacant);
  for (const std::string& name : scene.layer_names()) result.layer(name);
  for (const ObjectId& id : ids) {
    const Object<N, From>& object = scene.object(id);
    result.add(with_numbers<To, N, From>(object.shape),
               {object.name, object.layer, object.mask, object.user, object.mobility});
  }
  for (const auto& [a, b] : scene.excepted_pairs()) {
    result.except(*result.find(a.index, a.generation), *result.find(b.index, b.generation));
  }
  return result;
}

}  // namespace graze::io
