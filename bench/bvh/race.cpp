// SPDX-License-Identifier: MIT
#include "race.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include <graze/broad/spatial_index.hpp>
#include <graze/query/distance_squared.hpp>

namespace bench {
namespace {

/// The reference answers.
struct Answers {
  std::vector<std::uint64_t> regions = std::vector<std::uint64_t>(questions);
  std::vector<double> numbers = std::vector<double>(questions);
};

/// Which answers differ. Peers that calculate in float may differ by a few units in the last place.
std::vector<std::size_t> differences(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k] != b[k] && !(std::fabs(a[k] - b[k]) <= 1e-5 * (0.1 + std::fabs(a[k])))) found.push_back(k);
  }
  return found;
}

/// How many boxes that a ray barely touches a peer may miss.
constexpr std::size_t forgiven = questions / 10'000;

// ---- The reference: a loop over all boxes

constexpr std::size_t judged_step = 1000;  // every query at this step is compared with the reference

template <Dim N>
std::uint64_t judged_region(const std::vector<Box<N>>& boxes, const Box<N>& region) {
  std::uint64_t digest = 0;
  for (std::size_t k = 0; k < boxes.size(); ++k) digest += boxes_overlap(region, boxes[k]) ? digest_of(k) : 0;
  return digest;
}

template <Dim N>
double judged_ray(const std::vector<Box<N>>& boxes, const Ray<N>& ray) {
  double first = std::numeric_limits<double>::infinity();
  for (const Box<N>& box : boxes) first = std::min(first, graze::detail::entry_of(ray, box).value_or(first));
  return first;
}

template <Dim N>
double judged_nearest(const std::vector<Box<N>>& boxes, const Point<N>& point, std::size_t wanted) {
  std::vector<double> distances;
  distances.reserve(boxes.size());
  for (const Box<N>& box : boxes) distances.push_back(distance_squared(point, box));
  const auto last = distances.begin() + static_cast<std::ptrdiff_t>(wanted - 1);
  std::nth_element(distances.begin(), last, distances.end());
  return *last;
}

// ---- The comparison

template <Dim N>
class Race {
 public:
  Race(std::size_t count, const RaceOptions& options) : options_(options), trajectory_(count) {
    result_.dimensions = N;
    result_.count = count;
    Entrants<N> field;
    enter_graze(field);
    enter_boost(field);
    enter_box2d(field);
    enter_bullet(field);
    enter_embree(field);
    enter_fcl(field);
    enter_nanoflann(field);
    for (const Entrant<N>& entrant : field) {
      if (entrant.is_graze || is_wanted(entrant.name)) runners_.push_back({entrant, entrant.make()});
    }
  }

  RaceResult run() {
    run_heat(Work::build, [this](Contestant<N>& contestant) { contestant.build(trajectory_.first()); });
    run_regions();
    run_numbers(
        Work::rays,
        [this](Contestant<N>& contestant, Answers& answers) { contestant.ask_rays(trajectory_, answers.numbers); },
        [this](std::size_t k) { return judged_ray(trajectory_.first(), trajectory_.rays[k]); });
    run_nearest(Work::nearest_1, 1, trajectory_.first());
    run_nearest(Work::nearest_8, 8, trajectory_.first());
    run_moves(Work::update_all, 1);
    run_moves(Work::update_one_percent, 100);
    check_moved();
    for (Runner& runner : runners_) {
      if (does(runner, Work::nearest_point_1)) runner.contestant->build(trajectory_.centers);
    }
    run_nearest(Work::nearest_point_1, 1, trajectory_.centers);
    run_nearest(Work::nearest_point_8, 8, trajectory_.centers);
    return result_;
  }

 private:
  struct Runner {
    Entrant<N> entrant;
    std::unique_ptr<Contestant<N>> contestant;
  };

  static std::string miss(const std::string& name, std::size_t rays) {
    return name + ": another first hit on " + std::to_string(rays) + " of " + std::to_string(questions) + " rays";
  }
  void note(const std::string& text) {
    std::vector<std::string>& notes = result_.notes;
    if (std::find(notes.begin(), notes.end(), text) == notes.end()) notes.push_back(text);
  }
  bool is_wanted(const std::string& name) const {
    return options_.names.empty() ||
           std::any_of(options_.names.begin(), options_.names.end(),
                       [&name](const std::string& part) { return name.find(part) != std::string::npos; });
  }
  static bool does(const Runner& runner, Work work) { return (runner.entrant.works & bit_of(work)) != 0; }
  void find_fault(const Runner& runner, const std::string& what) {
    result_.faults.push_back(runner.entrant.name + ": " + what);
  }

