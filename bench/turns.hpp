// SPDX-License-Identifier: MIT
// Times contestants in turns, so that other load on the machine hits all of them alike.
#pragma once

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <limits>
#include <vector>

namespace bench {

struct Turns {
  std::size_t rounds = 3;     ///< In which all take turns; the best counts.
  double enough_seconds = 4;  ///< A contestant that has spent this time on one work skips its remaining rounds.
};

/// Work that takes less than this many seconds is repeated in the same turn, so that the caches left by other
/// contestants do not matter.
constexpr double shortest_turn = 0.01;

/// The best processor time of each of `count` contestants, in seconds. In each turn of contestant k, calls prepare(k),
/// which is not timed, and run(k), possibly several times, then check(k), which is not timed either.
template <class Prepare, class Run, class Check>
std::vector<double> best_times(std::size_t count, const Turns& turns, const Prepare& prepare, const Run& run,
                               const Check& check) {
  std::vector<double> best(count, std::numeric_limits<double>::infinity());
  std::vector<double> used(count, 0);
  for (std::size_t round = 0; round < turns.rounds; ++round) {
    for (std::size_t k = 0; k < count; ++k) {
      if (used[k] > turns.enough_seconds) continue;
      for (double turn = 0; turn < shortest_turn;) {
        prepare(k);
        const std::clock_t start = std::clock();
        run(k);
        const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        best[k] = std::min(best[k], seconds);
        used[k] += seconds;
        turn += seconds;
      }
      check(k);
    }
  }
  return best;
}

}  // namespace bench
