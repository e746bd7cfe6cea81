// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "results.hpp"

namespace graze::race {

/// A log-log SVG chart of milliseconds per frame over the number of boxes: a line for each single-threaded contestant,
/// distinguished by colour, marker and the name at its end. Readable on light and dark pages, and with colour
/// blindness. Empty if nothing was timed at two counts.
std::string chart_of(const CourseResult& result);

}  // namespace graze::race
