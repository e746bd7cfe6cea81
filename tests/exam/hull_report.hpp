// SPDX-License-Identifier: MIT
// The table of convex hulls, as Markdown.
#pragma once

#include <string>
#include <vector>

#include "exam/hull_exam.hpp"

namespace graze::exam {

/// graze's corners beside its rivals'; empty if there were no sets.
std::string hull_table(const std::vector<HullTally>& tallies);

}  // namespace graze::exam
