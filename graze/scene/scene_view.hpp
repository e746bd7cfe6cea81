// SPDX-License-Identifier: MIT
/// @file
/// The read-only part of a scene, and of a snapshot.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <graze/broad/executor.hpp>
#include <graze/broad/index/key_table.hpp>
#include <graze/broad/index/swept_box.hpp>
#include <graze/math/motion.hpp>
#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/impact.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/mesh_hit.hpp>
#include <graze/query/relation.hpp>
#include <graze/scene/events.hpp>
#include <graze/scene/filter.hpp>
#include <graze/scene/object.hpp>
#include <graze/scene/scene_query.hpp>
#include <graze/scene/storage/object_index.hpp>
#include <graze/scene/storage/pair_exceptions.hpp>
#include <graze/scene/storage/shared_slots.hpp>
#include <graze/scene/storage/shared_value.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/frustum.hpp>

namespace graze {

/// An object and its distance from a point or a shape.
template <class T = float>
struct NearObject {
  ObjectId id;  ///< Names the object.
  T distance;   ///< 0 if the point is in the object, or the shape touches it.

  friend bool operator==(const NearObject&, const NearObject&) = default;
};

/// Two objects and their distance.
template <class T = float>
struct NearPair {
  ObjectPair pair;  ///< The two objects.
  T distance;       ///< 0 if they touch.

  friend bool operator==(const NearPair&, const NearPair&) = default;
};

/// An object that a ray hits, and the hit.
template <Dim N, class T = float>
struct ObjectHit {
  ObjectId id;        ///< Names the object.
  MeshHit<N, T> hit;  ///< Where the ray meets the object's shape; with a face if that is a mesh.

  friend bool operator==(const ObjectHit&, const ObjectHit&) = default;
};

/// An object that a moving shape touches, and the first touch.
template <Dim N, class T = float>
struct ObjectImpact {
  ObjectId id;          ///< Names the object.
  Impact<N, T> impact;  ///< When and where the shape meets the object's; the normal points towards the object.

  friend bool operator==(const ObjectImpact&, const ObjectImpact&) = default;
};

/// An object that touches or overlaps a shape, and their contact points.
template <Dim N, class T = float>
struct ObjectTouch {
  ObjectId id;              ///< Names the object.
  Manifold<N, T> manifold;  ///< The normal points from the shape towards the object; at least one point.

  friend bool operator==(const ObjectTouch&, const ObjectTouch&) = default;
};

/// Two objects that touch or overlap, and their contact points.
template <Dim N, class T = float>
struct ObjectContact {
  ObjectPair pair;          ///< The two objects.
  Manifold<N, T> manifold;  ///< The normal points from pair.a to pair.b; at least one point.

  friend bool operator==(const ObjectContact&, const ObjectContact&) = default;
};

/// Queries on the objects of a scene. Pairs are admitted by filters unless one of the masks lacks the other object's
/// layer, both objects are fixed, or the pair is excepted. All queries are const and safe from many threads at once
/// while none writes to the scene; nothing writes to a snapshot. Queries for objects take a mask and find only objects
/// on its layers, or a SceneQuery, which can also leave out single objects. Instantiated for 2D and 3D, float and
/// double.
template <Dim N, class T = float>
class GRAZE_EXPORT SceneView {
 public:
  /// True while the id names an object.
  bool contains(ObjectId id) const { return ids_.contains({id.index, id.generation, id.owner}); }

  /// The object with this id. Throws std::out_of_range, naming the reason, if there is none.
  const Object<N, T>& object(ObjectId id) const;

  /// The object with this name, or none. Empty names are not found.
  std::optional<ObjectId> find(std::string_view name) const;

  /// The object with this index and generation, by which saved scenes refer to it, or none.
  std::optional<ObjectId> find(std::uint32_t index, std::uint32_t generation) const;

  /// The vacant places: those of removed objects, and those that `plan_ids` has planned and that are not used yet. Each
  /// has its index and an even generation, zero if it never had an object. They are used from the back, each for an id
  /// with the next generation; places of generation 4294967294, the last, are not reused.
  std::vector<ObjectId> vacant_ids() const;

  /// All ids, ascending: in the order of adding as long as nothing is removed.
  std::vector<ObjectId> ids() const;

  /// Whether Scene::except has named these two objects, in any order. Throws like it.
  bool excepted(ObjectId a, ObjectId b) const;

  /// All excepted pairs. Ascending.
  std::vector<ObjectPair> excepted_pairs() const;

  /// Number of objects.
  std::size_t size() const { return ids_.size(); }

  /// The names of the layers created so far, by index.
  const std::vector<std::string>& layer_names() const { return layer_names_; }

