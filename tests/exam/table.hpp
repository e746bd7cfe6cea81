// SPDX-License-Identifier: MIT
// The rows and cells of the exam's tables, as Markdown.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "exam/tally.hpp"

namespace graze::exam {

inline constexpr std::array<SpaceName, 4> spaces = {{{2, "float"}, {2, "double"}, {3, "float"}, {3, "double"}}};

inline std::string row(const std::vector<std::string>& cells) {
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

inline std::string head(const std::vector<std::string>& cells) {
  std::string line = row(cells) + "|---";
  for (std::size_t i = 1; i < cells.size(); ++i) line += "|--:";
  return line + "|\n";
}

/// Three digits, and a plain 0.
inline std::string rounded(double x) { return x == 0 ? "0" : fmt::format("{:.2g}", x); }

inline std::string percent(std::size_t part, std::size_t whole) {
  if (whole == 0) return "-";
  const double share = 100.0 * static_cast<double>(part) / static_cast<double>(whole);
  return part == 0 ? "0" : fmt::format("{:.{}f} %", share, share < 1 ? 2 : 0);
}

/// What the tallies of one name are in each space; those that were not run are empty.
template <class Tally>
using BySpace = std::array<Tally, spaces.size()>;

/// In the order in which the names first come.
template <class Tally, class NameOf>
std::vector<std::pair<std::string, BySpace<Tally>>> by_name(const std::vector<Tally>& tallies, NameOf name_of) {
  std::vector<std::pair<std::string, BySpace<Tally>>> rows;
  for (const Tally& tally : tallies) {
    const auto same = [&](const auto& row) { return row.first == name_of(tally); };
    auto found = std::find_if(rows.begin(), rows.end(), same);
    if (found == rows.end()) found = rows.insert(rows.end(), {name_of(tally), {}});
    const auto place = std::find_if(spaces.begin(), spaces.end(), [&](const SpaceName& space) {
      return space.dimension == tally.space.dimension && space.scalar == tally.space.scalar;
    });
    found->second[static_cast<std::size_t>(place - spaces.begin())] = tally;
  }
  return rows;
}

template <class Tally>
std::size_t sum_of(const BySpace<Tally>& tallies, std::size_t Tally::*count) {
  std::size_t sum = 0;
  for (const Tally& tally : tallies) sum += tally.*count;
  return sum;
}

}  // namespace graze::exam
