// SPDX-License-Identifier: MIT
#include <algorithm>
#include <stdexcept>

#include <graze/broad/index/path_filter.hpp>
#include <graze/broad/index/region.hpp>
#include <graze/broad/pairs.hpp>
#include <graze/query/bounds.hpp>
#include <graze/scene/scene_query.hpp>
#include <graze/scene/scene_view.hpp>
#include <graze/scene/storage/meets_inflated.hpp>
#include <graze/scene/visit_candidates.hpp>

namespace graze {

template <Dim N, class T>
std::shared_ptr<const SceneView<N, T>> SceneView<N, T>::share() {
  auto view = std::make_shared<SceneView>();
  view->ids_ = ids_;
  view->layer_names_ = layer_names_;
  if (is_current_) view->events_ = events_.share();
  view->is_current_ = is_current_;
  view->index_ = index_.share(objects_);
  view->objects_ = objects_.share();
  view->names_ = names_.share();
  view->exceptions_ = exceptions_.share();
  return view;
}

template <Dim N, class T>
const Object<N, T>& SceneView<N, T>::object(ObjectId id) const {
  if (contains(id)) return in_slot(id.index);
  const std::string name =
      "Scene: the id (index " + std::to_string(id.index) + ", generation " + std::to_string(id.generation) + ") ";
  if (id == ObjectId{}) throw std::out_of_range(name + "is default-constructed; only add returns ids");
  if (!ids_.has_issued({id.index, id.generation, id.owner})) throw std::out_of_range(name + "belongs to another scene");
  throw std::out_of_range(name + "names no object any more; it was removed");
}

template <Dim N, class T>
std::optional<ObjectId> SceneView<N, T>::find(std::string_view name) const {
  if (name.empty()) return std::nullopt;
  const auto found = names_->find(std::string(name));
  if (found == names_->end()) return std::nullopt;
  return found->second;
}

template <Dim N, class T>
std::optional<ObjectId> SceneView<N, T>::find(std::uint32_t index, std::uint32_t generation) const {
  const ObjectId id{index, generation, ids_.owner()};
  if (!contains(id)) return std::nullopt;
  return id;
}

template <Dim N, class T>
std::vector<ObjectId> SceneView<N, T>::vacant_ids() const {
  std::vector<ObjectId> result;
  for (const Key& key : ids_.free_keys()) result.push_back({key.index, key.generation, key.owner});
  return result;
}

template <Dim N, class T>
std::vector<ObjectId> SceneView<N, T>::ids() const {
  std::vector<ObjectId> result;
  result.reserve(size());
  for (std::uint32_t slot = 0; slot < ids_.slots(); ++slot) {
    if (ids_.is_taken(slot)) result.push_back(id_of(slot));
  }
  return result;
}

template <Dim N, class T>
void SceneView<N, T>::require_two_objects(ObjectId a, ObjectId b) const {
  object(a);
  object(b);
  if (a == b) throw std::invalid_argument("Scene: an object is never a pair with itself; except names two objects");
}

template <Dim N, class T>
bool SceneView<N, T>::excepted(ObjectId a, ObjectId b) const {
  require_two_objects(a, b);
  return exceptions_->contains(a.index, b.index);
}

template <Dim N, class T>
std::vector<ObjectPair> SceneView<N, T>::excepted_pairs() const {
  std::vector<ObjectPair> result;
  for (const Pair& pair : exceptions_->all()) result.push_back({id_of(pair.a), id_of(pair.b)});
  return result;
}

template <Dim N, class T>
std::vector<ObjectPair> SceneView<N, T>::candidates(double margin) const {
  const PairOptions options = detail::candidate_options<T>(margin);
  std::vector<Aabb<N, T>> boxes(ids_.slots(), Aabb<N, T>::nothing());
  for (std::uint32_t slot = 0; slot < ids_.slots(); ++slot) {
    if (ids_.is_taken(slot)) boxes[slot] = touching_bounds(in_slot(slot));
  }
  std::vector<ObjectPair> result;
  for (const Pair& pair : overlapping_pairs(boxes, options)) {
    if (!may_touch(in_slot(pair.a), in_slot(pair.b)) || exceptions_->contains(pair.a, pair.b)) continue;
    result.push_back({id_of(pair.a), id_of(pair.b)});
  }
  return result;
}

template <Dim N, class T>
std::vector<ObjectPair> SceneView<N, T>::pairs() const {
  if (is_current_) return detail::pairs_of(*events_);
  std::vector<ObjectPair> result = candidates();
  std::erase_if(result, [this](const ObjectPair& pair) {
    return relation(in_slot(pair.a.index).shape, in_slot(pair.b.index).shape) == Relation::apart;
  });
  return result;
}

template <Dim N, class T>
template <class R>
std::vector<ObjectId> SceneView<N, T>::near(const R& region, const SceneQuery& query) const {
  std::vector<ObjectId> result;
  const detail::SlotIndex<N, T>& index = this->index();
  index.query(Inflated<R>{region}, [&](std::uint32_t slot) {
    if (detail::admits(query, id_of(slot), in_slot(slot).layer)) result.push_back(id_of(slot));
  });
  std::sort(result.begin(), result.end());
  return result;
}

template <Dim N, class T>
std::vector<ObjectId> SceneView<N, T>::cull(const AnyShape<N, T>& region, const SceneQuery& query) const {
  detail::refuse_fault("region", region);
  return near(region, query);
}

template <Dim N, class T>
std::vector<ObjectId> SceneView<N, T>::cull(const Frustum<N, T>& frustum, const SceneQuery& query) const {
  detail::refuse_fault("region", "frustum", defect(frustum));
  return near(frustum, query);
}

template <Dim N, class T>
std::vector<ObjectId> SceneView<N, T>::overlapping(const AnyShape<N, T>& region, const SceneQuery& query) const {
  std::vector<ObjectId> result = cull(region, query);
  std::erase_if(result,
                [&](const ObjectId& id) { return relation(region, in_slot(id.index).shape) == Relation::apart; });
  return result;
}

#define GRAZE_INSTANTIATE(N, T)                                                                         \
  template class SceneView<N, T>;                                                                       \
  template std::vector<ObjectId> SceneView<N, T>::near(const AnyShape<N, T>&, const SceneQuery&) const; \
  template std::vector<ObjectId> SceneView<N, T>::near(const RayUntil<N, T>&, const SceneQuery&) const; \
  template std::vector<ObjectId> SceneView<N, T>::near(const Ray<N, T>&, const SceneQuery&) const;
GRAZE_INSTANTIATE(2, float)
GRAZE_INSTANTIATE(3, float)
GRAZE_INSTANTIATE(2, double)
GRAZE_INSTANTIATE(3, double)
#undef GRAZE_INSTANTIATE

// The explicit instantiations declared in meets_inflated.hpp.
#define GRAZE_INSTANTIATE(N, T)                                                  \
  template bool meets_inflated(const AnyShape<N, T>& region, const Aabb<N, T>&); \
  template bool meets_inflated(const Frustum<N, T>& region, const Aabb<N, T>&);
GRAZE_INSTANTIATE(2, float)
GRAZE_INSTANTIATE(3, float)
GRAZE_INSTANTIATE(2, double)
GRAZE_INSTANTIATE(3, double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
