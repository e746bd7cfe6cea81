// SPDX-License-Identifier: MIT
#include "race.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include <graze/broad/pairs.hpp>

#include "list_sorter.hpp"

namespace graze::race {
namespace {

/// The frames of a round are held in memory, with at most this many bytes.
constexpr std::size_t most_frame_bytes = std::size_t{3} << 30U;

/// Rounds with fewer boxes than this have more frames, up to a limit: a frame of a thousand boxes takes microseconds,
/// less than any interruption, and the first lists of a hundred thousand boxes need fresh memory from the system, as
/// later ones do not.
constexpr std::size_t boxes_of_few_frames = 400'000;
constexpr std::size_t most_times_frames = 25;

/// Lines on stderr; on a terminal, the last one is overwritten.
class Progress {
 public:
  void now(const std::string& text) const {
    if (is_terminal_) fmt::print(stderr, "\r\x1b[K{}", text);
  }
  void line(const std::string& text) const { fmt::print(stderr, "{}{}\n", is_terminal_ ? "\r\x1b[K" : "", text); }

 private:
  bool is_terminal_ = isatty(STDERR_FILENO) == 1;
};

/// How an answer differs from the right one, both sorted; empty if it does not.
std::string difference(std::span<const Pair> sorted, const std::vector<Pair>& right) {
  if (std::equal(sorted.begin(), sorted.end(), right.begin(), right.end())) return "";
  std::vector<Pair> missing;
  std::vector<Pair> surplus;
  std::set_difference(right.begin(), right.end(), sorted.begin(), sorted.end(), std::back_inserter(missing));
  std::set_difference(sorted.begin(), sorted.end(), right.begin(), right.end(), std::back_inserter(surplus));
  std::string text = fmt::format("{} pairs missing, {} too many", missing.size(), surplus.size());
  if (!missing.empty()) text += fmt::format("; ({}, {}) is missing", missing[0].a, missing[0].b);
  if (!surplus.empty()) text += fmt::format("; ({}, {}) is too many", surplus[0].a, surplus[0].b);
  return text;
}

double at(const std::vector<double>& ascending, double part) {
  const double place = part * static_cast<double>(ascending.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, ascending.size() - 1);
  return ascending[below] + (place - static_cast<double>(below)) * (ascending[above] - ascending[below]);
}

/// One contestant at one count, with its times so far.
template <Dim N, class T>
struct Runner {
  const Entrant<N, T>* entrant = nullptr;
  Timing timing;
  std::vector<double> times;
  std::vector<double> sorted_times;
  double seconds = 0;

  bool is_out() const { return !timing.why_not.empty(); }

  void finish() {
    if (is_out() || times.empty()) return;
    std::sort(times.begin(), times.end());
    std::sort(sorted_times.begin(), sorted_times.end());
    timing.frames = times.size();
    timing.median = at(times, 0.5);
    timing.sorted = at(sorted_times, 0.5);
    timing.spread = (at(times, 0.75) - at(times, 0.25)) / 2 / timing.median;
  }
};

/// The frames of one round with graze's answers to the first and the last.
template <Dim N, class T>
struct Round {
  std::vector<std::vector<Aabb<N, T>>> frames;
  std::vector<Pair> first_pairs;
  std::vector<Pair> last_pairs;
};

/// Why an entrant skips a count; empty if it runs. Peers that were too slow at the previous count are skipped, except
/// the two fastest, so that there is something to compare with.
template <Dim N, class T>
std::string reason_to_sit_out(const Entrant<N, T>& entrant, std::size_t count, const Heat* previous, double slowest) {
  if (count > entrant.most_boxes) return entrant.why_no_more;
  if (previous == nullptr || entrant.side == Side::graze) return "";
  for (const Timing& timing : previous->timings) {
    if (timing.name == entrant.name && timing.frames == 0) return timing.why_not;
  }
  const Timing* before = timing_of(*previous, entrant.name);
  const Timing* graze = judged(*previous, 1);
  if (before == nullptr || graze == nullptr || before->median <= slowest * graze->median) return "";
  const auto quicker = std::count_if(previous->timings.begin(), previous->timings.end(), [before](const Timing& other) {
    return other.side == Side::peer && other.threads == 1 && other.frames > 0 && other.median < before->median;
  });
  if (quicker < 2) return "";
  return fmt::format("{:.0f} times as long as graze at {}", before->median / graze->median, previous->count);
}

template <Dim N, class T>
class CourseRace {
 public:
  CourseRace(const Trajectory& course, const Settings& settings, Outcome& outcome)
      : settings_(settings), outcome_(outcome), result_{course, {}} {
    const auto is_wanted = [&settings](const Entrant<N, T>& entrant) {
      const auto holds = [&entrant](const std::string& part) { return entrant.name.find(part) != std::string::npos; };
      return entrant.side == Side::graze || settings.peers.empty() ||
             std::any_of(settings.peers.begin(), settings.peers.end(), holds);
    };
    for (Entrant<N, T>& entrant : all_entrants<N, T>(settings.threads)) {
      if (is_wanted(entrant)) entrants_.push_back(std::move(entrant));
    }
  }

  CourseResult run() {
    if (!result_.course.world) {
      run_heat(0);
      return result_;
    }
    for (const std::size_t count : settings_.counts) {
      if (count <= most_boxes_on(result_.course)) run_heat(count);
    }
    if (result_.heats.empty()) run_heat(most_boxes_on(result_.course));
    return result_;
  }

