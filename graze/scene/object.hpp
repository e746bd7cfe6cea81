// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>
#include <string>

#include <graze/math/vec.hpp>
#include <graze/query/bounds.hpp>
#include <graze/scene/filter.hpp>
#include <graze/shape/any_shape.hpp>

namespace graze {

/// The largest number of objects in a scene, limited by its index.
inline constexpr std::uint32_t max_objects = std::uint32_t{1} << 29U;

/// Names an object of a scene during its lifetime. Using the id of a removed object, of another scene, or a default one
/// is an error and never means another object. Ordered by index; indices are reused. Copies and snapshots of a scene
/// accept the ids of the original. Ids given out after the copy are valid only for the scene that gave them out, which
/// cannot be detected.
struct ObjectId {
  std::uint32_t index = 0;       ///< Position of the object; reused after it is removed.
  std::uint32_t generation = 0;  ///< Odd in every id that is given out.
  std::uint32_t owner = 0;       ///< Distinguishes the ids of different scenes; has no other meaning.

  friend auto operator<=>(const ObjectId&, const ObjectId&) = default;
};

/// Two objects of a scene, the one with the lower index as `a`.
struct ObjectPair {
  ObjectId a;  ///< The lower index.
  ObjectId b;  ///< The higher index.

  friend auto operator<=>(const ObjectPair&, const ObjectPair&) = default;
};

/// Whether an object moves during the simulation.
enum class Mobility : std::uint8_t {
  moving,  ///< Can be a pair with any object.
  fixed,   ///< Part of the world: two fixed objects are never a pair. It can still be moved.
};

/// Properties of an object beside its shape.
struct ObjectOptions {
  std::string name = {};                 ///< Unique in the scene, or empty for none.
  Layer layer = 0;                       ///< The layer it is on.
  LayerMask mask = all_layers;           ///< The layers it can touch.
  std::uint64_t user = 0;                ///< For the caller; the library does not use it.
  Mobility mobility = Mobility::moving;  ///< Whether it can be a pair with fixed objects.
};

/// An object of a scene. The members that a move writes come first, so that for a small shape they fill one or two
/// cache lines.
template <Dim N, class T = float>
struct Object {
  Aabb<N, T> box;        ///< bounds(shape).
  AnyShape<N, T> shape;  ///< Where it is now.
  std::string name;      ///< Unique in the scene, or empty.
  Layer layer;           ///< The layer that it is on.
  Mobility mobility;     ///< Whether it can be a pair with fixed objects.
  LayerMask mask;        ///< The layers that it can touch.
  std::uint64_t user;    ///< For the caller; the library does not use it.
};

namespace detail {

/// The properties that decide which pairs an object can be in.
struct PairFilter {
  LayerMask mask = all_layers;
  Layer layer = 0;
  Mobility mobility = Mobility::moving;
  bool has_exceptions = false;  ///< It is in an excepted pair.

  /// True if it can be a pair with every object that admits it.
  bool admits_all() const { return mask == all_layers && mobility == Mobility::moving && !has_exceptions; }
};

/// By layers, masks and mobility; excepted pairs are not considered.
inline bool may_touch(const PairFilter& a, const PairFilter& b) {
  if (a.mobility == Mobility::fixed && b.mobility == Mobility::fixed) return false;
  return filters_admit(a.layer, a.mask, b.layer, b.mask);
}

template <Dim N, class T>
PairFilter filter_of(const Object<N, T>& object) {
  return {object.mask, object.layer, object.mobility, false};
}

/// The object's box, ready for touching_bounds to grow.
template <Dim N, class T>
Aabb<N, T> sized_box(const Object<N, T>& object) {
  return sized_box(object.shape, object.box);
}

}  // namespace detail

/// touching_bounds of an object's shape, from its stored box.
template <Dim N, class T>
Aabb<N, T> touching_bounds(const Object<N, T>& object) {
  return touching_bounds(detail::sized_box(object));
}

/// True if two objects can be a pair: both masks contain the other's layer, and not both are fixed. Other pairs are
/// never tested, nor are those that Scene::except names, which are not considered here.
template <Dim N, class T>
bool may_touch(const Object<N, T>& a, const Object<N, T>& b) {
  return detail::may_touch(detail::filter_of(a), detail::filter_of(b));
}

}  // namespace graze
