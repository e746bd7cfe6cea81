// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include <graze/broad/relations.hpp>
#include <graze/io/report.hpp>
#include <graze/io/svg.hpp>
#include <graze/scene/manifolds.hpp>

#include "command.hpp"
#include "input.hpp"
#include "nearness.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "terminal.hpp"
#include "usage.hpp"

namespace graze::cli {
namespace {

using io::PairDetail;
using io::ReportedPair;
using io::ReportFormat;
using Clock = std::chrono::steady_clock;

/// The command line as it was given.
struct CheckArguments {
  std::string scene;
  std::string format = "table";
  std::string output = "-";
  std::optional<std::string> svg;
  bool only_interior = false;
  bool contacts = false;
  std::optional<double> within;
  bool fail_on_contact = false;
};

constexpr std::array<std::pair<std::string_view, ReportFormat>, 4> formats{{{"table", ReportFormat::table},
                                                                            {"json", ReportFormat::json},
                                                                            {"ndjson", ReportFormat::ndjson},
                                                                            {"csv", ReportFormat::csv}}};

bool name_same_file(const std::string& a, const std::string& b) {
  if (is_standard_stream(a) || is_standard_stream(b)) return a == b;
  std::error_code error;
  if (std::filesystem::equivalent(a, b, error)) return true;
  return std::filesystem::absolute(a, error).lexically_normal() ==
         std::filesystem::absolute(b, error).lexically_normal();
}

/// Refuses a distance that is none, and what does not go together.
void require_one_report(const CheckArguments& arguments) {
  if (!arguments.within) return;
  if (!(*arguments.within >= 0 && std::isfinite(*arguments.within))) {
    throw UsageError(fmt::format("--within {} is no distance; it must be 0 or more", *arguments.within));
  }
  if (arguments.contacts) throw UsageError("--within tells distances and --contacts depths; give one of the two");
  if (arguments.only_interior) throw UsageError("--within and --interior exclude each other; give one of the two");
}

PairDetail detail_of(const CheckArguments& arguments) {
  if (arguments.within) return PairDetail::distance;
  return arguments.contacts ? PairDetail::contacts : PairDetail::none;
}

/// Refuses what would mix two outputs, or overwrite the scene with its report.
void require_separate_files(const CheckArguments& arguments) {
  const std::string svg = arguments.svg.value_or(arguments.output);
  if (arguments.svg && name_same_file(arguments.output, svg)) {
    if (!is_standard_stream(svg)) throw UsageError("--output and --svg name the same file " + io::in_quotes(svg));
    throw UsageError("--svg - needs --output FILE, as the report goes to the standard output too");
  }
  for (const std::string& output : {arguments.output, svg}) {
    if (is_standard_stream(output) || !name_same_file(output, arguments.scene)) continue;
    throw UsageError("the scene " + io::in_quotes(output) + " would be overwritten; name another file to write to");
  }
}

/// One run of the command over a scene of either dimension.
class Check {
 public:
  Check(const CheckArguments& arguments, ReportFormat format, const io::SceneFile& file, Progress& progress)
      : arguments_(arguments),
        format_(format),
        file_(file),
        progress_(progress),
        head_{file.source, 2, 0, detail_of(arguments)} {
    std::visit(
        [this]<Dim N>(const Scene<N, double>& scene) {
          head_.dimension = N;
          head_.objects = scene.size();
        },
        file.scene);
  }

  /// Writes the report to `out`; true when there was a pair to report.
  bool report(std::ostream& out) {
    const bool on_terminal = is_standard_stream(arguments_.output) && is_terminal(Stream::output);
    const auto colours = on_terminal ? colours_for(Stream::output) : io::Colours::off;
    const std::unique_ptr<io::ReportWriter> writer = io::begin_report(out, format_, head_, colours);
    if (on_terminal && format_ != ReportFormat::table) progress_.stop();  // the pairs that come are progress enough
    std::visit([&](const auto& scene) { search(scene, *writer, out); }, file_.scene);
    progress_.stop();
    writer->finish(summary_);
    out.flush();
    return !touching_.empty();
  }

  /// Says the summary on the error stream, where the standard output does not show it.
  void say_summary() const {
    const bool in_report = format_ == ReportFormat::table || format_ == ReportFormat::json;
    if (!in_report || !is_standard_stream(arguments_.output)) say(io::summary_line(head_, summary_));
  }

  std::span<const ObjectPair> touching() const { return touching_; }

 private:
  template <Dim N>
  static std::vector<double> coordinates(const Vec<N, double>& v) {
    std::vector<double> numbers(static_cast<std::size_t>(N));
    for (Dim i = 0; i < N; ++i) numbers[static_cast<std::size_t>(i)] = v[i];
    return numbers;
  }

