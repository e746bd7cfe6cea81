// SPDX-License-Identifier: MIT
// The tables, as Markdown.
#pragma once

#include <string>
#include <vector>

#include "exam/measure.hpp"
#include "exam/settings.hpp"
#include "exam/tally.hpp"

namespace graze::exam {

struct Results {
  std::vector<PairTally> pairs;
  std::vector<PointTally> points;
  std::vector<MeasuredPair> contacts;
  std::vector<MeasuredPair> rays;
};

/// Where and how the exam was run, then a table for point queries, one for pairs and those with the rivals; and the
/// same for contacts and rays.
std::string markdown(const Results& results, const Settings& settings);

/// Writes `text` to a file: between the lines that begin with `<!-- exam: begin` and `<!-- exam: end` if it has them,
/// and else in place of all it holds. Throws std::runtime_error if it cannot.
void write_page(const std::string& path, const std::string& text);

}  // namespace graze::exam
