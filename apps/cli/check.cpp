// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/input_error.hpp>
#include <graze/io/report/check.hpp>
#include <graze/io/svg.hpp>

#include "command.hpp"
#include "html_report.hpp"
#include "input.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "scene_check.hpp"
#include "terminal.hpp"
#include "usage.hpp"

namespace graze::cli {
namespace {

using io::ReportFormat;

/// The parsed command line.
struct CheckArguments {
  std::string scene;
  std::string format = "table";
  std::string output = "-";
  std::optional<std::string> svg;
  std::optional<std::string> html;
  CheckedPairs pairs;
  bool fail_on_contact = false;
  io::SceneReading reading;
  bool strict = false;
};

constexpr std::array<std::pair<std::string_view, ReportFormat>, 4> check_formats{{{"table", ReportFormat::table},
                                                                                  {"json", ReportFormat::json},
                                                                                  {"ndjson", ReportFormat::ndjson},
                                                                                  {"csv", ReportFormat::csv}}};

/// Refuses an invalid distance, and options that exclude each other.
void require_one_report(const CheckedPairs& pairs) {
  if (!pairs.within) return;
  if (!(*pairs.within >= 0 && std::isfinite(*pairs.within))) {
    throw UsageError(fmt::format("--within {} is not a valid distance; it must be 0 or more", *pairs.within));
  }
  if (pairs.contacts) throw UsageError("--within reports distances and --contacts depths; give only one of them");
  if (pairs.only_interior) throw UsageError("--within and --interior exclude each other; give only one of them");
}

/// Refuses targets that would mix two outputs, or overwrite the scene with its report.
void require_separate_files(const CheckArguments& arguments) {
  const std::array<std::pair<std::string_view, const std::string*>, 3> outputs{
      {{"--output", &arguments.output},
       {"--svg", arguments.svg ? &*arguments.svg : nullptr},
       {"--html", arguments.html ? &*arguments.html : nullptr}}};
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const auto& [option, name] = outputs[i];
    if (name == nullptr) continue;
    for (const auto& [earlier, other] : std::span(outputs).first(i)) {
      if (other == nullptr || !name_same_file(*name, *other)) continue;
      if (!is_standard_stream(*name)) {
        throw UsageError(fmt::format("{} and {} name the same file {}", earlier, option, io::in_quotes(*name)));
      }
      if (earlier != "--output") throw UsageError(fmt::format("{} - and {} - cannot both be given", earlier, option));
      throw UsageError(fmt::format("{} - needs --output FILE, as the report goes to the standard output too", option));
    }
    require_not_overwritten(arguments.scene, *name);
  }
}

/// Collects the pairs for what needs them in addition to the report.
struct Pictures {
  std::optional<HtmlReport> html;
  std::vector<ObjectPair> touching;  // for the picture
};

/// Writes the report while pairs are found, and passes the pairs on to the picture and the page, if requested.
void write_report(std::ostream& out, const CheckArguments& arguments, SceneCheck& check, Progress& progress,
                  Pictures& pictures) {
  const ReportFormat format = chosen("--format", arguments.format, check_formats);
  const bool on_terminal = is_standard_stream(arguments.output) && is_terminal(Stream::output);
  const auto colours = on_terminal ? colours_for(Stream::output) : io::Colours::off;
  const std::unique_ptr<io::ReportWriter> writer = io::begin_report(out, format, check.head(), colours);
  if (on_terminal && format != ReportFormat::table) progress.stop();  // printing pairs shows the progress
  const auto write = [&](const io::ReportedPair& pair, const ObjectPair& ids) {
    writer->write(pair);
    if (pictures.html) pictures.html->add(pair);
    if (arguments.svg) pictures.touching.push_back(ids);
  };
  check.run(write, [&] { return static_cast<bool>(out.flush()); });
  progress.stop();
  writer->finish(check.summary());
  out.flush();
}

/// Prints the summary to the error stream, unless the report contains it.
void say_summary(const CheckArguments& arguments, const SceneCheck& check) {
  const bool in_report = arguments.format == "table" || arguments.format == "json";
  if (!in_report || !is_standard_stream(arguments.output)) say(io::summary_line(check.head(), check.summary()));
}

/// Does not call a scene free of contacts if a shape may be missing.
void require_all_shapes(const io::SceneFile& file) {
  std::vector<std::string> missing;
  for (const io::Omission& omission : io::missing_shapes(file.omissions))
    missing.push_back(io::omission_text(omission));
  if (missing.empty()) return;
  throw io::InputError(
      fmt::format("{}: no pair is reported, but --fail-on-contact does not pass while shapes that could touch were not "
                  "read: {}",
                  name_of(file), fmt::join(missing, "; ")));
}

ExitCode run_check(const CheckArguments& arguments) {
  static_cast<void>(chosen("--format", arguments.format, check_formats));  // checked before anything is read
  require_one_report(arguments.pairs);
  require_separate_files(arguments);
  std::string page = arguments.html ? read_report_template() : "";
  Progress progress("reading the scene");
  const io::SceneFile file = read_input(arguments.scene, arguments.reading);
  progress.stop();
  tell_omissions(file, arguments.strict);

  Progress search_progress("searching for candidates");
  SceneCheck check(file, arguments.pairs, search_progress);
  Pictures pictures;
  if (arguments.html) pictures.html.emplace(std::move(page), check.head());
  write_output(arguments.output, [&](std::ostream& out) {
    write_report(out, arguments, check, search_progress, pictures);
    if (!out) return;
    // Written here, so that a report file replaces its target only after the picture and the page have been written.
    const Progress drawing("drawing the picture");
    if (arguments.svg) {
      write_output(*arguments.svg, [&](std::ostream& picture) { io::write_svg(picture, file, pictures.touching); });
    }
    if (arguments.html) {
      write_output(*arguments.html, [&](std::ostream& to) { pictures.html->finish(to, file, check.summary()); });
    }
  });
  say_summary(arguments, check);
  if (!arguments.fail_on_contact) return done;
  if (check.summary().pairs > 0) return contact_found;
  require_all_shapes(file);
  return done;
}

constexpr const char* check_footer =
    R"(SCENE is a scene in graze's JSON or CSV, a Tiled map (.tmx, .tmj), or a mesh file (.glb, .gltf,
.stl, .obj, .ply, .off), recognized by content. Pairs are in the scene's order. Shapes that touch
without overlapping count. A table and CSV have a row for each contact point of a pair.

