// SPDX-License-Identifier: MIT
#include "report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <fstream>
#include <functional>
#include <set>
#include <string_view>
#include <thread>
#include <vector>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace graze::race {
namespace {

using Cells = std::vector<std::string>;

std::string row(const Cells& cells) { return fmt::format("| {} |\n", fmt::join(cells, " | ")); }

/// The first column contains words, the others numbers.
std::string head(const Cells& cells) {
  std::string rule = "|---|";
  for (std::size_t i = 1; i < cells.size(); ++i) rule += "--:|";
  return row(cells) + rule + "\n";
}

/// Three significant digits: "0.0123", "1.23", "12.3", "1,234".
std::string milliseconds(double value) {
  if (value >= 1000) return grouped(static_cast<std::size_t>(std::lround(value)));
  const int digits = value <= 0 ? 0 : 2 - static_cast<int>(std::floor(std::log10(value)));
  return fmt::format("{:.{}f}", value, std::clamp(digits, 0, 6));
}

/// Truncated, so that it never rounds up to a target: 9.98 is "9.9".
std::string ratio_text(double ratio) { return fmt::format("{:.1f}", std::floor(ratio * 10) / 10); }

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown processor";
}

std::string introduction(const Settings& settings) {
  const std::time_t now = std::time(nullptr);
  std::string text = "# Benchmarks: all overlapping pairs\n\n";
  text +=
      "Every contestant gets the same boxes in the same run, frame by frame, and finds all overlapping pairs;\n"
      "touching counts as overlapping. In every round, each contestant's answers to the first frame, which is not\n"
      "timed, and to the last one, unless its time is up before, are compared with graze's, pair by pair. Times are\n"
      "milliseconds per frame, from boxes to the list of pairs: the median, and half of the interquartile range, in\n"
      "percent. Generating boxes and comparing answers is not timed; what a library keeps between frames (a tree\n"
      "whose boxes are moved, memory) is created before. All boxes have moved between two frames, except those from\n"
      "files: for these, a kept tree needs no update. graze sorts its pairs unless told otherwise; the others\n"
      "return them in the order of discovery. Where their pairs are sorted too, this is done with Highway's VQSort,\n"
      "the fastest sort that was found. Only ratios within one run are meaningful: machines differ, and timings are\n"
      "noisy.\n\n";
  text += "| | |\n|---|---|\n";
  text += row({"Machine", fmt::format("{}, {} cores", processor(), std::thread::hardware_concurrency())});
  text += row({"Compiler", fmt::format("{}, {}", GRAZE_PEERS_COMPILER, GRAZE_PEERS_FLAGS)});
  text += row({"Date", fmt::format("{:%Y-%m-%d}", fmt::gmtime(now))});
  text += row({"Command", fmt::format("`{}`", settings.command)});
  text += row({"Threads", settings.threads == 1 ? std::string("one each")
                                                : fmt::format("one each; where a name says so, {}", settings.threads)});
  return text + "\n";
}

std::string contestants(const Outcome& outcome) {
  std::string text = "## Contestants\n\n";
  text +=
      "The best settings that were found. The files in `bench/peers`, one for each library, list what else was\n"
      "tried.\n\n";
  text += "| contestant | how |\n|---|---|\n";
  std::set<std::string> told;
  for (const CourseResult& result : outcome.results) {
    for (const Heat& heat : result.heats) {
      for (const Timing& timing : heat.timings) {
        if (timing.threads == 1 && told.insert(timing.name).second) text += row({timing.name, timing.settings});
      }
    }
  }
  return text + "\n";
}

/// A way to use graze that is compared with the targets.
struct Discipline {
  std::string contestant;
  std::string title;
  std::string explanation;
  Field field = Field::all;
  Finish finish = Finish::found;  ///< Of the peers.
};

