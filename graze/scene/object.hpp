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

/// As many objects a scene can hold; its index holds no more.
inline constexpr std::uint32_t max_objects = std::uint32_t{1} << 29U;

/// Names an object of a scene for as long as it lives. The id of an object that was removed, one that another scene
/// gave out, and one made by default are errors when they are used, never another object. Ordered by index, which is a
/// place that is used again. Copies and snapshots of a scene answer to the ids of the original. Of ids given out after
/// they part each is to be asked about its own alone: it cannot tell the other's from them.
struct ObjectId {
  std::uint32_t index = 0;
  std::uint32_t generation = 0;  ///< Odd in every id that is given out.
  std::uint32_t owner = 0;       ///< Tells the ids of one scene from those of others. Says nothing else.

  friend auto operator<=>(const ObjectId&, const ObjectId&) = default;
};

/// Two objects of a scene, that of the lower index as `a`.
struct ObjectPair {
  ObjectId a;
  ObjectId b;

  friend auto operator<=>(const ObjectPair&, const ObjectPair&) = default;
};

/// Whether an object goes about.
enum class Mobility : std::uint8_t {
  moving,
  fixed,  ///< Part of the world: two fixed objects are never a pair. It may be moved all the same.
};

/// What a caller may say about an object beside its shape.
struct ObjectOptions {
  std::string name = {};                 ///< Unique in the scene, or empty for none.
  Layer layer = 0;                       ///< The layer it is on.
  LayerMask mask = all_layers;           ///< The layers it can touch.
  std::uint64_t user = 0;                ///< The caller's own; graze does not look at it.
  Mobility mobility = Mobility::moving;  ///< Whether it can be a pair with what is fixed.
};

/// An object of a scene. What a move writes comes first: of a shape that is small, all of it in a cache line or two.
template <Dim N, class T = float>
struct Object {
  Aabb<N, T> box;  ///< bounds(shape)
  AnyShape<N, T> shape;
  std::string name;
  Layer layer;
  Mobility mobility;
  LayerMask mask;
  std::uint64_t user;
};

namespace detail {

/// What decides with whom an object may be a pair.
struct PairFilter {
  LayerMask mask = all_layers;
  Layer layer = 0;
  Mobility mobility = Mobility::moving;

  /// Whether it may be a pair with all that admit it.
  bool admits_all() const { return mask == all_layers && mobility == Mobility::moving; }
};

inline bool may_touch(const PairFilter& a, const PairFilter& b) {
  if (a.mobility == Mobility::fixed && b.mobility == Mobility::fixed) return false;
  return filters_admit(a.layer, a.mask, b.layer, b.mask);
}

template <Dim N, class T>
PairFilter filter_of(const Object<N, T>& object) {
  return {object.mask, object.layer, object.mobility};
}

/// The box of an object that touching_bounds grows by enough.
template <Dim N, class T>
Aabb<N, T> sized_box(const Object<N, T>& object) {
  return sized_box(object.shape, object.box);
}

}  // namespace detail

/// touching_bounds of an object's shape, whose box is at hand.
template <Dim N, class T>
Aabb<N, T> touching_bounds(const Object<N, T>& object) {
  return touching_bounds(detail::sized_box(object));
}

/// Whether two objects are asked about at all: both masks admit the other's layer, and not both are fixed.
template <Dim N, class T>
bool may_touch(const Object<N, T>& a, const Object<N, T>& b) {
  return detail::may_touch(detail::filter_of(a), detail::filter_of(b));
}

}  // namespace graze
