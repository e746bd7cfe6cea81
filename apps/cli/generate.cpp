// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <graze/broad/scene_generators.hpp>
#include <graze/io/json_scene.hpp>
#include <graze/io/recording.hpp>
#include <graze/io/text/in_quotes.hpp>

#include "command.hpp"
#include "file_ending.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "terminal.hpp"
#include "usage.hpp"
#include "world_argument.hpp"

namespace graze::cli {
namespace {

enum class WorldFormat { csv, json, aabbs };

/// The parsed command line.
struct GenerateArguments {
  std::string world;
  std::string seed = "1";
  std::optional<std::string> frames;
  std::string output = "-";
  std::optional<std::string> format;
};

/// What it requests.
struct Order {
  WorldArgument world;
  std::uint64_t seed = 1;
  std::size_t frames = 1;
  WorldFormat format = WorldFormat::csv;
  std::string output;
};

constexpr std::array<std::pair<std::string_view, WorldFormat>, 3> generate_formats{
    {{"csv", WorldFormat::csv}, {"json", WorldFormat::json}, {"aabbs", WorldFormat::aabbs}}};

/// The format given by --format, or by the file's extension; CSV for the standard output.
WorldFormat format_of(const GenerateArguments& arguments) {
  std::optional<WorldFormat> asked;
  if (arguments.format) asked = chosen("--format", *arguments.format, generate_formats);
  if (is_standard_stream(arguments.output)) return asked.value_or(WorldFormat::csv);
  const std::string ending = file_ending(arguments.output);
  for (const auto& [name, format] : generate_formats) {
    if (ending != "." + std::string(name)) continue;
    if (!asked || *asked == format) return format;
    throw UsageError(fmt::format("{} ends in {}, but --format says {}; leave one of them out",
                                 io::in_quotes(arguments.output), ending, *arguments.format));
  }
  if (asked) return *asked;
  throw UsageError("the name " + io::in_quotes(arguments.output) +
                   " does not determine a format; give a name that ends in .csv, .json or .aabbs, or add --format");
}

std::size_t frames_of(const GenerateArguments& arguments, WorldFormat format) {
  if (format != WorldFormat::aabbs) {
    const std::size_t frames = read_number("--frames", arguments.frames.value_or("1"), frame_range);
    if (frames == 1) return 1;
    throw UsageError(
        fmt::format("a scene in CSV or JSON has one frame, not {}; for a recording, give a name that ends in .aabbs or "
                    "add --format aabbs",
                    frames));
  }
  const std::size_t frames = read_number("--frames", arguments.frames.value_or("10"), frame_range);
  if (frames > 1) return frames;
  throw UsageError(
      "a recording needs at least 2 frames; for a single one write a scene, to a name that ends in .csv or .json");
}

Order order_of(const GenerateArguments& arguments) {
  Order order;
  order.world = read_world(arguments.world);
  order.seed = read_number("--seed", arguments.seed, {});
  order.format = format_of(arguments);
  order.frames = frames_of(arguments, order.format);
  order.output = arguments.output;
  const bool is_binary = order.format == WorldFormat::aabbs;
  if (is_binary && is_standard_stream(order.output) && is_terminal(Stream::output)) {
    throw UsageError(
        "a recording cannot be printed on a terminal; name a file with --output, or redirect the standard output");
  }
  return order;
}

std::string name_of_box(std::size_t k) { return fmt::format("b{}", k); }

/// One box per line; numbers as the shortest text that parses to the same double.
template <Dim N>
void write_csv(std::ostream& out, std::span<const Aabb<N, float>> boxes) {
  constexpr std::size_t block = 1U << 16U;
  std::string text = N == 2 ? "id,min_x,min_y,max_x,max_y\n" : "id,min_x,min_y,min_z,max_x,max_y,max_z\n";
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    text += name_of_box(k);
    for (const Vec<N, double>& corner : {wide<N, float>(boxes[k].min), wide<N, float>(boxes[k].max)}) {
      for (Dim i = 0; i < N; ++i) fmt::format_to(std::back_inserter(text), ",{}", corner[i]);
    }
    text += '\n';
    if (text.size() < block) continue;
    out << text;
    text.clear();
  }
  out << text;
}

template <Dim N>
void write_json(std::ostream& out, std::span<const Aabb<N, float>> boxes) {
  Scene<N, double> scene;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    ObjectOptions options;
    options.name = name_of_box(k);
    scene.add(Aabb<N, double>{wide<N, float>(boxes[k].min), wide<N, float>(boxes[k].max)}, std::move(options));
  }
  io::write_json_scene(out, {std::move(scene), "", "", io::YAxis::up, {}});
}

