// SPDX-License-Identifier: MIT
#include "scene_check.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <variant>

#include <graze/broad/executor.hpp>
#include <graze/broad/manifolds.hpp>
#include <graze/broad/pair_tasks.hpp>
#include <graze/broad/touching_pairs.hpp>

#include "coordinates.hpp"
#include "nearness.hpp"

namespace graze::cli {
namespace {

using io::PairDetail;
using io::ReportedPair;
using Clock = std::chrono::steady_clock;

/// Candidates that are tested at a time: enough for vectors, few enough for a report that goes on.
constexpr std::size_t block_size = 4096;

/// Candidates per task.
constexpr std::size_t candidates_per_task = 512;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

PairDetail detail_of(const CheckedPairs& wanted) {
  if (wanted.within) return PairDetail::distance;
  return wanted.contacts ? PairDetail::contacts : PairDetail::none;
}

/// The relation of every candidate.
template <Dim N>
std::vector<Relation> relations_of(const Scene<N, double>& scene, std::span<const ObjectPair> candidates) {
  std::vector<detail::ShapePair<N, double>> shapes;
  shapes.reserve(candidates.size());
  for (const ObjectPair& pair : candidates) {
    shapes.push_back({&scene.object(pair.a).shape, &scene.object(pair.b).shape});
  }
  std::vector<Relation> relations(shapes.size());
  detail::relations_of<N, double>(shapes, relations.data());
  return relations;
}

template <Dim N>
void add_contacts(const AnyShape<N, double>& a, const AnyShape<N, double>& b, ReportedPair& pair) {
  const Manifold<N, double> touch = manifold(a, b);
  pair.normal = coordinates(touch.normal);
  for (const ManifoldPoint<N, double>& each : touch.contacts()) {
    pair.contacts.push_back({coordinates(each.point), each.depth});
  }
}

}  // namespace

SceneCheck::SceneCheck(const io::SceneFile& file, const CheckedPairs& wanted, Progress& progress)
    : file_(file), wanted_(wanted), progress_(progress), head_{file.source, 2, 0, detail_of(wanted)} {
  std::visit(
      [this]<Dim N>(const Scene<N, double>& scene) {
        head_.dimension = N;
        head_.objects = scene.size();
      },
      file.scene);
}

/// What is to be told of each candidate, if it is one of those that were asked for.
template <Dim N>
std::vector<std::optional<ReportedPair>> SceneCheck::tested(const Scene<N, double>& scene,
                                                            std::span<const ObjectPair> candidates) const {
  std::vector<std::optional<ReportedPair>> found(candidates.size());
  detail::in_tasks(candidates.size(), candidates_per_task, default_executor(),
                   [&](std::size_t first, std::size_t last) {
                     std::vector<Relation> relations;
                     if (!wanted_.within) relations = relations_of(scene, candidates.subspan(first, last - first));
                     for (std::size_t i = first; i < last; ++i) {
                       const Object<N, double>& a = scene.object(candidates[i].a);
                       const Object<N, double>& b = scene.object(candidates[i].b);
                       ReportedPair pair{a.name, b.name};
                       if (wanted_.within) {
                         const Nearness nearness = nearness_of(a.shape, b.shape);
                         pair.relation = nearness.relation;
                         pair.distance = nearness.distance;
                         if (!(pair.distance <= *wanted_.within)) continue;
                       } else {
                         pair.relation = relations[i - first];
                         if (pair.relation == Relation::apart) continue;
                         if (wanted_.only_interior && pair.relation != Relation::overlapping) continue;
                         if (wanted_.contacts) add_contacts(a.shape, b.shape, pair);
                       }
                       found[i] = std::move(pair);
                     }
                   });
  return found;
}

template <Dim N>
void SceneCheck::search(const Scene<N, double>& scene, const std::function<void(const ReportedPair&)>& on_pair,
                        const std::function<void()>& after_block) {
  Clock::time_point start = Clock::now();
  progress_.begin("looking for candidates");
  const std::vector<ObjectPair> candidates = scene.candidates(wanted_.within.value_or(0));
  summary_.candidates = candidates.size();
  progress_.begin("testing pairs", candidates.size());
  for (std::size_t first = 0; first < candidates.size(); first += block_size) {
    const auto block = std::span(candidates).subspan(first, std::min(block_size, candidates.size() - first));
    const std::vector<std::optional<ReportedPair>> found = tested(scene, block);
    progress_.advance(first + block.size());
    summary_.seconds += seconds_since(start);
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (!found[i]) continue;
      on_pair(*found[i]);
      touching_.push_back(block[i]);
    }
    after_block();
    start = Clock::now();
  }
  summary_.seconds += seconds_since(start);
  summary_.pairs = touching_.size();
}

void SceneCheck::run(const std::function<void(const ReportedPair&)>& on_pair,
                     const std::function<void()>& after_block) {
  std::visit([&](const auto& scene) { search(scene, on_pair, after_block); }, file_.scene);
}

}  // namespace graze::cli
