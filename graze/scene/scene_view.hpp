// SPDX-License-Identifier: MIT
// What can be read of a scene: of one that lives on, and of a snapshot that stays as it is.
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
#include <graze/broad/touching/relations.hpp>
#include <graze/math/vec.hpp>
#include <graze/query/manifold.hpp>
#include <graze/query/ray_hit.hpp>
#include <graze/scene/events.hpp>
#include <graze/scene/filter.hpp>
#include <graze/scene/object.hpp>
#include <graze/scene/storage/object_index.hpp>
#include <graze/scene/storage/shared_slots.hpp>
#include <graze/scene/storage/shared_value.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/frustum.hpp>

namespace graze {

/// An object by its distance from a point.
template <class T = float>
struct NearObject {
  ObjectId id;
  T distance;  ///< 0 when the point is in the object.

  friend bool operator==(const NearObject&, const NearObject&) = default;
};

/// An object that a ray hits, and where.
template <Dim N, class T = float>
struct ObjectHit {
  ObjectId id;
  RayHit<N, T> hit;

  friend bool operator==(const ObjectHit&, const ObjectHit&) = default;
};

/// Two objects that touch or overlap, and where.
template <Dim N, class T = float>
struct ObjectContact {
  ObjectPair pair;
  Manifold<N, T> manifold;  ///< From pair.a to pair.b; at least one point.

  friend bool operator==(const ObjectContact&, const ObjectContact&) = default;
};

/// Objects with names, layers and places. All of it is const and safe from many threads at once, as long as none writes
/// to the scene; a snapshot has nobody who could. Queries that look for objects take a mask: only objects on its layers
/// are found. Instantiated for 2D and 3D, float and double.
template <Dim N, class T = float>
class SceneView {
 public:
  /// True while the id names an object.
  bool contains(ObjectId id) const { return ids_.contains({id.index, id.generation, id.owner}); }

  /// The object. Throws std::out_of_range, saying what is wrong with the id, when it names none.
  const Object<N, T>& object(ObjectId id) const;

  /// The object of that name, if there is one. Empty names are not found.
  std::optional<ObjectId> find(std::string_view name) const;

  /// The object of this index and generation, by which a saved scene knows it, if it lives.
  std::optional<ObjectId> find(std::uint32_t index, std::uint32_t generation) const;

  /// The places that are free, of removed objects and of those that `plan_ids` has planned and nobody added yet: their
  /// index, and a generation that is even, zero where no object was there ever. They are used from the back, each for
  /// an id of the next generation, but for those of generation 4294967294, the last, which are used up.
  std::vector<ObjectId> vacant_ids() const;

  /// All ids, ascending: in the order of adding while nothing is removed.
  std::vector<ObjectId> ids() const;

  std::size_t size() const { return ids_.size(); }

  /// The names of the layers made so far, by number.
  const std::vector<std::string>& layer_names() const { return layer_names_; }

  /// All pairs whose boxes overlap, or are no farther apart than `margin` along any axis, and that may touch: what is
  /// worth an exact test. Ascending. Throws std::invalid_argument for a margin that is negative or not finite.
  std::vector<ObjectPair> candidates(double margin = 0) const;

  /// All pairs that touch or overlap and may, exactly tested. Ascending.
  std::vector<ObjectPair> pairs() const;

  /// Where the pairs touch, in the order of `pairs`: along which normal, how deep, at which points and on which
  /// features of the two, as query/manifold.hpp has it. Throws what the executor throws.
  std::vector<ObjectContact<N, T>> contacts(const Executor& executor = default_executor()) const;

  /// The objects that touch or overlap a region, which may be any shape, exactly tested. Ascending. Throws
  /// std::invalid_argument when the region is not valid.
  std::vector<ObjectId> overlapping(const AnyShape<N, T>& region, LayerMask layers = all_layers) const;

  /// The objects whose boxes touch or overlap a region: quicker, and never fewer than `overlapping`. Ascending. Throws
  /// like it.
  std::vector<ObjectId> cull(const AnyShape<N, T>& region, LayerMask layers = all_layers) const;

  /// The same for what a camera sees (shape/frustum.hpp: frustum_of). What touches it exactly says
  /// `overlapping(convex_hull<N, T>(frustum.corners))`.
  std::vector<ObjectId> cull(const Frustum<N, T>& frustum, LayerMask layers = all_layers) const;

  /// The `count` objects nearest to a point, or all if there are fewer: by distance, equal ones by id. The distance is
  /// that of the shape, of a compound that of its nearest part; an empty one is infinitely far and never found. Throws
  /// std::invalid_argument when the point is not finite.
  std::vector<NearObject<T>> nearest(const Vec<N, T>& point, std::size_t count, LayerMask layers = all_layers) const;

  /// The object that a ray hits first, of equal ones that of the lowest id; none beyond `t_max`, in units of the ray's
  /// direction: with 1, a segment. A ray that starts in an object hits it at t = 0 (query/ray_cast.hpp). Throws
  /// std::invalid_argument when the ray is not valid or t_max is negative or NaN.
  std::optional<ObjectHit<N, T>> ray_cast(const Ray<N, T>& ray, T t_max = std::numeric_limits<T>::infinity(),
                                          LayerMask layers = all_layers) const;

  /// All objects that a ray hits, each where it hits it first, in order of t, equal ones by id. Throws like ray_cast.
  std::vector<ObjectHit<N, T>> ray_cast_all(const Ray<N, T>& ray, T t_max = std::numeric_limits<T>::infinity(),
                                            LayerMask layers = all_layers) const;

 protected:
  using Names = std::unordered_map<std::string, ObjectId>;

  /// All of this as it is now, for reading.
  std::shared_ptr<const SceneView> share();

  ObjectId id_of(std::uint32_t slot) const {
    const Key key = ids_.key_of(slot);
    return {key.index, key.generation, key.owner};
  }

  const Object<N, T>& in_slot(std::uint32_t slot) const { return *objects_[slot]; }
  const detail::SlotIndex<N, T>& index() const { return index_.over(objects_); }

  /// The objects on these layers whose boxes a region meets, rounding allowed for. Ascending.
  template <class R>
  std::vector<ObjectId> near(const R& region, LayerMask layers) const;

  /// Those which a ray meets up to t_max.
  std::vector<ObjectId> near_way(const Ray<N, T>& ray, T t_max, LayerMask layers) const;

  detail::KeyTable ids_{max_objects};
  detail::SharedSlots<Object<N, T>> objects_;  // by slot: the index of an id
  detail::SharedValue<Names> names_;
  std::vector<std::string> layer_names_;
  detail::ObjectIndex<N, T> index_;
  detail::SharedValue<SceneEvents> events_;  // of the last update
  bool is_current_ = false;                  // nothing has changed since
};

extern template class SceneView<2, float>;
extern template class SceneView<3, float>;
extern template class SceneView<2, double>;
extern template class SceneView<3, double>;

}  // namespace graze
