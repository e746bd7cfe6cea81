// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <graze/broad/orthtree/cell_kernels.hpp>
#include <graze/query/bounds.hpp>
#include <graze/scene/scene.hpp>
#include <graze/shape/fields/description.hpp>

namespace graze {
namespace {

/// Prefetch distance, in objects, when many are moved.
constexpr std::size_t moves_ahead = 8;

/// 'object "sphere"' or 'the object', for messages.
std::string named(const std::string& name) { return name.empty() ? "the object" : "object \"" + name + "\""; }

template <Dim N, class T>
[[noreturn]] void refuse(const AnyShape<N, T>& shape, std::string_view fault, const std::string& name) {
  throw std::invalid_argument("Scene: " + named(name) + ", " + detail::with_article(type_name<N, T>(shape)) + ", " +
                              std::string(fault));
}

/// Whether `defect` would find a fault. A fast version for boxes, which are moved by the thousand.
template <class S>
bool is_faulty(const S& shape) {
  return !defect(shape).empty();
}

template <Dim N, class T>
bool is_faulty(const Aabb<N, T>& box) {
  T sum = T(0);  // a sum of zeros, unless a coordinate is infinite or NaN
  unsigned is_faulty = 0;
  for (Dim i = 0; i < N; ++i) {
    sum += (box.min[i] - box.min[i]) + (box.max[i] - box.max[i]);
    is_faulty |= box.min[i] <= box.max[i] ? 0U : 1U;
  }
  return is_faulty != 0 || sum != T(0);
}

/// Whether a joint test of all shapes shows that none is faulty. Only boxes have such a test.
template <class S>
bool are_surely_sound(std::span<const S> /*shapes*/) {
  return false;
}

template <Dim N, class T>
bool are_surely_sound(std::span<const Aabb<N, T>> boxes) {
  return !is_nothing(detail::cell_kernels<N, T>().bounds(boxes.data(), boxes.size()));
}

}  // namespace

template <Dim N, class T>
ObjectId Scene<N, T>::add(AnyShape<N, T> shape, ObjectOptions options) {
  if (const std::string_view fault = defect(shape); !fault.empty()) refuse<N, T>(shape, fault, options.name);
  if (options.layer >= max_layers) {
    throw std::invalid_argument("Scene: layer " + std::to_string(options.layer) + " of " + named(options.name) +
                                " does not exist; layers are 0 to " + std::to_string(max_layers - 1));
  }
  if (this->find(options.name)) {
    throw std::invalid_argument("Scene: there is already an object \"" + options.name + "\"");
  }
  if (ids_.is_full()) {
    throw std::length_error("Scene: full; it holds at most " + std::to_string(max_objects) + " objects");
  }

  // Everything that can throw comes before the first visible change.
  const std::uint32_t slot = ids_.prepare().index;
  const std::size_t slots = std::max<std::size_t>(slot + std::size_t{1}, objects_.size());
  index_.reserve(slots);
  keeper_.reserve(slots);
  objects_.grow(slots);
  std::optional<Object<N, T>>& place = objects_.change(slot);
  const Aabb<N, T> box = bounds(shape);
  if (!options.name.empty()) names_.change().emplace(options.name, ObjectId{slot, 0, 0});
  const Key key = ids_.take();
  const ObjectId id{key.index, key.generation, key.owner};
  if (!options.name.empty()) names_.change().find(options.name)->second = id;
  place.emplace(Object<N, T>{box, std::move(shape), std::move(options.name), options.layer, options.mobility,
                             options.mask, options.user});
  index_.note(slot);
  keeper_.note_new(slot, *place);
  is_current_ = false;
  return id;
}

template <Dim N, class T>
void Scene<N, T>::plan_ids(std::span<const ObjectId> next, std::span<const ObjectId> vacant) {
  const auto keys = [](std::span<const ObjectId> ids) {
    std::vector<Key> result;
    result.reserve(ids.size());
    for (const ObjectId& id : ids) result.push_back({id.index, id.generation, id.owner});
    return result;
  };
  ids_.plan(keys(next), keys(vacant));
}

template <Dim N, class T>
void Scene<N, T>::move(ObjectId id, AnyShape<N, T> shape) {
  const std::string& name = this->object(id).name;
  if (const std::string_view fault = defect(shape); !fault.empty()) refuse<N, T>(shape, fault, name);
  const Aabb<N, T> box = bounds(shape);
  Object<N, T>& moved = *objects_.change(id.index);
  moved.shape = std::move(shape);
  moved.box = box;
  note_moved(id.index, moved);
}

/// Everything in a move to a valid shape that can throw, except copying a compound.
template <Dim N, class T>
void Scene<N, T>::prepare_move(ObjectId id) {
  if (!this->contains(id)) this->object(id);  // throws with the reason
  objects_.change(id.index);
}

/// Whether `prepare_move` certainly has nothing to do for any of them.
template <Dim N, class T>
bool Scene<N, T>::are_ready_to_move(std::span<const ObjectId> ids) const {
  return objects_.is_all_own() && ids_.contains_all(ids);
}

/// The same for any shape.
template <Dim N, class T>
template <class S>
void Scene<N, T>::prepare_move(ObjectId id, const S& shape) {
  prepare_move(id);
  if (is_faulty(shape)) refuse<N, T>(shape, defect(shape), this->object(id).name);
}

template <Dim N, class T>
template <class S>
void Scene<N, T>::put(std::uint32_t slot, const S& shape) noexcept {
  Object<N, T>& object = *objects_.own(slot);
  if (S* const held = std::get_if<S>(&object.shape)) {
    *held = shape;
  } else {
    object.shape = shape;
  }
  object.box = bounds(shape);
  note_moved(slot, object);
}

/// For an object that is a box.
template <Dim N, class T>
void Scene<N, T>::write_box(std::uint32_t slot, const Aabb<N, T>& box) noexcept {
  Object<N, T>& object = *objects_.own(slot);
  Aabb<N, T>* const held = std::get_if<Aabb<N, T>>(&object.shape);
#ifdef __GNUC__
  if (held == nullptr) __builtin_unreachable();  // so that the compiler omits the type check
#endif
  *held = box;
  object.box = box;
}

/// The same for a box, in fewer steps: the most common case.
template <Dim N, class T>
void Scene<N, T>::put(std::uint32_t slot, const Aabb<N, T>& box) noexcept {
  if (!keeper_.is_box(slot)) return put<Aabb<N, T>>(slot, box);
  write_box(slot, box);
  index_.note(slot);
  keeper_.note_moved_box(slot, box);
  is_current_ = false;
}

template <Dim N, class T>
template <class S>
void Scene<N, T>::put_all(std::span<const ObjectId> ids, std::span<const S> shapes) noexcept {
  for (std::size_t i = 0; i < ids.size(); ++i) {
    prefetch_move<S>(ids[std::min(i + moves_ahead, ids.size() - 1)].index);
    put(ids[i].index, shapes[i]);
  }
}

/// If all objects are boxes, one list after the other, in even fewer steps.
template <Dim N, class T>
void Scene<N, T>::put_all(std::span<const ObjectId> ids, std::span<const Aabb<N, T>> boxes) noexcept {
  if (!keeper_.holds_nothing_but_boxes(ids_.size())) return put_all<Aabb<N, T>>(ids, boxes);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const std::uint32_t later = ids[std::min(i + moves_ahead, ids.size() - 1)].index;
    objects_.template prefetch_first_of<2 * sizeof(Aabb<N, T>)>(later);
    write_box(ids[i].index, boxes[i]);
  }
  index_.note_all(ids, objects_.size());
  keeper_.note_moved_boxes(ids, boxes);
  is_current_ = false;
}