const std::array<Discipline, 5>& disciplines() {
  static const std::array<Discipline, 5> all{
      {{"graze PairFinder, any order", "Between frames",
        "Equal conditions: `PairFinder` keeps data from the previous frame and returns pairs in the order of\n"
        "discovery, as the peers do. One thread.",
        Field::all, Finish::found},
       {"graze overlapping_pairs, any order", "Single call",
        "Equal conditions: `overlapping_pairs` keeps nothing from the previous frame and allocates a new list, as the\n"
        "peers in this table do; pairs are unsorted. One thread.",
        Field::from_nothing, Finish::found},
       {"graze PairFinder", "Between frames, sorted",
        "Both return a sorted list: `PairFinder` by default, the peers with VQSort, in memory that is reused.",
        Field::all, Finish::sorted},
       {"graze overlapping_pairs", "Single call, sorted",
        "The call with its defaults, compared with the peers that keep nothing from the previous frame; both return a\n"
        "sorted list.",
        Field::from_nothing, Finish::sorted},
       {"graze overlapping_pairs", "Single sorting call against kept trees",
        "Unequal conditions, to graze's disadvantage: the call sorts, keeps nothing from the previous frame and\n"
        "allocates a new list, while the fastest peer is usually one that keeps and refits its tree, does not sort,\n"
        "and reuses the memory of its list.",
        Field::all, Finish::found}}};
  return all;
}

/// The ratio of the fastest single-threaded peer's time to graze's; 0 if either did not run.
double ratio_of(const Heat& heat, const Discipline& discipline) {
  const Timing* graze = timing_of(heat, discipline.contestant);
  const Timing* peer = fastest(heat, Side::peer, 1, discipline.field, discipline.finish);
  return graze == nullptr || peer == nullptr ? 0 : time_of(*peer, discipline.finish) / graze->median;
}

bool is_under_target(const Trajectory& course, const Heat& heat, const Discipline& discipline) {
  const double ratio = ratio_of(heat, discipline);
  return ratio > 0 && ratio < target_of(course, heat.count);
}

/// "10.3", with a mark and the target if it is below; a dash if there is no peer to compare with.
std::string verdict(const Trajectory& course, const Heat& heat, const Discipline& discipline) {
  const double ratio = ratio_of(heat, discipline);
  if (ratio == 0) return "-";
  if (!is_under_target(course, heat, discipline)) return ratio_text(ratio);
  return fmt::format("{} (< {:g})", ratio_text(ratio), target_of(course, heat.count));
}

/// Nanoseconds of a frame per box.
double per_box(const Heat& heat, const Timing& timing) {
  return timing.median * 1e6 / static_cast<double>(std::max<std::size_t>(1, heat.count));
}

const Heat* heat_of(const CourseResult& result, std::size_t count) {
  const auto found =
      std::find_if(result.heats.begin(), result.heats.end(), [count](const Heat& heat) { return heat.count == count; });
  return found == result.heats.end() ? nullptr : &*found;
}

std::set<std::size_t> all_counts(const Outcome& outcome) {
  std::set<std::size_t> counts;
  for (const CourseResult& result : outcome.results) {
    for (const Heat& heat : result.heats) {
      if (result.course.world) counts.insert(heat.count);
    }
  }
  return counts;
}

std::string ratios(const Outcome& outcome, const Discipline& discipline) {
  const std::set<std::size_t> counts = all_counts(outcome);
  std::string text = fmt::format("### {}\n\n{}\n\n", discipline.title, discipline.explanation);
  Cells cells = {"scene"};
  for (const std::size_t count : counts) cells.push_back(grouped(count));
  text += head(cells);
  for (const CourseResult& result : outcome.results) {
    if (!result.course.world) continue;
    cells = {title_of(result.course)};
    for (const std::size_t count : counts) {
      const Heat* const heat = heat_of(result, count);
      cells.push_back(heat == nullptr ? "" : verdict(result.course, *heat, discipline));
    }
    text += row(cells);
  }
  for (const CourseResult& result : outcome.results) {
    if (result.course.world || result.heats.empty()) continue;
    const Heat& heat = result.heats.front();
    text += fmt::format("\n{}, {} boxes: {}\n", title_of(result.course), grouped(heat.count),
                        verdict(result.course, heat, discipline));
  }
  return text + "\n";
}

