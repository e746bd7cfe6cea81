// SPDX-License-Identifier: MIT
// Queries on scenes. scenes.cpp contains the functions that change them.
#include <chrono>
#include <cstddef>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include <emscripten/bind.h>
#include <fmt/format.h>

#include <graze/io/json_scene.hpp>
#include <graze/io/report/check.hpp>
#include <graze/io/report/summary.hpp>
#include <graze/io/text/quoting.hpp>
#include <graze/query/relation.hpp>
#include <graze/scene/scene.hpp>

#include "arguments.hpp"
#include "scenes.hpp"

namespace graze::wasm {
namespace {

void put_pairs(const std::vector<ObjectPair>& pairs) {
  answer().reserve(2 * pairs.size());
  for (const ObjectPair& pair : pairs) {
    put_id(pair.a);
    put_id(pair.b);
  }
}

void put_ids(const std::vector<ObjectId>& ids) {
  for (const ObjectId id : ids) put_id(id);
}

void pairs(SceneHandle& self) {
  self.visit([](const auto& scene) { put_pairs(scene.pairs()); });
}

void put_feature(const Feature& feature) {
  answer().push_back(static_cast<double>(feature.kind));
  answer().push_back(feature.index);
}

/// Column by column: the numbers of pairs and of points; for each pair both ids, its number of points, normal, status
/// and error; for each point the point, those of a and b, the depth, and the id as for a single manifold.
void contacts(SceneHandle& self) {
  self.visit([]<Dim N>(const Scene<N, double>& scene) {
    const std::vector<ObjectContact<N, double>> found = scene.contacts();
    const auto for_pairs = [&found](const auto& put_column) {
      for (const ObjectContact<N, double>& each : found) put_column(each.pair, each.manifold);
    };
    const auto for_points = [&found](const auto& put_column) {
      for (const ObjectContact<N, double>& each : found) {
        for (const ManifoldPoint<N, double>& point : each.manifold.contacts()) put_column(point);
      }
    };
    std::size_t points = 0;
    for_points([&points](const auto&) { ++points; });
    constexpr auto n = static_cast<std::size_t>(N);
    answer().reserve(2 + found.size() * (5 + n) + points * (7 + 3 * n));
    answer().push_back(static_cast<double>(found.size()));
    answer().push_back(static_cast<double>(points));
    for_pairs([](const ObjectPair& pair, const auto&) {
      put_id(pair.a);
      put_id(pair.b);
    });
    for_pairs([](const auto&, const auto& manifold) { answer().push_back(static_cast<double>(manifold.size)); });
    for_pairs([](const auto&, const auto& manifold) { put<N>(manifold.normal); });
    for_pairs(
        [](const auto&, const auto& manifold) { answer().push_back(manifold.status == Status::converged ? 0 : 1); });
    for_pairs([](const auto&, const auto& manifold) { answer().push_back(manifold.error); });
    for_points([](const auto& point) { put<N>(point.point); });
    for_points([](const auto& point) { put<N>(point.point_a); });
    for_points([](const auto& point) { put<N>(point.point_b); });
    for_points([](const auto& point) { answer().push_back(point.depth); });
    for_points([](const auto& point) {
      put_feature(point.id.a);
      put_feature(point.id.b);
      answer().push_back(point.id.part_a);
      answer().push_back(point.id.part_b);
    });
  });
}

void candidates(SceneHandle& self) {
  self.visit([](const auto& scene) { put_pairs(scene.candidates()); });
}

void ids(SceneHandle& self) {
  self.visit([](const auto& scene) { put_ids(scene.ids()); });
}

bool contains_id(SceneHandle& self, double id) {
  return self.visit([&](const auto& scene) { return scene.contains(self.id_of(id)); });
}

/// The boxes of the objects whose ids the input contains, or of all.
void boxes(SceneHandle& self, std::size_t count, bool all) {
  self.visit([&]<Dim N>(const Scene<N, double>& scene) {
    if (all) {
      for (const ObjectId id : scene.ids()) put<N>(scene.object(id).box);
      return;
    }
    for (const double id : input<double>(count)) put<N>(scene.object(self.id_of(id)).box);
  });
}

/// Name, layer, user and mobility as text; the output contains the box, the mask's lower and upper half, and the shape.
std::string object(SceneHandle& self, double id) {
  return self.visit([&]<Dim N>(const Scene<N, double>& scene) {
    const Object<N, double>& found = scene.object(self.id_of(id));
    put<N>(found.box);
    answer().push_back(static_cast<double>(found.mask & 0xffffffffU));
    answer().push_back(static_cast<double>(found.mask >> 32U));
    put_shape<N>(found.shape);
    return fmt::format(R"({{"name": {}, "layer": {}, "user": "{}", "fixed": {}}})", io::json_string(found.name),
                       found.layer, found.user, found.mobility == Mobility::fixed);
  });
}

/// The ids and velocities of the objects with a velocity.
void velocities(SceneHandle& self) {
  self.visit([&]<Dim N>(const Scene<N, double>& scene) {
    const auto* const movers = std::get_if<std::vector<Mover<N>>>(&self.movers);
    if (movers == nullptr) return;
    for (const Mover<N>& mover : *movers) {
      if (!scene.contains(mover.id)) continue;
      put_id(mover.id);
      put<N>(mover.velocity);
    }
  });
}

/// Its id, if there is one.
void find(SceneHandle& self, std::string name) {
  self.visit([&](const auto& scene) {
    if (const auto id = scene.find(name)) put_id(*id);
  });
}

/// The name of the scene, the direction of its y axis, and its layers.
std::string head(SceneHandle& self) {
  return self.visit([&]<Dim N>(const Scene<N, double>& scene) {
    std::string layers;
    for (const std::string& name : scene.layer_names()) layers += (layers.empty() ? "" : ", ") + io::json_string(name);
    return fmt::format(
        R"({{"source": {}, "format": {}, "yAxis": "{}", "dimension": {}, "layers": [{}], "omissions": {}}})",
        io::json_string(self.file.source), io::json_string(self.file.format),
        self.file.y_axis == io::YAxis::down ? "down" : "up", N, layers, io::omissions_json(self.file.omissions));
  });
}

std::size_t size(SceneHandle& self) {
  return self.visit([](const auto& scene) { return scene.size(); });
}

void overlapping(SceneHandle& self, std::size_t place, std::string layers) {
  self.visit([&]<Dim N>(const Scene<N, double>& scene) {
    put_ids(scene.overlapping(Arguments(place).shape<N>(), mask_of_words(layers, scene.layer_names())));
  });
}

void cull(SceneHandle& self, std::size_t place, std::string layers) {
  self.visit([&]<Dim N>(const Scene<N, double>& scene) {
    put_ids(scene.cull(Arguments(place).shape<N>(), mask_of_words(layers, scene.layer_names())));
  });
}

void nearest(SceneHandle& self, std::size_t place, std::string layers, std::size_t count) {
  self.visit([&]<Dim N>(const Scene<N, double>& scene) {
    const Vec<N, double> from = Arguments(place).vector<N>();
    for (const NearObject<double>& near : scene.nearest(from, count, mask_of_words(layers, scene.layer_names()))) {
      put_id(near.id);
      answer().push_back(near.distance);
    }
  });
}

/// For each hit: id, t, point, normal, status, error.
template <Dim N>
void put_hit(const ObjectHit<N, double>& found) {
  put_id(found.id);
  answer().push_back(found.hit.t);
  put<N>(found.hit.point);
  put<N>(found.hit.normal);
  answer().push_back(found.hit.status == Status::converged ? 0 : 1);
  answer().push_back(found.hit.error);
}

void ray_cast_scene(SceneHandle& self, std::size_t place, std::string layers, double t_max) {
  self.visit([&]<Dim N>(const Scene<N, double>& scene) {
    const auto hit = scene.ray_cast(Arguments(place).ray<N>(), t_max, mask_of_words(layers, scene.layer_names()));
    if (hit) put_hit<N>(*hit);
  });
}

void ray_cast_all(SceneHandle& self, std::size_t place, std::string layers, double t_max) {
  self.visit([&]<Dim N>(const Scene<N, double>& scene) {
    for (const auto& hit :
         scene.ray_cast_all(Arguments(place).ray<N>(), t_max, mask_of_words(layers, scene.layer_names()))) {
      put_hit<N>(hit);
    }
  });
}

/// Calls found(pair, relation) for every pair that touches, or only for overlapping ones.
template <Dim N, class Found>
io::ReportSummary check(const Scene<N, double>& scene, bool only_interior, const Found& found) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  io::ReportSummary summary;
  const std::vector<ObjectPair> worth_testing = scene.candidates();
  summary.candidates = worth_testing.size();
  for (const ObjectPair& pair : worth_testing) {
    const Relation verdict = relation(scene.object(pair.a).shape, scene.object(pair.b).shape);
    if (verdict == Relation::apart || (only_interior && verdict != Relation::overlapping)) continue;
    found(pair, verdict);
    ++summary.pairs;
  }
  summary.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return summary;
}

/// The report that the command line writes.
std::string check_report(SceneHandle& self, bool only_interior) {
  return self.visit([&]<Dim N>(const Scene<N, double>& scene) {
    std::ostringstream out;
    const auto writer = io::begin_report(
        out, io::ReportFormat::json, {self.file.source, N, scene.size(), io::PairDetail::none, self.file.omissions});
    writer->finish(check(scene, only_interior, [&](const ObjectPair& pair, Relation verdict) {
      writer->write({scene.object(pair.a).name, scene.object(pair.b).name, verdict});
    }));
    return out.str();
  });
}

/// The number of candidates, the seconds, then for each pair both ids and the relation.
void check_pairs(SceneHandle& self, bool only_interior) {
  self.visit([&]<Dim N>(const Scene<N, double>& scene) {
    answer().resize(2);
    const io::ReportSummary summary = check(scene, only_interior, [](const ObjectPair& pair, Relation verdict) {
      put_id(pair.a);
      put_id(pair.b);
      answer().push_back(static_cast<double>(verdict));
    });
    answer()[0] = static_cast<double>(summary.candidates);
    answer()[1] = summary.seconds;
  });
}

std::string info(SceneHandle& self) {
  std::ostringstream out;
  io::write_summary_json(out, io::summarise(self.file));
  return out.str();
}

std::string to_json(SceneHandle& self) {
  std::ostringstream out;
  io::write_json_scene(out, self.file);
  return out.str();
}

/// A const method: embind requires methods of the registered class, hence functions that take the scene.
template <auto question>
constexpr auto asked = &Guarded<question>::call;

}  // namespace

EMSCRIPTEN_BINDINGS(graze_scene_questions) {
  using emscripten::function;
  function("scenePairs", asked<&pairs>);
  function("sceneContacts", asked<&contacts>);
  function("sceneCandidates", asked<&candidates>);
  function("sceneIds", asked<&ids>);
  function("sceneContains", asked<&contains_id>);
  function("sceneBoxes", asked<&boxes>);
  function("sceneObject", asked<&object>);
  function("sceneVelocities", asked<&velocities>);
  function("sceneFind", asked<&find>);
  function("sceneHead", asked<&head>);
  function("sceneSize", asked<&size>);
  function("sceneOverlapping", asked<&overlapping>);
  function("sceneCull", asked<&cull>);
  function("sceneNearest", asked<&nearest>);
  function("sceneRayCast", asked<&ray_cast_scene>);
  function("sceneRayCastAll", asked<&ray_cast_all>);
  function("sceneCheckReport", asked<&check_report>);
  function("sceneCheckPairs", asked<&check_pairs>);
  function("sceneInfo", asked<&info>);
  function("sceneToJson", asked<&to_json>);
}

}  // namespace graze::wasm