template <Dim N, class T>
void Scene<N, T>::move(std::span<const ObjectMove<N, T>> moves) {
  // Only compounds can fail to be copied: everything that can throw comes first.
  std::vector<AnyShape<N, T>> compounds;
  for (const ObjectMove<N, T>& each : moves) {
    prepare_move(each.id, each.shape);
    if (std::holds_alternative<Compound<N, T>>(each.shape)) compounds.push_back(each.shape);
  }
  auto next_compound = compounds.begin();
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const ObjectMove<N, T>& each = moves[i];
    prefetch_move<AnyShape<N, T>>(moves[std::min(i + moves_ahead, moves.size() - 1)].id.index);
    if (std::holds_alternative<Compound<N, T>>(each.shape)) {
      Object<N, T>& moved = *objects_.own(each.id.index);
      moved.shape = std::move(*next_compound++);
      moved.box = bounds(moved.shape);
      note_moved(each.id.index, moved);
    } else {
      detail::visit([&](const auto& held) { put(each.id.index, held); }, each.shape);
    }
  }
}

template <Dim N, class T>
template <detail::CopiedIntoAnyShape<N, T> S>
void Scene<N, T>::move(std::span<const ObjectId> ids, std::span<const S> shapes) {
  if (ids.size() != shapes.size()) {
    throw std::invalid_argument("Scene: " + std::to_string(shapes.size()) + " shapes for " +
                                std::to_string(ids.size()) + " objects to be moved; each needs one");
  }
  if (are_surely_sound(shapes)) {
    if (!are_ready_to_move(ids)) {
      for (const ObjectId& id : ids) prepare_move(id);
    }
  } else {
    for (std::size_t i = 0; i < ids.size(); ++i) prepare_move(ids[i], shapes[i]);
  }
  put_all(ids, shapes);
}