std::string under_target(const Outcome& outcome, const Discipline& discipline) {
  std::string lines;
  for (const CourseResult& result : outcome.results) {
    for (const Heat& heat : result.heats) {
      if (!is_under_target(result.course, heat, discipline)) continue;
      const Timing& peer = *fastest(heat, Side::peer, 1, discipline.field, discipline.finish);
      lines += fmt::format(
          "- {}, {} boxes: {} of {:g}; {} takes {} ms, graze {} ms\n", title_of(result.course), grouped(heat.count),
          ratio_text(ratio_of(heat, discipline)), target_of(result.course, heat.count), peer.name,
          milliseconds(time_of(peer, discipline.finish)), milliseconds(timing_of(heat, discipline.contestant)->median));
    }
  }
  return "Under target:\n\n" + (lines.empty() ? "- none of the above\n" : lines) + "\n";
}

/// A table of graze's own targets: one number for each contestant of every scene that has it, marked if `is_good` is
/// false.
struct OwnTarget {
  std::string title;
  std::string explanation;
  std::function<double(const CourseResult&, const std::string& contestant)> number;  ///< 0 if there is none.
  std::function<bool(double)> is_good;
};

std::string table(const Outcome& outcome, const OwnTarget& target) {
  std::vector<std::string> names;
  for (const Timing& timing : outcome.results.front().heats.front().timings) {
    if (timing.side == Side::graze && timing.threads == 1) names.push_back(timing.name);
  }
  Cells cells = {"scene"};
  cells.insert(cells.end(), names.begin(), names.end());
  const std::string header = head(cells);
  std::string rows;
  for (const CourseResult& result : outcome.results) {
    cells = {title_of(result.course)};
    bool has_number = false;
    for (const std::string& name : names) {
      const double number = target.number(result, name);
      has_number = has_number || number > 0;
      cells.push_back(number == 0 ? "-" : fmt::format("{:.2f}{}", number, target.is_good(number) ? "" : " (!)"));
    }
    if (has_number) rows += row(cells);
  }
  if (rows.empty()) return "";
  return fmt::format("### {}\n\n{} Values that miss it are marked with (!).\n\n{}{}\n", target.title,
                     target.explanation, header, rows);
}

