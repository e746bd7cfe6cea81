// SPDX-License-Identifier: MIT
// Times indexes side by side, and compares all their answers.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "../bench/turns.hpp"
#include "contestant.hpp"

namespace bench {

struct RaceOptions : Turns {
  std::vector<std::string> names;  ///< Peers whose names contain one of these take part; all if empty.
};

struct Result {
  std::string name;
  bool is_graze;
  bool is_judged;
  double seconds;  ///< Processor time.
};

struct Heat {
  Work work;
  std::vector<Result> results;
};

struct RaceResult {
  Dim dimensions;
  std::size_t count;
  std::vector<Heat> heats;
  std::vector<std::string> faults;  ///< Wrong answers, and whose they are.
  std::vector<std::string> notes;   ///< Boxes missed by rounding, tolerated if they are few.
};

/// Times all works for a number of boxes, on one thread. All timed answers are compared with each other, and some with
/// a loop over all boxes.
template <Dim N>
RaceResult race(std::size_t count, const RaceOptions& options);

}  // namespace bench
