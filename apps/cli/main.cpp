// SPDX-License-Identifier: MIT
// The command-line program graze: parses the arguments, runs one command, and turns errors into a one-line message and
// an exit code.
#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <new>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <graze/io/input_error.hpp>
#include <graze/io/output_error.hpp>

#include "command.hpp"
#include "output.hpp"
#include "system.hpp"
#include "terminal.hpp"
#include "usage.hpp"

namespace graze::cli {
namespace {

constexpr const char* program_footer = R"(Run `graze COMMAND --help` for the options of a command.

Examples:
  graze check level.tmx
  graze check --interior --format csv chip.csv > overlaps.csv
  graze view --html level.html level.tmx
  graze query level.tmx --point 120,64
  graze info level.tmx
  graze convert level.tmx level.json
  graze bench --generate brownian:1M
  graze generate 2d:heavy:100k --output boxes.csv
  graze pairs --generate brownian:100k

Exit codes: 0 done; 1 contact found, with check --fail-on-contact, or answers differ, with replay;
2 wrong usage; 3 bad input, or an output that cannot be written; 70 internal error)";

void write_text(const std::string& text) {
  write_output("-", [&](std::ostream& out) { out << text << '\n'; });
}

std::string help_of(const CLI::App& app) {
  std::string text = app.get_formatter()->make_help(&app, full_name(app), CLI::AppFormatMode::Normal);
  return text.substr(0, text.find_last_not_of('\n') + 1);
}

ExitCode refuse(const CLI::App& program, const UsageError& error) {
  say_error(error.what());
  say(fmt::format("run `{} --help` for usage", full_name(called(program))));
  return usage_error;
}

ExitCode run(const std::vector<std::string>& arguments) {
  CLI::App program("Collision detection for 2D and 3D scenes", "graze");

  const auto formatter = program.get_formatter();
  formatter->column_width(26);
  formatter->label("SUBCOMMAND", "COMMAND");
  formatter->label("Positionals", "Arguments");
  formatter->label("REQUIRED", "");
  program.set_help_flag("-h,--help", "Print this help and exit");
  program.set_version_flag("--version", "graze " GRAZE_VERSION, "Print the version and exit");
  program.footer(program_footer);
  const std::array<Command, 10> commands{
      add_check(program), add_view(program),    add_query(program), add_simulate(program), add_replay(program),
      add_info(program),  add_convert(program), add_bench(program), add_generate(program), add_pairs(program)};
  for (const Command& command : commands) command.app->group("Commands");
  try {
    std::vector<const char*> words;
    words.reserve(arguments.size());
    for (const std::string& argument : arguments) words.push_back(argument.c_str());
    program.parse(static_cast<int>(words.size()), words.data());
  } catch (const CLI::CallForVersion&) {
    write_text("graze " GRAZE_VERSION);
    return done;
  } catch (const CLI::CallForHelp&) {
    write_text(help_of(called(program)));
    return done;
  } catch (const CLI::ParseError& error) {
    return refuse(program, explained(program, error));
  }
  const auto* const command =
      std::find_if(commands.begin(), commands.end(), [](const Command& one) { return one.app->parsed(); });
  if (command == commands.end()) {
    say_text(help_of(program) + "\n");
    return usage_error;
  }
  try {
    return command->run();
  } catch (const UsageError& error) {
    return refuse(program, error);
  }
}

/// Runs the program and prints errors.
ExitCode run_and_report(const std::vector<std::string>& arguments) {
  try {
    return run(arguments);
  } catch (const io::InputError& error) {
    say_error(error.what());
    return bad_input;
  } catch (const io::OutputError& error) {
    say_error(error.what());
    return bad_input;
  } catch (const std::filesystem::filesystem_error& error) {
    say_error(error.what());
    return bad_input;
  } catch (const std::bad_alloc&) {
    say_error("out of memory; the scene is too large for this machine");
    return internal_error;
  } catch (const std::exception& error) {
    say_error(fmt::format("internal error, please report it: {}", error.what()));
    return internal_error;
  }
}

}  // namespace
}  // namespace graze::cli

int main(int argc, char** argv) {
  graze::cli::prepare_process();
  try {
    return graze::cli::run_and_report(graze::cli::arguments_in_utf8(argc, argv));
  } catch (const graze::cli::ClosedPipe&) {
    graze::cli::die_of_closed_pipe();
  } catch (...) {
    return graze::cli::internal_error;
  }
}