std::string own_targets(const Outcome& outcome, std::size_t threads) {
  if (outcome.results.empty() || outcome.results.front().heats.empty()) return "";
  std::string text;
  if (threads == 2) {
    constexpr double least = 1.7;
    const auto gain = [](const CourseResult& result, const std::string& name) {
      const Heat* const heat = heat_of(result, 1'000'000);
      const Timing* const one = heat == nullptr ? nullptr : timing_of(*heat, name);
      const Timing* const two = heat == nullptr ? nullptr : timing_of(*heat, name + ", 2 threads");
      return one == nullptr || two == nullptr ? 0.0 : one->median / two->median;
    };
    text += table(
        outcome,
        {"Two threads against one",
         "The ratio of one thread's time to two threads', for a million boxes. The target is at least 1.7 on an idle\n"
         "machine.",
         gain, [](double number) { return number >= least; }});
  }
  constexpr double most = 2;
  const auto growth = [](const CourseResult& result, const std::string& name) {
    const Heat* const large = heat_of(result, 10'000'000);
    const Heat* const small = heat_of(result, 100'000);
    if (large == nullptr || small == nullptr) return 0.0;
    const Timing* const in_large = timing_of(*large, name);
    const Timing* const in_small = timing_of(*small, name);
    return in_large == nullptr || in_small == nullptr ? 0.0 : per_box(*large, *in_large) / per_box(*small, *in_small);
  };
  return text + table(outcome, {"Growth from 100,000 to ten million boxes",
                                "The ratio of the times per box. The target is at most 2.", growth,
                                [](double number) { return number <= most; }});
}

std::string targets(const Outcome& outcome) {
  std::string text = "## Ratio of the fastest peer's time to graze's\n\n";
  text +=
      "The targets: 10 for brownian, cluster and lattice, 6 for heavy, line and giants, both from 100,000 to a\n"
      "million boxes; 6 for files; 2 for everything else. A ratio below its target is followed by the target.\n\n";
  for (const Discipline& discipline : disciplines()) {
    text += ratios(outcome, discipline) + under_target(outcome, discipline);
  }
  return text;
}

std::string differences(const Outcome& outcome) {
  if (outcome.differences.empty()) return "";
  std::string text = "## Wrong answers\n\n";
  for (const std::string& difference : outcome.differences) text += fmt::format("- {}\n", difference);
  return text + "\n";
}

std::string cell(const Timing& timing, bool is_fastest) {
  if (timing.frames == 0) return fmt::format("not run: {}", timing.why_not.empty() ? "out of time" : timing.why_not);
  const std::string time = milliseconds(timing.median);
  return fmt::format("{} ±{:.0f} %", is_fastest ? "**" + time + "**" : time, timing.spread * 100);
}

/// One row of the table of a course: a name, and one cell per heat.
std::string line(const std::string& name, const CourseResult& result,
                 const std::function<std::string(const Heat&)>& say) {
  Cells cells = {name};
  for (const Heat& heat : result.heats) cells.push_back(say(heat));
  return row(cells);
}

std::string ratio_cell(const Timing* graze, const Timing* peer) {
  return graze == nullptr || peer == nullptr ? "-" : ratio_text(peer->median / graze->median);
}

std::string ratio_lines(const CourseResult& result, std::size_t threads) {
  std::string text;
  for (const Timing& graze : result.heats.front().timings) {
    const bool is_judged = &graze == judged(result.heats.front(), threads);
    if (graze.side != Side::graze || (graze.threads > 1 && !is_judged)) continue;
    text += line("fastest peer / " + graze.name, result, [&graze](const Heat& heat) {
      return ratio_cell(timing_of(heat, graze.name), fastest(heat, Side::peer, graze.threads));
    });
  }
  text += line("graze overlapping_pairs, ns for a box", result, [](const Heat& heat) {
    const Timing* graze = judged(heat, 1);
    return graze == nullptr ? std::string("-") : fmt::format("{:.1f}", per_box(heat, *graze));
  });
  if (threads == 1) return text;
  return text + line(fmt::format("graze, 1 thread / {} threads", threads), result,
                     [threads](const Heat& heat) { return ratio_cell(judged(heat, threads), judged(heat, 1)); });
}

std::string table(const CourseResult& result, std::size_t threads) {
  std::string text = fmt::format("### {}\n\n", title_of(result.course));
  Cells cells = {"boxes"};
  for (const Heat& heat : result.heats) cells.push_back(grouped(heat.count));
  text += head(cells);
  text += line("pairs", result, [](const Heat& heat) { return grouped(heat.pairs); });
  const std::vector<Timing>& timings = result.heats.front().timings;
  for (std::size_t i = 0; i < timings.size(); ++i) {
    text += line(timings[i].name, result, [i](const Heat& heat) {
      const Timing& timing = heat.timings[i];
      return cell(timing, &timing == fastest(heat, Side::peer, 1));
    });
  }
  text += line("fastest peer until its list is sorted", result, [](const Heat& heat) {
    const Timing* peer = fastest(heat, Side::peer, 1, Field::all, Finish::sorted);
    return peer == nullptr ? std::string("-") : milliseconds(peer->sorted);
  });
  return text + ratio_lines(result, threads) + "\n";
}

}  // namespace

std::string grouped(std::size_t number) {
  std::string text = std::to_string(number);
  for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, ",");
  return text;
}

std::string markdown(const Outcome& outcome, const Settings& settings, const std::string& chart) {
  std::string text = introduction(settings);
  if (!chart.empty()) text += fmt::format("![Milliseconds per frame over the number of boxes]({})\n\n", chart);
  text += targets(outcome) + own_targets(outcome, settings.threads) + differences(outcome) + contestants(outcome);
  text += "## Milliseconds per frame\n\nThe fastest peer with one thread is in bold.\n\n";
  for (const CourseResult& result : outcome.results) {
    if (!result.heats.empty()) text += table(result, settings.threads);
  }
  text.pop_back();  // one line break at the end is enough
  return text;
}

}  // namespace graze::race