/// A box in the three dimensions of a recording; in 2D its z is 0.
template <Dim N>
Aabb<3, float> in_space(const Aabb<N, float>& box) {
  Aabb<3, float> result{Vec<3, float>(0.0F), Vec<3, float>(0.0F)};
  for (Dim i = 0; i < N; ++i) {
    result.min[i] = box.min[i];
    result.max[i] = box.max[i];
  }
  return result;
}

template <Dim N>
void write_frames(std::ostream& out, const Order& order, MovingBoxes<N, float>& world, Progress& progress) {
  const io::RecordingHead head{fmt::format("{}, seed {}", text_of(order.world), order.seed),
                               N == 2 ? "squares" : "cubes", order.world.count, order.frames, in_space(world.bounds())};
  io::write_recording<N>(out, head, [&](std::size_t frame) {
    if (frame > 0) world.step();
    progress.advance(frame);
    return world.boxes();
  });
}

template <Dim N>
void write_world(const Order& order) {
  Progress progress("generating boxes");
  MovingBoxes<N, float> world(order.world.world, order.world.count, order.seed);
  progress.begin("writing the boxes", order.frames == 1 ? 0 : order.frames);
  if (is_standard_stream(order.output)) progress.stop();  // the data may go to the same terminal
  write_output(order.output, [&](std::ostream& out) {
    if (order.format == WorldFormat::csv) write_csv<N>(out, world.boxes());
    if (order.format == WorldFormat::json) write_json<N>(out, world.boxes());
    if (order.format == WorldFormat::aabbs) write_frames<N>(out, order, world, progress);
  });
}

ExitCode run_generate(const GenerateArguments& arguments) {
  const Order order = order_of(arguments);
  if (order.world.dimension == 2) {
    write_world<2>(order);
  } else {
    write_world<3>(order);
  }
  return done;
}

constexpr const char* generate_footer =
    R"(WORLD is NAME:COUNT, or 2d:NAME:COUNT for 2D. NAME is brownian, heavy, cluster, line, plane,
lattice, giants or point; COUNT is the number of boxes. The same seed gives the same boxes.

Examples:
  graze generate brownian:100k --output boxes.csv
  graze generate 2d:heavy:1M --frames 100 --output heavy.aabbs
  graze generate cluster:5000 | graze check -

Exit codes: 0 done; 2 wrong usage; 3 an output that cannot be written)";

}  // namespace

Command add_generate(CLI::App& program) {
  CLI::App* app = program.add_subcommand("generate", "Generate a world of boxes, or a recording of its motion");
  const auto arguments = std::make_shared<GenerateArguments>();
  app->add_option("WORLD", arguments->world, "World to generate, such as brownian:100k or 2d:heavy:1M")
      ->required()
      ->type_name("");
  app->add_option("--seed", arguments->seed, "Seed of the random numbers, 1 by default")->type_name("N")->take_last();
  app->add_option("--frames", arguments->frames, "Number of frames in a recording, 10 by default")
      ->type_name("N")
      ->take_last();
  app->add_option("--output", arguments->output, "Write to a file instead of the standard output")
      ->type_name("FILE")
      ->take_last();
  app->add_option("--format", arguments->format, "csv, json or aabbs; by default according to the name of the file")
      ->type_name("FORMAT")
      ->take_last();
  app->footer(generate_footer);
  return {app, [arguments] { return run_generate(*arguments); }};
}

}  // namespace graze::cli
