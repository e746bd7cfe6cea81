// SPDX-License-Identifier: MIT
// Lets indexes work side by side, and compares all their answers.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "contestant.hpp"

namespace bench {

struct RaceOptions {
  std::size_t rounds = 3;          ///< In which all take turns; the best counts.
  double enough_seconds = 4;       ///< Who has worked so long at one thing sits out its other rounds.
  std::vector<std::string> names;  ///< Of the peers that take part, or parts of them; none for all.
};

struct Result {
  std::string name;
  bool is_graze;
  bool is_judged;
  double seconds;  ///< Of processor time.
};

struct Heat {
  Work work;
  std::vector<Result> results;
};

struct RaceResult {
  Dim dimensions;
  std::size_t count;
  std::vector<Heat> heats;
  std::vector<std::string> faults;  ///< Who gave a wrong answer to what.
  std::vector<std::string> notes;   ///< Who missed boxes by rounding, which is forgiven where they are few.
};

/// All works with so many boxes, on one thread. Answers are those that were timed; they are compared with each other
/// whole, and some of them with those of a loop over all boxes.
template <Dim N>
RaceResult race(std::size_t count, const RaceOptions& options);

}  // namespace bench
