// SPDX-License-Identifier: MIT
#include "table.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include <fmt/format.h>

namespace bench {
namespace {

/// The ratio to graze's time that a peer must at least reach: peers whose names begin like this, or all others. Zero
/// only prints the ratio.
struct Target {
  Work work;
  std::string_view peer;
  double ratio;
};

constexpr std::array targets = {
    Target{Work::build, "", 3},
    Target{Work::regions, "", 2},
    Target{Work::rays, "Embree", 1},
    Target{Work::rays, "", 3},
    Target{Work::nearest_1, "", 3},
    Target{Work::nearest_8, "", 3},
    Target{Work::nearest_point_1, "nanoflann", 1},
    Target{Work::nearest_point_8, "nanoflann", 1},
    Target{Work::nearest_point_1, "", 0},
    Target{Work::nearest_point_8, "", 0},
};

std::string_view title_of(Work work) {
  switch (work) {
    case Work::build:
      return "build";
    case Work::regions:
      return "100k regions";
    case Work::rays:
      return "100k rays, first hit";
    case Work::nearest_1:
      return "100k nearest box";
    case Work::nearest_8:
      return "100k nearest 8 boxes";
    case Work::nearest_point_1:
      return "100k nearest point";
    case Work::nearest_point_8:
      return "100k nearest 8 points";
    case Work::update_all:
      return "update, all move";
    case Work::update_one_percent:
      return "update, 1 % move";
  }
  return "";
}

bool is_named_elsewhere(const Result& result, Work work) {
  return std::any_of(targets.begin(), targets.end(), [&](const Target& target) {
    return target.work == work && !target.peer.empty() && result.name.rfind(target.peer, 0) == 0;
  });
}

std::optional<Result> fastest(const Heat& heat, std::string_view peer) {
  std::optional<Result> best;
  for (const Result& result : heat.results) {
    const bool counts =
        !result.is_graze && (peer.empty() ? !is_named_elsewhere(result, heat.work) : result.name.rfind(peer, 0) == 0);
    if (counts && (!best || result.seconds < best->seconds)) best = result;
  }
  return best;
}

/// Targets apply to trees built from all boxes, as the fastest peers are; for trees built box by box only the ratio is
/// printed.
std::string ratio_lines(const Heat& heat, std::string_view peer, double target) {
  const std::optional<Result> rival = fastest(heat, peer);
  if (!rival) return "";
  std::string lines;
  for (const Result& result : heat.results) {
    if (!result.is_judged) continue;
    const double ratio = rival->seconds / result.seconds;
    const double wanted = result.name.find("one by one") == std::string::npos ? target : 0;
    lines += fmt::format("{:<23} {:<20} {:<21} {:>7.2f} {:>7} {}\n", title_of(heat.work), result.name, rival->name,
                         ratio, wanted > 0 ? fmt::format("{:.0f}x", wanted) : "", ratio < wanted ? "missed" : "");
  }
  return lines;
}

}  // namespace

std::string table_of(const RaceResult& result) {
  std::string text = fmt::format("\n{} boxes, {}D, float, one thread: milliseconds of processor time\n", result.count,
                                 result.dimensions);
  for (const Heat& heat : result.heats) {
    text += fmt::format("{}\n", title_of(heat.work));
    for (const Result& each : heat.results) text += fmt::format("  {:<22} {:>12.3f}\n", each.name, each.seconds * 1e3);
  }
  text += fmt::format("\n{:<23} {:<20} {:<21} {:>7} {:>7}\n", "work", "graze", "fastest peer", "ratio", "target");
  for (const Heat& heat : result.heats) {
    bool has_target = false;
    for (const Target& target : targets) {
      if (target.work != heat.work) continue;
      text += ratio_lines(heat, target.peer, target.ratio);
      has_target = true;
    }
    if (!has_target) text += ratio_lines(heat, "", 0);
  }
  for (const std::string& note : result.notes) text += fmt::format("note: {}\n", note);
  for (const std::string& fault : result.faults) text += fmt::format("WRONG: {}\n", fault);
  return text;
}

}  // namespace bench
