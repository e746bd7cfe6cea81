// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include <graze/broad/scene_generators.hpp>
#include <graze/broad/sorted_pairs.hpp>

#include "command.hpp"
#include "output.hpp"
#include "pair_lines.hpp"
#include "progress.hpp"
#include "usage.hpp"

namespace graze::cli {
namespace {

/// The parsed command line.
struct PairsArguments {
  std::string world;
  std::string seed = "1";
  std::string frame = "0";
  std::string format = "csv";
  std::string output = "-";
};

template <Dim N>
void write_pairs(const PairWorld& wanted, PairFormat format, const std::string& output) {
  Progress progress("generating boxes");
  MovingBoxes<N, float> boxes(wanted.world.world, wanted.world.count, wanted.seed);
  for (std::uint64_t frame = 0; frame < wanted.frame; ++frame) boxes.step();
  progress.stop();
  write_output(output, [&](std::ostream& out) {
    std::string text = head_of_pairs(format, wanted);
    std::vector<NumberedPair> numbered;
    bool is_first = true;
    visit_sorted_pairs(boxes.boxes(), [&](std::span<const Pair> block) {
      numbered.clear();
      for (const auto& [a, b] : block) numbered.push_back({a, b});
      append_pairs(text, format, numbered, is_first);
      is_first = is_first && block.empty();
      out << text;
      text.clear();
      return true;
    });
    out << text << tail_of_pairs(format);
  });
}

ExitCode run_pairs(const PairsArguments& arguments) {
  const PairFormat format = chosen("--format", arguments.format, pair_formats);
  const PairWorld wanted{read_world(arguments.world), read_number("--seed", arguments.seed, {}),
                         read_number("--frame", arguments.frame, {0, frame_range.most})};
  if (wanted.world.dimension == 2) {
    write_pairs<2>(wanted, format, arguments.output);
  } else {
    write_pairs<3>(wanted, format, arguments.output);
  }
  return done;
}

constexpr const char* pairs_footer =
    R"(Boxes are numbered from 0, as `graze generate` writes them. Each line is a pair a,b with a < b,
ascending. Boxes that only touch are pairs, too. --generate takes WORLD:COUNT, or 2d:WORLD:COUNT
for 2D. WORLD is brownian, heavy, cluster, line, plane, lattice, giants or point.

Examples:
  graze pairs --generate brownian:100k --seed 3
  graze pairs --generate 2d:heavy:10k --frame 5 --format json --output pairs.json

Exit codes: 0 done; 2 wrong usage; 3 an output that cannot be written)";

}  // namespace

Command add_pairs(CLI::App& program) {
  CLI::App* app = program.add_subcommand("pairs", "List all overlapping boxes of a generated world");
  const auto arguments = std::make_shared<PairsArguments>();
  app->add_option("--generate", arguments->world, "World to generate, such as brownian:100k")
      ->required()
      ->type_name("WORLD:COUNT")
      ->take_last();
  app->add_option("--seed", arguments->seed, "Seed of the random numbers, 1 by default")->type_name("N")->take_last();
  app->add_option("--frame", arguments->frame, "How often the boxes move before, 0 by default")
      ->type_name("N")
      ->take_last();
  app->add_option("--format", arguments->format, "csv (the default) or json")->type_name("FORMAT")->take_last();
  app->add_option("--output", arguments->output, "Write to a file instead of the standard output")
      ->type_name("FILE")
      ->take_last();
  app->footer(pairs_footer);
  return {app, [arguments] { return run_pairs(*arguments); }};
}

}  // namespace graze::cli
