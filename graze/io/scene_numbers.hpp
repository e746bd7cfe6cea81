// SPDX-License-Identifier: MIT
// Scenes of one number type as scenes of another.
#pragma once

#include <string>
#include <vector>

#include <graze/io/shape_numbers.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/scene.hpp>

namespace graze::io {

/// A scene with the same objects, whose shapes have numbers of another type: exactly the same ones where that type is
/// the larger one, else rounded. Indexes and generations of ids, of those that are vacant too, names, layers, masks and
/// what the user keeps stay as they are; owners of ids do not, and nothing was updated yet. As files hold numbers in
/// double, this is how a scene in float is saved, and how it comes back as it was. Throws std::invalid_argument, naming
/// the fact, where a rounded shape is not valid any more.
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
  return result;
}

}  // namespace graze::io
