// SPDX-License-Identifier: MIT
#include "exam/hull_report.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "exam/hull_rival.hpp"
#include "exam/table.hpp"

namespace graze::exam {
namespace {

std::string cell(const std::map<std::string_view, CornerTally>& programs, std::string_view name) {
  const auto found = programs.find(name);
  if (found == programs.end()) return "";
  const CornerTally& tally = found->second;
  return fmt::format("{} + {}, {}, {}", tally.missing, tally.extra, rounded(tally.worst), tally.given_up);
}

}  // namespace

std::string hull_table(const std::vector<HullTally>& tallies) {
  if (tallies.empty()) return "";
  std::string text =
      "### Convex hulls\n\n"
      "Sets of 4 to 20 points, of which some are corners; which ones is known from brute force in whole numbers. A "
      "cell is\n"
      "*missing + extra, worst, given up*: the corners that are not named, the points that are named though they lie "
      "in\n"
      "the hull of the others, how far a missing corner is outside of the hull of those named, as a share of the "
      "largest\n"
      "coordinate, and for how many sets there was no answer. graze takes the numbers as exact, others do not claim "
      "to.\n\n";
  std::vector<std::string> cells{"space", "kind", "sets", "points", "corners", "graze"};
  for (const HullRival<3>& rival : hull_rivals<3>()) cells.emplace_back(rival.name);
  text += head(cells);
  for (const HullTally& tally : tallies) {
    cells = {label(tally.space),
             std::string(hull_kind_names[static_cast<std::size_t>(tally.kind)]),
             std::to_string(tally.programs.at("graze").sets),
             std::to_string(tally.points),
             std::to_string(tally.corners),
             cell(tally.programs, "graze")};
    for (const HullRival<3>& rival : hull_rivals<3>()) cells.push_back(cell(tally.programs, rival.name));
    text += row(cells);
  }
  return text + "\n";
}

}  // namespace graze::exam
