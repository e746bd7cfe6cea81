// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "course.hpp"

namespace graze::race {

struct Settings {
  std::vector<Trajectory> courses;
  std::vector<std::size_t> counts;  ///< Ascending.
  std::size_t largest = 0;          ///< An additional count for the first course, if not 0.
  std::size_t frames = 5;
  std::size_t rounds = 3;
  std::size_t threads = 1;
  double seconds = 10;
  double slowest = 20;
  std::uint64_t seed = 1;
  std::vector<std::string> peers;
  std::string markdown;
  std::string chart;
  std::string command;  ///< The command line, for the report.
};

/// The settings, or the exit status: 0 after --help, 2 if options are invalid, which is reported on stderr.
std::variant<Settings, int> read_settings(int argc, const char* const* argv);

}  // namespace graze::race
