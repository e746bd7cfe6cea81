// SPDX-License-Identifier: MIT
#include <memory>
#include <ostream>
#include <string>

#include <graze/io/json_scene.hpp>
#include <graze/io/text/in_quotes.hpp>

#include "command.hpp"
#include "file_ending.hpp"
#include "input.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "usage.hpp"

namespace graze::cli {
namespace {

struct ConvertArguments {
  std::string input;
  std::string output;
  bool strict = false;
};

void require_json_name(const std::string& output) {
  if (is_standard_stream(output)) return;
  if (file_ending(output) == ".json") return;
  throw UsageError("graze cannot write " + io::in_quotes(output) +
                   "; it writes graze's JSON, so give a name that ends in .json, or - for the standard output");
}

ExitCode run_convert(const ConvertArguments& arguments) {
  require_json_name(arguments.output);
  Progress reading("reading the scene");
  const io::SceneFile file = read_input(arguments.input);
  reading.stop();
  tell_omissions(file, arguments.strict);
  Progress writing("writing the scene");
  if (is_standard_stream(arguments.output)) writing.stop();  // the data may go to the same terminal
  write_output(arguments.output, [&](std::ostream& out) { io::write_json_scene(out, file); });
  return done;
}

constexpr const char* convert_footer = R"(IN and OUT may be the same file. Numbers survive bit for bit.

Examples:
  graze convert level.tmx level.json
  graze convert chip.csv - | gzip > chip.json.gz

Exit codes: 0 done; 2 wrong usage; 3 bad input, or an output that cannot be written)";

}  // namespace

Command add_convert(CLI::App& program) {
  CLI::App* app = program.add_subcommand("convert", "Write a scene in graze's own JSON");
  const auto arguments = std::make_shared<ConvertArguments>();
  app->add_option("IN", arguments->input, "Scene file, or - for the standard input")->required()->type_name("");
  app->add_option("OUT", arguments->output, "File to write, ending in .json, or - for the standard output")
      ->required()
      ->type_name("");
  add_strict(*app, arguments->strict);
  app->footer(convert_footer);
  return {app, [arguments] { return run_convert(*arguments); }};
}

}  // namespace graze::cli
