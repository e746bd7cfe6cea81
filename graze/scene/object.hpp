// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>
#include <string>

#include <graze/math/vec.hpp>
#include <graze/scene/filter.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze {

/// Names an object of a scene for as long as it lives. The generation makes the id of a removed object an error
/// when it is used again, never another object. Ordered by index.
struct ObjectId {
  std::uint32_t index = 0;
  std::uint32_t generation = 0;

  friend auto operator<=>(const ObjectId&, const ObjectId&) = default;
};

/// What a caller may say about an object beside its shape.
struct ObjectOptions {
  std::string name = {};        ///< Unique in the scene, or empty for none.
  Layer layer = 0;              ///< The layer it is on.
  LayerMask mask = all_layers;  ///< The layers it can touch.
  std::uint64_t user = 0;       ///< The caller's own; graze does not look at it.
};

/// An object of a scene.
template <Dim N, class T = float>
struct Object {
  AnyShape<N, T> shape;
  Aabb<N, T> box;  ///< bounds(shape)
  std::string name;
  Layer layer;
  LayerMask mask;
  std::uint64_t user;
};

}  // namespace graze
