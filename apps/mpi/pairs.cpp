// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <mpi.h>

#include <graze/broad/scene_generators.hpp>
#include <graze/distributed/overlapping_pairs.hpp>
#include <graze/distributed/together.hpp>

#include "command.hpp"
#include "pair_lines.hpp"
#include "standard_output.hpp"
#include "usage.hpp"
#include "world_options.hpp"

namespace graze::mpi {
namespace {

struct PairsArguments {
  WorldOptions world;
  std::string frame = "0";
  std::string format = "csv";
};

/// The pairs of one rank after the other come to rank 0, in blocks, and are written: ranks own ascending ids.
void write_in_order(std::span<const IdPair> pairs, const cli::PairWorld& wanted, cli::PairFormat format) {
  constexpr std::size_t most = std::size_t{1} << 20U;
  const int self = rank_of_this();
  const int ranks = number_of_ranks();
  std::vector<std::uint64_t> counts;
  std::vector<cli::NumberedPair> block;
  std::string text;
  together(MPI_COMM_WORLD, [&] {
    counts.resize(static_cast<std::size_t>(ranks));
    block.reserve(most);
    if (self == 0) text = cli::head_of_pairs(format, wanted);
  });
  const std::uint64_t mine = pairs.size();
  MPI_Allgather(&mine, 1, MPI_UINT64_T, counts.data(), 1, MPI_UINT64_T, MPI_COMM_WORLD);
  bool is_first = true;
  for (int rank = 0; rank < ranks; ++rank) {
    const std::uint64_t count = counts[static_cast<std::size_t>(rank)];
    for (std::size_t done = 0; done < count; done += most) {
      const std::size_t size = std::min<std::size_t>(most, count - done);
      block.resize(size);  // within what is reserved
      if (rank == self) {
        for (std::size_t k = 0; k < size; ++k) block[k] = {pairs[done + k].a, pairs[done + k].b};
      }
      const int bytes = static_cast<int>(size * sizeof(cli::NumberedPair));
      if (rank == self && self != 0) MPI_Send(block.data(), bytes, MPI_BYTE, 0, 0, MPI_COMM_WORLD);
      if (rank != self && self == 0) {
        MPI_Recv(block.data(), bytes, MPI_BYTE, rank, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
      }
      together(MPI_COMM_WORLD, [&] {
        if (self != 0) return;
        cli::append_pairs(text, format, block, std::exchange(is_first, false));
        write_out(text);
        text.clear();
      });
    }
  }
  together(MPI_COMM_WORLD, [&] {
    if (self == 0) write_out(text + cli::tail_of_pairs(format));
  });
}

template <Dim N>
void find_and_write(const cli::PairWorld& wanted, cli::PairFormat format, std::uint64_t threads) {
  std::optional<MovingBoxes<N, float>> world;
  std::vector<std::uint64_t> ids;
  std::unique_ptr<Executor> executor;
  std::span<const Aabb<N, float>> boxes;
  together(MPI_COMM_WORLD, [&] {
    world.emplace(wanted.world.world, wanted.world.count, wanted.seed);
    for (std::uint64_t frame = 0; frame < wanted.frame; ++frame) world->step();
    const auto [begin, end] = part_of(wanted.world.count, rank_of_this(), number_of_ranks());
    boxes = world->boxes().subspan(begin, end - begin);
    ids.resize(end - begin);
    std::iota(ids.begin(), ids.end(), std::uint64_t{begin});
    executor = limited_executor(threads);
  });
  const std::vector<IdPair> pairs =
      overlapping_pairs<N, float>(MPI_COMM_WORLD, boxes, ids, {.executor = executor.get()});
  write_in_order(pairs, wanted, format);
}

void run_pairs(const PairsArguments& arguments) {
  const cli::PairFormat format = cli::chosen("--format", arguments.format, cli::pair_formats);
  const std::uint64_t threads = threads_of(arguments.world);
  const cli::PairWorld wanted{cli::read_world(arguments.world.world),
                              cli::read_number("--seed", arguments.world.seed, {}),
                              cli::read_number("--frame", arguments.frame, {0, cli::frame_range.most})};
  if (wanted.world.dimension == 2) {
    find_and_write<2>(wanted, format, threads);
  } else {
    find_and_write<3>(wanted, format, threads);
  }
}

constexpr const char* pairs_footer =
    R"(Writes the same bytes as `graze pairs` with the same options, whatever the number of ranks.

Examples:
  mpirun -n 4 graze-mpi pairs --generate brownian:100000 --seed 3 --format csv)";

}  // namespace

Command add_pairs(CLI::App& program) {
  CLI::App* app = program.add_subcommand("pairs", "List all overlapping boxes of a generated world");
  const auto arguments = std::make_shared<PairsArguments>();
  add_world_options(*app, arguments->world);
  app->add_option("--frame", arguments->frame, "How often the boxes move before, 0 by default")
      ->type_name("N")
      ->take_last();
  app->add_option("--format", arguments->format, "csv (the default) or json")->type_name("FORMAT")->take_last();
  app->footer(pairs_footer);
  return {app, [arguments] { run_pairs(*arguments); }};
}

}  // namespace graze::mpi
