// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include <graze/query/cast_options.hpp>
#include <graze/scene/filter.hpp>
#include <graze/scene/object.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/fields/description.hpp>

namespace graze {

/// Which objects a query of a scene may find: those on some layers that are not excepted and that a predicate accepts;
/// by default all. Rays and moving shapes pass through the others.
struct SceneQuery {
  /// The layers of the objects.
  LayerMask layers = all_layers;
  /// Objects to leave out. Ids that name no object are ignored. Every candidate is compared with each of them; for many
  /// ids use the predicate.
  std::span<const ObjectId> except = {};
  /// True for the objects that may be found; if it is empty, all may. A query calls it for some objects, in any order,
  /// perhaps more than once. It may query the scene but must not change it. What it throws reaches the caller.
  std::function<bool(ObjectId)> predicate = {};
  /// For `shape_cast` and `shape_cast_all`: what the shape touches at the start, and does not approach, does not stop
  /// it, as CastOptions::ignore_initial_touch describes. Other queries do not use it.
  bool ignore_initial_touch = false;
};

namespace detail {

/// How a query casts a shape.
inline CastOptions cast_options(const SceneQuery& query) {
  return {.ignore_initial_touch = query.ignore_initial_touch};
}

/// Whether a query may find an object on a layer.
inline bool admits(const SceneQuery& query, const ObjectId& id, Layer layer) {
  if ((query.layers & only_layer(layer)) == 0) return false;
  if (std::find(query.except.begin(), query.except.end(), id) != query.except.end()) return false;
  return !query.predicate || query.predicate(id);
}

/// Throws std::invalid_argument if there is a fault in what a query was given: "Scene: the region, a sphere, has ...".
inline void refuse_fault(std::string_view role, std::string_view type, std::string_view fault) {
  if (fault.empty()) return;
  throw std::invalid_argument("Scene: the " + std::string(role) + ", " + with_article(type) + ", " +
                              std::string(fault));
}

template <Dim N, class T>
void refuse_fault(std::string_view role, const AnyShape<N, T>& shape) {
  refuse_fault(role, type_name<N, T>(shape), defect(shape));
}

}  // namespace detail
}  // namespace graze
