// SPDX-License-Identifier: MIT
#include <array>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>

#include <graze/io/report/summary.hpp>

#include "command.hpp"
#include "input.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "terminal.hpp"
#include "usage.hpp"

namespace graze::cli {
namespace {

enum class InfoFormat { table, json };

struct InfoArguments {
  std::string scene;
  std::string format = "table";
  io::SceneReading reading;
  bool strict = false;
};

constexpr std::array<std::pair<std::string_view, InfoFormat>, 2> info_formats{
    {{"table", InfoFormat::table}, {"json", InfoFormat::json}}};

ExitCode run_info(const InfoArguments& arguments) {
  const InfoFormat format = chosen("--format", arguments.format, info_formats);
  Progress progress("reading the scene");
  const io::SceneFile file = read_input(arguments.scene, arguments.reading);
  const io::SceneSummary summary = io::summarise(file);
  progress.stop();
  arguments.strict ? refuse_omissions(file) : say_warnings(file);
  write_output("-", [&](std::ostream& out) {
    if (format == InfoFormat::json) {
      io::write_summary_json(out, summary);
    } else {
      io::write_summary_table(out, summary, colours_for(Stream::output));
    }
  });
  return done;
}

constexpr const char* info_footer =
    R"(Sizes are the largest extents of the objects' boxes. Edges and components of meshes are counted
after equal vertices have been joined.

Examples:
  graze info level.tmx
  graze info --format json chip.csv
  graze info engine.glb

Exit codes: 0 done; 2 wrong usage; 3 bad input, or an output that cannot be written)";

}  // namespace

Command add_info(CLI::App& program) {
  CLI::App* app = program.add_subcommand("info", "Summarize a scene: types, layers, bounds, sizes, what was not read");
  const auto arguments = std::make_shared<InfoArguments>();
  app->add_option("SCENE", arguments->scene, "Scene file, or - for the standard input")->required()->type_name("");
  app->add_option("--format", arguments->format, "table (the default) or json")->type_name("FORMAT")->take_last();
  add_solid(*app, arguments->reading);
  add_strict(*app, arguments->strict);
  app->footer(info_footer);
  return {app, [arguments] { return run_info(*arguments); }};
}

}  // namespace graze::cli
