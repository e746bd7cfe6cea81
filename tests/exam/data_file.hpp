// SPDX-License-Identifier: MIT
// The results of the exam as JSON, one row per line, from which tools/exam_tables.py makes tables.
#pragma once

#include <string>
#include <vector>

#include "exam/settings.hpp"
#include "exam/tally.hpp"

namespace graze::exam {

/// An object with three members:
///
/// - `run`: date, compiler and settings.
/// - `answers`: graze's answers, one row for each question and subject, over all spaces. A largest error is one number,
/// or
///   an object with one for each space, or one each for float and double.
/// - `side_by_side`: the figures of each program, one row for each question, space and subject, and one with the
/// subject
///   "all" for their sum.
///
/// Shares have six digits, errors two; an infinite error is null.
std::string data_text(const std::vector<Tally>& tallies, const Settings& settings);

/// Throws std::runtime_error if the file cannot be written.
void write_file(const std::string& path, const std::string& text);

}  // namespace graze::exam
