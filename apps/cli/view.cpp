// SPDX-License-Identifier: MIT
#include <memory>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>

#include <graze/io/report/check.hpp>

#include "command.hpp"
#include "html_report.hpp"
#include "input.hpp"
#include "output.hpp"
#include "page_server.hpp"
#include "progress.hpp"
#include "scene_check.hpp"
#include "terminal.hpp"
#include "usage.hpp"

namespace graze::cli {
namespace {

/// The parsed command line.
struct ViewArguments {
  std::string scene;
  std::optional<std::string> html;
  io::SceneReading reading;
  bool strict = false;
};

/// Checks the scene and writes the page; returns the summary sentence.
std::string write_view(std::ostream& out, std::string page, const io::SceneFile& file) {
  Progress progress("searching for candidates");
  SceneCheck check(file, {}, progress);
  HtmlReport report(std::move(page), check.head());
  check.run([&](const io::ReportedPair& pair, const ObjectPair&) { report.add(pair); }, [] { return true; });
  progress.begin("writing the page");
  report.finish(out, file, check.summary());
  progress.stop();
  return io::summary_line(check.head(), check.summary());
}

[[noreturn]] void serve(std::string page) {
  PageServer server(std::move(page));
  write_output("-", [&](std::ostream& out) { out << server.address() << '\n'; });
  say("open this address in a browser; press Ctrl+C to end the program");
  server.serve();
}

ExitCode run_view(const ViewArguments& arguments) {
  if (arguments.html) require_not_overwritten(arguments.scene, *arguments.html);
  std::string page = read_report_template();
  Progress progress("reading the scene");
  const io::SceneFile file = read_input(arguments.scene, arguments.reading);
  progress.stop();
  tell_omissions(file, arguments.strict);
  if (arguments.html) {
    std::string summary;
    write_output(*arguments.html, [&](std::ostream& out) { summary = write_view(out, std::move(page), file); });
    say(summary);
    return done;
  }
  std::ostringstream filled;
  say(write_view(filled, std::move(page), file));
  serve(std::move(filled).str());
}

constexpr const char* view_footer =
    R"(SCENE is a scene in graze's JSON or CSV, a Tiled map (.tmx, .tmj), or a mesh file (.glb, .gltf,
.stl, .obj, .ply, .off), recognized by content. The page is self-contained and opens without a
network. Without --html it is served at a local address until the program ends.

Examples:
  graze view level.tmx
  graze view --html level.html level.tmx

Exit codes: 0 done; 2 wrong usage; 3 bad input, or an output that cannot be written)";

}  // namespace

Command add_view(CLI::App& program) {
  CLI::App* app = program.add_subcommand("view", "Show a scene and its contacts in the browser");
  const auto arguments = std::make_shared<ViewArguments>();
  app->add_option("SCENE", arguments->scene, "Scene file, or - for the standard input")->required()->type_name("");
  app->add_option("--html", arguments->html, "Write the page to a file, - for the standard output")
      ->type_name("FILE")
      ->take_last();
  add_solid(*app, arguments->reading);
  add_strict(*app, arguments->strict);
  app->footer(view_footer);
  return {app, [arguments] { return run_view(*arguments); }};
}

}  // namespace graze::cli
