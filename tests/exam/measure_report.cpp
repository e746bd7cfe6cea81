// SPDX-License-Identifier: MIT
#include "exam/measure_report.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "exam/contact_rival.hpp"
#include "exam/ray_rival.hpp"
#include "exam/table.hpp"

namespace graze::exam {
namespace {

std::string own_table(const std::vector<MeasuredPair>& tallies, const std::vector<std::string>& columns) {
  std::string text = head(columns);
  for (const auto& [name, tally] : by_name(tallies, [](const MeasuredPair& one) { return one.pair; })) {
    const std::size_t cases = sum_of(tally, &MeasuredPair::cases);
    std::vector<std::string> cells = {name, std::to_string(cases), percent(sum_of(tally, &MeasuredPair::hits), cases),
                                      std::to_string(sum_of(tally, &MeasuredPair::wrong)),
                                      std::to_string(sum_of(tally, &MeasuredPair::outside))};
    double left = 0;
    for (const MeasuredPair& one : tally) {
      cells.push_back(one.cases == 0 ? "-" : rounded(one.worst));
      left = std::max(left, one.worst_left);
    }
    if (columns.size() > cells.size()) cells.push_back(rounded(left));
    text += row(cells);
  }
  return text + "\n";
}

std::string cell(const MeasureTally& tally) {
  if (tally.cases == 0) return "";
  return fmt::format("{} + {}, {}, {}", tally.false_yes, tally.false_no, tally.off, rounded(tally.worst));
}

using MeasureSums = std::map<std::string_view, MeasureTally>;

std::string side_by_side(const std::vector<MeasuredPair>& tallies, const SpaceName& space,
                         const std::vector<std::string_view>& names) {
  std::vector<std::string> cells{"pair", "cases", "measured"};
  cells.insert(cells.end(), names.begin(), names.end());
  std::string text = head(cells);
  const auto add_row = [&](const std::string& name, const MeasureSums& of_pair) {
    const MeasureTally& own = of_pair.at("graze");
    cells = {name, std::to_string(own.cases), std::to_string(own.measured)};
    for (const std::string_view rival : names) cells.push_back(of_pair.count(rival) > 0 ? cell(of_pair.at(rival)) : "");
    text += row(cells);
  };
  MeasureSums sums;
  for (const MeasuredPair& tally : tallies) {
    if (label(tally.space) != label(space) || tally.rivals.empty()) continue;
    add_row(tally.pair, tally.rivals);
    for (const auto& [name, of_pair] : tally.rivals) sums[name] += of_pair;
  }
  if (sums.empty()) return "";
  add_row("**all that it has**", sums);
  return text + "\n";
}

template <class Rivals>
std::vector<std::string_view> names_of(const Rivals& rivals) {
  std::vector<std::string_view> names{"graze"};
  for (const auto& rival : rivals) names.push_back(rival.name);
  return names;
}

/// `length` is what an answer may be off by a thousandth of before it counts as off.
std::string side_introduction(std::string_view length) {
  return "A cell is *wrong yes + wrong no, off, worst*: the first two as above; *off* is how many answers, of those "
         "that\n"
         "rightly say that the two meet, are farther off than a thousandth of " +
         std::string(length) +
         "\n(and 1e-6 in float, 1e-12 in double of the largest coordinate, which are given to rounding); *worst* is "
         "the\n"
         "largest error as a share of the largest coordinate. Each program was asked the pairs that it has, of cases "
         "that\n"
         "are no variations of others.\n\n";
}

}  // namespace

std::string contact_tables(const std::vector<MeasuredPair>& tallies) {
  if (tallies.empty()) return "";
  std::string text =
      "### Contacts\n\n"
      "All cases were judged by the oracle. *Wrong*: a contact of what is apart, none of what meets, a depth that is\n"
      "farther off than its `error` and its rounding, or more overlap than that left when b has gone by the depth\n"
      "along the normal. *Outside* as above. The largest errors of the depth are in epsilon of the type times the "
      "size\n"
      "that the promise names, its rounding included; *left*: the most overlap that is left, in the same, of shapes\n"
      "that are bounded.\n\n";
  text += own_table(tallies, {"pair", "cases", "meet", "wrong", "outside", "2D f", "2D d", "3D f", "3D d", "left"});
  const std::string in_float = side_by_side(tallies, {3, "float"}, names_of(contact_rivals<float>()));
  const std::string in_double = side_by_side(tallies, {3, "double"}, names_of(contact_rivals<double>()));
  if (in_float.empty() && in_double.empty()) return text;
  text +=
      "The error of an answer is that of the depth or, where that is more, the overlap that is left when b has gone\n"
      "by depth along the normal. " +
      side_introduction("the pair's own size");
  if (!in_float.empty()) text += "### Contacts side by side, 3D float\n\n" + in_float;
  if (!in_double.empty()) text += "### Contacts side by side, 3D double\n\n" + in_double;
  return text;
}

std::string ray_tables(const std::vector<MeasuredPair>& tallies) {
  if (tallies.empty()) return "";
  std::string text =
      "### Rays\n\n"
      "All cases were judged by the oracle. *Wrong*: a hit of what is missed, none of what is hit, or a point that is\n"
      "farther than `error` and rounding allow from where the ray truly enters; where it grazes or only nearly "
      "touches,\n"
      "from the surface. *Outside* as above. The largest errors are in epsilon of the type times the largest "
      "coordinate\n"
      "of the ray's origin, the shape and the point.\n\n";
  text += own_table(tallies, {"shape", "cases", "hits", "wrong", "outside", "2D f", "2D d", "3D f", "3D d"});
  const std::string in_float = side_by_side(tallies, {3, "float"}, names_of(ray_rivals<float>()));
  const std::string in_double = side_by_side(tallies, {3, "double"}, names_of(ray_rivals<double>()));
  if (in_float.empty() && in_double.empty()) return text;
  text +=
      "The error of an answer is the way along the ray to the true entry or, where that is less, the distance of\n"
      "the point from the surface. " +
      side_introduction("the way to the entry");
  if (!in_float.empty()) text += "### Rays side by side, 3D float\n\n" + in_float;
  if (!in_double.empty()) text += "### Rays side by side, 3D double\n\n" + in_double;
  return text;
}

}  // namespace graze::exam
