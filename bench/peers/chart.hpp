// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "results.hpp"

namespace graze::race {

/// Milliseconds per frame over the number of boxes as an SVG picture, both axes logarithmic: a line for each contestant
/// with one thread, told apart by colour, marker and the name at its end. Readable on light and dark pages, and with
/// every kind of colour vision. Empty when nothing was timed at two counts.
std::string chart_of(const CourseResult& result);

}  // namespace graze::race
