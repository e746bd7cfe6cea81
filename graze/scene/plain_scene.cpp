// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include <graze/broad/pairs.hpp>
#include <graze/math/tolerance.hpp>
#include <graze/query/bounds.hpp>
#include <graze/query/distance.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/relation.hpp>
#include <graze/query/shape_cast.hpp>
#include <graze/query/signed_distance.hpp>
#include <graze/query/time_of_impact.hpp>
#include <graze/scene/plain_scene.hpp>
#include <graze/scene/scene_query.hpp>
#include <graze/scene/storage/hit_with_face.hpp>
#include <graze/scene/storage/meets_inflated.hpp>

namespace graze {
namespace {

void require(bool is_right, const char* fact) {
  if (!is_right) throw std::invalid_argument(std::string("PlainScene: ") + fact);
}

/// The distance of a point from a shape; 0 inside solids.
template <Dim N, class T>
T distance_between(const AnyShape<N, T>& shape, const Vec<N, T>& point) {
  const T distance = signed_distance(shape, point);
  return std::holds_alternative<Plane<N, T>>(shape) ? std::fabs(distance) : std::max(distance, T(0));
}

ObjectPair in_order(const ObjectId& a, const ObjectId& b) { return a < b ? ObjectPair{a, b} : ObjectPair{b, a}; }

/// The first result, or none.
template <class Result>
std::optional<Result> first_of(const std::vector<Result>& results) {
  if (results.empty()) return std::nullopt;
  return results.front();
}

}  // namespace

template <Dim N, class T>
const Object<N, T>& PlainScene<N, T>::at(ObjectId id) const {
  const auto found = objects_.find(id);
  if (found == objects_.end()) throw std::out_of_range("PlainScene: the id names no object");
  return found->second;
}

template <Dim N, class T>
ObjectId PlainScene<N, T>::add(AnyShape<N, T> shape, ObjectOptions options) {
  require(is_valid(shape), "the shape is not valid");
  require(options.layer < max_layers, "there is no such layer");
  require(!find(options.name), "there is already an object of this name");
  ids_.prepare();
  const Key key = ids_.take();
  const ObjectId id{key.index, key.generation, key.owner};
  const Aabb<N, T> box = bounds(shape);
  objects_.insert({id, Object<N, T>{box, std::move(shape), std::move(options.name), options.layer, options.mobility,
                                    options.mask, options.user}});
  return id;
}

template <Dim N, class T>
void PlainScene<N, T>::plan_ids(std::span<const ObjectId> next, std::span<const ObjectId> vacant) {
  const auto keys = [](std::span<const ObjectId> ids) {
    std::vector<Key> result;
    for (const ObjectId& id : ids) result.push_back({id.index, id.generation, id.owner});
    return result;
  };
  ids_.plan(keys(next), keys(vacant));
}

template <Dim N, class T>
void PlainScene<N, T>::move(ObjectId id, AnyShape<N, T> shape) {
  at(id);
  require(is_valid(shape), "the shape is not valid");
  Object<N, T>& moved = objects_.at(id);
  moved.box = bounds(shape);
  moved.shape = std::move(shape);
}

template <Dim N, class T>
void PlainScene<N, T>::move(std::span<const ObjectMove<N, T>> moves) {
  for (const auto& [id, shape] : moves) {
    at(id);
    require(is_valid(shape), "a shape is not valid");
  }
  for (const auto& [id, shape] : moves) move(id, shape);
}

template <Dim N, class T>
void PlainScene<N, T>::remove(ObjectId id) {
  at(id);
  objects_.erase(id);
  ids_.release(id.index);
  std::erase_if(exceptions_, [id](const ObjectPair& pair) { return pair.a == id || pair.b == id; });
}

template <Dim N, class T>
bool PlainScene<N, T>::excepted(ObjectId a, ObjectId b) const {
  at(a);
  at(b);
  require(a != b, "an object is never a pair with itself");
  return exceptions_.contains(in_order(a, b));
}

template <Dim N, class T>
void PlainScene<N, T>::except(ObjectId a, ObjectId b) {
  if (!excepted(a, b)) exceptions_.insert(in_order(a, b));
}

template <Dim N, class T>
void PlainScene<N, T>::accept(ObjectId a, ObjectId b) {
  if (excepted(a, b)) exceptions_.erase(in_order(a, b));
}

template <Dim N, class T>
bool PlainScene<N, T>::may_be_pair(const ObjectPair& pair) const {
  return may_touch(objects_.at(pair.a), objects_.at(pair.b)) && !exceptions_.contains(pair);
}

template <Dim N, class T>
Layer PlainScene<N, T>::layer(std::string_view name) {
  const auto known = std::find(layer_names_.begin(), layer_names_.end(), name);
  const auto number = static_cast<Layer>(known - layer_names_.begin());
  if (known != layer_names_.end()) return number;
  if (layer_names_.size() == max_layers) throw std::length_error("PlainScene: there are too many layers");
  layer_names_.emplace_back(name);
  return number;
}

template <Dim N, class T>
SceneEvents PlainScene<N, T>::update() {
  std::vector<ObjectPair> touching = pairs();
  SceneEvents events = events_between(touching_, touching);
  touching_ = std::move(touching);
  return events;
}

template <Dim N, class T>
std::optional<ObjectId> PlainScene<N, T>::find(std::string_view name) const {
  if (name.empty()) return std::nullopt;
  const auto found =
      std::find_if(objects_.begin(), objects_.end(), [name](const auto& each) { return each.second.name == name; });
  if (found == objects_.end()) return std::nullopt;
  return found->first;
}

template <Dim N, class T>
std::vector<ObjectPair> PlainScene<N, T>::candidates(double margin) const {
  require(margin >= 0 && std::isfinite(margin), "the margin is negative or not finite");
  std::vector<Aabb<N, T>> boxes;
  std::vector<ObjectId> ids;
  for (const auto& [id, object] : objects_) {
    boxes.push_back(touching_bounds(object));
    ids.push_back(id);
  }
  const PairOptions options{.margin = margin * (0.5 + tolerance::convex_in<T>), .method = PairMethod::brute_force};
  std::vector<ObjectPair> result;
  for (const Pair& pair : overlapping_pairs(boxes, options)) {
    const ObjectPair found{ids[pair.a], ids[pair.b]};
    if (may_be_pair(found)) result.push_back(found);
  }
  return result;
}

/// Tests the boxes first: a thousand objects are half a million pairs.
template <Dim N, class T>
std::vector<ObjectPair> PlainScene<N, T>::pairs() const {
  std::vector<ObjectPair> result = candidates();
  std::erase_if(result, [this](const ObjectPair& pair) {
    return relation(objects_.at(pair.a).shape, objects_.at(pair.b).shape) == Relation::apart;
  });
  return result;
}

template <Dim N, class T>
std::vector<ObjectContact<N, T>> PlainScene<N, T>::contacts() const {
  std::vector<ObjectContact<N, T>> result;
  for (const ObjectPair& pair : pairs()) {
    result.push_back({pair, manifold(objects_.at(pair.a).shape, objects_.at(pair.b).shape)});
  }
  return result;
}

template <Dim N, class T>
std::vector<NearPair<T>> PlainScene<N, T>::closest_pairs(T within) const {
  require(within >= T(0) && std::isfinite(within), "the distance of closest pairs is negative or not finite");
  std::vector<NearPair<T>> result;
  for (auto a = objects_.begin(); a != objects_.end(); ++a) {
    for (auto b = std::next(a); b != objects_.end(); ++b) {
      if (!may_be_pair({a->first, b->first})) continue;
      const T found = distance(a->second.shape, b->second.shape);
      if (found <= within) result.push_back({{a->first, b->first}, found});
    }
  }
  return result;
}

template <Dim N, class T>
std::vector<ObjectTouch<N, T>> PlainScene<N, T>::contacts_with(const AnyShape<N, T>& shape,
                                                               const SceneQuery& query) const {
  require(is_valid(shape), "the shape is not valid");
  std::vector<ObjectTouch<N, T>> result;
  for (const auto& [id, object] : objects_) {
    if (!detail::admits(query, id, object.layer)) continue;
    const Manifold<N, T> found = manifold(shape, object.shape);
    if (found.size > 0) result.push_back({id, found});
  }
  return result;
}

template <Dim N, class T>
std::vector<ObjectId> PlainScene<N, T>::overlapping(const AnyShape<N, T>& region, const SceneQuery& query) const {
  require(is_valid(region), "the region is not valid");
  std::vector<ObjectId> result;
  for (const auto& [id, object] : objects_) {
    if (detail::admits(query, id, object.layer) && relation(region, object.shape) != Relation::apart)
      result.push_back(id);
  }
  return result;
}

template <Dim N, class T>
template <class R>
std::vector<ObjectId> PlainScene<N, T>::near(const R& region, const SceneQuery& query) const {
  require(is_valid(region), "the region is not valid");
  std::vector<ObjectId> result;
  for (const auto& [id, object] : objects_) {
    if (!detail::admits(query, id, object.layer) || is_nothing(object.box)) continue;
    if (meets_inflated(region, touching_bounds(object))) result.push_back(id);
  }
  return result;
}

template <Dim N, class T>
std::vector<ObjectId> PlainScene<N, T>::cull(const AnyShape<N, T>& region, const SceneQuery& query) const {
  return near(region, query);
}

template <Dim N, class T>
std::vector<ObjectId> PlainScene<N, T>::cull(const Frustum<N, T>& frustum, const SceneQuery& query) const {
  return near(frustum, query);
}

template <Dim N, class T>
template <class Measure>
std::vector<NearObject<T>> PlainScene<N, T>::nearest_to(std::size_t count, const SceneQuery& query,
                                                        const Measure& distance_to) const {
  std::vector<NearObject<T>> result;
  for (const auto& [id, object] : objects_) {
    const T distance =
        detail::admits(query, id, object.layer) ? distance_to(object.shape) : std::numeric_limits<T>::infinity();
    if (distance < std::numeric_limits<T>::infinity()) result.push_back({id, distance});
  }
  std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.distance < b.distance; });
  if (result.size() > count) result.resize(count);
  return result;
}

