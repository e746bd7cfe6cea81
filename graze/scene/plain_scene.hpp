// SPDX-License-Identifier: MIT
// The judge of Scene: the same calls, answered by asking every object by itself.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <graze/broad/index/key_table.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/events.hpp>
#include <graze/scene/object.hpp>
#include <graze/scene/scene.hpp>
#include <graze/scene/scene_view.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/frustum.hpp>

namespace graze {

/// Answers as a Scene does, and throws the same types of exceptions where it does, but without an index, memory of
/// pairs or threads: each question goes to all objects one after the other, those about pairs to all pairs. Too slow
/// for many objects, too simple to be wrong; for tests, and to judge what a scene answered. What the calls mean is said
/// in scene.hpp and scene_view.hpp. Instantiated for 2D and 3D, float and double.
template <Dim N, class T = float>
class PlainScene {
 public:
  ObjectId add(AnyShape<N, T> shape, ObjectOptions options = {});
  void plan_ids(std::span<const ObjectId> next, std::span<const ObjectId> vacant);
  void move(ObjectId id, AnyShape<N, T> shape);
  void move(std::span<const ObjectMove<N, T>> moves);
  void remove(ObjectId id);
  Layer layer(std::string_view name);
  SceneEvents update();

  std::optional<ObjectId> find(std::string_view name) const;
  std::vector<ObjectPair> candidates(double margin = 0) const;
  std::vector<ObjectPair> pairs() const;
  std::vector<ObjectContact<N, T>> contacts() const;
  std::vector<ObjectId> overlapping(const AnyShape<N, T>& region, LayerMask layers = all_layers) const;
  std::vector<ObjectId> cull(const AnyShape<N, T>& region, LayerMask layers = all_layers) const;
  std::vector<ObjectId> cull(const Frustum<N, T>& frustum, LayerMask layers = all_layers) const;
  std::vector<NearObject<T>> nearest(const Vec<N, T>& point, std::size_t count, LayerMask layers = all_layers) const;
  std::optional<ObjectHit<N, T>> ray_cast(const Ray<N, T>& ray, T t_max = std::numeric_limits<T>::infinity(),
                                          LayerMask layers = all_layers) const;
  std::vector<ObjectHit<N, T>> ray_cast_all(const Ray<N, T>& ray, T t_max = std::numeric_limits<T>::infinity(),
                                            LayerMask layers = all_layers) const;

 private:
  Object<N, T>& at(ObjectId id);
  template <class R>
  std::vector<ObjectId> near(const R& region, LayerMask layers) const;

  std::map<ObjectId, Object<N, T>> objects_;  // so that all answers ascend
  detail::KeyTable ids_{max_objects};         // a stack of vacant places
  std::vector<std::string> layer_names_;
  std::vector<ObjectPair> touching_;  // at the last update
};

extern template class PlainScene<2, float>;
extern template class PlainScene<3, float>;
extern template class PlainScene<2, double>;
extern template class PlainScene<3, double>;

}  // namespace graze
