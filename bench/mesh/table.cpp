// SPDX-License-Identifier: MIT
#include "table.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

namespace mesh_bench {
namespace {

/// How many times as long as graze the fastest of the peers must take whose names begin like this; 0 only prints it.
struct Target {
  Work work;
  std::string_view peer;
  double ratio;
};

constexpr std::array targets = {
    Target{Work::build, "Embree medium quality", 2},
    Target{Work::build, "Embree low quality", 0},
    Target{Work::refit, "graze mesh_of", 10},
    Target{Work::refit, "Embree", 0},
    Target{Work::moved_rays, "", 0},
    Target{Work::rays, "", 1},
    Target{Work::rays_batch, "", 1.5},
    Target{Work::closest, "", 3},
    Target{Work::closest_batch, "", 6},
    Target{Work::inside, "", 3},
    Target{Work::inside_batch, "", 6},
    Target{Work::meshes_touch, "", 3},
    Target{Work::face_pairs, "", 3},
    Target{Work::mesh_distance, "", 3},
    Target{Work::sphere, "Bullet", 3},
    Target{Work::sphere, "FCL", 3},
    Target{Work::box, "Bullet", 3},
    Target{Work::box, "FCL", 3},
    Target{Work::capsule, "Bullet", 3},
    Target{Work::capsule, "FCL", 3},
    Target{Work::sphere_contact, "Bullet", 3},
    Target{Work::sphere_contact, "FCL", 3},
    Target{Work::box_contact, "Bullet", 3},
    Target{Work::box_contact, "FCL", 3},
    Target{Work::capsule_contact, "Bullet", 3},
    Target{Work::capsule_contact, "FCL", 3},
};

bool is_rival(const Result& result, std::string_view peer) {
  return peer.empty() ? !result.is_graze : result.name.rfind(peer, 0) == 0;
}

std::optional<Result> fastest(const Heat& heat, std::string_view peer) {
  std::optional<Result> best;
  for (const Result& result : heat.results) {
    if (is_rival(result, peer) && (!best || result.seconds < best->seconds)) best = result;
  }
  return best;
}

/// With three digits, in the unit that suits.
std::string time_of(double seconds) {
  if (seconds < 1e-6) return fmt::format("{:.3g} ns", seconds * 1e9);
  if (seconds < 1e-3) return fmt::format("{:.3g} us", seconds * 1e6);
  if (seconds < 1) return fmt::format("{:.3g} ms", seconds * 1e3);
  return fmt::format("{:.3g} s", seconds);
}

std::string line_of(const Heat& heat, const Target& target) {
  const std::optional<Result> rival = fastest(heat, target.peer);
  if (!rival || !heat.results.front().is_graze) return "";
  const Result& ours = heat.results.front();
  const double ratio = rival->seconds / ours.seconds;
  return fmt::format("{:<28} {:>9} {:<24} {:>9} {:>7.2f} {:>6} {}\n", title_of(heat.work), time_of(ours.seconds),
                     rival->name, time_of(rival->seconds), ratio,
                     target.ratio > 0 ? fmt::format("{:g}", target.ratio) : "", ratio < target.ratio ? "missed" : "");
}

}  // namespace

std::string_view title_of(Work work) {
  switch (work) {
    case Work::build:
      return "build";
    case Work::refit:
      return "refit";
    case Work::moved_rays:
      return "rays after refit";
    case Work::rays:
      return "rays, one by one";
    case Work::rays_batch:
      return "rays, batch";
    case Work::closest:
      return "closest point, one by one";
    case Work::closest_batch:
      return "closest point, batch";
    case Work::inside:
      return "inside, one by one";
    case Work::inside_batch:
      return "inside, batch";
    case Work::meshes_touch:
      return "two meshes, yes or no";
    case Work::face_pairs:
      return "two meshes, face pairs";
    case Work::mesh_distance:
      return "two meshes, distance";
    case Work::sphere:
      return "sphere, yes or no";
    case Work::sphere_contact:
      return "sphere, contact";
    case Work::box:
      return "box, yes or no";
    case Work::box_contact:
      return "box, contact";
    case Work::capsule:
      return "capsule, yes or no";
    case Work::capsule_contact:
      return "capsule, contact";
  }
  return "";
}

std::string times_of(const Heat& heat) {
  std::string text = fmt::format("{}{}\n", title_of(heat.work), heat.answers.empty() ? "" : " (" + heat.answers + ")");
  for (const Result& each : heat.results) text += fmt::format("  {:<36} {:>9}\n", each.name, time_of(each.seconds));
  return text;
}

std::string table_of(const RaceResult& result) {
  std::string text = fmt::format("\n{:<28} {:>9} {:<24} {:>9} {:>7} {:>6}\n", "work", "graze", "fastest peer",
                                 "its time", "ratio", "target");
  for (const Heat& heat : result.heats) {
    for (const Target& target : targets) {
      if (target.work == heat.work) text += line_of(heat, target);
    }
  }
  for (const std::string& fault : result.faults) text += fmt::format("WRONG: {}\n", fault);
  return text;
}

}  // namespace mesh_bench
