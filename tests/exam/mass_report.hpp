// SPDX-License-Identifier: MIT
// The table of mass properties, as Markdown.
#pragma once

#include <string>
#include <vector>

#include "exam/mass_exam.hpp"

namespace graze::exam {

/// Empty if there were no cases.
std::string mass_table(const std::vector<MassTally>& tallies);

}  // namespace graze::exam
