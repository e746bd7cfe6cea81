// SPDX-License-Identifier: MIT
// The program graze-mpi: the same on every rank; only rank 0 writes.
#include <algorithm>
#include <array>
#include <exception>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <mpi.h>

#include "command.hpp"
#include "standard_output.hpp"
#include "terminal.hpp"
#include "usage.hpp"

namespace graze::mpi {
namespace {

enum ExitCode : int { done = 0, usage_error = 2, failed = 70 };

constexpr const char* program_footer = R"(Run `graze-mpi COMMAND --help` for the options of a command.

Examples:
  mpirun -n 4 graze-mpi pairs --generate brownian:100000 --seed 3
  mpirun -n 2 graze-mpi bench --generate brownian:4M --format json

Exit codes: 0 done; 2 wrong usage; 70 an error)";

void write_by_first(const std::string& text) {
  if (rank_of_this() == 0) write_out(text);
}

std::string help_of(const CLI::App& app) {
  return app.get_formatter()->make_help(&app, cli::full_name(app), CLI::AppFormatMode::Normal);
}

ExitCode refuse(const CLI::App& program, const cli::UsageError& error) {
  if (rank_of_this() != 0) return usage_error;
  cli::say_error(error.what());
  cli::say(fmt::format("run `{} --help` for usage", cli::full_name(cli::called(program))));
  return usage_error;
}

ExitCode run(int argc, const char* const* argv) {
  CLI::App program("Collision detection on several machines, by MPI", "graze-mpi");
  program.get_formatter()->column_width(26);
  program.get_formatter()->label("SUBCOMMAND", "COMMAND");
  program.get_formatter()->label("REQUIRED", "");
  program.set_help_flag("-h,--help", "Print this help and exit");
  program.set_version_flag("--version", "graze-mpi " GRAZE_VERSION, "Print the version and exit");
  program.footer(program_footer);
  const std::array<Command, 2> commands{add_pairs(program), add_bench(program)};
  for (const Command& command : commands) command.app->group("Commands");
  try {
    program.parse(argc, argv);
  } catch (const CLI::CallForVersion&) {
    write_by_first("graze-mpi " GRAZE_VERSION "\n");
    return done;
  } catch (const CLI::CallForHelp&) {
    write_by_first(help_of(cli::called(program)));
    return done;
  } catch (const CLI::ParseError& error) {
    return refuse(program, cli::explained(program, error));
  }
  const auto* const command =
      std::find_if(commands.begin(), commands.end(), [](const Command& one) { return one.app->parsed(); });
  if (command == commands.end()) {
    return refuse(program, cli::UsageError("a command is missing; the commands are pairs and bench"));
  }
  try {
    command->run();
    return done;
  } catch (const cli::UsageError& error) {
    return refuse(program, error);
  }
}

/// Errors have been agreed on, so that all ranks come here, and one message is enough.
ExitCode run_and_report(int argc, const char* const* argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    if (rank_of_this() == 0) cli::say_error(error.what());
    return failed;
  }
}

}  // namespace
}  // namespace graze::mpi

int main(int argc, char** argv) {
  int level = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &level);
  const int code = graze::mpi::run_and_report(argc, argv);
  MPI_Finalize();
  return code;
}
