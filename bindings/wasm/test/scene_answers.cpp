// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <limits>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <graze/math/motion.hpp>
#include <graze/math/rotation.hpp>
#include <graze/scene/scene.hpp>
#include <graze/scene/slide.hpp>
#include <graze/shape/polytope.hpp>

#include "answers.hpp"

namespace graze::test {
namespace {

constexpr std::size_t objects = 300;
constexpr std::size_t questions = 120;
constexpr std::size_t layers = 3;

/// Random shapes, a few units across, with as much free space between them in 2D as in 3D.
template <Dim N>
class Maker {
 public:
  double number(double least, double most) { return least + (most - least) * static_cast<double>(random_()) / 0x1p32; }

  Vec<N, double> vector(double most) {
    Vec<N, double> vector;
    for (Dim axis = 0; axis < N; ++axis) vector[axis] = number(-most, most);
    return vector;
  }

  AnyShape<N, double> shape(std::size_t kind) {
    const Vec<N, double> middle = vector(N == 2 ? 24 : 10);
    const Vec<N, double> half(number(0.2, 1.5));
    switch (kind % 8) {
      case 0:
        return Sphere<N, double>{middle, half[0]};
      case 1:
        return Aabb<N, double>{middle - half, middle + half * 0.5};
      case 2:
        return Capsule<N, double>{middle, middle + vector(2), half[0] / 2};
      case 3:
        return Triangle<N, double>{middle, middle + vector(2), middle + vector(2)};
      case 4:
        return Segment<N, double>{middle, middle + vector(2)};
      case 5:
        return Obb<N, double>{middle, half, axes()};
      case 6:
        return hull(middle);
      default:
        return compound_of<N, double>(
            {Sphere<N, double>{middle, half[0]}, Aabb<N, double>{middle, middle + half}, hull(middle + half)});
    }
  }

 private:
  Mat<N, double> axes() {
    if constexpr (N == 2) return rotation_matrix(number(-180, 180));
    if constexpr (N == 3) return rotation_matrix(vector(1), number(-180, 180));
  }

  AnyShape<N, double> hull(const Vec<N, double>& middle) {
    std::vector<Vec<N, double>> points;
    for (int i = 0; i < 6; ++i) points.push_back(middle + vector(1.5));
    return convex_hull<N, double>(points);
  }

  std::mt19937 random_{20261129};
};

template <Dim N>
void put_impact(const ObjectImpact<N, double>& found, Numbers& out) {
  out.put(found.id.index);
  put_hit<N>(found.impact, out);
}

/// The filter of a question: none, layers 0 and 2, exceptions, or a predicate. `except` must outlive it.
SceneQuery filter_of(std::size_t question, const std::vector<ObjectId>& except) {
  const LayerMask some = only_layer(0) | only_layer(2);
  const auto predicate = [](ObjectId id) { return id.index % 7 != 0; };
  switch (question % 4) {
    case 0:
      return {};
    case 1:
      return {.layers = some};
    case 2:
      return {.except = except};
    default:
      return {.layers = some, .except = except, .predicate = predicate};
  }
}

/// What a scene says about a shape, a motion and a rotation, as test/scene_queries.test.mjs asks.
template <Dim N>
void answer(const Scene<N, double>& scene, const AnyShape<N, double>& shape, const Vec<N, double>& way,
            SceneQuery query, Numbers& out) {
  constexpr double endless = std::numeric_limits<double>::infinity();
  for (const ObjectId id : scene.overlapping(shape, query)) out.put(id.index);
  for (const ObjectId id : scene.cull(shape, query)) out.put(id.index);
  for (const ObjectTouch<N, double>& touch : scene.contacts_with(shape, query)) {
    out.put(touch.id.index);
    put_manifold<N>(touch.manifold, out);
  }
  for (const auto& nearest : {scene.nearest(shape, 4, query), scene.nearest(way, 4, query)}) {
    for (const NearObject<double>& near : nearest) {
      out.put(near.id.index);
      out.put(near.distance);
    }
  }
  for (const ObjectHit<N, double>& found : scene.ray_cast_all(Ray<N, double>{way, -way}, endless, query)) {
    out.put(found.id.index);
    put_hit<N>(found.hit, out);
  }
  Motion<N, double> motion{.linear = way};
  if constexpr (N == 2) motion.angular = 2;
  if constexpr (N == 3) motion.angular = {0, 1, -2};
  if (const auto found = scene.time_of_impact(shape, motion, query)) put_impact<N>(*found, out);
  for (const bool ignores : {false, true}) {
    query.ignore_initial_touch = ignores;
    if (const auto found = scene.shape_cast(shape, way, query)) put_impact<N>(*found, out);
    for (const auto& found : scene.shape_cast_all(shape, way, query)) put_impact<N>(found, out);
  }
  SlideOptions climbing{.query = query, .max_slope = 0.8, .step_height = 0.5, .clearance = 0.01};
  if constexpr (N == 3) climbing.up = {0, 0, 2};
  for (const SlideOptions& options : std::array{SlideOptions{.query = query}, climbing}) {
    const Slide<N, double> path = slide(scene, shape, way, options);
    out.put<N>(path.motion);
    for (const auto& found : path.touches) put_impact<N>(found, out);
  }
}

}  // namespace

template <Dim N>
void write_scene(std::ostream& out) {
  Maker<N> maker;
  Scene<N, double> scene;
  for (std::size_t layer = 0; layer < layers; ++layer) scene.layer(fmt::format("layer {}", layer));
  std::string shapes;
  for (std::size_t i = 0; i < objects; ++i) {
    const AnyShape<N, double> shape = maker.shape(i);
    scene.add(shape, {.layer = static_cast<Layer>(i % layers)});
    shapes += (i > 0 ? ", " : "") + text_of<N>(shape);
  }
  const std::vector<ObjectId> ids = scene.ids();
  const std::vector<ObjectId> except(ids.begin() + 3, ids.begin() + 30);
  std::string asked;
  for (std::size_t i = 0; i < questions; ++i) {
    const AnyShape<N, double> shape = maker.shape(i);
    const Vec<N, double> way = maker.vector(12);
    Numbers answers;
    answer<N>(scene, shape, way, filter_of(i, except), answers);
    Numbers motion;
    motion.put<N>(way);
    asked += fmt::format("{}{{\"shape\": {}, \"motion\": {}, \"answers\": {}}}", i > 0 ? ", " : "", text_of<N>(shape),
                         motion.list(), answers.list());
  }
  scene.except(ids[0], ids[1]);
  for (const ObjectPair& pair : scene.pairs()) {
    if (pair.a.index % 2 == 0) scene.except(pair.b, pair.a);
  }
  Numbers near;
  for (const NearPair<double>& each : scene.closest_pairs(0.5)) {
    near.put(each.pair.a.index);
    near.put(each.pair.b.index);
    near.put(each.distance);
  }
  Numbers excepted;
  for (const ObjectPair& pair : scene.excepted_pairs()) {
    excepted.put(pair.a.index);
    excepted.put(pair.b.index);
  }
  out << fmt::format("{{\"shapes\": [{}], \"asked\": [{}], \"near\": {}, \"excepted\": {}}}\n", shapes, asked,
                     near.list(), excepted.list());
}

template void write_scene<2>(std::ostream&);
template void write_scene<3>(std::ostream&);

}  // namespace graze::test
