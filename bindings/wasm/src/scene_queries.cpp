// SPDX-License-Identifier: MIT
// Queries that find objects of a scene for a region, a point, a ray or a moving shape. Their arguments are the ids to
// leave out, then those that each function names; layers and predicate select among the other objects.
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <graze/math/motion.hpp>
#include <graze/scene/scene.hpp>
#include <graze/scene/scene_query.hpp>
#include <graze/scene/slide.hpp>

#include "arguments.hpp"
#include "results.hpp"
#include "scenes.hpp"

namespace graze::wasm {
namespace {

using emscripten::val;

/// A function of JavaScript that returns 1 for an id that may be found and 0 for others, or 2 if it has caught an
/// exception, which the query then ends with. It may query the module, whose output is discarded.
bool accepts(const val& predicate, ObjectId id) {
  const int verdict = predicate(packed_id(id.index, id.generation)).as<int>();
  answer().clear();
  if (verdict == 2) throw std::runtime_error("the predicate has thrown an exception");
  return verdict == 1;
}

/// Calls ask(scene, in, query), which reads the other arguments and then calls the scene: not in one expression,
/// because the predicate may write arguments of its own.
template <class Ask>
void with_filter(SceneHandle& self, std::size_t place, const std::string& layers, const val& predicate,
                 const Ask& ask) {
  self.visit([&](const auto& scene) {
    Arguments in(place);
    std::vector<ObjectId> except;
    for (const double id : in.numbers(in.count())) except.push_back(self.id_of(id));
    SceneQuery query{.layers = mask_of_words(layers, scene.layer_names()), .except = except};
    if (!predicate.isUndefined()) query.predicate = [&predicate](ObjectId id) { return accepts(predicate, id); };
    ask(scene, in, query);
  });
}

/// The ids of the objects that overlap a region.
void overlapping(SceneHandle& self, std::size_t place, std::string layers, val predicate) {
  with_filter(self, place, layers, predicate,
              []<Dim N>(const Scene<N, double>& scene, Arguments& in, const SceneQuery& query) {
                const AnyShape<N, double> region = in.shape<N>();
                put_ids(scene.overlapping(region, query));
              });
}

/// The ids of the objects whose boxes overlap a region.
void cull(SceneHandle& self, std::size_t place, std::string layers, val predicate) {
  with_filter(self, place, layers, predicate,
              []<Dim N>(const Scene<N, double>& scene, Arguments& in, const SceneQuery& query) {
                const AnyShape<N, double> region = in.shape<N>();
                put_ids(scene.cull(region, query));
              });
}

/// The id and the manifold of each object that a shape touches.
void contacts_with(SceneHandle& self, std::size_t place, std::string layers, val predicate) {
  with_filter(self, place, layers, predicate,
              []<Dim N>(const Scene<N, double>& scene, Arguments& in, const SceneQuery& query) {
                const AnyShape<N, double> shape = in.shape<N>();
                for (const ObjectTouch<N, double>& touch : scene.contacts_with(shape, query)) {
                  put_id(touch.id);
                  put_manifold<N>(touch.manifold);
                }
              });
}

void put_near(const std::vector<NearObject<double>>& found) {
  for (const NearObject<double>& near : found) {
    put_id(near.id);
    answer().push_back(near.distance);
  }
}

/// The ids and distances of the objects nearest to a point.
void nearest(SceneHandle& self, std::size_t place, std::string layers, val predicate, std::size_t count) {
  with_filter(self, place, layers, predicate,
              [count]<Dim N>(const Scene<N, double>& scene, Arguments& in, const SceneQuery& query) {
                const Vec<N, double> from = in.vector<N>();
                put_near(scene.nearest(from, count, query));
              });
}

/// The same for a shape.
void nearest_to_shape(SceneHandle& self, std::size_t place, std::string layers, val predicate, std::size_t count) {
  with_filter(self, place, layers, predicate,
              [count]<Dim N>(const Scene<N, double>& scene, Arguments& in, const SceneQuery& query) {
                const AnyShape<N, double> from = in.shape<N>();
                put_near(scene.nearest(from, count, query));
              });
}

/// The first object that a ray hits, if there is one: its id and the hit.
void ray_cast_scene(SceneHandle& self, std::size_t place, std::string layers, val predicate, double t_max) {
  with_filter(self, place, layers, predicate,
              [t_max]<Dim N>(const Scene<N, double>& scene, Arguments& in, const SceneQuery& query) {
                const Ray<N, double> ray = in.ray<N>();
                const auto found = scene.ray_cast(ray, t_max, query);
                if (!found) return;
                put_id(found->id);
                put_mesh_hit<N>(found->hit);
              });
}

/// The same for all objects that it hits.
void ray_cast_all(SceneHandle& self, std::size_t place, std::string layers, val predicate, double t_max) {
  with_filter(self, place, layers, predicate,
              [t_max]<Dim N>(const Scene<N, double>& scene, Arguments& in, const SceneQuery& query) {
                const Ray<N, double> ray = in.ray<N>();
                for (const ObjectHit<N, double>& found : scene.ray_cast_all(ray, t_max, query)) {
                  put_id(found.id);
                  put_mesh_hit<N>(found.hit);
                }
              });
}

template <Dim N>
void put_impact(const ObjectImpact<N, double>& found) {
  put_id(found.id);
  put_hit<N>(found.impact);
}

/// The first object that a shape touches as it moves along a vector, if there is one: its id and the impact.
void shape_cast_scene(SceneHandle& self, std::size_t place, std::string layers, val predicate, bool ignores_touch) {
  with_filter(self, place, layers, predicate,
              [ignores_touch]<Dim N>(const Scene<N, double>& scene, Arguments& in, SceneQuery& query) {
                query.ignore_initial_touch = ignores_touch;
                const AnyShape<N, double> shape = in.shape<N>();
                const Vec<N, double> motion = in.vector<N>();
                if (const auto found = scene.shape_cast(shape, motion, query)) put_impact<N>(*found);
              });
}

/// The same for all objects that it touches.
void shape_cast_all(SceneHandle& self, std::size_t place, std::string layers, val predicate, bool ignores_touch) {
  with_filter(self, place, layers, predicate,
              [ignores_touch]<Dim N>(const Scene<N, double>& scene, Arguments& in, SceneQuery& query) {
                query.ignore_initial_touch = ignores_touch;
                const AnyShape<N, double> shape = in.shape<N>();
                const Vec<N, double> motion = in.vector<N>();
                for (const auto& found : scene.shape_cast_all(shape, motion, query)) put_impact<N>(found);
              });
}

/// The first object that a shape touches as it moves and rotates.
void time_of_impact_scene(SceneHandle& self, std::size_t place, std::string layers, val predicate) {
  with_filter(self, place, layers, predicate,
              []<Dim N>(const Scene<N, double>& scene, Arguments& in, const SceneQuery& query) {
                const AnyShape<N, double> shape = in.shape<N>();
                const Motion<N, double> motion = in.motion<N>();
                if (const auto found = scene.time_of_impact(shape, motion, query)) put_impact<N>(*found);
              });
}

/// The motion of a shape that slides along a vector, then each touch. An option that is NaN has its default; `up` is a
/// list of numbers, empty for the default.
void slide_in_scene(SceneHandle& self, std::size_t place, std::string layers, val predicate, double max_slope,
                    double step_height, double clearance) {
  with_filter(self, place, layers, predicate,
              [&]<Dim N>(const Scene<N, double>& scene, Arguments& in, const SceneQuery& query) {
                const AnyShape<N, double> shape = in.shape<N>();
                const Vec<N, double> motion = in.vector<N>();
                SlideOptions options{.query = query};
                Dim axis = 0;
                for (const double number : in.numbers(in.count())) options.up[axis++] = number;
                if (!std::isnan(max_slope)) options.max_slope = max_slope;
                if (!std::isnan(step_height)) options.step_height = step_height;
                if (!std::isnan(clearance)) options.clearance = clearance;
                const Slide<N, double> path = slide(scene, shape, motion, options);
                put<N>(path.motion);
                for (const auto& found : path.touches) put_impact<N>(found);
              });
}

}  // namespace

EMSCRIPTEN_BINDINGS(graze_scene_queries) {
  using emscripten::function;
  function("sceneOverlapping", asked<&overlapping>);
  function("sceneCull", asked<&cull>);
  function("sceneContactsWith", asked<&contacts_with>);
  function("sceneNearest", asked<&nearest>);
  function("sceneNearestToShape", asked<&nearest_to_shape>);
  function("sceneRayCast", asked<&ray_cast_scene>);
  function("sceneRayCastAll", asked<&ray_cast_all>);
  function("sceneShapeCast", asked<&shape_cast_scene>);
  function("sceneShapeCastAll", asked<&shape_cast_all>);
  function("sceneTimeOfImpact", asked<&time_of_impact_scene>);
  function("sceneSlide", asked<&slide_in_scene>);
}

}  // namespace graze::wasm