Examples:
  graze check level.tmx
  graze check --interior --format csv chip.csv > overlaps.csv
  graze check --contacts --format json level.tmx
  graze check --within 0.5 machine.json
  graze check engine.glb
  graze check --output report.json --format json --svg picture.svg level.tmx
  graze check --html report.html level.tmx
  generate | graze check --fail-on-contact -

Exit codes: 0 done; 1 contact found, with --fail-on-contact; 2 wrong usage;
3 bad input, a shape not read with --fail-on-contact, or an output that cannot be written)";

}  // namespace

Command add_check(CLI::App& program) {
  CLI::App* app = program.add_subcommand("check", "Find every pair of objects that touch");
  const auto arguments = std::make_shared<CheckArguments>();
  app->add_option("SCENE", arguments->scene, "Scene file, or - for the standard input")->required()->type_name("");
  app->add_option("--format", arguments->format, "table (the default), json, ndjson or csv")
      ->type_name("FORMAT")
      ->take_last();
  app->add_flag("--interior", arguments->pairs.only_interior, "Report only pairs whose interiors overlap");
  app->add_flag("--contacts", arguments->pairs.contacts, "Report the depth, normal and contact points of each pair");
  app->add_option("--within", arguments->pairs.within, "Report all pairs at most this far apart, and their distance")
      ->type_name("DISTANCE")
      ->take_last();
  app->add_option("--svg", arguments->svg, "Draw the scene and its contacts, - for the standard output")
      ->type_name("FILE")
      ->take_last();
  app->add_option("--html", arguments->html,
                  "Write a page that shows the result in a browser, - for the standard output")
      ->type_name("FILE")
      ->take_last();
  app->add_option("--output", arguments->output, "Write the report to a file instead of the standard output")
      ->type_name("FILE")
      ->take_last();
  app->add_flag("--fail-on-contact", arguments->fail_on_contact, "End with exit code 1 if a pair is reported");
  add_solid(*app, arguments->reading);
  add_strict(*app, arguments->strict);
  app->footer(check_footer);
  return {app, [arguments] { return run_check(*arguments); }};
}

}  // namespace graze::cli
