// SPDX-License-Identifier: MIT
#include "exam/measure_report.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "exam/cast_rival.hpp"
#include "exam/contact_rival.hpp"
#include "exam/distance_rival.hpp"
#include "exam/impact_rival.hpp"
#include "exam/manifold_rival.hpp"
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
      left = std::max(left, one.worst_second);
    }
    if (columns.size() > cells.size()) cells.push_back(rounded(left));
    text += row(cells);
  }
  return text + "\n";
}

std::string impact_table(const std::vector<MeasuredPair>& tallies) {
  std::string text =
      head({"pair", "cases", "hits", "wrong", "unfinished", "outside", "2D f", "2D d", "3D f", "3D d", "claimed"});
  for (const auto& [name, tally] : by_name(tallies, [](const MeasuredPair& one) { return one.pair; })) {
    const std::size_t cases = sum_of(tally, &MeasuredPair::cases);
    std::vector<std::string> cells = {name, std::to_string(cases), percent(sum_of(tally, &MeasuredPair::hits), cases)};
    for (const auto count : {&MeasuredPair::wrong, &MeasuredPair::unfinished, &MeasuredPair::outside}) {
      cells.push_back(std::to_string(sum_of(tally, count)));
    }
    double claimed = 0;
    for (const MeasuredPair& one : tally) {
      cells.push_back(one.cases == 0 ? "-" : rounded(one.worst));
      claimed = std::max(claimed, one.worst_second);
    }
    cells.push_back(rounded(claimed));
    text += row(cells);
  }
  return text + "\n";
}

std::string cell(const MeasureTally& tally) {
  if (tally.cases == 0) return "";
  return fmt::format("{} + {}, {}, {}", tally.false_yes, tally.false_no, tally.off, rounded(tally.worst));
}

std::string distance_cell(const MeasureTally& tally) {
  if (tally.cases == 0) return "";
  return fmt::format("{} + {}, {} / {}, {}, {}", tally.false_yes, tally.false_no, tally.off, tally.slightly_off,
                     rounded(tally.worst), tally.points_off);
}

std::string cast_cell(const MeasureTally& tally) {
  if (tally.cases == 0) return "";
  return fmt::format("{} + {}, {} / {}, {}", tally.false_yes, tally.false_no, tally.off, tally.slightly_off,
                     rounded(tally.worst));
}

std::string manifold_cell(const MeasureTally& tally) {
  if (tally.cases == 0) return "";
  const double of_each =
      static_cast<double>(tally.points) / static_cast<double>(std::max(tally.measured, std::size_t{1}));
  return fmt::format("{} + {}, {}, {}, {}, {:.1f}", tally.false_yes, tally.false_no, tally.off, rounded(tally.worst),
                     tally.points_off, of_each);
}

using MeasureSums = std::map<std::string_view, MeasureTally>;

