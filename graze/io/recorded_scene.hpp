// SPDX-License-Identifier: MIT
// A scene whose calls are written to a log, so that a bug report can carry what happened.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <graze/broad/executor.hpp>
#include <graze/io/log/logged_answer.hpp>
#include <graze/io/log/logged_call.hpp>
#include <graze/io/log/logged_ids.hpp>
#include <graze/math/vec.hpp>
#include <graze/scene/scene.hpp>
#include <graze/shape/any_shape.hpp>
#include <graze/shape/frustum.hpp>

namespace graze::io {

/// Has the calls of a Scene, with the same meaning, and writes each to a log (docs/query_log.md) with what came of it:
/// an answer, or the message of an exception. It is around a scene, not in it: a Scene that nobody records has no
/// observer to ask, and knows nothing of text. A program that says `using World = graze::Scene<3>;` once records by
/// saying `graze::io::RecordedScene<3>` there.
///
/// A call stands in the log, flushed, before it is performed: it is there also if the program does not survive it. What
/// only reads what was stored (`object`, `contains`, `size`, snapshots) is asked of `scene()` and not recorded. Const
/// calls are safe from many threads at once, and are performed one after the other. Every call throws, beside what
/// Scene throws, OutputError before it does anything when its arguments cannot be written (see call_line). The state of
/// the stream is the caller's to check. Instantiated for 2D and 3D, float and double.
template <Dim N, class T = float>
class RecordedScene {
 public:
  /// Begins a log on a stream, which must outlive this, with a scene as it is. Throws std::logic_error for a scene that
  /// has changed since its last update, whose next events a log could not tell.
  explicit RecordedScene(std::ostream& log, Scene<N, T> scene = {});

  /// The scene, for calls that are not recorded.
  const Scene<N, T>& scene() const { return scene_; }

  ObjectId add(AnyShape<N, T> shape, ObjectOptions options = {});
  void plan_ids(std::span<const ObjectId> next, std::span<const ObjectId> vacant);
  void move(ObjectId id, AnyShape<N, T> shape);
  void move(std::span<const ObjectMove<N, T>> moves);

  /// Recorded as a list of any shapes; not at all where there are not as many shapes as ids.
  template <detail::CopiedIntoAnyShape<N, T> S>
  void move(std::span<const ObjectId> ids, std::span<const S> shapes) {
    if (ids.size() != shapes.size()) return scene_.move(ids, shapes);  // which says what is wrong
    std::vector<ObjectMove<N, T>> moves;
    moves.reserve(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) moves.push_back({ids[i], shapes[i]});
    move(std::span<const ObjectMove<N, T>>(moves.data(), moves.size()));
  }
  template <class S>
  void move(const std::vector<ObjectId>& ids, const std::vector<S>& shapes) {
    move(std::span<const ObjectId>(ids.data(), ids.size()), std::span<const S>(shapes.data(), shapes.size()));
  }

  void remove(ObjectId id);
  Layer layer(std::string_view name);
  const SceneEvents& update(const Executor& executor = default_executor());
  std::shared_ptr<const SceneView<N, T>> snapshot() { return scene_.snapshot(); }

  bool contains(ObjectId id) const { return scene_.contains(id); }
  const Object<N, T>& object(ObjectId id) const { return scene_.object(id); }
  const SceneEvents& events() const { return scene_.events(); }
  std::vector<ObjectId> ids() const { return scene_.ids(); }
  std::size_t size() const { return scene_.size(); }

  std::optional<ObjectId> find(std::string_view name) const;
  std::vector<ObjectPair> candidates(double margin = 0) const;
  std::vector<ObjectPair> pairs() const;
  std::vector<ObjectContact<N, T>> contacts(const Executor& executor = default_executor()) const;
  std::vector<ObjectId> overlapping(const AnyShape<N, T>& region, LayerMask layers = all_layers) const;
  std::vector<ObjectId> cull(const AnyShape<N, T>& region, LayerMask layers = all_layers) const;
  std::vector<ObjectId> cull(const Frustum<N, T>& frustum, LayerMask layers = all_layers) const;
  std::vector<NearObject<T>> nearest(const Vec<N, T>& point, std::size_t count, LayerMask layers = all_layers) const;
  std::optional<ObjectHit<N, T>> ray_cast(const Ray<N, T>& ray, T t_max = std::numeric_limits<T>::infinity(),
                                          LayerMask layers = all_layers) const;
  std::vector<ObjectHit<N, T>> ray_cast_all(const Ray<N, T>& ray, T t_max = std::numeric_limits<T>::infinity(),
                                            LayerMask layers = all_layers) const;

 private:
  template <class Act>
  decltype(auto) record(const LoggedCall<N>& call, const Act& act) const;
  void write(const LoggedCall<N>& call) const;
  void write(const LoggedAnswer& answer) const;
  void write_past();

  Scene<N, T> scene_;
  std::ostream* log_;
  LoggedIds ids_;
  mutable std::mutex one_call_;
};

extern template class RecordedScene<2, float>;
extern template class RecordedScene<3, float>;
extern template class RecordedScene<2, double>;
extern template class RecordedScene<3, double>;

}  // namespace graze::io