template <Dim N, class T>
std::vector<NearObject<T>> PlainScene<N, T>::nearest(const Vec<N, T>& point, std::size_t count,
                                                     const SceneQuery& query) const {
  require(is_finite(point), "the point is not finite");
  return nearest_to(count, query,
                    [&point](const AnyShape<N, T>& other) { return distance_between<N, T>(other, point); });
}

template <Dim N, class T>
std::vector<NearObject<T>> PlainScene<N, T>::nearest(const AnyShape<N, T>& shape, std::size_t count,
                                                     const SceneQuery& query) const {
  require(is_valid(shape), "the shape is not valid");
  return nearest_to(count, query, [&shape](const AnyShape<N, T>& other) { return distance(shape, other); });
}

template <Dim N, class T>
std::vector<ObjectHit<N, T>> PlainScene<N, T>::ray_cast_all(const Ray<N, T>& ray, T t_max,
                                                            const SceneQuery& query) const {
  require(is_valid(ray), "the ray is not valid");
  require(t_max >= T(0), "t_max is negative or not a number");
  std::vector<ObjectHit<N, T>> result;
  for (const auto& [id, object] : objects_) {
    if (!detail::admits(query, id, object.layer)) continue;
    if (const auto hit = detail::hit_with_face(object.shape, ray, t_max)) result.push_back({id, *hit});
  }
  std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.hit.t < b.hit.t; });
  return result;
}

