// SPDX-License-Identifier: MIT
// The command-line program graze: parses the arguments, runs one command, and turns errors into a one-line message and
// an exit code.
#include <algorithm>
#include <array>
#include <csignal>
#include <exception>
#include <filesystem>
#include <new>
#include <ostream>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <graze/io/file/temporary_file.hpp>
#include <graze/io/input_error.hpp>
#include <graze/io/output_error.hpp>

#include "command.hpp"
#include "output.hpp"
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

ExitCode run(int argc, const char* const* argv) {
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
    program.parse(argc, argv);
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

/// Removes incomplete files and lets the signal end the program as usual.
extern "C" void end_by_signal(int signal) {
  io::remove_temporary_files();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

/// Ignored signals, as under nohup, stay ignored.
void clean_up_on_signals() {
  for (const int number : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGXCPU}) {
    struct sigaction action {};
    if (sigaction(number, nullptr, &action) != 0 || action.sa_handler != SIG_DFL) continue;
    action.sa_handler = end_by_signal;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
    sigaction(number, &action, nullptr);
  }
}

/// Ends like a program whose reader has closed the pipe, so that a shell sees the usual code.
[[noreturn]] void die_of_closed_pipe() {
  std::signal(SIGPIPE, SIG_DFL);
  std::raise(SIGPIPE);
  std::_Exit(128 + SIGPIPE);
}

/// Runs the program and prints errors.
ExitCode run_and_report(int argc, const char* const* argv) {
  try {
    return run(argc, argv);
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
  // Writing to a closed pipe, or beyond the maximum size of a file, must return an error, so that it is reported and
  // temporary files are removed.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  graze::cli::clean_up_on_signals();
  graze::cli::claim_standard_streams();
  try {
    return graze::cli::run_and_report(argc, argv);
  } catch (const graze::cli::ClosedPipe&) {
    graze::cli::die_of_closed_pipe();
  } catch (...) {
    return graze::cli::internal_error;
  }
}
