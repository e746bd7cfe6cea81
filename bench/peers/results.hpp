// SPDX-License-Identifier: MIT
// The results of a comparison.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "contestant.hpp"
#include "course.hpp"

namespace graze::race {

/// The times of one contestant at one count.
struct Timing {
  std::string name;
  std::string settings;
  Side side = Side::peer;
  std::size_t threads = 1;
  bool keeps = false;      ///< Whether it keeps data between frames.
  std::size_t frames = 0;  ///< The number of timed frames; 0 if it did not run.
  std::string why_not;     ///< The reason, if it did not run.
  double median = 0;       ///< Milliseconds per frame.
  double sorted = 0;       ///< The same including sorting its list.
  double spread = 0;       ///< Half of the interquartile range, relative to the median.
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

/// The timing of that name, or null if it did not run.
const Timing* timing_of(const Heat& heat, const std::string& name);

/// Which contestants are considered.
enum class Field { all, from_nothing };

/// The end of the timed interval.
enum class Finish { found, sorted };

/// Milliseconds per frame.
double time_of(const Timing& timing, Finish finish);

/// The fastest contestant of that side with at most this many threads, or null if none ran.
const Timing* fastest(const Heat& heat, Side side, std::size_t threads, Field field = Field::all,
                      Finish finish = Finish::found);

/// The contestant by which graze is judged: plain overlapping_pairs with this many threads. Null if it did not run.
const Timing* judged(const Heat& heat, std::size_t threads);

}  // namespace graze::race
