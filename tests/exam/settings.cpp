// SPDX-License-Identifier: MIT
#include "exam/settings.hpp"

#include <string>

#include <CLI/CLI.hpp>

namespace graze::exam {

std::variant<Settings, int> read_settings(int argc, const char* const* argv) {
  constexpr int usage_error = 2;
  Settings settings;
  CLI::App app("Puts hard cases to graze, to the exact oracle and to other libraries, and counts wrong answers.",
               "graze_exam");
  for (const Limit& limit : limits) {
    app.add_option("--" + std::string(limit.name), settings.*limit.number, std::string(limit.help))
        ->capture_default_str();
  }
  app.add_option("--seed", settings.seed, "other cases")->capture_default_str();
  app.add_option("--pairs", settings.pairs, "only pairs whose name holds this, such as \"3D float obb, triangle\"");
  app.add_option("--seconds", settings.seconds, "stop each pair after this time; 0 for never")->capture_default_str();
  app.add_option("--output", settings.output, "write the data to this file")->take_last();
  app.add_option("--regressions", settings.regressions, "add the cases that fail to this file, as rows")
      ->capture_default_str();
  app.add_flag("--keep-hardest", settings.keeps_hardest, "add the hardest right case of each pair and shape, too");
  app.add_option("--jobs", settings.jobs, "threads")->check(CLI::Range(1, 1024))->take_last()->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : usage_error;
  }
  return settings;
}

}  // namespace graze::exam
