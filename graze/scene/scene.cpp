// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <graze/broad/pairs.hpp>
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

template <Dim N, class T>
ObjectId Scene<N, T>::add(AnyShape<N, T> shape, ObjectOptions options) {
  require_valid(shape, options.name);
  if (options.layer >= max_layers) {
    throw std::invalid_argument("Scene: layer " + std::to_string(options.layer) + " of " + named(options.name) +
                                " does not exist; layers are 0 to " + std::to_string(max_layers - 1));
  }
  if (find(options.name)) throw std::invalid_argument("Scene: there is already an object \"" + options.name + "\"");
  if (slots_.size() == std::numeric_limits<std::uint32_t>::max()) throw std::length_error("Scene: it is full");

  // Everything that can throw comes before the first change that would show.
  const Aabb<N, T> box = bounds(shape);
  if (free_.empty()) {
    // Room for every slot in the free list, so that a later remove cannot fail.
    if (free_.capacity() <= slots_.size()) free_.reserve(2 * slots_.size() + 16);
    slots_.emplace_back();
    free_.push_back(static_cast<std::uint32_t>(slots_.size() - 1));
  }
  const std::uint32_t index = free_.back();
  Slot& slot = slots_[index];
  const ObjectId id{index, slot.generation};
  if (!options.name.empty()) by_name_.emplace(options.name, id);
  free_.pop_back();
  slot.object.emplace(
      Object<N, T>{std::move(shape), box, std::move(options.name), options.layer, options.mask, options.user});
  ++size_;
  return id;
}

template <Dim N, class T>
void Scene<N, T>::move(ObjectId id, AnyShape<N, T> shape) {
  require_valid(shape, object(id).name);
  const Aabb<N, T> box = bounds(shape);
  Object<N, T>& moved = *slots_[id.index].object;
  moved.shape = std::move(shape);
  moved.box = box;
}

template <Dim N, class T>
void Scene<N, T>::remove(ObjectId id) {
  const std::string& name = object(id).name;
  if (!name.empty()) by_name_.erase(name);
  Slot& slot = slots_[id.index];
  slot.object.reset();
  --size_;
  // A slot whose generations are used up is retired: an id must never come back to life.
  if (++slot.generation != 0) free_.push_back(id.index);
}

template <Dim N, class T>
bool Scene<N, T>::contains(ObjectId id) const {
  return id.index < slots_.size() && slots_[id.index].object && slots_[id.index].generation == id.generation;
}

template <Dim N, class T>
const Object<N, T>& Scene<N, T>::object(ObjectId id) const {
  if (!contains(id)) {
    throw std::out_of_range("Scene: the id (index " + std::to_string(id.index) + ", generation " +
                            std::to_string(id.generation) + ") names no object; it was removed or is of another scene");
  }
  return *slots_[id.index].object;
}

template <Dim N, class T>
std::optional<ObjectId> Scene<N, T>::find(std::string_view name) const {
  if (name.empty()) return std::nullopt;
  const auto found = by_name_.find(std::string(name));
  if (found == by_name_.end()) return std::nullopt;
  return found->second;
}

template <Dim N, class T>
std::vector<ObjectId> Scene<N, T>::ids() const {
  std::vector<ObjectId> result;
  result.reserve(size_);
  for (std::uint32_t index = 0; index < slots_.size(); ++index) {
    if (slots_[index].object) result.push_back({index, slots_[index].generation});
  }
  return result;
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
std::vector<ObjectPair> Scene<N, T>::candidates() const {
  const std::vector<ObjectId> all = ids();
  std::vector<Aabb<N, T>> boxes;
  boxes.reserve(all.size());
  for (const ObjectId id : all) boxes.push_back(touching_bounds(slots_[id.index].object->box));
  std::vector<ObjectPair> result;
  for (const Pair& pair : overlapping_pairs(boxes)) {
    const Object<N, T>& a = *slots_[all[pair.a].index].object;
    const Object<N, T>& b = *slots_[all[pair.b].index].object;
    if (filters_admit(a.layer, a.mask, b.layer, b.mask)) result.push_back({all[pair.a], all[pair.b]});
  }
  return result;
}

template <Dim N, class T>
std::vector<ObjectPair> Scene<N, T>::pairs() const {
  std::vector<ObjectPair> result = candidates();
  std::erase_if(result, [this](const ObjectPair& pair) {
    return relation(slots_[pair.a.index].object->shape, slots_[pair.b.index].object->shape) == Relation::apart;
  });
  return result;
}

template class Scene<2, float>;
template class Scene<3, float>;
template class Scene<2, double>;
template class Scene<3, double>;

}  // namespace graze
