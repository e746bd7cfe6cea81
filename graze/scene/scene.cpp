// SPDX-License-Identifier: MIT
#include <algorithm>
#include <stdexcept>
#include <string>
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
void require_valid(const AnyShape<N, T>& shape, const std::string& name) {
  const std::string_view fault = defect(shape);
  if (fault.empty()) return;
  throw std::invalid_argument("Scene: " + named(name) + ", a " + std::string(type_name<N, T>(shape)) + ", " +
                              std::string(fault));
}

}  // namespace

/// Room for the slot was made before.
template <Dim N, class T>
void Scene<N, T>::note(std::uint32_t slot, const Aabb<N, T>& box) noexcept {
  index_.note(slot);
  keeper_.note(slot, box);
  pairs_.reset();
}

template <Dim N, class T>
ObjectId Scene<N, T>::add(AnyShape<N, T> shape, ObjectOptions options) {
  require_valid(shape, options.name);
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
  note(slot, box);
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
  require_valid(shape, this->object(id).name);
  const Aabb<N, T> box = bounds(shape);
  Object<N, T>& moved = *objects_.change(id.index);
  moved.shape = std::move(shape);
  moved.box = box;
  note(id.index, box);
}

template <Dim N, class T>
void Scene<N, T>::move(std::span<const ObjectMove<N, T>> moves) {
  // Of all types only compounds can fail to be copied: everything that can throw comes first.
  std::vector<AnyShape<N, T>> compounds;
  for (const ObjectMove<N, T>& each : moves) {
    require_valid(each.shape, this->object(each.id).name);
    objects_.change(each.id.index);
    if (std::holds_alternative<Compound<N, T>>(each.shape)) compounds.push_back(each.shape);
  }
  auto next_compound = compounds.begin();
  for (const ObjectMove<N, T>& each : moves) {
    const std::uint32_t slot = each.id.index;
    Object<N, T>& moved = *objects_.change(slot);
    if (std::holds_alternative<Compound<N, T>>(each.shape)) {
      moved.shape = std::move(*next_compound++);
    } else {
      moved.shape = each.shape;
    }
    moved.box = bounds(moved.shape);
    note(slot, moved.box);
  }
}

template <Dim N, class T>
void Scene<N, T>::remove(ObjectId id) {
  this->object(id);
  std::optional<Object<N, T>>& place = objects_.change(id.index);
  if (!place->name.empty()) names_.change().erase(place->name);
  place.reset();
  ids_.release(id.index);
  note(id.index, Aabb<N, T>::nothing());
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
  std::vector<ObjectPair> touching;
  touching.reserve(found.size());
  for (const Pair& pair : found) touching.push_back({this->id_of(pair.a), this->id_of(pair.b)});
  auto known = std::make_shared<const std::vector<ObjectPair>>(touching);
  events_ = events_between(touching_, touching);
  touching_ = std::move(touching);
  pairs_ = std::move(known);
  return events_;
}

template class Scene<2, float>;
template class Scene<3, float>;
template class Scene<2, double>;
template class Scene<3, double>;

}  // namespace graze
