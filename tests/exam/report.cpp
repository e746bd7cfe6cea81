// SPDX-License-Identifier: MIT
#include "exam/report.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "exam/hull_report.hpp"
#include "exam/mass_report.hpp"
#include "exam/measure_report.hpp"
#include "exam/rival.hpp"
#include "exam/table.hpp"

namespace graze::exam {
namespace {

std::string compiler() {
#ifdef __clang__
  return "Clang " __clang_version__;
#else
  return "GCC " __VERSION__;
#endif
}

std::string circumstances(const Results& results, const Settings& settings) {
  std::size_t cases = 0;
  std::size_t pair_cases = 0;
  std::size_t certified = 0;
  for (const PairTally& tally : results.pairs) {
    pair_cases += tally.cases;
    certified += tally.certified;
  }
  for (const PointTally& tally : results.points) cases += tally.cases;
  for (const auto* tallies :
       {&results.distances, &results.contacts, &results.manifolds, &results.rays, &results.casts, &results.impacts}) {
    for (const MeasuredPair& tally : *tallies) cases += tally.cases;
  }
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::string text = fmt::format(
      "{:%Y-%m-%d}, {}, seed {}, {} cases per pair of types and space, {} per shape and "
      "space for point queries, {} per pair and space for distances, {} for contacts, {} for manifolds, {} per shape "
      "and space for rays",
      fmt::gmtime(now), compiler(), settings.seed, settings.cases, settings.points, settings.distances,
      settings.contacts, settings.manifolds, settings.rays);
  if (settings.seconds > 0) text += fmt::format(", but at most {} seconds for each", settings.seconds);
  if (!settings.pairs.empty()) text += fmt::format(", only those named \"{}\"", settings.pairs);
  text += fmt::format("; {} cases in all.", pair_cases + cases);
  if (pair_cases > 0) {
    text += fmt::format(" Of the verdicts on pairs {:.2f} % were judged by a certificate, the others by the oracle.",
                        100.0 * static_cast<double>(certified) / static_cast<double>(pair_cases));
  }
  return text + "\n\n";
}

/// The larger of the values in 2D and 3D, in float and in double.
template <class Tally>
std::string worst_of(const BySpace<Tally>& tallies, double Tally::*error) {
  return fmt::format("{} / {}", rounded(std::max(tallies[0].*error, tallies[2].*error)),
                     rounded(std::max(tallies[1].*error, tallies[3].*error)));
}

std::string point_table(const std::vector<PointTally>& tallies) {
  std::string text =
      "### Point queries\n\n"
      "The worst errors in float / double, in ulp: epsilon of the type times the largest coordinate of shape, point\n"
      "and answer. *Wrong*: an answer beyond the bounds above, or one that the shape does not contain. *Forgiven*: "
      "the\n"
      "error of `signed_distance` for points that are outside and yet contained; that of the others has a column of "
      "its\n"
      "own. Triangles in 2D and polytopes that are more than 3 times longer than thick have corners that the promise "
      "on\n"
      "points excepts: *needles* is their worst error, which is divided by how many times longer than thick they are "
      "in\n"
      "the columns before.\n\n";
  text += head({"shape", "cases", "held", "wrong", "forgiven", "`signed_distance`", "`closest_point`",
                "`closest_boundary_point`", "needles"});
  for (const auto& [name, tally] : by_name(tallies, [](const PointTally& one) { return one.shape; })) {
    const std::size_t cases = sum_of(tally, &PointTally::cases);
    text += row({name, std::to_string(cases), percent(sum_of(tally, &PointTally::held), cases),
                 std::to_string(sum_of(tally, &PointTally::wrong)), worst_of(tally, &PointTally::forgiven),
                 worst_of(tally, &PointTally::distance), worst_of(tally, &PointTally::closest),
                 worst_of(tally, &PointTally::boundary), worst_of(tally, &PointTally::needle)});
  }
  return text + "\n";
}

std::string pair_table(const std::vector<PairTally>& tallies) {
  std::string text =
      "### Pairs\n\n"
      "*In band*: called touching though apart or overlapping, by no more than documented; *worst*: by how much at "
      "most,\n"
      "in epsilon of double times the size, in 2D float, 2D double, 3D float and 3D double. *Outside*: cases that the\n"
      "documentation leaves out (numbers too small to square, unbounded shapes parallel up to rounding). *Certified*:\n"
      "judged by a certificate.\n\n";
  text +=
      head({"pair", "cases", "certified", "hits", "wrong", "outside", "in band", "worst 2D f", "2D d", "3D f", "3D d"});
  for (const auto& [name, tally] : by_name(tallies, [](const PairTally& one) { return one.pair; })) {
    const std::size_t cases = sum_of(tally, &PairTally::cases);
    std::vector<std::string> cells = {name,
                                      std::to_string(cases),
                                      percent(sum_of(tally, &PairTally::certified), cases),
                                      percent(sum_of(tally, &PairTally::hits), cases),
                                      std::to_string(sum_of(tally, &PairTally::wrong)),
                                      std::to_string(sum_of(tally, &PairTally::outside)),
                                      percent(sum_of(tally, &PairTally::in_band), cases)};
    for (const PairTally& one : tally) cells.push_back(one.cases == 0 ? "-" : rounded(one.worst));
    text += row(cells);
  }
  return text + "\n";
}

// ---- Side by side

std::string cell(const RivalTally& tally) {
  if (tally.cases == 0) return "";
  return fmt::format("{} + {}, {}", tally.false_yes, tally.false_no, tally.touching_missed);
}

template <class T>
std::vector<std::string_view> rival_names() {
  std::vector<std::string_view> names{"graze"};
  for (const Rival<T>& rival : rivals<T>()) names.push_back(rival.name);
  return names;
}

using RivalSums = std::map<std::string_view, RivalTally>;

std::string kind_table(const std::vector<std::string_view>& names, RivalSums& sums) {
  std::string text = "Wrong answers by kind of case:\n\n";
  std::vector<std::string> cells{"kind"};
  cells.insert(cells.end(), names.begin(), names.end());
  text += head(cells);
  for (std::size_t kind = 0; kind < test::case_kind_count; ++kind) {
    cells = {std::string(test::case_kind_names[kind])};
    for (const std::string_view name : names)
      cells.push_back(percent(sums[name].wrong_of_kind[kind], sums[name].cases_of_kind[kind]));
    text += row(cells);
  }
  return text + "\n";
}

template <class T>
std::string rival_tables(const std::vector<PairTally>& tallies) {
  const std::vector<std::string_view> names = rival_names<T>();
  const std::string_view scalar = space_name<3, T>().scalar;
  RivalSums sums;
  std::string text = fmt::format("### Side by side, 3D {}\n\n", scalar);
  std::vector<std::string> cells{"pair", "cases", "touching"};
  cells.insert(cells.end(), names.begin(), names.end());
  text += head(cells);
  const auto add_row = [&](const std::string& name, const RivalSums& of_pair) {
    const RivalTally& own = of_pair.at("graze");
    cells = {name, std::to_string(own.cases), std::to_string(own.touching)};
    for (const std::string_view rival : names) cells.push_back(of_pair.count(rival) > 0 ? cell(of_pair.at(rival)) : "");
    text += row(cells);
  };
  for (const PairTally& tally : tallies) {
    if (tally.space.dimension != 3 || tally.space.scalar != scalar || tally.rivals.empty()) continue;
    add_row(tally.pair, tally.rivals);
    for (const auto& [name, of_pair] : tally.rivals) sums[name] += of_pair;
  }
  if (sums.empty()) return "";
  add_row("**all that it has**", sums);
  return text + "\n" + kind_table(names, sums);
}

constexpr std::string_view rival_introduction =
    "Each program was asked the same cases of the pairs that it has, of those that are no variations of others. A cell "
    "is\n"
    "*wrong yes + wrong no, touching missed*: wrong is an answer where gap or depth are more than 1e-6 (float) or "
    "1e-12\n"
    "(double) of the largest coordinate, and the last number says how many of the exactly touching cases were called\n"
    "apart. Shapes without size are among the cases: spheres of radius zero, flat boxes, triangles that are segments "
    "or\n"
    "points.\n\n";

}  // namespace

std::string markdown(const Results& results, const Settings& settings) {
  std::string text = circumstances(results, settings);
  if (!results.points.empty()) text += point_table(results.points);
  if (!results.pairs.empty()) text += pair_table(results.pairs);
  const std::string compared = rival_tables<float>(results.pairs) + rival_tables<double>(results.pairs);
  if (!compared.empty()) text += std::string(rival_introduction) + compared;
  return text + distance_tables(results.distances) + contact_tables(results.contacts) +
         manifold_tables(results.manifolds) + ray_tables(results.rays) + cast_tables(results.casts) +
         impact_tables(results.impacts) + hull_table(results.hulls) + mass_table(results.masses);
}

void write_page(const std::string& path, const std::string& text) {
  std::string page = text;
  if (std::ifstream old{path}; old) {
    const std::string held{std::istreambuf_iterator<char>(old), {}};
    const std::size_t begin = held.find("<!-- exam: begin");
    const std::size_t end = held.find("<!-- exam: end");
    if (begin != std::string::npos && end != std::string::npos && begin < end) {
      const std::size_t after_mark = held.find('\n', begin) + 1;
      page = held.substr(0, after_mark) + "\n" + text + held.substr(end);
    }
  }
  std::ofstream file(path);
  file << page;
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

}  // namespace graze::exam
