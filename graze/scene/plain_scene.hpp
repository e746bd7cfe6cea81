// SPDX-License-Identifier: MIT
/// @file
/// The reference for Scene: the same calls, answered by testing every object.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include <graze/broad/index/key_table.hpp>
#include <graze/math/motion.hpp>
#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/events.hpp>
#include <graze/scene/object.hpp>
#include <graze/scene/scene.hpp>
#include <graze/scene/scene_query.hpp>
#include <graze/scene/scene_view.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/frustum.hpp>

namespace graze {

/// Gives the same results as a Scene, and throws the same types of exceptions, but without an index, stored pairs or
/// threads: every query tests all objects, or all pairs. Too slow for many objects, too simple to be wrong; intended
/// for tests and for checking the results of a scene. The contracts of its members are those in scene.hpp and
/// scene_view.hpp. Instantiated for 2D and 3D, float and double.
template <Dim N, class T = float>
class GRAZE_EXPORT PlainScene {
 public:
  /// As Scene::add.
  ObjectId add(AnyShape<N, T> shape, ObjectOptions options = {});
  /// As Scene::plan_ids.
  void plan_ids(std::span<const ObjectId> next, std::span<const ObjectId> vacant);
  /// As Scene::move of one object.
  void move(ObjectId id, AnyShape<N, T> shape);
  /// As Scene::move of many objects.
  void move(std::span<const ObjectMove<N, T>> moves);
  /// As Scene::remove.
  void remove(ObjectId id);
  /// As Scene::except.
  void except(ObjectId a, ObjectId b);
  /// As Scene::accept.
  void accept(ObjectId a, ObjectId b);
  /// As Scene::layer.
  Layer layer(std::string_view name);
  /// As Scene::update, but returns the events by value.
  SceneEvents update();

  /// As SceneView::find. Takes linear time.
  std::optional<ObjectId> find(std::string_view name) const;
  /// As SceneView::excepted.
  bool excepted(ObjectId a, ObjectId b) const;
  /// As SceneView::excepted_pairs.
  std::vector<ObjectPair> excepted_pairs() const { return {exceptions_.begin(), exceptions_.end()}; }
  /// As SceneView::candidates. Tests all pairs.
  std::vector<ObjectPair> candidates(double margin = 0) const;
  /// As SceneView::pairs. Tests all pairs.
  std::vector<ObjectPair> pairs() const;
  /// As SceneView::contacts. Tests all pairs.
  std::vector<ObjectContact<N, T>> contacts() const;
  /// As SceneView::closest_pairs. Tests all pairs.
  std::vector<NearPair<T>> closest_pairs(T within) const;
  /// As SceneView::overlapping. Tests all objects.
  std::vector<ObjectId> overlapping(const AnyShape<N, T>& region, const SceneQuery& query) const;
  /// Of the objects on these layers.
  std::vector<ObjectId> overlapping(const AnyShape<N, T>& region, LayerMask layers = all_layers) const {
    return overlapping(region, SceneQuery{.layers = layers});
  }
  /// As SceneView::contacts_with. Tests all objects.
  std::vector<ObjectTouch<N, T>> contacts_with(const AnyShape<N, T>& shape, const SceneQuery& query = {}) const;
  /// As SceneView::cull of a shape. Tests all objects.
  std::vector<ObjectId> cull(const AnyShape<N, T>& region, const SceneQuery& query) const;
  /// Of the objects on these layers.
  std::vector<ObjectId> cull(const AnyShape<N, T>& region, LayerMask layers = all_layers) const {
    return cull(region, SceneQuery{.layers = layers});
  }
  /// As SceneView::cull of a frustum. Tests all objects.
  std::vector<ObjectId> cull(const Frustum<N, T>& frustum, const SceneQuery& query) const;
  /// Of the objects on these layers.
  std::vector<ObjectId> cull(const Frustum<N, T>& frustum, LayerMask layers = all_layers) const {
    return cull(frustum, SceneQuery{.layers = layers});
  }
  /// As SceneView::nearest. Tests all objects.
  std::vector<NearObject<T>> nearest(const Vec<N, T>& point, std::size_t count, const SceneQuery& query) const;
  /// Of the objects on these layers.
  std::vector<NearObject<T>> nearest(const Vec<N, T>& point, std::size_t count, LayerMask layers = all_layers) const {
    return nearest(point, count, SceneQuery{.layers = layers});
  }
  /// As SceneView::nearest to a shape. Tests all objects.
  std::vector<NearObject<T>> nearest(const AnyShape<N, T>& shape, std::size_t count,
                                     const SceneQuery& query = {}) const;
  /// As SceneView::ray_cast. Tests all objects.
  std::optional<ObjectHit<N, T>> ray_cast(const Ray<N, T>& ray, T t_max, const SceneQuery& query) const;
  /// Of the objects on these layers.
  std::optional<ObjectHit<N, T>> ray_cast(const Ray<N, T>& ray, T t_max = std::numeric_limits<T>::infinity(),
                                          LayerMask layers = all_layers) const {
    return ray_cast(ray, t_max, SceneQuery{.layers = layers});
  }
  /// As SceneView::ray_cast_all. Tests all objects.
  std::vector<ObjectHit<N, T>> ray_cast_all(const Ray<N, T>& ray, T t_max, const SceneQuery& query) const;
  /// Of the objects on these layers.
  std::vector<ObjectHit<N, T>> ray_cast_all(const Ray<N, T>& ray, T t_max = std::numeric_limits<T>::infinity(),
                                            LayerMask layers = all_layers) const {
    return ray_cast_all(ray, t_max, SceneQuery{.layers = layers});
  }
  /// As SceneView::shape_cast. Tests all objects.
  std::optional<ObjectImpact<N, T>> shape_cast(const AnyShape<N, T>& shape, const Vec<N, T>& motion,
                                               const SceneQuery& query = {}) const;
  /// As SceneView::shape_cast_all. Tests all objects.
  std::vector<ObjectImpact<N, T>> shape_cast_all(const AnyShape<N, T>& shape, const Vec<N, T>& motion,
                                                 const SceneQuery& query = {}) const;
  /// As SceneView::time_of_impact. Tests all objects, and leaves out none.
  std::optional<ObjectImpact<N, T>> time_of_impact(const AnyShape<N, T>& shape, const Motion<N, T>& motion,
                                                   const SceneQuery& query = {}) const;

 private:
  const Object<N, T>& at(ObjectId id) const;
  bool may_be_pair(const ObjectPair& pair) const;
  template <class R>
  std::vector<ObjectId> near(const R& region, const SceneQuery& query) const;
  template <class Measure>
  std::vector<NearObject<T>> nearest_to(std::size_t count, const SceneQuery& query, const Measure& distance_to) const;
  template <class Find>
  std::vector<ObjectImpact<N, T>> impacts(const SceneQuery& query, const Find& find) const;

  std::map<ObjectId, Object<N, T>> objects_;  // in the order of results
  detail::KeyTable ids_{max_objects};         // vacant places are a stack
  std::set<ObjectPair> exceptions_;
  std::vector<std::string> layer_names_;
  std::vector<ObjectPair> touching_;  // at the last update
};

}  // namespace graze
