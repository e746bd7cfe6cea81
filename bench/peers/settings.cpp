// SPDX-License-Identifier: MIT
#include "settings.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace graze::race {
namespace {

constexpr int usage_error = 2;

/// "1000", "10k", "1M".
std::size_t read_count(const std::string& text) {
  std::size_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  const std::string_view suffix(rest, static_cast<std::size_t>(end - rest));
  const std::size_t factor = suffix.empty() ? 1 : suffix == "k" ? 1000 : suffix == "M" ? 1'000'000 : 0;
  if (error != std::errc() || factor == 0 || number == 0 ||
      number > std::numeric_limits<std::uint32_t>::max() / factor) {
    throw std::invalid_argument(fmt::format("\"{}\" is no number of boxes; write 5000, 10k or 1M", text));
  }
  return number * factor;
}

std::string joined(int argc, const char* const* argv) {
  std::string command;
  for (int i = 0; i < argc; ++i) command += (i == 0 ? "" : " ") + std::string(argv[i]);
  return command;
}

/// The command line before validation.
struct Words {
  std::vector<std::string> scenes = {"brownian", "2d:brownian"};
  std::vector<std::string> counts = {"1k", "10k", "100k"};
  std::vector<std::string> files;
  std::string largest;
};

void add_options(CLI::App& app, Words& words, Settings& settings) {
  app.add_option("--scenes", words.scenes, "worlds, such as brownian, 2d:heavy, double:line; all for all in 3D and 2D")
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--boxes", words.files, "files of boxes to race on as well")->delimiter(',');
  app.add_option("--counts", words.counts, "numbers of boxes, such as 1k,1M")->delimiter(',')->capture_default_str();
  app.add_option("--largest", words.largest, "so many boxes too in the first scene, which the chart shows");
  app.add_option("--frames", settings.frames,
                 "frames that are timed in a round; of fewer than 400,000 boxes up to 25 times as many")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  app.add_option("--rounds", settings.rounds, "rounds, in which all contestants take turns")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  app.add_option("--seconds", settings.seconds, "timed seconds after which a contestant has run enough at a count")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--slowest", settings.slowest,
                 "a peer that takes so many times as long as graze sits out larger counts")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--threads", settings.threads, "race with so many threads too, those who can")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_option("--peers", settings.peers, "only peers whose names hold one of these, such as Boost,FCL")
      ->delimiter(',');
  app.add_option("--seed", settings.seed, "other boxes")->capture_default_str();
  app.add_option("--markdown", settings.markdown, "write the report to this file, not to standard output");
  app.add_option("--chart", settings.chart, "write a chart of the first scene to this SVG file");
}

std::vector<Trajectory> courses_of(const Words& words) {
  std::vector<Trajectory> courses;
  for (const std::string& scene : words.scenes) {
    if (scene != "all") {
      if (scene != "none") courses.push_back(world_course(scene));
      continue;
    }
    for (const char* const space : {"", "2d:"}) {
      for (const World world : all_worlds()) courses.push_back(world_course(space + std::string(name_of(world))));
    }
  }
  for (const std::string& file : words.files) {
    for (Trajectory& course : file_courses(file)) courses.push_back(std::move(course));
  }
  return courses;
}

}  // namespace

std::variant<Settings, int> read_settings(int argc, const char* const* argv) {
  Settings settings;
  Words words;
  CLI::App app("Races graze's overlapping_pairs against other libraries on the same boxes, and compares their answers.",
               "graze_peers");
  add_options(app, words, settings);
  try {
    app.parse(argc, argv);
    settings.courses = courses_of(words);
    for (const std::string& count : words.counts) settings.counts.push_back(read_count(count));
    if (!words.largest.empty()) settings.largest = read_count(words.largest);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : usage_error;
  } catch (const std::exception& error) {
    fmt::print(stderr, "graze_peers: {}\n", error.what());
    return usage_error;
  }
  std::sort(settings.counts.begin(), settings.counts.end());
  settings.command = joined(argc, argv);
  return settings;
}

}  // namespace graze::race
