// SPDX-License-Identifier: MIT
#include <array>
#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include <graze/io/log/query_log.hpp>
#include <graze/io/replay.hpp>
#include <graze/io/report/replay.hpp>
#include <graze/io/shrink.hpp>

#include "command.hpp"
#include "input.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "terminal.hpp"
#include "usage.hpp"

namespace graze::cli {
namespace {

using Clock = std::chrono::steady_clock;

/// The parsed command line.
struct ReplayArguments {
  std::string log;
  std::optional<std::string> format;
  std::string output = "-";
  bool shrink = false;
};

constexpr std::array<std::pair<std::string_view, io::ReplayFormat>, 2> replay_formats{
    {{"table", io::ReplayFormat::table}, {"json", io::ReplayFormat::json}}};

template <Dim N>
ExitCode replay_log(const ReplayArguments& arguments, const io::QueryLog<N>& log, Progress& progress) {
  const io::ReplayFormat format = chosen("--format", arguments.format.value_or("table"), replay_formats);
  progress.begin("replaying", log.entries.size());
  const Clock::time_point start = Clock::now();
  const io::ReplayReport report =
      io::replay(log, io::library_targets<N>(log.numbers), [&progress](std::size_t calls) { progress.advance(calls); });
  const io::ReplayHead head{arguments.log, std::chrono::duration<double>(Clock::now() - start).count()};
  progress.stop();
  write_output(arguments.output, [&](std::ostream& out) { io::write_replay(out, format, head, log, report); });
  if (!is_standard_stream(arguments.output)) say(io::summary_line(head, log, report));
  return report.differing == 0 ? done : answers_differ;
}

template <Dim N>
ExitCode shrink_log(const ReplayArguments& arguments, const io::QueryLog<N>& log, Progress& progress) {
  progress.begin("shrinking");
  std::size_t tries = 0;
  const auto small =
      io::shrunk(log, io::library_targets<N>(log.numbers), [&tries](std::size_t count) { tries = count; });
  progress.stop();
  if (!small) {
    say(fmt::format("none of {} answers differs, so there is nothing to shrink", log.entries.size()));
    return done;
  }
  write_output(arguments.output, [&](std::ostream& out) { io::write_query_log(out, *small); });
  say(fmt::format("{} of {} calls are left after {} attempts", small->entries.size(), log.entries.size(), tries));
  return answers_differ;
}

ExitCode run_replay(const ReplayArguments& arguments) {
  if (arguments.shrink && arguments.format) {
    throw UsageError("--format applies to reports, but --shrink writes a log");
  }
  if (!is_standard_stream(arguments.output) && name_same_file(arguments.log, arguments.output)) {
    throw UsageError("the log " + io::in_quotes(arguments.output) +
                     " would be overwritten; name another file to write to");
  }
  Progress progress("reading the log");
  const io::AnyQueryLog log = read_log(arguments.log);
  return std::visit(
      [&](const auto& held) {
        return arguments.shrink ? shrink_log(arguments, held, progress) : replay_log(arguments, held, progress);
      },
      log);
}

constexpr const char* replay_footer =
    R"(A log contains the calls on a scene and its answers, recorded by a C++ program or by
`graze simulate --log`. The calls are executed again, and each answer is compared with the
one in the log and with that of a brute-force scene.

Examples:
  graze replay yard.log
  graze replay --format json yard.log
  graze replay --shrink --output small.log yard.log

Exit codes: 0 done; 1 an answer differs; 2 wrong usage; 3 bad input, or an output that cannot be
written)";

}  // namespace

Command add_replay(CLI::App& program) {
  CLI::App* app = program.add_subcommand("replay", "Replay recorded calls on a scene and compare the answers");
  const auto arguments = std::make_shared<ReplayArguments>();
  const auto add = [app](const char* name, auto& value, const char* help, const char* type) {
    app->add_option(name, value, help)->type_name(type)->take_last();
  };
  app->add_option("LOG", arguments->log, "Query log, or - for the standard input")->required()->type_name("");
  app->add_flag("--shrink", arguments->shrink, "Instead of a report, write a minimal log that still differs");
  add("--format", arguments->format, "table (the default) or json", "FORMAT");
  add("--output", arguments->output, "Write to a file instead of the standard output", "FILE");
  app->footer(replay_footer);
  return {app, [arguments] { return run_replay(*arguments); }};
}

}  // namespace graze::cli