  /// Calls do_work(contestant) in turns, and check(runner) after each.
  template <class DoWork, class Check>
  void run_heat(Work work, const DoWork& do_work, const Check& check) {
    std::vector<const Runner*> runners;
    for (const Runner& runner : runners_) {
      if (does(runner, work)) runners.push_back(&runner);
    }
    const std::vector<double> best = best_times(
        runners.size(), options_, [](std::size_t) {}, [&](std::size_t k) { do_work(*runners[k]->contestant); },
        [&](std::size_t k) { check(*runners[k]); });
    Heat heat{work, {}};
    for (std::size_t k = 0; k < runners.size(); ++k) {
      const Entrant<N>& entrant = runners[k]->entrant;
      heat.results.push_back({entrant.name, entrant.is_graze, entrant.is_judged, best[k]});
    }
    if (!heat.results.empty()) result_.heats.push_back(heat);
  }
  template <class DoWork>
  void run_heat(Work work, const DoWork& do_work) {
    run_heat(work, do_work, [](const Runner&) {});
  }

  void run_regions() {
    Answers expected;
    runners_.front().contestant->ask_regions(trajectory_, expected.regions);
    for (std::size_t k = 0; k < questions; k += judged_step) {
      if (expected.regions[k] == judged_region(trajectory_.first(), trajectory_.regions[k])) continue;
      find_fault(runners_.front(), "a region, beside a loop over all boxes");
      break;
    }
    Answers answers;
    run_heat(
        Work::regions, [&](Contestant<N>& contestant) { contestant.ask_regions(trajectory_, answers.regions); },
        [&](const Runner& runner) {
          if (answers.regions != expected.regions) find_fault(runner, "regions");
          std::fill(answers.regions.begin(), answers.regions.end(), 0);
        });
  }

  /// ask(contestant, answers) writes numbers; judge(query) returns the right one.
  template <class Ask, class Judge>
  void run_numbers(Work work, const Ask& ask, const Judge& judge) {
    Answers expected;
    ask(*runners_.front().contestant, expected);
    for (std::size_t k = 0; k < questions; k += judged_step) {
      if (expected.numbers[k] == judge(k)) continue;
      find_fault(runners_.front(), "a number, beside a loop over all boxes");
      break;
    }
    Answers answers;
    run_heat(
        work, [&](Contestant<N>& contestant) { ask(contestant, answers); },
        [&](const Runner& runner) {
          const std::vector<std::size_t> others = differences(expected.numbers, answers.numbers);
          for (const std::size_t k : others) {
            if (expected.numbers[k] != judge(k)) find_fault(runners_.front(), "a number, beside a loop over all boxes");
          }
          if (work == Work::rays && !runner.entrant.is_graze && others.size() <= forgiven) {
            if (!others.empty()) note(miss(runner.entrant.name, others.size()));
          } else if (!others.empty()) {
            find_fault(runner, work == Work::rays ? "first hits" : "distances");
          }
          std::fill(answers.numbers.begin(), answers.numbers.end(), -1);
        });
  }

  void run_nearest(Work work, std::size_t wanted, const std::vector<Box<N>>& boxes) {
    run_numbers(
        work,
        [&](Contestant<N>& contestant, Answers& answers) {
          contestant.ask_nearest(trajectory_, wanted, answers.numbers);
        },
        [&](std::size_t k) { return judged_nearest(boxes, trajectory_.points[k], wanted); });
  }

  /// Moves to the final positions and back, repeatedly. If only some boxes move, others move in each frame.
  void run_moves(Work work, std::size_t step) {
    constexpr std::size_t way = std::tuple_size_v<decltype(trajectory_.places)> - 1;
    run_heat(work, [&](Contestant<N>& contestant) {
      for (std::size_t frame = 1; frame <= 2 * way; ++frame) {
        contestant.move(trajectory_.places[std::min(frame, 2 * way - frame)], {frame * 7 % step, step});
      }
    });
    for (Result& result : result_.heats.back().results) result.seconds /= 2 * way;
  }

  /// Whether the region queries of those that move are right at the final positions.
  void check_moved() {
    Answers answers;
    for (Runner& runner : runners_) {
      if (!does(runner, Work::update_all) || !does(runner, Work::regions)) continue;
      runner.contestant->move(trajectory_.last(), {0, 2});
      runner.contestant->move(trajectory_.last(), {1, 2});
      runner.contestant->ask_regions(trajectory_, answers.regions);
      for (std::size_t k = 0; k < questions; k += judged_step) {
        if (answers.regions[k] == judged_region(trajectory_.last(), trajectory_.regions[k])) continue;
        find_fault(runner, "regions after boxes moved");
        break;
      }
    }
  }

  RaceOptions options_;
  Trajectory<N> trajectory_;
  std::vector<Runner> runners_;
  RaceResult result_;
};

}  // namespace

template <Dim N>
RaceResult race(std::size_t count, const RaceOptions& options) {
  return Race<N>(count, options).run();
}

template RaceResult race<2>(std::size_t, const RaceOptions&);
template RaceResult race<3>(std::size_t, const RaceOptions&);

}  // namespace bench
