// SPDX-License-Identifier: MIT
// What the commands of the program have in common, and the door of each.
#pragma once

#include <functional>

#include <CLI/CLI.hpp>

namespace graze::cli {

/// What a process ends with. Documented in docs/cli.md.
enum ExitCode : int {
  done = 0,
  contact_found = 1,   ///< Only under --fail-on-contact.
  answers_differ = 1,  ///< Of a log that is replayed.
  usage_error = 2,
  bad_input = 3,  ///< Or an output that cannot be written.
  internal_error = 70,
};

/// A subcommand: what it accepts, and what it does once its options have been read.
struct Command {
  CLI::App* app = nullptr;
  std::function<ExitCode()> run;
};

/// Each adds its subcommand to the program.
Command add_check(CLI::App& program);
Command add_view(CLI::App& program);
Command add_query(CLI::App& program);
Command add_simulate(CLI::App& program);
Command add_replay(CLI::App& program);
Command add_info(CLI::App& program);
Command add_convert(CLI::App& program);
Command add_bench(CLI::App& program);
Command add_generate(CLI::App& program);

}  // namespace graze::cli