 private:
  void run_heat(std::size_t count) {
    Frames<N, T> frames(result_.course, count, settings_.seed);
    Heat heat;
    heat.count = frames.boxes().size();
    std::vector<Runner<N, T>> runners = line_up(heat.count);
    for (std::size_t round_number = 0; round_number < settings_.rounds; ++round_number) {
      const Round<N, T> round = record(frames);
      if (round_number == 0) heat.pairs = round.first_pairs.size();
      // Each round begins with another contestant, so that none always follows the same one.
      for (std::size_t k = 0; k < runners.size(); ++k) {
        Runner<N, T>& runner = runners[(k + round_number) % runners.size()];
        if (runner.is_out() || runner.seconds >= settings_.seconds) continue;
        progress_.now(fmt::format("{}, {} boxes, round {} of {}: {}", title_of(result_.course), heat.count,
                                  round_number + 1, settings_.rounds, runner.entrant->name));
        run_round(runner, round, heat.count);
      }
      frames.step();
    }
    for (Runner<N, T>& runner : runners) {
      runner.finish();
      heat.timings.push_back(runner.timing);
    }
    tell(heat);
    result_.heats.push_back(std::move(heat));
  }

  std::vector<Runner<N, T>> line_up(std::size_t count) const {
    const Heat* previous = result_.heats.empty() ? nullptr : &result_.heats.back();
    std::vector<Runner<N, T>> runners;
    for (const Entrant<N, T>& entrant : entrants_) {
      Runner<N, T> runner;
      runner.entrant = &entrant;
      runner.timing.name = entrant.name;
      runner.timing.settings = entrant.settings;
      runner.timing.side = entrant.side;
      runner.timing.threads = entrant.threads;
      runner.timing.keeps = entrant.keeps;
      runner.timing.why_not = reason_to_sit_out(entrant, count, previous, settings_.slowest);
      runners.push_back(std::move(runner));
    }
    return runners;
  }

  Round<N, T> record(Frames<N, T>& frames) const {
    const std::size_t bytes = std::max<std::size_t>(1, frames.boxes().size_bytes());
    const std::size_t times = boxes_of_few_frames / std::max<std::size_t>(1, frames.boxes().size());
    const std::size_t wanted = settings_.frames * std::clamp<std::size_t>(times, 1, most_times_frames);
    const std::size_t timed = std::clamp<std::size_t>(most_frame_bytes / bytes, 1, wanted);
    Round<N, T> round;
    for (std::size_t i = 0; i <= timed; ++i) {
      if (i > 0) frames.step();
      round.frames.emplace_back(frames.boxes().begin(), frames.boxes().end());
    }
    round.first_pairs = overlapping_pairs(round.frames.front());
    round.last_pairs = overlapping_pairs(round.frames.back());
    return round;
  }

  void run_round(Runner<N, T>& runner, const Round<N, T>& round, std::size_t count) {
    using Clock = std::chrono::steady_clock;
    const std::unique_ptr<Contestant<N, T>> contestant = runner.entrant->prepare(round.frames.front());
    if (!is_right(runner, contestant->find(round.frames.front()), round.first_pairs, count)) return;
    std::span<const Pair> pairs;
    std::size_t done = 1;
    for (; done < round.frames.size() && runner.seconds < settings_.seconds; ++done) {
      const Clock::time_point start = Clock::now();
      pairs = contestant->find(round.frames[done]);
      const Clock::time_point found = Clock::now();
      if (runner.entrant->side == Side::peer) pairs = sorter_.sort(pairs);
      const auto seconds_to = [start](Clock::time_point end) {
        return std::chrono::duration<double>(end - start).count();
      };
      const double seconds = seconds_to(Clock::now());
      runner.times.push_back(seconds_to(found) * 1000);
      runner.sorted_times.push_back(seconds * 1000);
      runner.seconds += seconds;
    }
    if (done == round.frames.size()) is_right(runner, pairs, round.last_pairs, count);
  }

  bool is_right(Runner<N, T>& runner, std::span<const Pair> answer, const std::vector<Pair>& right, std::size_t count) {
    const std::string how = difference(sorter_.sort(answer), right);
    if (how.empty()) return true;
    runner.timing.why_not = "wrong answer";
    outcome_.differences.push_back(
        fmt::format("{}, {} boxes: {}: {}", title_of(result_.course), count, runner.entrant->name, how));
    progress_.line("WRONG " + outcome_.differences.back());
    return false;
  }

  void tell(const Heat& heat) const {
    const Timing* graze = judged(heat, 1);
    const Timing* peer = fastest(heat, Side::peer, 1);
    if (graze == nullptr) return;
    std::string text = fmt::format("{}: {} boxes, {} pairs, graze {:.4g} ms", title_of(result_.course), heat.count,
                                   heat.pairs, graze->median);
    if (peer != nullptr)
      text += fmt::format(", {} {:.4g} ms: {:.1f}", peer->name, peer->median, peer->median / graze->median);
    progress_.line(text);
  }

  const Settings& settings_;
  Outcome& outcome_;
  Progress progress_;
  ListSorter sorter_;
  Entrants<N, T> entrants_;
  CourseResult result_;
};

template <Dim N>
CourseResult run_course(const Trajectory& course, const Settings& settings, Outcome& outcome) {
  if (course.is_double) return CourseRace<N, double>(course, settings, outcome).run();
  return CourseRace<N, float>(course, settings, outcome).run();
}

}  // namespace

Outcome run_race(const Settings& settings) {
  Outcome outcome;
  Settings extended = settings;
  if (settings.largest > 0) extended.counts.push_back(settings.largest);
  std::sort(extended.counts.begin(), extended.counts.end());
  for (const Trajectory& course : settings.courses) {
    const Settings& of_course = outcome.results.empty() ? extended : settings;
    outcome.results.push_back(course.dimension == 2 ? run_course<2>(course, of_course, outcome)
                                                    : run_course<3>(course, of_course, outcome));
  }
  return outcome;
}

}  // namespace graze::race