template <Dim N, class T>
void Scene<N, T>::remove(ObjectId id) {
  this->object(id);
  std::optional<Object<N, T>>& place = objects_.change(id.index);
  detail::PairExceptions* const exceptions = exceptions_->has_any(id.index) ? &exceptions_.change() : nullptr;
  if (!place->name.empty()) names_.change().erase(place->name);
  place.reset();
  ids_.release(id.index);
  index_.note(id.index);
  keeper_.note_gone(id.index);
  is_current_ = false;
  if (exceptions == nullptr) return;
  exceptions->remove_all_of(id.index,
                            [&](std::uint32_t other) { keeper_.note_exceptions(other, exceptions->has_any(other)); });
}

template <Dim N, class T>
void Scene<N, T>::except(ObjectId a, ObjectId b) {
  if (this->excepted(a, b)) return;
  exceptions_.change().add(a.index, b.index);
  keeper_.note_exceptions(a.index, true);
  keeper_.note_exceptions(b.index, true);
  is_current_ = false;
}

template <Dim N, class T>
void Scene<N, T>::accept(ObjectId a, ObjectId b) {
  if (!this->excepted(a, b)) return;
  detail::PairExceptions& exceptions = exceptions_.change();
  exceptions.remove(a.index, b.index);
  for (const std::uint32_t slot : {a.index, b.index}) keeper_.note_exceptions(slot, exceptions.has_any(slot));
  is_current_ = false;
}

template <Dim N, class T>
Layer Scene<N, T>::layer(std::string_view name) {
  const auto known = std::find(layer_names_.begin(), layer_names_.end(), name);
  if (known != layer_names_.end()) return static_cast<Layer>(known - layer_names_.begin());
  if (layer_names_.size() == max_layers) {
    throw std::length_error("Scene: layer \"" + std::string(name) + "\" is one too many; a scene has at most " +
                            std::to_string(max_layers) + " layers");
  }
  layer_names_.emplace_back(name);
  return static_cast<Layer>(layer_names_.size() - 1);
}

/// Everything that can fail comes before the first visible change.
template <Dim N, class T>
const SceneEvents& Scene<N, T>::update(const Executor& executor) {
  if (keeper_.find(objects_, executor, detail::PairPlan::automatic, *exceptions_) == detail::PairPlan::mend) {
    next_edit_.plan(*events_, keeper_.began(), keeper_.ended(), ids_);
    SceneEvents& events = events_.change();
    next_edit_.make_room(events);
    next_edit_.apply(events);
  } else {
    const auto slot_reuse =
        ids_.changes() == last_changes_ ? detail::SlotReuse::the_same : detail::SlotReuse::maybe_others;
    const auto listed = keeper_.listed();
    if (listed && slot_reuse == detail::SlotReuse::the_same) {
      detail::find_events(*events_, young_, *listed, ids_, next_);
    } else {
      detail::find_events(*events_, keeper_.found(), ids_, slot_reuse, next_);
    }
    events_.exchange(next_.events);
    std::swap(young_, next_.young);
  }
  keeper_.commit();
  last_changes_ = ids_.changes();
  is_current_ = true;
  return *events_;
}

#define GRAZE_INSTANTIATE(N, T)                                                                 \
  template class Scene<N, T>;                                                                   \
  template void Scene<N, T>::move(std::span<const ObjectId>, std::span<const Vec<N, T>>);       \
  template void Scene<N, T>::move(std::span<const ObjectId>, std::span<const Segment<N, T>>);   \
  template void Scene<N, T>::move(std::span<const ObjectId>, std::span<const Ray<N, T>>);       \
  template void Scene<N, T>::move(std::span<const ObjectId>, std::span<const Sphere<N, T>>);    \
  template void Scene<N, T>::move(std::span<const ObjectId>, std::span<const Aabb<N, T>>);      \
  template void Scene<N, T>::move(std::span<const ObjectId>, std::span<const Obb<N, T>>);       \
  template void Scene<N, T>::move(std::span<const ObjectId>, std::span<const Plane<N, T>>);     \
  template void Scene<N, T>::move(std::span<const ObjectId>, std::span<const HalfSpace<N, T>>); \
  template void Scene<N, T>::move(std::span<const ObjectId>, std::span<const Triangle<N, T>>);  \
  template void Scene<N, T>::move(std::span<const ObjectId>, std::span<const Capsule<N, T>>);   \
  template void Scene<N, T>::move(std::span<const ObjectId>, std::span<const Polytope<N, T>>);
GRAZE_INSTANTIATE(2, float)
GRAZE_INSTANTIATE(3, float)
GRAZE_INSTANTIATE(2, double)
GRAZE_INSTANTIATE(3, double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
