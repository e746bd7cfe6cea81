// SPDX-License-Identifier: MIT
#include "race.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include "judge.hpp"
#include "table.hpp"

namespace mesh_bench {
namespace {

bool is_chosen(std::string_view name, const std::vector<std::string>& parts) {
  return parts.empty() || std::any_of(parts.begin(), parts.end(), [name](const std::string& part) {
           return name.find(part) != std::string_view::npos;
         });
}

/// The share of queries with an answer other than "no" or "none", where there are such.
std::string summary_of(Work work, const Answers& answers) {
  if (work == Work::face_pairs) {
    std::size_t pairs = 0;
    for (const auto& list : answers.pairs) pairs += list.size();
    return fmt::format("{} pairs per query", pairs / std::max<std::size_t>(1, answers.pairs.size()));
  }
  const bool is_distance = work == Work::closest || work == Work::closest_batch || work == Work::mesh_distance;
  if (answers.numbers.empty() || is_distance) return "";
  const auto yes = std::count_if(answers.numbers.begin(), answers.numbers.end(),
                                 [](double number) { return number != 0 && std::isfinite(number); });
  return fmt::format("{} % yes", 100 * yes / static_cast<std::ptrdiff_t>(answers.numbers.size()));
}

class Race {
 public:
  Race(const Surface& surface, const RaceOptions& options)
      : options_(options), course_(surface, options.counts), judge_(course_) {
    enter_graze(course_, field_);
    enter_bullet(course_, field_);
    enter_cgal(course_, field_);
    enter_embree(course_, field_);
    enter_fcl(course_, field_);
  }

  RaceResult run() {
    for (int work = 0; work < works; ++work) {
      if (is_chosen(title_of(static_cast<Work>(work)), options_.works)) run_heat(static_cast<Work>(work));
    }
    return result_;
  }

 private:
  void run_heat(Work work) {
    std::vector<const Entry*> entries;
    for (const Entry& entry : field_) {
      if (entry.work == work && (entry.is_graze || is_chosen(entry.name, options_.peers))) entries.push_back(&entry);
    }
    Answers expected;
    Answers found;
    std::vector<bool> is_wrong(entries.size());
    const auto check = [&](std::size_t k) {
      const auto queries = is_wrong[k] ? std::vector<std::size_t>() : judge_.differences(work, expected, found);
      if (!queries.empty()) {
        is_wrong[k] = true;
        result_.faults.push_back(fault(*entries[k], queries, expected, found));
      }
      found = {};
    };
    // Not timed: what is calculated when it is needed first. The first of graze's gives the answers to compare with.
    for (std::size_t k = 0; k < entries.size(); ++k) {
      entries[k]->prepare();
      entries[k]->run(k == 0 ? expected : found);
      if (k > 0) check(k);
    }
    const std::vector<double> seconds = bench::best_times(
        entries.size(), options_, [&](std::size_t k) { entries[k]->prepare(); },
        [&](std::size_t k) { entries[k]->run(found); }, check);
    Heat heat{work, summary_of(work, expected), {}};
    const double queries =
        static_cast<double>(std::max({std::size_t{1}, expected.numbers.size(), expected.pairs.size()}));
    for (std::size_t k = 0; k < entries.size(); ++k) {
      heat.results.push_back({entries[k]->name, entries[k]->is_graze, seconds[k] / queries});
    }
    if (options_.when_run) options_.when_run(heat);
    result_.heats.push_back(heat);
  }

  /// How many answers are wrong, and the first of them.
  static std::string fault(const Entry& entry, const std::vector<std::size_t>& queries, const Answers& expected,
                           const Answers& found) {
    const std::size_t query = queries.front();
    const std::string text =
        fmt::format("{}, {}: {} of {} answers differ by more than rounding; query {}", entry.name, title_of(entry.work),
                    queries.size(), std::max(expected.numbers.size(), expected.pairs.size()), query);
    if (query < found.pairs.size()) {
      return text + fmt::format(": {} pairs, graze finds {}", found.pairs[query].size(), expected.pairs[query].size());
    }
    if (query >= found.numbers.size()) return text + ": no answer";
    return text + fmt::format(": {}, graze finds {}", found.numbers[query], expected.numbers[query]);
  }

  const RaceOptions& options_;
  Course course_;
  Judge judge_;
  Entries field_;
  RaceResult result_;
};

}  // namespace

RaceResult race(const Surface& surface, const RaceOptions& options) {
  std::string titles;
  bool is_any_chosen = false;
  for (int work = 0; work < works; ++work) {
    const std::string_view title = title_of(static_cast<Work>(work));
    is_any_chosen = is_any_chosen || is_chosen(title, options.works);
    titles += fmt::format("{}\"{}\"", work > 0 ? ", " : "", title);
  }
  if (!is_any_chosen) throw std::invalid_argument("no work has such a title; they are " + titles);
  return Race(surface, options).run();
}

}  // namespace mesh_bench
