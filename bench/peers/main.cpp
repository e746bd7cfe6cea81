// SPDX-License-Identifier: MIT
// graze_peers: times graze's overlapping_pairs and other libraries on the same boxes, side by side. The report goes to
// standard output or a file; the status is 1 if an answer was wrong.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <ostream>
#include <string>
#include <variant>

#include <fmt/format.h>

#include <graze/io/file/atomic_file.hpp>

#include "chart.hpp"
#include "race.hpp"
#include "report.hpp"
#include "settings.hpp"

namespace graze::race {
namespace {

void write(const std::filesystem::path& path, const std::string& text) {
  io::write_atomically(path, [&text](std::ostream& stream) { stream << text; });
}

/// Writes the chart, if one is requested and there is data for it, and returns its path relative to the report.
std::string write_chart(const Outcome& outcome, const Settings& settings) {
  if (settings.chart.empty() || outcome.results.empty()) return "";
  const std::string svg = chart_of(outcome.results.front());
  if (svg.empty()) {
    fmt::print(stderr, "graze_peers: no chart: {} was timed at one count only\n",
               title_of(outcome.results.front().course));
    return "";
  }
  write(settings.chart, svg);
  const std::filesystem::path folder = std::filesystem::absolute(settings.markdown).parent_path();
  return std::filesystem::absolute(settings.chart).lexically_relative(folder).generic_string();
}

int run(const Settings& settings) {
  const Outcome outcome = run_race(settings);
  const std::string report = markdown(outcome, settings, write_chart(outcome, settings));
  if (settings.markdown.empty()) {
    fmt::print("{}", report);
  } else {
    write(settings.markdown, report);
  }
  if (outcome.differences.empty()) return 0;
  fmt::print(stderr, "graze_peers: {} wrong answers, see the report\n", outcome.differences.size());
  return 1;
}

}  // namespace
}  // namespace graze::race

int main(int argc, char** argv) {
  try {
    const auto asked = graze::race::read_settings(argc, argv);
    if (const int* status = std::get_if<int>(&asked)) return *status;
    return graze::race::run(std::get<graze::race::Settings>(asked));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "graze_peers: %s\n", error.what());
    return 2;
  }
}