std::string side_by_side(const std::vector<MeasuredPair>& tallies, const SpaceName& space,
                         const std::vector<std::string_view>& names,
                         std::string (*cell_of)(const MeasureTally&) = cell) {
  std::vector<std::string> cells{"pair", "cases", "measured"};
  cells.insert(cells.end(), names.begin(), names.end());
  std::string text = head(cells);
  const auto add_row = [&](const std::string& name, const MeasureSums& of_pair) {
    const MeasureTally& own = of_pair.at("graze");
    cells = {name, std::to_string(own.cases), std::to_string(own.measured)};
    for (const std::string_view rival : names) {
      cells.push_back(of_pair.count(rival) > 0 ? cell_of(of_pair.at(rival)) : "");
    }
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

std::string distance_tables(const std::vector<MeasuredPair>& tallies) {
  if (tallies.empty()) return "";
  std::string text =
      "### Distances\n\n"
      "All cases were judged by the oracle. *Wrong*: zero of what is apart, or a distance of what meets; a distance "
      "that\n"
      "is farther off than its `error`, or than documented; points that are not in their shapes or not as far from "
      "each\n"
      "other as the distance says; another answer in the other order. *Outside* as above. The largest errors of the\n"
      "distance, before it is rounded, are in epsilon of double times the size that the promise names; *points*: the\n"
      "largest of the points of shapes that are apart, in epsilon of the type times the largest coordinate and "
      "`error`.\n\n";
  text += own_table(tallies, {"pair", "cases", "apart", "wrong", "outside", "2D f", "2D d", "3D f", "3D d", "points"});
  const std::string in_float = side_by_side(tallies, {3, "float"}, names_of(distance_rivals<float>()), distance_cell);
  const std::string in_double =
      side_by_side(tallies, {3, "double"}, names_of(distance_rivals<double>()), distance_cell);
  if (in_float.empty() && in_double.empty()) return text;
  text +=
      "A cell is *wrong yes + wrong no, off / slightly off, worst, points off*: the first two as above, yes being that "
      "the\n"
      "two meet; *off* is how many distances, of those of shapes that are apart and are said to be, are farther off "
      "than a\n"
      "thousandth of the pair's own size, and *slightly off* than a millionth (and 1e-6 in float, 1e-12 in double of "
      "the\n"
      "largest coordinate, which are given to rounding); *worst* is the largest error as a share of the largest\n"
      "coordinate, infinite where a program gave up. *Points off*: how many pairs of nearest points are a thousandth "
      "or\n"
      "more away from their shapes, or nearer to or farther from each other than is true. Each program was asked the "
      "pairs\n"
      "that it has, of cases that are no variations of others.\n\n";
  if (!in_float.empty()) text += "### Distances side by side, 3D float\n\n" + in_float;
  if (!in_double.empty()) text += "### Distances side by side, 3D double\n\n" + in_double;
  return text;
}

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

std::string manifold_tables(const std::vector<MeasuredPair>& tallies) {
  if (tallies.empty()) return "";
  std::string text =
      "### Manifolds\n\n"
      "All cases were judged by the oracle. *Wrong*: points of what is apart, none of what meets, a contact that is "
      "wrong\n"
      "as above, a deepest point that is not as deep, or a point that is beside its shape or not as deep as it says, "
      "each\n"
      "by more than is promised. *Outside* as above. The largest errors of the deepest point's depth are in epsilon "
      "of\n"
      "the type times the size that the promise names; *points*: how far a point is from its shape at most, as a share "
      "of\n"
      "the largest coordinate.\n\n";
  text += own_table(tallies, {"pair", "cases", "meet", "wrong", "outside", "2D f", "2D d", "3D f", "3D d", "points"});
  const std::string in_float = side_by_side(tallies, {3, "float"}, names_of(manifold_rivals<float>()), manifold_cell);
  const std::string in_double =
      side_by_side(tallies, {3, "double"}, names_of(manifold_rivals<double>()), manifold_cell);
  if (in_float.empty() && in_double.empty()) return text;
  text +=
      "A cell is *wrong yes + wrong no, off, worst, points off, points*: the first two as above; *off* is how many "
      "of the\n"
      "deepest points are less or more deep than the shapes by a thousandth of the pair's own size (and 1e-6 in "
      "float,\n"
      "1e-12 in double of the largest coordinate), and *worst* by how much at most, as a share of the largest "
      "coordinate;\n"
      "*points off*: how many manifolds have a point that is farther from one of the shapes than it is deep, by as "
      "much;\n"
      "*points*: how many a manifold has on average. Each program was asked the pairs that it has, of cases that are "
      "no\n"
      "variations of others.\n\n";
  if (!in_float.empty()) text += "### Manifolds side by side, 3D float\n\n" + in_float;
  if (!in_double.empty()) text += "### Manifolds side by side, 3D double\n\n" + in_double;
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

std::string cast_tables(const std::vector<MeasuredPair>& tallies) {
  if (tallies.empty()) return "";
  std::string text =
      "### Casts\n\n"
      "The first shape moves. All cases were judged by the oracle: on both shapes at the time of the impact, and on "
      "all\n"
      "places that the first has come by until then, which are one convex set. *Wrong*: the shapes are farther apart "
      "at\n"
      "the impact than its `error`, or have been deeper in each other before, or overlap without one. *Outside* as "
      "above.\n"
      "The largest errors, a distance or a depth, are in epsilon of double times the size that the promise names, "
      "which\n"
      "the motion adds to; *claimed*: the largest `error`, in the same.\n\n";
  text += own_table(tallies, {"pair", "cases", "hits", "wrong", "outside", "2D f", "2D d", "3D f", "3D d", "claimed"});
  const std::string in_float = side_by_side(tallies, {3, "float"}, names_of(cast_rivals<float>()), cast_cell);
  const std::string in_double = side_by_side(tallies, {3, "double"}, names_of(cast_rivals<double>()), cast_cell);
  if (in_float.empty() && in_double.empty()) return text;
  text +=
      "A cell is *wrong yes + wrong no, off / slightly off, worst*: the first two as above, of shapes that are apart "
      "before\n"
      "they move; the error of a time is how far apart the shapes are then or, if they have met before, how deep the "
      "one is\n"
      "in all that the other has come by. *Off* is how many are farther off than a thousandth of the pair's own size "
      "or "
      "its\n"
      "motion, and *slightly off* than a millionth (and 1e-6 in float, 1e-12 in double of the largest coordinate); "
      "*worst*\n"
      "is the largest error as a share of the largest coordinate. Each program was asked the pairs that it has.\n\n";
  if (!in_float.empty()) text += "### Casts side by side, 3D float\n\n" + in_float;
  if (!in_double.empty()) text += "### Casts side by side, 3D double\n\n" + in_double;
  return text;
}

std::string impact_tables(const std::vector<MeasuredPair>& tallies) {
  if (tallies.empty()) return "";
  std::string text =
      "### Times of impact\n\n"
      "Both shapes move and turn, mostly. All cases were judged by the oracle, at the time of the impact and at two "
      "dozen\n"
      "times before it, around the nearest of these more closely. *Wrong*: the shapes are farther apart at the impact "
      "than\n"
      "its `error`, or have met before, or at all without one, each by more than the rounding of their places. "
      "*Unfinished*:\n"
      "the steps ended before, and the status says so. *Outside* as above. The largest gaps at an impact are in 2^-36 "
      "of the\n"
      "pair's size and way, which is what is aimed at; *claimed*: the largest `error`, in the same; both of those that "
      "are\n"
      "finished.\n\n";
  text += impact_table(tallies);
  const std::string in_float = side_by_side(tallies, {3, "float"}, names_of(impact_rivals<float>()), cast_cell);
  const std::string in_double = side_by_side(tallies, {3, "double"}, names_of(impact_rivals<double>()), cast_cell);
  if (in_float.empty() && in_double.empty()) return text;
  text +=
      "A cell is as of casts, of shapes that turn about their middles by up to 0.75 radians. The error of a time is "
      "how "
      "far\n"
      "apart the shapes are then or, where they have met before, how deep they have been in each other since.\n\n";
  if (!in_float.empty()) text += "### Times of impact side by side, 3D float\n\n" + in_float;
  if (!in_double.empty()) text += "### Times of impact side by side, 3D double\n\n" + in_double;
  return text;
}

}  // namespace graze::exam
