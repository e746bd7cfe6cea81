// SPDX-License-Identifier: MIT
/// @file
/// A scene that writes its calls to a log, so that a bug report can contain what happened.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <graze/broad/executor.hpp>
#include <graze/io/log/logged_answer.hpp>
#include <graze/io/log/logged_call.hpp>
#include <graze/io/log/logged_ids.hpp>
#include <graze/math/motion.hpp>
#include <graze/math/platform/export.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/scene.hpp>
#include <graze/scene/scene_query.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/frustum.hpp>

namespace graze::io {

/// Has the calls of a Scene, with the same meaning, and writes each to a log (docs/query_log.md) with its result: an
/// answer, or the message of an exception. A Scene that is not recorded pays nothing. A program that names its scene
/// type once, `using World = graze::Scene<3>;`, records by changing it to `graze::io::RecordedScene<3>`.
///
/// A call is written and flushed before it is performed, so it is in the log even if the program crashes in it. What
/// only reads stored values (`object`, `contains`, `size`, snapshots) goes to `scene()` and is not recorded. Const
/// calls are safe from many threads at once and run one after the other. Beside what Scene throws, every call throws
/// OutputError, before it does anything, if its arguments cannot be written (see call_line). The caller checks the
/// state of the stream. Instantiated for 2D and 3D, float and double.
template <Dim N, class T = float>
class GRAZE_EXPORT RecordedScene {
 public:
  /// Starts a log on a stream, which must outlive this object, of a scene of its own.
  explicit RecordedScene(std::ostream& log) : RecordedScene(log, nullptr) {}

  /// Starts a log with the current state of a scene, which must outlive this object: its later calls are recorded if
  /// they are made here. Throws std::logic_error, before it writes anything, if the touching pairs have changed since
  /// the last update, because the log could not reproduce the next events.
  RecordedScene(std::ostream& log, Scene<N, T>& scene) : RecordedScene(log, &scene) {}

  RecordedScene(const RecordedScene&) = delete;
  RecordedScene& operator=(const RecordedScene&) = delete;

  /// The scene, for calls that are not recorded.
  const Scene<N, T>& scene() const { return *scene_; }

  /// As Scene::add. Recorded.
  ObjectId add(AnyShape<N, T> shape, ObjectOptions options = {});
  /// As Scene::plan_ids. Recorded.
  void plan_ids(std::span<const ObjectId> next, std::span<const ObjectId> vacant);
  /// As Scene::move of one object. Recorded.
  void move(ObjectId id, AnyShape<N, T> shape);
  /// As Scene::move of many objects. Recorded.
  void move(std::span<const ObjectMove<N, T>> moves);

  /// As Scene::move of many objects to shapes of one type. Recorded as a list of any shapes, but not if the numbers of
  /// shapes and ids differ.
  template <detail::CopiedIntoAnyShape<N, T> S>
  void move(std::span<const ObjectId> ids, std::span<const S> shapes) {
    if (ids.size() != shapes.size()) return scene_->move(ids, shapes);  // throws
    std::vector<ObjectMove<N, T>> moves;
    moves.reserve(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) moves.push_back({ids[i], shapes[i]});
    move(std::span<const ObjectMove<N, T>>(moves.data(), moves.size()));
  }
  /// The overload for vectors, from which the spans' template arguments cannot be deduced.
  template <class S>
  void move(const std::vector<ObjectId>& ids, const std::vector<S>& shapes) {
    move(std::span<const ObjectId>(ids.data(), ids.size()), std::span<const S>(shapes.data(), shapes.size()));
  }

  /// As Scene::remove. Recorded.
  void remove(ObjectId id);
  /// As Scene::except. Recorded.
  void except(ObjectId a, ObjectId b);
  /// As Scene::accept. Recorded.
  void accept(ObjectId a, ObjectId b);
  /// As Scene::layer. Recorded.
  Layer layer(std::string_view name);
  /// As Scene::update. Recorded with its events.
  const SceneEvents& update(const Executor& executor = default_executor());
  /// As Scene::snapshot. Not recorded.
  std::shared_ptr<const SceneView<N, T>> snapshot() { return scene_->snapshot(); }

  /// As SceneView::contains. Not recorded.
  bool contains(ObjectId id) const { return scene_->contains(id); }
  /// As SceneView::object. Not recorded.
  const Object<N, T>& object(ObjectId id) const { return scene_->object(id); }
  /// As Scene::events. Not recorded.
  const SceneEvents& events() const { return scene_->events(); }
  /// As SceneView::ids. Not recorded.
  std::vector<ObjectId> ids() const { return scene_->ids(); }
  /// As SceneView::layer_names. Not recorded.
  const std::vector<std::string>& layer_names() const { return scene_->layer_names(); }
  /// As SceneView::size. Not recorded.
  std::size_t size() const { return scene_->size(); }

  /// As SceneView::excepted. Not recorded.
  bool excepted(ObjectId a, ObjectId b) const { return scene_->excepted(a, b); }
  /// As SceneView::excepted_pairs. Not recorded.
  std::vector<ObjectPair> excepted_pairs() const { return scene_->excepted_pairs(); }

