// SPDX-License-Identifier: MIT
// The tables of contacts and rays, as Markdown.
#pragma once

#include <string>
#include <vector>

#include "exam/measure.hpp"

namespace graze::exam {

/// What graze said of each pair, and beside its rivals; empty if there were no cases.
std::string contact_tables(const std::vector<MeasuredPair>& tallies);

/// The same of each shape and rays.
std::string ray_tables(const std::vector<MeasuredPair>& tallies);

}  // namespace graze::exam
