// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <vector>

#include "results.hpp"
#include "settings.hpp"

namespace graze::race {

struct Outcome {
  std::vector<CourseResult> results;
  std::vector<std::string> differences;  ///< Wrong answers, one sentence each.
};

/// Runs all courses at all counts. In each round, every contestant in turn is prepared and runs one warm-up frame,
/// whose answer is compared with graze's pair by pair, and then the timed frames, the same for all; the answer to the
/// last is compared as well. Only one contestant exists at a time. Generating boxes and comparing is not timed. A
/// contestant with a wrong answer is excluded, and the difference is reported. Progress is printed on stderr.
Outcome run_race(const Settings& settings);

}  // namespace graze::race
