// SPDX-License-Identifier: MIT
// What a race leaves behind.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "contestant.hpp"
#include "course.hpp"

namespace graze::race {

/// How one contestant did at one count.
struct Timing {
  std::string name;
  std::string settings;
  Side side = Side::peer;
  std::size_t threads = 1;
  bool keeps = false;      ///< What it knows, from frame to frame.
  std::size_t frames = 0;  ///< How many were timed; 0 when it did not run.
  std::string why_not;     ///< Then the reason.
  double median = 0;       ///< Milliseconds per frame.
  double sorted = 0;       ///< The same until its list is sorted, whoever does it.
  double spread = 0;       ///< Half of what lies between the quartiles, relative to the median.
};

struct Heat {
  std::size_t count = 0;  ///< Of boxes.
  std::size_t pairs = 0;  ///< In the first frame.
  std::vector<Timing> timings;
};

struct CourseResult {
  Trajectory course;
  std::vector<Heat> heats;  ///< By ascending count.
};

/// The timing of that name, or null when it did not run.
const Timing* timing_of(const Heat& heat, const std::string& name);

/// Whom a contestant is compared with.
enum class Field { all, from_nothing };

/// Until when it is timed.
enum class Finish { found, sorted };

/// Milliseconds per frame.
double time_of(const Timing& timing, Finish finish);

/// The fastest contestant of that side that uses at most so many threads, or null when none ran.
const Timing* fastest(const Heat& heat, Side side, std::size_t threads, Field field = Field::all,
                      Finish finish = Finish::found);

/// What graze is judged by: plain overlapping_pairs, with so many threads. Null when it did not run.
const Timing* judged(const Heat& heat, std::size_t threads);

}  // namespace graze::race