  /// As SceneView::find. Recorded.
  std::optional<ObjectId> find(std::string_view name) const;
  /// As SceneView::candidates. Recorded.
  std::vector<ObjectPair> candidates(double margin = 0) const;
  /// As SceneView::pairs. Recorded.
  std::vector<ObjectPair> pairs() const;
  /// As SceneView::contacts. Recorded.
  std::vector<ObjectContact<N, T>> contacts(const Executor& executor = default_executor()) const;
  /// As SceneView::closest_pairs. Recorded.
  std::vector<NearPair<T>> closest_pairs(T within) const;
  /// As SceneView::contacts_with. Recorded. A predicate, here and below, is called for every object on the layers,
  /// before the call; the log holds the objects that it leaves out.
  std::vector<ObjectTouch<N, T>> contacts_with(const AnyShape<N, T>& shape, const SceneQuery& query = {}) const;
  /// As SceneView::overlapping. Recorded.
  std::vector<ObjectId> overlapping(const AnyShape<N, T>& region, const SceneQuery& query) const;
  /// The same, of layers. Recorded.
  std::vector<ObjectId> overlapping(const AnyShape<N, T>& region, LayerMask layers = all_layers) const {
    return overlapping(region, SceneQuery{.layers = layers});
  }
  /// As SceneView::cull of a shape. Recorded.
  std::vector<ObjectId> cull(const AnyShape<N, T>& region, const SceneQuery& query) const;
  /// The same, of layers. Recorded.
  std::vector<ObjectId> cull(const AnyShape<N, T>& region, LayerMask layers = all_layers) const {
    return cull(region, SceneQuery{.layers = layers});
  }
  /// As SceneView::cull of a frustum. Recorded.
  std::vector<ObjectId> cull(const Frustum<N, T>& frustum, const SceneQuery& query) const;
  /// The same, of layers. Recorded.
  std::vector<ObjectId> cull(const Frustum<N, T>& frustum, LayerMask layers = all_layers) const {
    return cull(frustum, SceneQuery{.layers = layers});
  }
  /// As SceneView::nearest. Recorded.
  std::vector<NearObject<T>> nearest(const Vec<N, T>& point, std::size_t count, const SceneQuery& query) const;
  /// The same, of layers. Recorded.
  std::vector<NearObject<T>> nearest(const Vec<N, T>& point, std::size_t count, LayerMask layers = all_layers) const {
    return nearest(point, count, SceneQuery{.layers = layers});
  }
  /// As SceneView::nearest to a shape. Recorded.
  std::vector<NearObject<T>> nearest(const AnyShape<N, T>& shape, std::size_t count,
                                     const SceneQuery& query = {}) const;
  /// As SceneView::ray_cast. Recorded.
  std::optional<ObjectHit<N, T>> ray_cast(const Ray<N, T>& ray, T t_max, const SceneQuery& query) const;
  /// The same, of layers. Recorded.
  std::optional<ObjectHit<N, T>> ray_cast(const Ray<N, T>& ray, T t_max = std::numeric_limits<T>::infinity(),
                                          LayerMask layers = all_layers) const {
    return ray_cast(ray, t_max, SceneQuery{.layers = layers});
  }
  /// As SceneView::ray_cast_all. Recorded.
  std::vector<ObjectHit<N, T>> ray_cast_all(const Ray<N, T>& ray, T t_max, const SceneQuery& query) const;
  /// The same, of layers. Recorded.
  std::vector<ObjectHit<N, T>> ray_cast_all(const Ray<N, T>& ray, T t_max = std::numeric_limits<T>::infinity(),
                                            LayerMask layers = all_layers) const {
    return ray_cast_all(ray, t_max, SceneQuery{.layers = layers});
  }
  /// As SceneView::shape_cast. Recorded.
  std::optional<ObjectImpact<N, T>> shape_cast(const AnyShape<N, T>& shape, const Vec<N, T>& motion,
                                               const SceneQuery& query = {}) const;
  /// As SceneView::shape_cast_all. Recorded.
  std::vector<ObjectImpact<N, T>> shape_cast_all(const AnyShape<N, T>& shape, const Vec<N, T>& motion,
                                                 const SceneQuery& query = {}) const;
  /// As SceneView::time_of_impact. Recorded.
  std::optional<ObjectImpact<N, T>> time_of_impact(const AnyShape<N, T>& shape, const Motion<N, T>& motion,
                                                   const SceneQuery& query = {}) const;

 private:
  RecordedScene(std::ostream& log, Scene<N, T>* scene);

  std::vector<ObjectId> left_out_by(const SceneQuery& query) const;
  template <class Ask>
  auto ask(LoggedCall<N> call, const SceneQuery& query, const Ask& act) const;
  template <class Act>
  decltype(auto) record(const LoggedCall<N>& call, const Act& act) const;
  void write(const LoggedCall<N>& call) const;
  void write(const LoggedAnswer& answer) const;
  void write_past(const std::vector<ObjectPair>& touching);

  Scene<N, T> own_;
  Scene<N, T>* scene_;
  std::ostream* log_;
  LoggedIds ids_;
  mutable std::mutex one_call_;
};

}  // namespace graze::io
