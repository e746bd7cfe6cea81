// SPDX-License-Identifier: MIT
// The options about worlds and threads that the commands have in common.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>

#include <graze/broad/executor.hpp>

#include "world_argument.hpp"

namespace graze::mpi {

struct WorldOptions {
  std::string world;
  std::string seed = "1";
  std::string threads = "1";
};

inline void add_world_options(CLI::App& app, WorldOptions& options) {
  app.add_option("--generate", options.world, "World to generate, such as brownian:100k")
      ->required()
      ->type_name("WORLD:COUNT")
      ->take_last();
  app.add_option("--seed", options.seed, "Seed of the random numbers, 1 by default")->type_name("N")->take_last();
  app.add_option("--threads", options.threads, "Threads of each rank, 1 by default")->type_name("N")->take_last();
}

inline std::uint64_t threads_of(const WorldOptions& options) {
  return cli::read_number("--threads", options.threads, {1, 1024});
}

/// The numbers of the boxes that a rank passes at first: equal parts of all, in order.
inline std::pair<std::size_t, std::size_t> part_of(std::size_t count, int rank, int ranks) {
  const auto part = [&](int r) { return count * static_cast<std::size_t>(r) / static_cast<std::size_t>(ranks); };
  return {part(rank), part(rank + 1)};
}

}  // namespace graze::mpi
