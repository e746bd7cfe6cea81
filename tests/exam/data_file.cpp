// SPDX-License-Identifier: MIT
#include "exam/data_file.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace graze::exam {
namespace {

using Row = nlohmann::ordered_json;

/// Counts that are the same for all programs, so they are written once.
constexpr std::array<std::string_view, 4> common_counts = {"measured", "touching", "points", "corners"};

double rounded(double x, int digits) { return std::isfinite(x) ? std::stod(fmt::format("{:.{}g}", x, digits)) : x; }

double error(double x) { return rounded(x, 2); }

double ratio(const Figures::Share& share) {
  const auto whole = static_cast<double>(std::max(share.whole, std::size_t{1}));
  return rounded(static_cast<double>(share.part) / whole, 6);
}

std::string compiler() {
#ifdef __clang__
  return "Clang " __clang_version__;
#else
  return "GCC " __VERSION__;
#endif
}

Row run_row(const std::vector<Tally>& tallies, const Settings& settings) {
  Figures all;
  for (const Tally& tally : tallies) all += tally.own;
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  Row row = {{"date", fmt::format("{:%Y-%m-%d}", fmt::gmtime(now))}, {"compiler", compiler()}, {"seed", settings.seed}};
  for (const Limit& limit : limits) row[std::string(limit.name)] = settings.*limit.number;
  row["seconds"] = settings.seconds;
  row["pairs"] = settings.pairs;
  row["certified"] = ratio(all.shares["certified"]);
  return row;
}

/// The tallies of one question and subject, one for each space.
using Spaces = std::vector<const Tally*>;

Row largest_of(std::string_view name, By by, const Spaces& spaces) {
  std::map<std::string, double> values;
  for (const Tally* tally : spaces) {
    double& value = values[by == By::space ? label(tally->space) : std::string(tally->space.scalar)];
    value = std::max(value, tally->own.largest.at(name).value);
  }
  Row row;
  for (const auto& [space, value] : values) row[space] = error(value);
  return row;
}

Row answers_row(const Spaces& spaces) {
  Figures sum;
  for (const Tally* tally : spaces) sum += tally->own;
  Row row = {{"question", spaces[0]->question}, {"subject", spaces[0]->subject}, {"cases", sum.cases}};
  for (const auto& [name, number] : sum.counts) row[std::string(name)] = number;
  for (const auto& [name, share] : sum.shares) row[std::string(name)] = ratio(share);
  for (const auto& [name, kept] : sum.largest)
    row[std::string(name)] = kept.by == By::all ? Row(error(kept.value)) : largest_of(name, kept.by, spaces);
  return row;
}

Row figures_row(const Figures& figures) {
  Row row;
  for (const auto& [name, number] : figures.counts) {
    if (std::find(common_counts.begin(), common_counts.end(), name) == common_counts.end())
      row[std::string(name)] = number;
  }
  for (const auto& [name, share] : figures.shares) row[std::string(name)] = ratio(share);
  for (const auto& [name, kept] : figures.largest) row[std::string(name)] = error(kept.value);
  return row;
}

Row programs_row(const Tally& tally) {
  const Figures& own = tally.programs.at("graze");
  Row row = {
      {"question", tally.question}, {"space", label(tally.space)}, {"subject", tally.subject}, {"cases", own.cases}};
  for (const std::string_view name : common_counts) {
    if (const auto found = own.counts.find(name); found != own.counts.end()) row[std::string(name)] = found->second;
  }
  for (const auto& [name, figures] : tally.programs) row["programs"][std::string(name)] = figures_row(figures);
  return row;
}

/// The sum over all subjects in one space, with the share of wrong answers by kind of case.
Row total_row(Tally total) {
  total.subject = "all";
  Row row = programs_row(total);
  for (const auto& [name, figures] : total.programs) {
    for (const auto& [kind, share] : figures.wrong_of_kind)
      row["programs"][std::string(name)]["wrong_of_kind"][std::string(kind)] = ratio(share);
  }
  return row;
}

std::vector<Row> answers(const std::vector<Tally>& tallies) {
  std::vector<Spaces> subjects;  // in order of first occurrence
  for (const Tally& tally : tallies) {
    const auto is_same = [&](const Spaces& spaces) {
      return spaces[0]->question == tally.question && spaces[0]->subject == tally.subject;
    };
    const auto found = std::find_if(subjects.begin(), subjects.end(), is_same);
    if (found == subjects.end()) {
      subjects.push_back({&tally});
    } else {
      found->push_back(&tally);
    }
  }
  std::vector<Row> rows;
  for (const Spaces& spaces : subjects) rows.push_back(answers_row(spaces));
  return rows;
}

std::vector<Row> side_by_side(const std::vector<Tally>& tallies) {
  std::vector<Row> rows;
  for (auto tally = tallies.begin(); tally != tallies.end();) {
    const auto is_other = [&](const Tally& one) {
      return one.question != tally->question || label(one.space) != label(tally->space);
    };
    const auto end = std::find_if(tally, tallies.end(), is_other);
    Tally total = *tally;
    total.programs.clear();
    for (; tally != end; ++tally) {
      if (tally->programs.empty()) continue;
      rows.push_back(programs_row(*tally));
      for (const auto& [name, figures] : tally->programs) total.programs[name] += figures;
    }
    if (!total.programs.empty()) rows.push_back(total_row(std::move(total)));
  }
  return rows;
}

/// The rows, sorted by question.
std::string lines(std::vector<Row> rows) {
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a["question"] < b["question"]; });
  std::string text;
  for (const Row& row : rows) text += (text.empty() ? "" : ",\n") + row.dump();
  return text;
}

}  // namespace

std::string data_text(const std::vector<Tally>& tallies, const Settings& settings) {
  return fmt::format("{{\n\"run\": {},\n\"answers\": [\n{}\n],\n\"side_by_side\": [\n{}\n]\n}}\n",
                     run_row(tallies, settings).dump(), lines(answers(tallies)), lines(side_by_side(tallies)));
}

void write_file(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

}  // namespace graze::exam