  /// All pairs whose boxes overlap, or are at most `margin` apart along every axis, and that the filters admit: the
  /// pairs worth an exact test. Ascending. Throws std::invalid_argument if the margin is negative or not finite.
  /// `visit_candidates` does not store them all.
  std::vector<ObjectPair> candidates(double margin = 0) const;

  /// All pairs that touch or overlap and that the filters admit, exactly tested. Ascending.
  std::vector<ObjectPair> pairs() const;

  /// The contact points of `pairs`, in that order: normal, depths, points and features of both objects, as in
  /// query/manifold.hpp. Throws what the executor throws. `pairs` is cheaper.
  std::vector<ObjectContact<N, T>> contacts(const Executor& executor = default_executor()) const;

  /// All pairs that are at most `within` apart and that the filters admit, with their `distance` (query/distance.hpp),
  /// bit for bit. Ascending by pair. Zero gives those of `pairs`, which is cheaper. Throws std::invalid_argument if the
  /// distance is negative or not finite.
  std::vector<NearPair<T>> closest_pairs(T within) const;

  /// The objects that touch or overlap a region of any shape, exactly tested. Ascending. Throws std::invalid_argument
  /// if the region is invalid. `cull` is cheaper.
  std::vector<ObjectId> overlapping(const AnyShape<N, T>& region, const SceneQuery& query) const;
  /// Of the objects on these layers.
  std::vector<ObjectId> overlapping(const AnyShape<N, T>& region, LayerMask layers = all_layers) const {
    return overlapping(region, SceneQuery{.layers = layers});
  }

  /// The objects that touch or overlap a shape, which need not be an object, and where: for each the `manifold` of the
  /// shape and the object (query/manifold.hpp), bit for bit. Ascending. Throws std::invalid_argument if the shape is
  /// invalid. `overlapping` is cheaper.
  std::vector<ObjectTouch<N, T>> contacts_with(const AnyShape<N, T>& shape, const SceneQuery& query = {}) const;

  /// The objects whose boxes touch or overlap a region: cheaper, and never fewer than `overlapping`. Ascending. Throws
  /// std::invalid_argument if the region is invalid.
  std::vector<ObjectId> cull(const AnyShape<N, T>& region, const SceneQuery& query) const;
  /// Of the objects on these layers.
  std::vector<ObjectId> cull(const AnyShape<N, T>& region, LayerMask layers = all_layers) const {
    return cull(region, SceneQuery{.layers = layers});
  }

  /// The objects whose boxes touch or overlap a camera's view volume (shape/frustum.hpp: frustum_of). For an exact test
  /// use `overlapping(convex_hull<N, T>(frustum.corners))`.
  std::vector<ObjectId> cull(const Frustum<N, T>& frustum, const SceneQuery& query) const;
  /// Of the objects on these layers.
  std::vector<ObjectId> cull(const Frustum<N, T>& frustum, LayerMask layers = all_layers) const {
    return cull(frustum, SceneQuery{.layers = layers});
  }

  /// The `count` objects nearest to a point, or all if there are fewer: by distance, ties by id. The distance is that
  /// of the shape, for a compound that of its nearest part; empty compounds are infinitely far away and never found.
  /// Throws std::invalid_argument if the point is not finite.
  std::vector<NearObject<T>> nearest(const Vec<N, T>& point, std::size_t count, const SceneQuery& query) const;
  /// Of the objects on these layers.
  std::vector<NearObject<T>> nearest(const Vec<N, T>& point, std::size_t count, LayerMask layers = all_layers) const {
    return nearest(point, count, SceneQuery{.layers = layers});
  }

  /// The `count` objects nearest to a shape, which need not be an object, or all if there are fewer: by `distance`
  /// (query/distance.hpp), bit for bit, ties by id; 0 for all that touch the shape. Empty compounds are never found,
  /// and nothing is near an empty compound. Throws std::invalid_argument if the shape is invalid.
  std::vector<NearObject<T>> nearest(const AnyShape<N, T>& shape, std::size_t count,
                                     const SceneQuery& query = {}) const;

  /// The first object that a ray hits, of several the one with the lowest id; none beyond `t_max`, in units of the
  /// ray's direction: 1 makes it a segment. A ray that starts in an object hits it at t = 0 (query/ray_cast.hpp).
  /// Throws std::invalid_argument if the ray is invalid or t_max is negative or NaN.
  std::optional<ObjectHit<N, T>> ray_cast(const Ray<N, T>& ray, T t_max, const SceneQuery& query) const;
  /// Of the objects on these layers.
  std::optional<ObjectHit<N, T>> ray_cast(const Ray<N, T>& ray, T t_max = std::numeric_limits<T>::infinity(),
                                          LayerMask layers = all_layers) const {
    return ray_cast(ray, t_max, SceneQuery{.layers = layers});
  }