  /// Blocks of candidates are tested, then written and flushed, so that whoever reads the report gets pairs while the
  /// search goes on, and so that the time of the search is told from that of writing.
  template <Dim N>
  void search(const Scene<N, double>& scene, io::ReportWriter& writer, std::ostream& out) {
    constexpr std::size_t block = 1024;
    Clock::time_point start = Clock::now();
    progress_.begin("looking for candidates");
    const std::vector<ObjectPair> candidates = scene.candidates(arguments_.within.value_or(0));
    summary_.candidates = candidates.size();
    progress_.begin("testing pairs", candidates.size());
    std::vector<ReportedPair> found;
    for (std::size_t first = 0; first < candidates.size(); first += block) {
      const std::size_t last = std::min(first + block, candidates.size());
      found.clear();
      for (std::size_t i = first; i < last; ++i) {
        if (auto pair = tested(scene, candidates[i])) {
          found.push_back(std::move(*pair));
          touching_.push_back(candidates[i]);
        }
        progress_.advance(i + 1);
      }
      summary_.seconds += std::chrono::duration<double>(Clock::now() - start).count();
      for (const ReportedPair& pair : found) writer.write(pair);
      out.flush();
      start = Clock::now();
    }
    summary_.seconds += std::chrono::duration<double>(Clock::now() - start).count();
    summary_.pairs = touching_.size();
  }

  /// What is to be told of a candidate, if it is one of those that were asked for.
  template <Dim N>
  std::optional<ReportedPair> tested(const Scene<N, double>& scene, const ObjectPair& candidate) const {
    const Object<N, double>& a = scene.object(candidate.a);
    const Object<N, double>& b = scene.object(candidate.b);
    ReportedPair pair{a.name, b.name};
    if (arguments_.within) {
      const Nearness nearness = nearness_of(a.shape, b.shape);
      pair.relation = nearness.relation;
      pair.distance = nearness.distance;
      if (!(pair.distance <= *arguments_.within)) return std::nullopt;
      return pair;
    }
    pair.relation = relation(a.shape, b.shape);
    const bool wanted = arguments_.only_interior ? pair.relation == Relation::overlapping  //
                                                 : pair.relation != Relation::apart;
    if (!wanted) return std::nullopt;
    if (arguments_.contacts) {
      const Manifold<N, double> touch = manifold(a.shape, b.shape);
      pair.normal = coordinates(touch.normal);
      for (const ManifoldPoint<N, double>& each : touch.contacts()) {
        pair.contacts.push_back({coordinates(each.point), each.depth});
      }
    }
    return pair;
  }

  const CheckArguments& arguments_;
  ReportFormat format_;
  const io::SceneFile& file_;
  Progress& progress_;
  io::ReportHead head_;
  io::ReportSummary summary_;
  std::vector<ObjectPair> touching_;
};

ExitCode run_check(const CheckArguments& arguments) {
  const ReportFormat format = chosen("--format", arguments.format, formats);
  require_one_report(arguments);
  require_separate_files(arguments);
  Progress progress("reading the scene");
  const io::SceneFile file = read_input(arguments.scene);
  progress.stop();
  say_omissions(file);

  Progress search_progress("looking for candidates");
  Check check(arguments, format, file, search_progress);
  bool found = false;
  write_output(arguments.output, [&](std::ostream& out) {
    found = check.report(out);
    if (!arguments.svg || !out) return;
    const Progress drawing("drawing the picture");
    // Inside, so that a report in a file takes its place only when the picture has been written as well.
    write_output(*arguments.svg, [&](std::ostream& picture) { io::write_svg(picture, file, check.touching()); });
  });
  check.say_summary();
  return found && arguments.fail_on_contact ? contact_found : done;
}

constexpr const char* footer =
    R"(SCENE is a scene in graze's JSON, boxes in CSV, or a Tiled map (.tmx, .tmj); told apart
by content. Pairs come in the scene's order. Shapes that touch without overlapping count.
A pair with several contact points has a row for each of them in a table and in CSV.

Examples:
  graze check level.tmx
  graze check --interior --format csv chip.csv > overlaps.csv
  graze check --contacts --format json level.tmx
  graze check --within 0.5 machine.json
  graze check --output report.json --format json --svg picture.svg level.tmx
  generate | graze check --fail-on-contact -

Exit codes: 0 done; 1 contact found, with --fail-on-contact; 2 wrong usage;
3 bad input, or an output that cannot be written)";

}  // namespace

Command add_check(CLI::App& program) {
  CLI::App* app = program.add_subcommand("check", "Find every pair of objects that touch");
  const auto arguments = std::make_shared<CheckArguments>();
  app->add_option("SCENE", arguments->scene, "Scene file, or - for the standard input")->required()->type_name("");
  app->add_option("--format", arguments->format, "table (the default), json, ndjson or csv")
      ->type_name("FORMAT")
      ->take_last();
  app->add_flag("--interior", arguments->only_interior, "Report only pairs whose interiors overlap");
  app->add_flag("--contacts", arguments->contacts, "Tell how deep, along which normal and at which points pairs touch");
  app->add_option("--within", arguments->within, "Report all pairs that are no farther apart than this, and how far")
      ->type_name("DISTANCE")
      ->take_last();
  app->add_option("--svg", arguments->svg, "Draw the scene and its contacts, - for the standard output")
      ->type_name("FILE")
      ->take_last();
  app->add_option("--output", arguments->output, "Write the report to a file instead of the standard output")
      ->type_name("FILE")
      ->take_last();
  app->add_flag("--fail-on-contact", arguments->fail_on_contact, "End with exit code 1 when a pair is reported");
  app->footer(footer);
  return {app, [arguments] { return run_check(*arguments); }};
}

}  // namespace graze::cli
