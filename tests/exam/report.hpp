// SPDX-License-Identifier: MIT
// The tables, as Markdown.
#pragma once

#include <string>
#include <vector>

#include "exam/hull_exam.hpp"
#include "exam/mass_exam.hpp"
#include "exam/measure.hpp"
#include "exam/settings.hpp"
#include "exam/tally.hpp"

namespace graze::exam {

struct Results {
  std::vector<PairTally> pairs;
  std::vector<PointTally> points;
  std::vector<MeasuredPair> distances;
  std::vector<MeasuredPair> contacts;
  std::vector<MeasuredPair> manifolds;
  std::vector<MeasuredPair> rays;
  std::vector<MeasuredPair> casts;
  std::vector<MeasuredPair> impacts;
  std::vector<HullTally> hulls;
  std::vector<MassTally> masses;
};

/// Where and how the exam was run, then a table for point queries, one for pairs and those with the rivals; and the
/// same for distances, contacts, manifolds, rays, casts and impacts, and one each of hulls and mass properties.
std::string markdown(const Results& results, const Settings& settings);

/// Writes `text` to a file: between the lines that begin with `<!-- exam: begin` and `<!-- exam: end` if it has them,
/// and else in place of all it holds. Throws std::runtime_error if it cannot.
void write_page(const std::string& path, const std::string& text);

}  // namespace graze::exam
