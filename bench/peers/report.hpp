// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "race.hpp"
#include "settings.hpp"

namespace graze::race {

/// The whole report as Markdown: what was compared and how, the ratios compared with the targets, and a table for each
/// course. `chart`, if not empty, is the path of a picture relative to the report.
std::string markdown(const Outcome& outcome, const Settings& settings, const std::string& chart);

/// "1,000,000".
std::string grouped(std::size_t number);

}  // namespace graze::race
