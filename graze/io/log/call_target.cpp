// SPDX-License-Identifier: MIT
#include <algorithm>
#include <exception>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include <graze/io/log/call_target.hpp>
#include <graze/io/log/logged_ids.hpp>
#include <graze/io/shape_numbers.hpp>
#include <graze/math/motion.hpp>
#include <graze/scene/plain_scene.hpp>
#include <graze/scene/scene.hpp>
#include <graze/scene/scene_query.hpp>

namespace graze::io {
namespace {

/// A target that wraps a Scene or a PlainScene.
template <class World, Dim N, class T>
class WorldTarget final : public CallTarget<N> {
 public:
  LoggedAnswer perform(const LoggedCall<N>& call) override {
    try {
      return ids_.logged(form_of(call.kind).is_change ? change(call) : ask(call));
    } catch (const std::exception& error) {
      return {.refusal = error.what()};
    }
  }

 private:
  LoggedAnswer change(const LoggedCall<N>& call) {
    switch (call.kind) {
      case CallKind::plan_ids:
        world_.plan_ids(call.ids, call.vacant_ids);
        return {};
      case CallKind::layer:
        return logged(world_.layer(call.name));
      case CallKind::add: {
        const ObjectId id = world_.add(shape(call, 0), call.options);
        ids_.learn_from(id);
        return logged(id);
      }
      case CallKind::move:
        world_.move(ids_.real(call.ids.front()), shape(call, 0));
        return {};
      case CallKind::move_many:
        world_.move(moves(call));
        return {};
      case CallKind::except:
        world_.except(ids_.real(call.ids[0]), ids_.real(call.ids[1]));
        return {};
      case CallKind::accept:
        world_.accept(ids_.real(call.ids[0]), ids_.real(call.ids[1]));
        return {};
      default:
        world_.remove(ids_.real(call.ids.front()));
        return {};
    }
  }

  LoggedAnswer ask(const LoggedCall<N>& call) {
    switch (call.kind) {
      case CallKind::update:
        return logged(world_.update());
      case CallKind::find:
        return logged(world_.find(call.name));
      case CallKind::candidates:
        return logged(world_.candidates(call.margin));
      case CallKind::pairs:
        return logged(world_.pairs());
      case CallKind::contacts:
        return logged(world_.contacts());
      case CallKind::closest_pairs:
        return logged(world_.closest_pairs(static_cast<T>(call.within)));
      default:
        return ask_with_query(call);
    }
  }

  LoggedAnswer ask_with_query(const LoggedCall<N>& call) {
    std::vector<ObjectId> except;
    for (const ObjectId& id : call.except) except.push_back(ids_.real(id));
    const SceneQuery query{.layers = call.layers, .except = except, .ignore_initial_touch = call.ignore_initial_touch};
    if (call.kind == CallKind::cull_frustum) return logged(world_.cull(frustum(call), query));
    const AnyShape<N, T> asked = shape(call, 0);
    const T t_max = static_cast<T>(call.t_max);
    const Motion<N, T> motion{Vec<N, T>(call.motion.linear), Turn<N, T>(call.motion.angular),
                              Vec<N, T>(call.motion.center)};
    switch (call.kind) {
      case CallKind::overlapping:
        return logged(world_.overlapping(asked, query));
      case CallKind::cull:
        return logged(world_.cull(asked, query));
      case CallKind::nearest:
        return logged(world_.nearest(std::get<Vec<N, T>>(asked), call.count, query));
      case CallKind::ray_cast:
        return logged(world_.ray_cast(std::get<Ray<N, T>>(asked), t_max, query));
      case CallKind::ray_cast_all:
        return logged(world_.ray_cast_all(std::get<Ray<N, T>>(asked), t_max, query));
      case CallKind::shape_cast:
        return logged(world_.shape_cast(asked, motion.linear, query));
      case CallKind::shape_cast_all:
        return logged(world_.shape_cast_all(asked, motion.linear, query));
      case CallKind::time_of_impact:
        return logged(world_.time_of_impact(asked, motion, query));
      case CallKind::contacts_with:
        return logged(world_.contacts_with(asked, query));
      default:
        return logged(world_.nearest(asked, call.count, query));
    }
  }

  static AnyShape<N, T> shape(const LoggedCall<N>& call, std::size_t place) {
    return with_numbers<T, N, double>(call.shapes[place]);
  }

  std::vector<ObjectMove<N, T>> moves(const LoggedCall<N>& call) const {
    std::vector<ObjectMove<N, T>> result;
    for (std::size_t i = 0; i < call.ids.size(); ++i) result.push_back({ids_.real(call.ids[i]), shape(call, i)});
    return result;
  }

  static Frustum<N, T> frustum(const LoggedCall<N>& call) {
    Frustum<N, T> result;
    for (std::size_t i = 0; i < result.corners.size(); ++i) result.corners[i] = Vec<N, T>(call.corners[i]);
    return result;
  }

  World world_;
  LoggedIds ids_;
};

template <template <Dim, class> class World, Dim N>
TargetMaker<N> makers_of(NumberType numbers) {
  if (numbers == NumberType::single_precision) {
    return [] { return std::make_unique<WorldTarget<World<N, float>, N, float>>(); };
  }
  return [] { return std::make_unique<WorldTarget<World<N, double>, N, double>>(); };
}

}  // namespace

template <Dim N>
TargetMaker<N> scene_targets(NumberType numbers) {
  return makers_of<Scene, N>(numbers);
}

template <Dim N>
TargetMaker<N> plain_scene_targets(NumberType numbers) {
  return makers_of<PlainScene, N>(numbers);
}

template TargetMaker<2> scene_targets<2>(NumberType);
template TargetMaker<3> scene_targets<3>(NumberType);
template TargetMaker<2> plain_scene_targets<2>(NumberType);
template TargetMaker<3> plain_scene_targets<3>(NumberType);

}  // namespace graze::io
