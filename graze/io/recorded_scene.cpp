// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <exception>
#include <iterator>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include <graze/io/log/query_log.hpp>
#include <graze/io/recorded_scene.hpp>
#include <graze/io/shape_numbers.hpp>
#include <graze/shape/fields/description.hpp>

namespace graze::io {
namespace {

/// Adds a shape to a call, or a description of its fault: an invalid shape cannot be written.
template <Dim N, class T>
void give(LoggedCall<N>& call, const AnyShape<N, T>& shape) {
  const std::string_view fault = defect(shape);
  if (!fault.empty()) {
    call.fault = fmt::format("{} {}", graze::detail::with_article(type_name<N, T>(shape)), fault);
  } else {
    call.shapes.push_back(with_numbers<double, N, T>(shape));
  }
}

template <Dim N, class T>
LoggedCall<N> call_with(CallKind kind, const AnyShape<N, T>& shape) {
  LoggedCall<N> call{.kind = kind};
  give(call, shape);
  return call;
}

template <Dim N, class T>
LoggedCall<N> ray_call(CallKind kind, const Ray<N, T>& ray, T t_max) {
  LoggedCall<N> call = call_with<N, T>(kind, ray);
  call.t_max = static_cast<double>(t_max);
  const bool is_number = t_max > -std::numeric_limits<T>::infinity();
  if (!is_number) call.fault = fmt::format("a t_max that is {}", call.t_max);
  return call;
}

/// The call of a shape that moves. A motion that is not finite cannot be written.
template <Dim N, class T>
LoggedCall<N> motion_call(CallKind kind, const AnyShape<N, T>& shape, const Motion<N, T>& motion) {
  LoggedCall<N> call = call_with(kind, shape);
  if (!is_finite(motion)) {
    call.fault = "a motion that is not finite";
  } else {
    call.motion = {Vec<N, double>(motion.linear), Turn<N, double>(motion.angular), Vec<N, double>(motion.center)};
  }
  return call;
}

/// Whether the ids differ from those that adding the objects in order would give.
template <Dim N, class T>
bool needs_plan_of_ids(const Scene<N, T>& scene) {
  const std::vector<ObjectId> ids = scene.ids();
  return !scene.vacant_ids().empty() ||
         std::any_of(ids.begin(), ids.end(), [](const ObjectId& id) { return id.generation != 1; });
}

}  // namespace

template <Dim N, class T>
RecordedScene<N, T>::RecordedScene(std::ostream& log, Scene<N, T>* scene)
    : scene_(scene == nullptr ? &own_ : scene), log_(&log) {
  const SceneEvents& last = scene_->events();
  std::vector<ObjectPair> touching;
  std::merge(last.began.begin(), last.began.end(), last.stayed.begin(), last.stayed.end(),
             std::back_inserter(touching));
  if (!touching.empty() && touching != scene_->pairs()) {
    throw std::logic_error("RecordedScene: the scene has changed since its last update; update it before");
  }
  *log_ << log_head(N, number_type_of<T>) << '\n';
  write_past(touching);
  log_->flush();
}

/// The calls that recreate the scene, which has these touching pairs since its last update.
template <Dim N, class T>
void RecordedScene<N, T>::write_past(const std::vector<ObjectPair>& touching) {
  const std::vector<ObjectId> ids = scene_->ids();
  const std::vector<ObjectId> vacant = scene_->vacant_ids();
  if (!ids.empty()) ids_.learn_from(ids.front());
  if (!vacant.empty()) ids_.learn_from(vacant.front());
  const auto note = [this](const LoggedCall<N>& call, const LoggedAnswer& answer) {
    write(call);
    write(answer);
  };
  if (needs_plan_of_ids(*scene_)) {
    LoggedCall<N> plan{.kind = CallKind::plan_ids};
    for (const ObjectId& id : ids) plan.ids.push_back(ids_.logged(id));
    for (const ObjectId& id : vacant) plan.vacant_ids.push_back(ids_.logged(id));
    note(plan, {});
  }
  Layer number = 0;
  for (const std::string& name : scene_->layer_names()) note({.kind = CallKind::layer, .name = name}, logged(number++));
  for (const ObjectId& id : ids) {
    const Object<N, T>& object = scene_->object(id);
    note({.kind = CallKind::add,
          .shapes = {with_numbers<double, N, T>(object.shape)},
          .options = {object.name, object.layer, object.mask, object.user, object.mobility}},
         logged(id));
  }
  for (const auto& [a, b] : scene_->excepted_pairs()) {
    note({.kind = CallKind::except, .ids = {ids_.logged(a), ids_.logged(b)}}, {});
  }
  if (touching.empty()) return;
  note({.kind = CallKind::update}, logged(SceneEvents{touching, {}, {}}));
}

template <Dim N, class T>
void RecordedScene<N, T>::write(const LoggedCall<N>& call) const {
  *log_ << call_line(call) + '\n';
}

template <Dim N, class T>
void RecordedScene<N, T>::write(const LoggedAnswer& answer) const {
  *log_ << answer_line(ids_.logged(answer)) + '\n';
}

template <Dim N, class T>
template <class Act>
decltype(auto) RecordedScene<N, T>::record(const LoggedCall<N>& call, const Act& act) const {
  const std::lock_guard<std::mutex> lock(one_call_);
  write(call);
  log_->flush();
  const auto perform = [&]() -> decltype(auto) {
    try {
      return act();
    } catch (const std::exception& error) {
      write(LoggedAnswer{.refusal = error.what()});
      throw;
    } catch (...) {  // an executor may throw anything
      write(LoggedAnswer{.refusal = "an exception of an unknown type"});
      throw;
    }
  };
  if constexpr (std::is_void_v<decltype(act())>) {
    perform();
    write(LoggedAnswer{});
  } else {
    decltype(auto) result = perform();
    write(logged(result));
    return result;
  }
}

template <Dim N, class T>
ObjectId RecordedScene<N, T>::add(AnyShape<N, T> shape, ObjectOptions options) {
  LoggedCall<N> call{.kind = CallKind::add, .options = options};
  give(call, shape);
  return record(call, [&] {
    const ObjectId id = scene_->add(std::move(shape), std::move(options));
    ids_.learn_from(id);
    return id;
  });
}

template <Dim N, class T>
void RecordedScene<N, T>::plan_ids(std::span<const ObjectId> next, std::span<const ObjectId> vacant) {
  LoggedCall<N> call{.kind = CallKind::plan_ids};
  for (const ObjectId& id : next) call.ids.push_back({id.index, id.generation, logged_scene});
  for (const ObjectId& id : vacant) call.vacant_ids.push_back({id.index, id.generation, logged_scene});
  record(call, [&] { scene_->plan_ids(next, vacant); });
}

template <Dim N, class T>
void RecordedScene<N, T>::move(ObjectId id, AnyShape<N, T> shape) {
  LoggedCall<N> call{.kind = CallKind::move, .ids = {ids_.logged(id)}};
  give(call, shape);
  record(call, [&] { scene_->move(id, std::move(shape)); });
}

template <Dim N, class T>
void RecordedScene<N, T>::move(std::span<const ObjectMove<N, T>> moves) {
  LoggedCall<N> call{.kind = CallKind::move_many};
  for (const ObjectMove<N, T>& each : moves) {
    call.ids.push_back(ids_.logged(each.id));
    give(call, each.shape);
  }
  record(call, [&] { scene_->move(moves); });
}

template <Dim N, class T>
void RecordedScene<N, T>::remove(ObjectId id) {
  record({.kind = CallKind::remove, .ids = {ids_.logged(id)}}, [&] { scene_->remove(id); });
}

template <Dim N, class T>
void RecordedScene<N, T>::except(ObjectId a, ObjectId b) {
  record({.kind = CallKind::except, .ids = {ids_.logged(a), ids_.logged(b)}}, [&] { scene_->except(a, b); });
}

template <Dim N, class T>
void RecordedScene<N, T>::accept(ObjectId a, ObjectId b) {
  record({.kind = CallKind::accept, .ids = {ids_.logged(a), ids_.logged(b)}}, [&] { scene_->accept(a, b); });
}

template <Dim N, class T>
Layer RecordedScene<N, T>::layer(std::string_view name) {
  return record({.kind = CallKind::layer, .name = std::string(name)}, [&] { return scene_->layer(name); });
}

template <Dim N, class T>
const SceneEvents& RecordedScene<N, T>::update(const Executor& executor) {
  return record({.kind = CallKind::update}, [&]() -> const SceneEvents& { return scene_->update(executor); });
}

template <Dim N, class T>
std::optional<ObjectId> RecordedScene<N, T>::find(std::string_view name) const {
  return record({.kind = CallKind::find, .name = std::string(name)}, [&] { return scene_->find(name); });
}

template <Dim N, class T>
std::vector<ObjectPair> RecordedScene<N, T>::candidates(double margin) const {
  LoggedCall<N> call{.kind = CallKind::candidates, .margin = margin};
  if (!std::isfinite(margin)) call.fault = fmt::format("a margin that is {}", margin);
  return record(call, [&] { return scene_->candidates(margin); });
}

template <Dim N, class T>
std::vector<ObjectPair> RecordedScene<N, T>::pairs() const {
  return record({.kind = CallKind::pairs}, [&] { return scene_->pairs(); });
}

template <Dim N, class T>
std::vector<ObjectContact<N, T>> RecordedScene<N, T>::contacts(const Executor& executor) const {
  return record({.kind = CallKind::contacts}, [&] { return scene_->contacts(executor); });
}

/// Those that it names, and those that its predicate does not accept.
template <Dim N, class T>
std::vector<ObjectId> RecordedScene<N, T>::left_out_by(const SceneQuery& query) const {
  std::vector<ObjectId> result(query.except.begin(), query.except.end());
  if (!query.predicate) return result;
  for (const ObjectId& id : scene_->ids()) {
    const bool is_asked_for = detail::admits({.layers = query.layers, .except = query.except}, id, object(id).layer);
    if (is_asked_for && !query.predicate(id)) result.push_back(id);
  }
  return result;
}

/// Adds the query to a call, and records it. The predicate is not called during the call, so that it may
/// query this scene.
template <Dim N, class T>
template <class Ask>
auto RecordedScene<N, T>::ask(LoggedCall<N> call, const SceneQuery& query, const Ask& act) const {
  const std::vector<ObjectId> except = left_out_by(query);
  call.layers = query.layers;
  for (const ObjectId& id : except) call.except.push_back(ids_.logged(id));
  call.ignore_initial_touch = query.ignore_initial_touch;
  return record(call, [&] {
    return act(
        SceneQuery{.layers = query.layers, .except = except, .ignore_initial_touch = query.ignore_initial_touch});
  });
}

template <Dim N, class T>
std::vector<ObjectId> RecordedScene<N, T>::overlapping(const AnyShape<N, T>& region, const SceneQuery& query) const {
  return ask(call_with(CallKind::overlapping, region), query,
             [&](const SceneQuery& asked) { return scene_->overlapping(region, asked); });
}

template <Dim N, class T>
std::vector<ObjectId> RecordedScene<N, T>::cull(const AnyShape<N, T>& region, const SceneQuery& query) const {
  return ask(call_with(CallKind::cull, region), query,
             [&](const SceneQuery& asked) { return scene_->cull(region, asked); });
}

template <Dim N, class T>
std::vector<ObjectId> RecordedScene<N, T>::cull(const Frustum<N, T>& frustum, const SceneQuery& query) const {
  LoggedCall<N> call{.kind = CallKind::cull_frustum};
  for (const Vec<N, T>& corner : frustum.corners) call.corners.push_back(Vec<N, double>(corner));
  if (!is_valid(frustum)) call.fault = fmt::format("a frustum {}", defect(frustum));
  return ask(std::move(call), query, [&](const SceneQuery& asked) { return scene_->cull(frustum, asked); });
}

template <Dim N, class T>
std::vector<NearObject<T>> RecordedScene<N, T>::nearest(const Vec<N, T>& point, std::size_t count,
                                                        const SceneQuery& query) const {
  LoggedCall<N> call = call_with<N, T>(CallKind::nearest, point);
  call.count = count;
  return ask(std::move(call), query, [&](const SceneQuery& asked) { return scene_->nearest(point, count, asked); });
}

template <Dim N, class T>
std::optional<ObjectHit<N, T>> RecordedScene<N, T>::ray_cast(const Ray<N, T>& ray, T t_max,
                                                             const SceneQuery& query) const {
  return ask(ray_call(CallKind::ray_cast, ray, t_max), query,
             [&](const SceneQuery& asked) { return scene_->ray_cast(ray, t_max, asked); });
}

template <Dim N, class T>
std::vector<ObjectHit<N, T>> RecordedScene<N, T>::ray_cast_all(const Ray<N, T>& ray, T t_max,
                                                               const SceneQuery& query) const {
  return ask(ray_call(CallKind::ray_cast_all, ray, t_max), query,
             [&](const SceneQuery& asked) { return scene_->ray_cast_all(ray, t_max, asked); });
}

template <Dim N, class T>
std::vector<NearPair<T>> RecordedScene<N, T>::closest_pairs(T within) const {
  LoggedCall<N> call{.kind = CallKind::closest_pairs, .within = static_cast<double>(within)};
  if (!std::isfinite(within)) call.fault = fmt::format("a distance that is {}", within);
  return record(call, [&] { return scene_->closest_pairs(within); });
}

template <Dim N, class T>
std::vector<ObjectTouch<N, T>> RecordedScene<N, T>::contacts_with(const AnyShape<N, T>& shape,
                                                                  const SceneQuery& query) const {
  return ask(call_with(CallKind::contacts_with, shape), query,
             [&](const SceneQuery& asked) { return scene_->contacts_with(shape, asked); });
}

template <Dim N, class T>
std::vector<NearObject<T>> RecordedScene<N, T>::nearest(const AnyShape<N, T>& shape, std::size_t count,
                                                        const SceneQuery& query) const {
  LoggedCall<N> call = call_with(CallKind::nearest_to, shape);
  call.count = count;
  return ask(std::move(call), query, [&](const SceneQuery& asked) { return scene_->nearest(shape, count, asked); });
}

template <Dim N, class T>
std::optional<ObjectImpact<N, T>> RecordedScene<N, T>::shape_cast(const AnyShape<N, T>& shape, const Vec<N, T>& motion,
                                                                  const SceneQuery& query) const {
  return ask(motion_call<N, T>(CallKind::shape_cast, shape, {motion}), query,
             [&](const SceneQuery& asked) { return scene_->shape_cast(shape, motion, asked); });
}

template <Dim N, class T>
std::vector<ObjectImpact<N, T>> RecordedScene<N, T>::shape_cast_all(const AnyShape<N, T>& shape,
                                                                    const Vec<N, T>& motion,
                                                                    const SceneQuery& query) const {
  return ask(motion_call<N, T>(CallKind::shape_cast_all, shape, {motion}), query,
             [&](const SceneQuery& asked) { return scene_->shape_cast_all(shape, motion, asked); });
}

template <Dim N, class T>
std::optional<ObjectImpact<N, T>> RecordedScene<N, T>::time_of_impact(const AnyShape<N, T>& shape,
                                                                      const Motion<N, T>& motion,
                                                                      const SceneQuery& query) const {
  return ask(motion_call<N, T>(CallKind::time_of_impact, shape, motion), query,
             [&](const SceneQuery& asked) { return scene_->time_of_impact(shape, motion, asked); });
}

template class RecordedScene<2, float>;
template class RecordedScene<3, float>;
template class RecordedScene<2, double>;
template class RecordedScene<3, double>;

}  // namespace graze::io
