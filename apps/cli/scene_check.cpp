// SPDX-License-Identifier: MIT
#include "scene_check.hpp"

#include <chrono>
#include <cstddef>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include <graze/broad/contacts.hpp>
#include <graze/broad/executor.hpp>
#include <graze/broad/touching/pair_tasks.hpp>
#include <graze/broad/touching_pairs.hpp>
#include <graze/scene/visit_candidates.hpp>

#include "coordinates.hpp"
#include "nearness.hpp"

namespace graze::cli {
namespace {

using io::PairDetail;
using io::ReportedPair;
using Clock = std::chrono::steady_clock;

/// Candidates per task.
constexpr std::size_t candidates_per_task = 512;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

PairDetail detail_of(const CheckedPairs& wanted) {
  if (wanted.within) return PairDetail::distance;
  return wanted.contacts ? PairDetail::contacts : PairDetail::none;
}

/// The candidates of a task, and space for their results.
template <Dim N>
struct Task {
  const Scene<N, double>& scene;
  std::span<const ObjectPair> candidates;
  std::span<std::optional<ReportedPair>> found;

  ReportedPair pair(std::size_t i, Relation relation) const {
    return {scene.object(candidates[i].a).name, scene.object(candidates[i].b).name, relation};
  }

  detail::ShapePair<N, double> shapes(std::size_t i) const {
    return {&scene.object(candidates[i].a).shape, &scene.object(candidates[i].b).shape};
  }
};

template <Dim N>
void find_near(const Task<N>& task, double within) {
  for (std::size_t i = 0; i < task.candidates.size(); ++i) {
    const detail::ShapePair<N, double> shapes = task.shapes(i);
    const Nearness nearness = nearness_of(*shapes.a, *shapes.b);
    if (!(nearness.distance <= within)) continue;
    ReportedPair& pair = task.found[i].emplace(task.pair(i, nearness.relation));
    pair.distance = nearness.distance;
    pair.status = nearness.status;
    pair.error = nearness.error;
  }
}

template <Dim N>
void find_touching(const Task<N>& task, bool only_interior) {
  std::vector<detail::ShapePair<N, double>> shapes(task.candidates.size());
  for (std::size_t i = 0; i < shapes.size(); ++i) shapes[i] = task.shapes(i);
  std::vector<Relation> relations(shapes.size());
  detail::relations_of<N, double>(shapes, relations.data());
  for (std::size_t i = 0; i < relations.size(); ++i) {
    if (relations[i] == Relation::apart || (only_interior && relations[i] != Relation::overlapping)) continue;
    task.found[i] = task.pair(i, relations[i]);
  }
}

template <Dim N>
void tell(const Manifold<N, double>& touch, ReportedPair& pair) {
  pair.normal = coordinates(touch.normal);
  for (const ManifoldPoint<N, double>& each : touch.contacts()) {
    pair.contacts.push_back({coordinates(each.point), each.depth});
  }
  pair.status = touch.status;
  pair.error = touch.error;
}

/// Adds the contacts of the pairs that were found.
template <Dim N>
void add_contacts(const Task<N>& task) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < task.found.size(); ++i) {
    if (task.found[i]) places.push_back(i);
  }
  std::vector<Manifold<N, double>> manifolds(places.size());
  std::vector<detail::ShapesToContact<N, double>> touching(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) touching[i] = {task.shapes(places[i]), &manifolds[i]};
  detail::contacts_of<N, double>(touching);
  for (std::size_t i = 0; i < places.size(); ++i) tell(manifolds[i], *task.found[places[i]]);
}

}  // namespace

SceneCheck::SceneCheck(const io::SceneFile& file, const CheckedPairs& wanted, Progress& progress)
    : file_(file), wanted_(wanted), progress_(progress), head_{file.source, 2, 0, detail_of(wanted), file.omissions} {
  std::visit(
      [this]<Dim N>(const Scene<N, double>& scene) {
        head_.dimension = N;
        head_.objects = scene.size();
      },
      file.scene);
}

/// The result for each candidate that is to be reported.
template <Dim N>
std::vector<std::optional<ReportedPair>> SceneCheck::tested(const Scene<N, double>& scene,
                                                            std::span<const ObjectPair> candidates) const {
  std::vector<std::optional<ReportedPair>> found(candidates.size());
  detail::in_tasks(candidates.size(), candidates_per_task, default_executor(),
                   [&](std::size_t first, std::size_t last) {
                     const Task<N> task{scene, candidates.subspan(first, last - first),
                                        std::span(found).subspan(first, last - first)};
                     if (wanted_.within) return find_near(task, *wanted_.within);
                     find_touching(task, wanted_.only_interior);
                     if (wanted_.contacts) add_contacts(task);
                   });
  return found;
}

template <Dim N>
void SceneCheck::search(const Scene<N, double>& scene, const OnPair& on_pair,
                        const std::function<bool()>& after_block) {
  Clock::time_point start = Clock::now();
  progress_.begin("searching for candidates");
  bool has_begun = false;
  const auto test = [&](std::span<const ObjectPair> candidates) {
    if (!has_begun) progress_.begin("testing pairs", scene.size());
    has_begun = true;
    const std::vector<std::optional<ReportedPair>> found = tested(scene, candidates);
    progress_.advance(candidates.back().a.index);
    summary_.candidates += candidates.size();
    summary_.seconds += seconds_since(start);
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (!found[i]) continue;
      on_pair(*found[i], candidates[i]);
      if (found[i]->status != Status::converged) ++summary_.not_converged;
      ++summary_.pairs;
    }
    const bool goes_on = after_block();
    start = Clock::now();
    return goes_on;
  };
  visit_candidates(scene, test, wanted_.within.value_or(0));
  summary_.seconds += seconds_since(start);
}

void SceneCheck::run(const OnPair& on_pair, const std::function<bool()>& after_block) {
  std::visit([&](const auto& scene) { search(scene, on_pair, after_block); }, file_.scene);
}

}  // namespace graze::cli
