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

/// Runs all courses at all counts. In each of the rounds every contestant in turn is prepared, does one frame to warm
/// up, whose answer is compared with graze's pair by pair, and then the frames that are timed, the same for all, of
/// which the last is compared again. One contestant is alive at a time. Making boxes and comparing is not timed.
/// A contestant with a wrong answer is out, and the difference is told. Progress is told on stderr.
Outcome run_race(const Settings& settings);

}  // namespace graze::race
