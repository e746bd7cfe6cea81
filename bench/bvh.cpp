// SPDX-License-Identifier: MIT
// Compares Bvh and graze's other indexes with those of Boost, Box2D, Bullet, Embree, FCL and nanoflann, on the bounding
// boxes of cubes that drift, in 2D or 3D: build, move all or one percent, and 100,000 queries each for the boxes in a
// region, the first box on a ray, and the nearest boxes. A library that lacks an operation does not take part in it.
// All timed answers are compared; a wrong one makes the exit status 1. The contestants are in the folder beside this
// file.
#include <cstddef>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "bvh/race.hpp"
#include "bvh/table.hpp"
#include "count_of.hpp"

int main(int argc, char** argv) {
  std::vector<std::string> counts = {"10k", "100k"};
  std::vector<int> dimensions = {2, 3};
  bench::RaceOptions options;
  CLI::App app("Races graze's indexes of boxes against those of other libraries, and compares their answers.", "bvh");
  app.add_option("--counts", counts, "numbers of boxes, such as 10k,100k,1M")->delimiter(',')->capture_default_str();
  app.add_option("--dimensions", dimensions, "2 for boxes in a plane, 3 in space")
      ->delimiter(',')
      ->check(CLI::IsMember({2, 3}))
      ->capture_default_str();
  app.add_option("--rounds", options.rounds, "rounds, in which all take turns; the best one counts")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--enough", options.enough_seconds,
                 "who has worked so many seconds at one thing sits out its other rounds")
      ->capture_default_str();
  app.add_option("--peers", options.names, "only peers whose names hold one of these, such as Boost,FCL")
      ->delimiter(',');
  CLI11_PARSE(app, argc, argv);
  try {
    bool is_right = true;
    for (const int dimension : dimensions) {
      for (const std::string& count : counts) {
        const std::size_t number = bench::count_of(count, "boxes");
        const bench::RaceResult result =
            dimension == 2 ? bench::race<2>(number, options) : bench::race<3>(number, options);
        fmt::print("{}", bench::table_of(result));
        std::fflush(stdout);
        is_right = is_right && result.faults.empty();
      }
    }
    return is_right ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "bvh: {}\n", error.what());
    return 2;
  }
}
