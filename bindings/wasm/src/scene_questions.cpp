// SPDX-License-Identifier: MIT
// Queries on all of a scene. scene_queries.cpp contains those that find objects for a shape, a point or a ray;
// scenes.cpp the functions that change scenes.
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
#include "results.hpp"
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

void pairs(SceneHandle& self) {
  self.visit([](const auto& scene) { put_pairs(scene.pairs()); });
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
    for_points([](const auto& point) { put_contact_id(point.id); });
  });
}

void candidates(SceneHandle& self) {
  self.visit([](const auto& scene) { put_pairs(scene.candidates()); });
}

/// For each pair both ids and the distance.
void closest_pairs(SceneHandle& self, double within) {
  self.visit([within](const auto& scene) {
    for (const NearPair<double>& near : scene.closest_pairs(within)) {
      put_id(near.pair.a);
      put_id(near.pair.b);
      answer().push_back(near.distance);
    }
  });
}

bool excepted(SceneHandle& self, double a, double b) {
  return self.visit([&](const auto& scene) { return scene.excepted(self.id_of(a), self.id_of(b)); });
}

void excepted_pairs(SceneHandle& self) {
  self.visit([](const auto& scene) { put_pairs(scene.excepted_pairs()); });
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

}  // namespace

EMSCRIPTEN_BINDINGS(graze_scene_questions) {
  using emscripten::function;
  function("scenePairs", asked<&pairs>);
  function("sceneContacts", asked<&contacts>);
  function("sceneCandidates", asked<&candidates>);
  function("sceneClosestPairs", asked<&closest_pairs>);
  function("sceneExcepted", asked<&excepted>);
  function("sceneExceptedPairs", asked<&excepted_pairs>);
  function("sceneIds", asked<&ids>);
  function("sceneContains", asked<&contains_id>);
  function("sceneBoxes", asked<&boxes>);
  function("sceneObject", asked<&object>);
  function("sceneVelocities", asked<&velocities>);
  function("sceneFind", asked<&find>);
  function("sceneHead", asked<&head>);
  function("sceneSize", asked<&size>);
  function("sceneCheckReport", asked<&check_report>);
  function("sceneCheckPairs", asked<&check_pairs>);
  function("sceneInfo", asked<&info>);
  function("sceneToJson", asked<&to_json>);
}

}  // namespace graze::wasm
