// SPDX-License-Identifier: MIT
#include "exam/settings.hpp"

#include <CLI/CLI.hpp>

namespace graze::exam {

std::variant<Settings, int> read_settings(int argc, const char* const* argv) {
  constexpr int usage_error = 2;
  Settings settings;
  CLI::App app("Puts hard cases to graze, to the exact oracle and to other libraries, and counts wrong answers.",
               "graze_exam");
  app.add_option("--cases", settings.cases, "cases per pair of types and space")->capture_default_str();
  app.add_option("--points", settings.points, "cases per shape and space for point queries")->capture_default_str();
  app.add_option("--contacts", settings.contacts, "cases per pair of types and space for contact")
      ->capture_default_str();
  app.add_option("--distances", settings.distances, "cases per pair of types and space for closest_points")
      ->capture_default_str();
  app.add_option("--manifolds", settings.manifolds, "cases per pair of types and space for manifold")
      ->capture_default_str();
  app.add_option("--casts", settings.casts, "cases per pair of types and space for shape_cast")->capture_default_str();
  app.add_option("--impacts", settings.impacts, "cases per pair of types and space for time_of_impact")
      ->capture_default_str();
  app.add_option("--rays", settings.rays, "cases per shape and space for ray_cast")->capture_default_str();
  app.add_option("--hulls", settings.hulls, "sets of points per kind and space for convex_hull")->capture_default_str();
  app.add_option("--masses", settings.masses, "cases per shape and space for mass_properties")->capture_default_str();
  app.add_option("--seed", settings.seed, "other cases")->capture_default_str();
  app.add_option("--pairs", settings.pairs, "only pairs whose name holds this, such as \"3D float obb, triangle\"");
  app.add_option("--seconds", settings.seconds, "stop each pair after this time; 0 for never")->capture_default_str();
  app.add_option("--output", settings.output, "write the tables to this file, between its marks if it has them");
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
