// SPDX-License-Identifier: MIT
// Compares triangle meshes with Bullet, CGAL, Embree and FCL, one thread, side by side: build and refit, rays, closest
// points, inside or outside, two meshes, and spheres, boxes and capsules against a mesh; on a closed bumpy surface of
// 5,000, 80,000 and 1,000,000 faces, and on any files that are named. All timed answers are compared; if one differs by
// more than rounding, the query is printed and the exit status is 1. The contestants are in the folder beside this
// file.
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "count_of.hpp"
#include "mesh/race.hpp"
#include "mesh/table.hpp"

namespace {

/// Prints times as soon as they are known, then the table. Returns whether all answers are right.
bool race_and_print(const mesh_bench::Surface& surface, const mesh_bench::RaceOptions& options) {
  fmt::print("\n{}, {} faces, one thread: processor time for one query or mesh\n", surface.name, surface.faces.size());
  const mesh_bench::RaceResult result = mesh_bench::race(surface, options);
  fmt::print("{}", mesh_bench::table_of(result));
  std::fflush(stdout);
  return result.faults.empty();
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> faces = {"5k", "80k", "1M"};
  std::vector<std::string> files;
  bool is_quick = false;
  mesh_bench::RaceOptions options;
  CLI::App app("Races graze's meshes against those of other libraries, and compares their answers.", "mesh");
  app.add_option("files", files, "OFF, STL, PLY or OBJ files to race on, instead of the built-in surface");
  app.add_option("--faces", faces, "numbers of faces of the built-in surface, such as 5k,1M")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str();
  app.add_option("--rounds", options.rounds, "rounds, in which all take turns; the best one counts")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--enough", options.enough_seconds,
                 "who has worked so many seconds at one thing sits out its other rounds")
      ->capture_default_str();
  app.add_option("--peers", options.peers, "only peers whose names hold one of these, such as CGAL,FCL")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--works", options.works, "only works whose titles hold one of these, such as rays,inside")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_flag("--quick", is_quick, "one round with a tenth of the queries, to compare answers rather than times");
  CLI11_PARSE(app, argc, argv);
  try {
    if (is_quick) {
      options.rounds = 1;
      options.counts = {10'000, 10'000, 400, 5};
    }
    options.when_run = [](const mesh_bench::Heat& heat) {
      fmt::print("{}", mesh_bench::times_of(heat));
      std::fflush(stdout);
    };
    bool is_right = true;
    for (const std::string& file : files)
      is_right = race_and_print(mesh_bench::surface_of_file(file), options) && is_right;
    if (!files.empty()) return is_right ? 0 : 1;
    for (const std::string& count : faces) {
      is_right = race_and_print(mesh_bench::potato(bench::count_of(count, "faces")), options) && is_right;
    }
    return is_right ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "mesh: {}\n", error.what());
    return 2;
  }
}
