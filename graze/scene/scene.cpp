// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <graze/query/bounds.hpp>
#include <graze/scene/scene.hpp>

namespace graze {
namespace {

/// 'object "ball"' or 'the object', for messages.
std::string named(const std::string& name) { return name.empty() ? "the object" : "object \"" + name + "\""; }

template <Dim N, class T>
[[noreturn]] void refuse(const AnyShape<N, T>& shape, std::string_view fault, const std::string& name) {
  throw std::invalid_argument("Scene: " + named(name) + ", a " + std::string(type_name<N, T>(shape)) + ", " +
                              std::string(fault));
}

/// Copies a shape into an object's place. Of all types only compounds can fail to be copied.
template <Dim N, class T>
void put(const AnyShape<N, T>& shape, Object<N, T>& object) {
  detail::visit(
      [&object](const auto& held) {
        object.shape = held;
        object.box = bounds(held);
      },
      shape);
}

}  // namespace

/// Room for the slot was made before.
template <Dim N, class T>
void Scene<N, T>::note_moved(std::uint32_t slot, const Object<N, T>& object) noexcept {
  index_.note(slot);
  keeper_.note_moved(slot, object);
  is_current_ = false;
}

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
    throw std::length_error("Scene: it is full; it holds " + std::to_string(max_objects) + " objects at most");
  }

  // Everything that can throw comes before the first change that would show.
  const std::uint32_t slot = ids_.prepare();
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
  place.emplace(Object<N, T>{std::move(shape), box, std::move(options.name), options.layer, options.mask, options.user,
                             options.mobility});
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

template <Dim N, class T>
void Scene<N, T>::move(std::span<const ObjectMove<N, T>> moves) {
  // Of all types only compounds can fail to be copied: everything that can throw comes first.
  std::vector<AnyShape<N, T>> compounds;
  for (const ObjectMove<N, T>& each : moves) {
    if (!this->contains(each.id)) this->object(each.id);  // which says what is wrong with the id
    if (const std::string_view fault = defect(each.shape); !fault.empty()) {
      refuse<N, T>(each.shape, fault, this->object(each.id).name);
    }
    objects_.change(each.id.index);
    if (std::holds_alternative<Compound<N, T>>(each.shape)) compounds.push_back(each.shape);
  }
  auto next_compound = compounds.begin();
  for (const ObjectMove<N, T>& each : moves) {
    Object<N, T>& moved = *objects_.change(each.id.index);
    if (std::holds_alternative<Compound<N, T>>(each.shape)) {
      moved.shape = std::move(*next_compound++);
      moved.box = bounds(moved.shape);
    } else {
      put(each.shape, moved);
    }
    note_moved(each.id.index, moved);
  }
}

template <Dim N, class T>
void Scene<N, T>::remove(ObjectId id) {
  this->object(id);
  std::optional<Object<N, T>>& place = objects_.change(id.index);
  if (!place->name.empty()) names_.change().erase(place->name);
  place.reset();
  ids_.release(id.index);
  index_.note(id.index);
  keeper_.note_gone(id.index);
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

template <Dim N, class T>
const SceneEvents& Scene<N, T>::update(const Executor& executor) {
  const std::vector<Pair>& found = keeper_.update(objects_, index_, executor);
  next_.resize(found.size());
  for (std::size_t i = 0; i < found.size(); ++i) next_[i] = {this->id_of(found[i].a), this->id_of(found[i].b)};
  detail::find_events(*pairs_, next_, next_events_);
  pairs_.exchange(next_);
  is_current_ = true;
  std::swap(events_, next_events_);
  return events_;
}

template class Scene<2, float>;
template class Scene<3, float>;
template class Scene<2, double>;
template class Scene<3, double>;

}  // namespace graze