  /// All objects that a ray hits, each with its first hit, by t, ties by id. Throws like ray_cast.
  std::vector<ObjectHit<N, T>> ray_cast_all(const Ray<N, T>& ray, T t_max, const SceneQuery& query) const;
  /// Of the objects on these layers.
  std::vector<ObjectHit<N, T>> ray_cast_all(const Ray<N, T>& ray, T t_max = std::numeric_limits<T>::infinity(),
                                            LayerMask layers = all_layers) const {
    return ray_cast_all(ray, t_max, SceneQuery{.layers = layers});
  }

  /// The first object that a shape touches as it moves by `motion` from t = 0 to t = 1, of several the one with the
  /// lowest id: the earliest `shape_cast` of the shape at any object (query/shape_cast.hpp), bit for bit. What the
  /// shape touches at the start it touches at t = 0. The shape need not be an object; an object that is cast from its
  /// own place excepts itself. Throws std::invalid_argument if the shape is invalid or the motion is not finite.
  std::optional<ObjectImpact<N, T>> shape_cast(const AnyShape<N, T>& shape, const Vec<N, T>& motion,
                                               const SceneQuery& query = {}) const;

  /// All objects that a shape touches as it moves, each with its first touch, by t, ties by id: it passes through what
  /// it touches. Throws like shape_cast.
  std::vector<ObjectImpact<N, T>> shape_cast_all(const AnyShape<N, T>& shape, const Vec<N, T>& motion,
                                                 const SceneQuery& query = {}) const;

  /// The first object that a shape touches as it moves and rotates: the earliest `time_of_impact` of the shape and any
  /// object, which stays where it is (query/time_of_impact.hpp), bit for bit. If the shape rotates by hundreds of
  /// radians, mere bounds on the time (`Status::best_bound`) are left out for objects whose boxes it cannot reach.
  /// Throws like shape_cast, which is cheaper without rotation.
  std::optional<ObjectImpact<N, T>> time_of_impact(const AnyShape<N, T>& shape, const Motion<N, T>& motion,
                                                   const SceneQuery& query = {}) const;

 protected:
  /// @cond protected

  /// The objects by name.
  using Names = std::unordered_map<std::string, ObjectId>;

  /// A read-only copy of the current state: see Scene::snapshot.
  std::shared_ptr<const SceneView> share();

  /// The id of the object in a slot, which must be taken.
  ObjectId id_of(std::uint32_t slot) const {
    const Key key = ids_.key_of(slot);
    return {key.index, key.generation, key.owner};
  }

  /// The object in a slot, which must be taken.
  const Object<N, T>& in_slot(std::uint32_t slot) const { return *objects_[slot]; }

  /// Throws unless the ids name two different objects.
  void require_two_objects(ObjectId a, ObjectId b) const;

  /// The index of the boxes, up to date.
  const detail::SlotIndex<N, T>& index() const { return index_.over(objects_); }

  /// The objects whose boxes meet a region, up to rounding. Ascending.
  template <class R>
  std::vector<ObjectId> near(const R& region, const SceneQuery& query) const;

  /// The objects whose boxes a ray meets up to t_max, up to rounding.
  std::vector<ObjectId> near_way(const Ray<N, T>& ray, T t_max, const SceneQuery& query) const;

  /// The `count` objects of the least `distance_to(shape)`, which is at least the distance of their boxes from a box.
  template <class Measure>
  std::vector<NearObject<T>> nearest_to(const Aabb<N, T>& from, std::size_t count, const SceneQuery& query,
                                        const Measure& distance_to) const;

  /// The earliest of `find(shape)`, an optional impact, for the objects whose boxes a moving box may touch.
  template <class Find>
  std::optional<ObjectImpact<N, T>> first_impact(const detail::SweptBox<N>& sweep, const SceneQuery& query,
                                                 const Find& find) const;

  detail::KeyTable ids_{max_objects};                       ///< Which slots are taken, and their ids.
  detail::SharedSlots<Object<N, T>> objects_;               ///< By slot, the index of an id.
  detail::SharedValue<Names> names_;                        ///< Of the objects that have a name.
  std::vector<std::string> layer_names_;                    ///< By layer.
  detail::ObjectIndex<N, T> index_;                         ///< Finds objects by their boxes.
  detail::SharedValue<detail::PairExceptions> exceptions_;  ///< By slots: the excepted pairs.
  detail::SharedValue<SceneEvents> events_;                 ///< Those of the last update.
  bool is_current_ = false;                                 ///< True if nothing has changed since the last update.

  /// @endcond
};

}  // namespace graze
