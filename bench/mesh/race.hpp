// SPDX-License-Identifier: MIT
// Times the contestants on one surface, and compares their answers.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "../bench/turns.hpp"
#include "contestant.hpp"

namespace mesh_bench {

struct Result {
  std::string name;
  bool is_graze;
  double seconds;  ///< Processor time for one query, or for one mesh to be built.
};

struct Heat {
  Work work;
  std::string answers;  ///< Such as "71 % hit".
  std::vector<Result> results;
};

struct RaceOptions : bench::Turns {
  std::vector<std::string> peers;             ///< Those whose names contain one of these take part; all if empty.
  std::vector<std::string> works;             ///< The same for the titles of works.
  std::function<void(const Heat&)> when_run;  ///< Called after each work.
  Counts counts;
};

struct RaceResult {
  std::vector<Heat> heats;
  std::vector<std::string> faults;  ///< Wrong answers, and whose they are.
};

/// Times all works, on one thread. Every answer is compared with that of graze in float; see Judge.
/// Throws std::invalid_argument if the options choose no work.
RaceResult race(const Surface& surface, const RaceOptions& options);

}  // namespace mesh_bench