template <Dim N, class T>
std::optional<ObjectHit<N, T>> PlainScene<N, T>::ray_cast(const Ray<N, T>& ray, T t_max,
                                                          const SceneQuery& query) const {
  return first_of(ray_cast_all(ray, t_max, query));
}

/// By t, ties by id.
template <Dim N, class T>
template <class Find>
std::vector<ObjectImpact<N, T>> PlainScene<N, T>::impacts(const SceneQuery& query, const Find& find) const {
  std::vector<ObjectImpact<N, T>> result;
  for (const auto& [id, object] : objects_) {
    if (!detail::admits(query, id, object.layer)) continue;
    if (const std::optional<Impact<N, T>> impact = find(object.shape)) result.push_back({id, *impact});
  }
  std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.impact.t < b.impact.t; });
  return result;
}

template <Dim N, class T>
std::vector<ObjectImpact<N, T>> PlainScene<N, T>::shape_cast_all(const AnyShape<N, T>& shape, const Vec<N, T>& motion,
                                                                 const SceneQuery& query) const {
  require(is_valid(shape), "the moving shape is not valid");
  require(is_finite(motion), "the motion is not finite");
  return impacts(query, [&](const AnyShape<N, T>& other) {
    return graze::shape_cast(shape, motion, other, detail::cast_options(query));
  });
}

template <Dim N, class T>
std::optional<ObjectImpact<N, T>> PlainScene<N, T>::shape_cast(const AnyShape<N, T>& shape, const Vec<N, T>& motion,
                                                               const SceneQuery& query) const {
  return first_of(shape_cast_all(shape, motion, query));
}

template <Dim N, class T>
std::optional<ObjectImpact<N, T>> PlainScene<N, T>::time_of_impact(const AnyShape<N, T>& shape,
                                                                   const Motion<N, T>& motion,
                                                                   const SceneQuery& query) const {
  require(is_valid(shape), "the moving shape is not valid");
  require(is_finite(motion), "the motion is not finite");
  return first_of(impacts(
      query, [&](const AnyShape<N, T>& other) { return graze::time_of_impact(shape, motion, other, Motion<N, T>{}); }));
}

template class PlainScene<2, float>;
template class PlainScene<3, float>;
template class PlainScene<2, double>;
template class PlainScene<3, double>;

}  // namespace graze
